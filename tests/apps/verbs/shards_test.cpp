// certify --part, --merge and --resume: a history certified by several processes, or by one that
// was killed, has the report of one that was not.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <thread>

#include "tests/apps/verbs/shards_cli.h"

namespace voroproof::internal {
namespace {

bool has_ended(pid_t child) {
  siginfo_t found{};
  waitid(P_PID, static_cast<id_t>(child), &found, WEXITED | WNOHANG | WNOWAIT);
  return found.si_pid == child;
}

TEST_F(ShardsCli, HaveTheReportOfTheWhole) {
  const std::string report = whole();
  for (const int of : {1, 3, 20}) {
    Arguments names = parts(of);
    std::reverse(names.begin(), names.end());
    const Result result = run(merge(names));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, about + "s CERTIFIED\n");
    EXPECT_TRUE(read_bytes(report_) == report) << of;
    std::filesystem::remove(report_);
  }
}

// One flip is missing in the second of three.
TEST_F(ShardsCli, RefuteTheWhole) {
  drop_a_flip(read_bytes(history_).size() / 2);
  const std::string report = whole(1);
  EXPECT_EQ(part(1, 3).code, 0);
  const Result second = part(2, 3);
  EXPECT_EQ(second.code, 1);
  EXPECT_EQ(second.out, about_shard(2, 3) + "s SHARD 2/3 REFUTED\n");
  const Result result = run(merge({name(2), name(1)}));
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.out, about + "s REFUTED\n");
  EXPECT_NE(result.err.find("missing event"), std::string::npos) << result.err;
  EXPECT_TRUE(read_bytes(report_) == report);
  std::filesystem::remove(report_);
  refused_merge({name(2)}, "is shard 2 of 3, and shard 1 is missing");
  // A forged witness is known for what it is.
  change(2, [](Json& s) {
    s["report"]["divergence"]["witness"]["polynomial"]["coefficients"][0] = "12345";
  });
  refused_merge({name(1), name(2)}, "and its witness is false");
  for (const char* bad : {"1/0", "1/", "/2", "-", "", "0x1", "1e5", "banana", "1/2/3", "--1"}) {
    change(2, [&](Json& s) {
      s["report"]["divergence"]["witness"]["polynomial"]["coefficients"][0] = bad;
    });
    refused_merge({name(1), name(2)}, "coefficients[0]: no fraction");
  }
}

TEST_F(ShardsCli, OfAHistoryThatStops) {
  must({"certify", scene_, history_, "--truth", "recorded", "--quiet"});
  const int code =
      run({"simulate", scene_, "-o", history_, "--replace", "--max-events", "3000"}).code;
  EXPECT_EQ(code, 3);
  const std::string report = whole(3);
  Arguments names;
  for (int k = 1; k <= 4; ++k) {
    const int found = part(k, 4).code;
    EXPECT_TRUE(found == 0 || found == 3) << found;
    names.push_back(name(k));
  }
  EXPECT_EQ(run(merge(names)).code, 3);
  EXPECT_TRUE(read_bytes(report_) == report);
}

