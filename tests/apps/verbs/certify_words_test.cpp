// What certify says besides the verdict, and of which bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "history/sha256.h"
#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

// A report is of bytes: it has their hashes, whatever the verdict, and wherever reading stopped.
TEST_F(CertifyCli, ReportsNameTheBytes) {
  const std::string scene = reference(20, "40"), path = history(scene);
  const std::string wrong = edited(path, [](auto& lines) { lines.erase(lines.begin() + 1); });
  for (const std::string& history : {path, wrong}) {
    for (const char* truth : {"exact", "recorded"}) {
      for (const Arguments& limit : std::vector<Arguments>{{}, {"--max-events", "3"}}) {
        Arguments words{"certify", scene, history, "--truth", truth, "--report", file("r.json")};
        words.insert(words.end(), limit.begin(), limit.end());
        EXPECT_EQ(run(words).code, history == wrong ? 1 : limit.empty() ? 0 : 3);
        EXPECT_EQ(json("r.json")["scene_sha256"], sha256_of_file(scene));
        EXPECT_EQ(json("r.json")["history_sha256"], sha256_of_file(history)) << truth;
      }
    }
  }
}

// What refutes a history is enough, also where its rest cannot be read: then the report has no hash
// of it, and cannot be shown with it.
TEST_F(CertifyCli, RefutedBeforeADamagedRest) {
  const std::string scene = reference(30, "1000"), path = history(scene);
  const std::string wrong = edited(path, [](auto& lines) { lines.erase(lines.begin() + 1); });
  // A gzip of it that breaks off in the middle.
  const std::string packed = file("w.jsonl.gz");
  ASSERT_EQ(std::system(("gzip -c " + wrong + " > " + packed).c_str()), 0);
  std::filesystem::resize_file(packed, std::filesystem::file_size(packed) / 2);
  for (const char* truth : {"exact", "recorded"}) {
    const Result out =
        run({"certify", scene, packed, "--truth", truth, "--report", file("r.json")});
    EXPECT_EQ(out.code, 1) << truth << out.err;
    EXPECT_FALSE(json("r.json").contains("history_sha256"));
    refused({"movie", scene, wrong, "--report", file("r.json"), "-o", file("m.html")},
            "does not say which history");
  }
}

// What was accepted is said with --quiet, too: here the tolerance is the whole horizon.
TEST_F(CertifyCli, LeniencyIsSaidQuietly) {
  const std::string small = scene("12", disk("-6,0", "2", "1,0") + "," + disk("4,0", "3", "0,0"));
  const std::string empty = edited(history(small), [](std::vector<std::string>& lines) {
    lines.erase(lines.begin() + 1, lines.end() - 1);
    lines.back() = R"({"end":{"t":12,"flips":0,"collisions":0,"maneuvers":0}})";
  });
  const Result out = must({"certify", small, empty, "--truth", "recorded", "--tolerance", "12",
                           "--quiet", "--report", file("r.json")});
  EXPECT_EQ(
      out.out,
      "c all events, recorded truth, up to t = 12, times within 12, velocities within 1e-9\n"
      "c leniency: 1 events within the tolerance of the horizon that are not claimed\n"
      "c the tolerance is as long as the time that is judged: no event of it had to be claimed\n"
      "s CERTIFIED\n");
  const Json words = json("r.json")["words"];
  EXPECT_EQ(words["verdict"], "CERTIFIED");
  EXPECT_NE(words["reservations"][0].get<std::string>().find("not claimed"), std::string::npos);
  EXPECT_NE(must({"explain", file("r.json")}).out.find("Note: leniency: 1 events"),
            std::string::npos);
}

// Times are so late that rounding them moves them by more than the tolerance.
TEST_F(CertifyCli, ToleranceBelowAnUlp) {
  const std::string late =
      scene("1e12", disk("-5,0.3", "1", "3e-11,1e-11") + "," + disk("5,0.1", "1", "-1e-11,0") +
                        "," + disk("0,7", "1", "0,0"));
  const std::string path = history(late);
  const std::string hint =
      "c binary64 numbers near t = 1e12 are 0.0001220703125 apart, so that rounding alone takes a "
      "time out of the tolerance: --tolerance 0.0001220703125 allows for it\n";
  for (const char* truth : {"exact", "recorded"}) {
    const Result out = run({"certify", late, path, "--truth", truth, "--quiet"});
    EXPECT_EQ(out.code, 1) << truth;
    EXPECT_NE(out.out.find(hint), std::string::npos) << out.out;
    const Result wide =
        must({"certify", late, path, "--truth", truth, "--tolerance", "0.0001220703125"});
    EXPECT_EQ(wide.out.find("apart"), std::string::npos) << wide.out;
  }
}

// Numbers that are off, and an event that is: wider tolerances tell them apart.
TEST_F(CertifyCli, LeastTolerances) {
  const std::string small = scene("20", disk("-6,0", "1", "1,0") + "," + disk("4,0", "1", "0,0"));
  const std::string whole = history(small);  // one collision, at t = 8
  const auto judged = [&](const std::string& path, const char* truth) {
    return run({"certify", small, path, "--truth", truth, "--least-tolerances", "--report",
                file("r.json")});
  };
  const auto collision = [](std::vector<std::string>& lines) -> std::string& {
    return *std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("collide") != std::string::npos;
    });
  };
  const std::string late =
      edited(whole, [&](auto& lines) { collision(lines).replace(0, 6, R"({"t":8.00003)"); });
  for (const char* truth : {"exact", "recorded"}) {
    Result out = judged(whole, truth);
    EXPECT_EQ(out.code, 0);
    EXPECT_NE(out.out.find("c the least powers of ten that certify the history are times within "),
              std::string::npos)
        << out.out;
    out = judged(late, truth);
    EXPECT_EQ(out.code, 1);
    EXPECT_NE(out.out.find("c all events are right, and numbers leave the tolerances from t = 8"),
              std::string::npos)
        << out.out;
    EXPECT_EQ(json("r.json")["least_tolerances"]["times"], "1/10000");
    EXPECT_EQ(verdict({small, late, "--truth", truth, "--tolerance", "1e-4", "--law-tolerance",
                       json("r.json")["least_tolerances"]["velocities"].get<std::string>()}),
              "s CERTIFIED");
  }
  // For a centre the tolerance of times counts.
  const std::string aside = edited(whole, [&](auto& lines) {
    const std::string centres = R"("p":[[)";
    std::string& line = collision(lines);
    const std::size_t begin = line.find(centres) + centres.size();
    line.replace(begin, line.find(',', begin) - begin, "2.00003");
  });
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(judged(aside, truth).code, 1);
    EXPECT_EQ(json("r.json")["least_tolerances"]["times"], "1/10000");
  }
  const std::string missing = edited(whole, [&](auto& lines) {
    lines.erase(std::find(lines.begin(), lines.end(), collision(lines)));
    lines.back() = R"({"end":{"t":20,"flips":)" + std::to_string(lines.size() - 2) +
                   R"(,"collisions":0,"maneuvers":0}})";
  });
  for (const char* truth : {"exact", "recorded"}) {
    const Result out = judged(missing, truth);
    EXPECT_EQ(out.code, 1);
    EXPECT_NE(out.out.find("c an event is wrong with times within "), std::string::npos) << out.out;
    EXPECT_FALSE(json("r.json").contains("least_tolerances"));
  }
  refused({"certify", small, whole, "--least-tolerances", "--max-events", "1"},
          "--least-tolerances");
  refused({"certify", small, "-", "--least-tolerances"}, "--least-tolerances");
}

}  // namespace
}  // namespace voroproof::internal
