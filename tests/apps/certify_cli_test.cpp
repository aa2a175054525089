// certify and convert as their users meet them: verdicts, exit codes, reports, foreign files.
#include <filesystem>
#include <fstream>

#include "tests/apps/cli.h"

namespace voroproof {
namespace {

class CertifyCli : public Cli {
 protected:
  // The last line of the output, which is the verdict, and the exit code that belongs to it.
  std::string verdict(const Arguments& arguments) const {
    Arguments all{"certify"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Result result = run(all);
    const auto lines = lines_of(result.out);
    const std::string last = lines.empty() ? "" : lines.back();
    const std::vector<std::string> of_code{"s CERTIFIED", "s REFUTED", "s INVALID", "s UNDECIDED"};
    EXPECT_GE(result.code, 0);
    EXPECT_LE(result.code, 3) << result.err;
    if (result.code >= 0 && result.code <= 3) {
      EXPECT_EQ(last, of_code[result.code]) << result.err;
    }
    EXPECT_EQ(result.err.empty(), result.code == 0) << result.err;
    return last;
  }

  std::string history(const std::string& scene) const {
    const std::string path = file("a.history.jsonl");
    must({"simulate", scene, "-o", path});
    return path;
  }

  // The history with line `number` (from 0) put through `change`.
  template <class Change>
  std::string edited(const std::string& path, Change&& change) const {
    std::vector<std::string> lines = lines_of(read_file(path));
    change(lines);
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    const std::string to = file("edited.history.jsonl");
    std::ofstream(to, std::ios::binary) << text;
    return to;
  }

  static std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(CertifyCli, OwnHistoriesUnderBothTruths) {
  const std::string scene = reference(30, "40"), path = history(scene);
  EXPECT_EQ(verdict({scene, path}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, path, "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, path, "--strict", "--report", file("r.json")}), "s CERTIFIED");
  const Json report = json("r.json");
  EXPECT_EQ(report["verdict"], "CERTIFIED");
  EXPECT_LE(report["time_error_ulps"]["max"].get<double>(), 0.5000001);
  EXPECT_EQ(report["certified_prefix"]["events"].get<std::size_t>(),
            lines_of(read_file(path)).size() - 2);
}

TEST_F(CertifyCli, SmallestScenes) {
  for (const char* n : {"0", "1", "2", "3"}) {
    const std::string scene = reference(std::stoi(n), "20"), path = history(scene);
    EXPECT_EQ(verdict({scene, path}), "s CERTIFIED") << n;
    EXPECT_EQ(verdict({scene, path, "--truth", "recorded"}), "s CERTIFIED") << n;
  }
}

TEST_F(CertifyCli, FaultsAreRefutedWithTheirLine) {
  const std::string scene = reference(30, "40"), path = history(scene);
  std::size_t dropped = 0;
  const std::string bad = edited(path, [&](std::vector<std::string>& lines) {
    while (lines[++dropped].find("flip") == std::string::npos) {
    }
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(dropped));
  });
  for (const char* truth : {"exact", "recorded"}) {
    EXPECT_EQ(verdict({scene, bad, "--truth", truth, "--report", file("r.json")}), "s REFUTED");
    const Json report = json("r.json");
    EXPECT_EQ(report["verdict"], "REFUTED");
    EXPECT_EQ(report["divergence"]["kind"], "missing event");
    EXPECT_EQ(report["divergence"]["line"].get<std::size_t>(), dropped + 1);
  }
}

TEST_F(CertifyCli, ReportsAreExplainedAndDrawn) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string bad = edited(path, [](auto& lines) {
    lines.erase(lines.begin() + 1);
    lines.erase(lines.begin() + 1);
  });
  EXPECT_EQ(verdict({scene, bad, "--report", file("r.json")}), "s REFUTED");
  const std::string words = must({"explain", file("r.json")}).out;
  EXPECT_NE(words.find("REFUTED"), std::string::npos);
  EXPECT_NE(words.find("Exactly one root lies between"), std::string::npos);
  EXPECT_EQ(directory_.read("r.svg").substr(0, 5), "<?xml");
  must({"explain", file("r.json"), "-o", file("r.png")});
  EXPECT_EQ(directory_.read("r.png").substr(1, 3), "PNG");
  EXPECT_EQ(verdict({scene, path, "--report", file("good.json")}), "s CERTIFIED");
  must({"explain", file("good.json")});
  EXPECT_FALSE(std::filesystem::exists(file("good.svg")));
  refused({"explain", scene}, "not a report");
  refused({"explain", path}, "not a report");
  refused({"explain", file("r.json"), "-o", file("r.gif")}, ".svg or .png");
}

TEST_F(CertifyCli, TheSelfCheckChangesNoByte) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string plain = read_file(path);
  must({"simulate", scene, "-o", path, "--self-check"});
  EXPECT_EQ(read_file(path), plain);
  must({"simulate", scene, "-o", path, "--self-check", "--threads", "2"});
  EXPECT_EQ(read_file(path), plain);
}

TEST_F(CertifyCli, WhatIsNotAHistoryOfTheSceneIsInvalid) {
  const std::string scene = reference(30, "40"), path = history(scene);
  EXPECT_EQ(verdict({scene, edited(path, [](auto& lines) { lines.pop_back(); })}), "s INVALID");
  EXPECT_EQ(verdict({scene, edited(path,
                                   [](auto& lines) {
                                     const auto at = lines[0].find("sha256\":\"") + 9;
                                     lines[0][at] = lines[0][at] == 'a' ? 'b' : 'a';
                                   })}),
            "s INVALID");
  EXPECT_EQ(verdict({scene, file("absent")}), "s INVALID");
  EXPECT_EQ(verdict({path, path}), "s INVALID");
}

TEST_F(CertifyCli, AHistoryThatStopsIsUndecided) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string stopped = edited(path, [](auto& lines) {
    lines.resize(20);
    lines.push_back(R"({"stopped":{"t":)" + lines.back().substr(5, lines.back().find(',') - 5) +
                    R"(,"reason":"interrupted","events":[]}})");
  });
  EXPECT_EQ(verdict({scene, stopped, "--report", file("r.json")}), "s UNDECIDED");
  EXPECT_EQ(json("r.json")["certified_prefix"]["events"], 19);
}

TEST_F(CertifyCli, ThereAndBackThroughAnEventSequence) {
  const std::string scene = reference(30, "40"), path = history(scene);
  const std::string disks = file("a.disks.txt"), events = file("a.evtsq");
  must({"convert", scene, "-o", disks});
  must({"convert", path, "--scene", scene, "-o", events});
  EXPECT_EQ(verdict({disks, events, "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, events, "--truth", "recorded"}), "s CERTIFIED");
  EXPECT_EQ(verdict({scene, events}), "s CERTIFIED");
  must({"convert", path, "--scene", scene, "-o", events, "--numbers", "decimal"});
  EXPECT_EQ(verdict({scene, events, "--truth", "recorded"}), "s CERTIFIED");
  must({"convert", disks, "--horizon", "40", "-o", file("b.scene.json")});
  const std::string back = file("b.history.jsonl");
  must({"convert", events, "--scene", file("b.scene.json"), "-o", back});
  EXPECT_EQ(verdict({file("b.scene.json"), back, "--truth", "recorded"}), "s CERTIFIED");
}

TEST_F(CertifyCli, ConversionsThatCannotBe) {
  const std::string scene = reference(5, "5"), path = history(scene);
  refused({"convert", path, "-o", file("a.evtsq")}, "--scene");
  refused({"convert", scene, "-o", file("a.svg")}, "--output");
  must({"convert", scene, "-o", file("a.disks.txt")});
  refused({"convert", file("a.disks.txt"), "-o", file("b.scene.json")}, "--horizon");
  refused({"convert", path, "-o", file("b.scene.json"), "--horizon", "1"}, "number of circles");
}

// Real output of the engine of the paper's authors, where it is at hand.
TEST_F(CertifyCli, SamplesOfTheAuthorsEngine) {
  const std::filesystem::path samples =
      std::filesystem::path(VOROPROOF_SOURCE).parent_path() / "shared" / "samples";
  if (!std::filesystem::exists(samples)) {
    GTEST_SKIP() << "the samples of the authors' engine are not beside the project";
  }
  const auto sample = [&](const char* name) { return (samples / name).string(); };
  const std::string events = sample("vdrc-n30.evtsq");
  for (const std::string& scene : {sample("vdrc-n30.disks.txt"), sample("vdrc-n30.scene.json")}) {
    EXPECT_EQ(verdict({scene, events, "--truth", "recorded"}), "s CERTIFIED");
    // A float history leaves the true motion after a while, and no sooner.
    EXPECT_EQ(verdict({scene, events, "--report", file("r.json")}), "s REFUTED");
    EXPECT_GT(json("r.json")["certified_prefix"]["t"], 100);
  }
  // It begins with a wrong diagram, for its start is cocircular.
  EXPECT_EQ(verdict({sample("vdrc-grid25.disks.txt"), sample("vdrc-grid25.evtsq"), "--truth",
                     "recorded"}),
            "s REFUTED");
}

}  // namespace
}  // namespace voroproof