TEST_F(ShardsCli, ThatDoNotFit) {
  const Arguments names = parts(3);
  refused_merge({names[0], names[1]}, "shard 3 of 3 is missing");
  refused_merge({names[0], names[2]}, "is shard 3 of 3, and shard 2 is missing");
  refused_merge({names[1], names[2]}, "is shard 2 of 3, and shard 1 is missing");
  refused_merge({names[0], names[1], names[1], names[2]}, "is there twice");
  const auto with = [&](int k, const std::string& message, const std::function<void(Json&)>& what) {
    const std::string before = read_bytes(name(k));
    change(k, what);
    refused_merge(names, message);
    directory_.write("s" + std::to_string(k) + ".shard.json", before);
  };
  const std::string breaks = "does not begin where the one before it ends: ";
  // Forged, each in one place.
  with(2, breaks + "another state",
       [](Json& s) { s["begin"]["state_sha256"] = std::string(64, 'a'); });
  with(2, breaks + "another state",
       [](Json& s) { s["end"]["state_sha256"] = std::string(64, 'a'); });
  with(2, breaks + "other bytes",
       [](Json& s) { s["begin"]["bytes_sha256"] = std::string(64, 'a'); });
  with(2, breaks + "other claims", [](Json& s) { s["end"]["flips"] = 5; });
  with(2, breaks + "other claims", [](Json& s) { s["end"]["line"] = 5; });
  with(2, breaks + "another place", [](Json& s) { s["end"]["t"] = 500; });
  with(2, "begins where the history is over", [](Json& s) { s["end"] = nullptr; });
  with(3, "does not end with the history", [](Json& s) { s["end"] = s["begin"]; });
  with(1, "does not begin with the history", [](Json& s) { s["begin"]["part"] = 1; });
  // Two exchanged: each says that it is the other.
  with(2, breaks, [&](Json& s) {
    s = json("s3.shard.json");
    s["part"][0] = 2;
  });
  // Of something else.
  with(2, "is of another scene",
       [](Json& s) { s["report"]["scene_sha256"] = std::string(64, 'a'); });
  with(2, "is of another history", [](Json& s) { s["report"]["horizon"] = "999"; });
  with(2, "is with other options", [](Json& s) { s["report"]["tolerance"] = "1/1000"; });
  with(2, "is with other options", [](Json& s) { s["unoriented"] = true; });
  with(2, "is of another truth", [](Json& s) { s["report"]["truth"] = "exact"; });
  with(2, "is by another version", [](Json& s) { s["report"]["producer"] = "voroproof 9"; });
  with(3, "and others are of 3", [](Json& s) { s["part"] = {3, 4}; });
  // No shards.
  with(2, "begin: nothing is left", [](Json& s) { s["begin"] = s["end"] = nullptr; });
  with(2, "begin.state_sha256: not 64", [](Json& s) { s["begin"]["state_sha256"] = "a"; });
  with(2, "report.proved.flips: out of range",
       [](Json& s) { s["report"]["proved"]["flips"] = -1; });
  with(2, "report.verdict: no verdict", [](Json& s) { s["report"]["verdict"] = "FINE"; });
  with(2, "part[0]: out of range", [](Json& s) { s["part"][0] = 4; });
  refused_merge({names[0], scene_, names[2]}, "not \"voroproof-shard\"");
  const std::string second = read_bytes(name(2));
  directory_.write("s2.shard.json", second + std::string(1, '\0') + "and more");
  refused_merge(names, "a byte 0");
  directory_.write("s2.shard.json", second.substr(0, 1000));
  refused_merge(names, "incomplete");
}

// Both histories are of the scene, and the shards of each fit together.
TEST_F(ShardsCli, OfTwoHistoriesDoNotFit) {
  parts(3);
  const std::string last = read_bytes(name(3));
  const std::string text = read_bytes(history_);
  const std::size_t flip = text.find("\"flip\"", text.size() / 8), from = text.rfind('\n', flip);
  // Another line, the same claim: the shards are not of one file.
  std::string other = text;
  other.insert(from + 2, " ");
  directory_.write("a.history.jsonl", other);
  parts(3);
  directory_.write("s3.shard.json", last);
  refused_merge({name(1), name(2), name(3)}, "another place");
  // Another time, in a place beyond those that are proved, in as many bytes.
  other = text;
  const std::size_t end = text.find_first_of(",}", text.find("\"t\":", from));
  other[end - 1] = other[end - 1] == '1' ? '2' : '1';
  directory_.write("a.history.jsonl", other);
  parts(3);
  directory_.write("s3.shard.json", last);
  refused_merge({name(1), name(2), name(3)}, "other bytes before it");
}

// What a merge would have to judge itself is asked for when the shards are made.
TEST_F(ShardsCli, AMergeTakesNoOtherOption) {
  const Arguments names = parts(2);
  for (const Arguments& option : std::vector<Arguments>{{"--strict"},
                                                        {"--kernel"},
                                                        {"--proved"},
                                                        {"--unoriented"},
                                                        {"--resume"},
                                                        {"--truth", "exact"},
                                                        {"--events", "collisions"},
                                                        {"--tolerance", "1e-12"},
                                                        {"--law-tolerance", "1e-15"},
                                                        {"--threads", "2"},
                                                        {"--part", "1/2"},
                                                        {"--checkpoint", "5"},
                                                        {"--max-bits", "64"},
                                                        {"--max-events", "5"}}) {
    Arguments arguments{"certify", "--report", report_};
    arguments.insert(arguments.end(), option.begin(), option.end());
    arguments.push_back("--merge");
    arguments.insert(arguments.end(), names.begin(), names.end());
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << option[0];
    EXPECT_EQ(result.out.find("CERTIFIED"), std::string::npos) << option[0];
    EXPECT_NE(result.err.find(option[0]), std::string::npos) << result.err;
  }
  EXPECT_EQ(run(merge(names)).code, 0);
}

// The name under which a run keeps what it has proved may be that of something else.
TEST_F(ShardsCli, NothingElseIsReplacedByWhatIsKept) {
  const std::string text = read_bytes(history_);
  directory_.write("b.partial", text);
  directory_.write("c.partial", "precious");
  const Arguments end{"--truth", "recorded", "--quiet", "--report"};
  for (const auto& [history, report] :
       {std::pair(file("b.partial"), std::string("b")), std::pair(history_, std::string("c"))}) {
    Arguments arguments{"certify", scene_, history};
    arguments.insert(arguments.end(), end.begin(), end.end());
    arguments.push_back(file(report));
    EXPECT_EQ(run(arguments).code, 2) << report;
    EXPECT_FALSE(std::filesystem::exists(file(report)));
  }
  EXPECT_TRUE(read_bytes(file("b.partial")) == text);
  EXPECT_EQ(read_bytes(file("c.partial")), "precious");
}

TEST_F(ShardsCli, NeedWhatTheyNeed) {
  const std::string s = name(1);
  for (const char* bad : {"0/3", "4/3", "1", "1/", "/3", "1/3x", "a/b", "1/9999999", "-1/3"}) {
    const Result result = run(certify({"--part", bad}));
    EXPECT_EQ(result.code, 2) << bad;
    EXPECT_NE(result.err.find("--part: not I/N"), std::string::npos) << result.err;
  }
  refused({"certify", scene_, history_, "--part", "1/2", "--report", s}, "--truth recorded");
  refused({"certify", scene_, history_, "--resume", "--report", s}, "--truth recorded");
  refused({"certify", scene_, history_, "--truth", "recorded", "--part", "1/2"}, "--report");
  refused({"certify", scene_, history_, "--truth", "recorded", "--resume"}, "--report");
  refused({"certify", scene_, history_, "--truth", "recorded", "--resume", "--report", "-"},
          "stream");
  refused({"certify", scene_, history_, "--truth", "recorded", "--part", "1/2", "--report", s,
           "--kernel"},
          "the kernel judges the whole history");
}

// What a run that was broken off has left is a shard that begins with the history.
TEST_F(ShardsCli, ResumeWhereARunWasBrokenOff) {
  const std::string report = whole();
  EXPECT_EQ(part(1, 2).code, 0);
  change(1, [](Json& s) { s["part"] = {1, 1}; });
  const std::string left = read_bytes(name(1));
  const std::string partial = "a.report.json.partial";
  directory_.write(partial, left);
  Arguments resume = certify({"--resume"});
  resume.erase(std::find(resume.begin(), resume.end(), "--quiet"));
  const Result result = run(resume);
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find(partial + " at t = "), std::string::npos) << result.err;
  EXPECT_TRUE(read_bytes(report_) == report);
  EXPECT_FALSE(std::filesystem::exists(file(partial)));
  std::filesystem::remove(report_);
  // Nothing is taken up without the option.
  directory_.write(partial, left);
  EXPECT_EQ(whole(), report);
  // Of something else, or of nothing that can be taken up.
  const auto not_of_this = [&](const std::string& message, const std::function<void(Json&)>& what) {
    Json s = Json::parse(left);
    what(s);
    directory_.write(partial, s.dump());
    const Result refused = run(certify({"--resume"}));
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.err.find(message), std::string::npos) << message << ": " << refused.err;
    EXPECT_FALSE(std::filesystem::exists(report_));
    EXPECT_TRUE(std::filesystem::exists(file(partial)));
  };
  not_of_this("is of another shard", [](Json& s) { s["part"] = {1, 2}; });
  not_of_this("is with other options", [](Json& s) { s["report"]["strict"] = true; });
  not_of_this("is of another history than", [](Json& s) { s["end"]["line"] = 7; });
  not_of_this("can be taken up", [](Json& s) { s["end"] = nullptr; });
  not_of_this("and is something else", [](Json& s) { s["format"] = "voroproof-report"; });
  std::filesystem::remove(file(partial));
}

// Killed at random instants, again and again. No kill leaves what a later run cannot take up.
TEST_F(ShardsCli, OfProcessesThatAreKilled) {
  const std::string report = whole();
  const Arguments resume = certify({"--resume", "--checkpoint", "0", "--threads", "2"});
  const std::string partial = report_ + ".partial";
  std::mt19937_64 random(9);
  int left = 0;
  for (int k = 0; k < 100; ++k) {
    const pid_t child = start(resume);
    // Each other one at some time after it has kept something.
    while (k % 2 == 0 && !std::filesystem::exists(partial) && !has_ended(child)) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 40000));
    kill(child, SIGKILL);
    finish(child);
    left += std::filesystem::exists(partial);
    if (!std::filesystem::exists(report_)) continue;
    ASSERT_TRUE(read_bytes(report_) == report) << k;
    std::filesystem::remove(report_);
  }
  EXPECT_GT(left, 0);
  EXPECT_EQ(run(resume).code, 0);
  EXPECT_TRUE(read_bytes(report_) == report);
  // The scene, the history, the report; what killed writers left is gone, too.
  EXPECT_EQ(directory_.number_of_files(), 3u);
}

}  // namespace
}  // namespace voroproof::internal
