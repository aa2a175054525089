// certify --proved, with the program voroproof-proved where it was built, and with stand-ins for it
// that say what the real one never should.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>

#include "tests/apps/verbs/certify_cli.h"

namespace voroproof::internal {
namespace {

class SecondChecker : public CertifyCli {
 protected:
  void SetUp() override {
    scene_ = reference(12, "20");
    history_ = history(scene_);
    wrong_ = edited(history_, [](auto& lines) { lines.erase(lines.begin() + 1); });
  }

  void TearDown() override { setenv("PATH", path_.c_str(), 1); }

  Result certified(const std::string& history, const Arguments& more = {}) const {
    Arguments all{"certify", scene_, history, "--truth", "recorded", "--proved"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }

  // From here on the program is a copy of its own, without the proved checker.
  void move_away() {
    std::filesystem::create_directory(file("bin"));
    std::filesystem::copy_file(VOROPROOF_PROGRAM, file("bin/voroproof"));
    program_ = file("bin/voroproof");
  }

  // From here on the proved checker beside the program is a script.
  void stand_in(const std::string& script) {
    if (!std::filesystem::exists(file("bin"))) move_away();
    const std::string path = file("bin/voroproof-proved");
    std::ofstream(path) << "#!/bin/sh\n" << script;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }

  std::string scene_, history_, wrong_;
  const std::string path_ = std::getenv("PATH");
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(SecondChecker, BothCertify) {
  const Result result = certified(history_, {"--kernel", "--report", file("r.json")});
  if (holds(result.err, "is not installed")) GTEST_SKIP() << result.err;
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(holds(result.out, "c kernel: CERTIFIED\nc proved checker: CERTIFIED\n"))
      << result.out;
  EXPECT_EQ(lines_of(result.out).back(), "s CERTIFIED");
  EXPECT_EQ(json("r.json")["proved_checker"], "CERTIFIED");
}

TEST_F(SecondChecker, TheKernelJudgesBilliards) {
  std::ofstream(file("b.json"))
      << R"({"format":"voroproof-scene","version":2,"contacts":"bounce","horizon":2,)"
         R"("frame":{"periodic":[10,null]},"disks":[{"center":[1,5],"radius":1,"velocity":[-2,0]},)"
         R"({"center":[7,5],"radius":1,"velocity":[0,0]}]})";
  must({"simulate", file("b.json"), "-o", file("b.jsonl")});
  const auto both = [&](const std::string& history, const char* truth) {
    return run({"certify", file("b.json"), history, "--truth", truth, "--kernel", "--report",
                file("b.report.json")});
  };
  const Result right = both(file("b.jsonl"), "recorded");
  EXPECT_EQ(right.code, 0) << right.err;
  EXPECT_TRUE(holds(right.out, "c kernel: CERTIFIED\n")) << right.out;
  EXPECT_EQ(json("b.report.json")["kernel"], "CERTIFIED");
  const Result wrong = both(
      edited(file("b.jsonl"), [](auto& lines) { lines.erase(lines.begin() + 1); }), "recorded");
  EXPECT_EQ(wrong.code, 1) << wrong.err;
  EXPECT_TRUE(holds(wrong.out, "c kernel: REFUTED: line 2: disks 0 and 1 at image [-1,0] overlap"))
      << wrong.out;
  const Result exact = both(file("b.jsonl"), "exact");
  EXPECT_EQ(exact.code, 2);
  EXPECT_TRUE(holds(exact.err, "--truth recorded")) << exact.err;
}

TEST_F(SecondChecker, WhatTheProvedCheckerDoesNotDecideIsUndecided) {
  const std::string alone = scene("5", disk("0,0", "1", "1,0"));
  must({"simulate", alone, "-o", file("alone.history.jsonl")});
  const Result result =
      run({"certify", alone, file("alone.history.jsonl"), "--truth", "recorded", "--proved"});
  if (holds(result.err, "is not installed")) GTEST_SKIP() << result.err;
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(holds(result.out, "c proved checker: UNDECIDED: fewer than two disks\n"));
  EXPECT_TRUE(holds(result.err, "the proved checker does not decide it: fewer than two disks"));
}

TEST_F(SecondChecker, WhatIsRefutedStaysRefuted) {
  const Result result = certified(wrong_);
  if (holds(result.err, "is not installed")) GTEST_SKIP() << result.err;
  EXPECT_EQ(result.code, 1) << result.err;
  EXPECT_TRUE(holds(result.out, "c proved checker: UNDECIDED")) << result.out;
}

TEST_F(SecondChecker, OneThatIsNotInstalledIsAnError) {
  move_away();
  ASSERT_EQ(setenv("PATH", "/nowhere:", 1), 0);
  refused({"certify", scene_, history_, "--truth", "recorded", "--proved", "--report", file("r")},
          "--proved: the program voroproof-proved is not installed");
  stand_in("echo 's CERTIFIED'\n");
  EXPECT_EQ(certified(history_).code, 0);
}

TEST_F(SecondChecker, OneInAFolderOfPathIsFound) {
  stand_in("echo 's CERTIFIED'\n");
  std::filesystem::create_directory(file("path"));
  std::filesystem::rename(file("bin/voroproof-proved"), file("path/voroproof-proved"));
  ASSERT_EQ(setenv("PATH", ("/nowhere:" + file("path")).c_str(), 1), 0);
  EXPECT_EQ(certified(history_).code, 0);
}

TEST_F(SecondChecker, WhatItCannotJudgeIsRefused) {
  refused({"certify", scene_, history_, "--proved"}, "judges the recorded truth");
  const Arguments recorded{"certify", scene_, history_, "--truth", "recorded", "--proved"};
  Arguments strict = recorded, collisions = recorded;
  strict.push_back("--strict");
  refused(strict, "knows no --strict");
  collisions.insert(collisions.end(), {"--events", "collisions"});
  refused(collisions, "judges all events");
}

TEST_F(SecondChecker, ItGetsTheSameBytesAndTolerances) {
  stand_in("cat \"$1\" > " + file("scene") + "; cat \"$2\" > " + file("history") +
           "; shift 2; echo \"$@\" > " + file("options") + "; echo 's CERTIFIED'\n");
  const std::string packed = file("packed.history.jsonl.zst");
  must({"simulate", scene_, "-o", packed});
  const Result result =
      certified(packed, {"--tolerance", "1/4000000", "--law-tolerance", "1e-8", "--quiet"});
  EXPECT_EQ(lines_of(result.out).back(), "s CERTIFIED") << result.err;
  EXPECT_EQ(read_file(file("scene")), read_file(scene_));
  EXPECT_EQ(read_file(file("history")), read_file(history_));
  EXPECT_EQ(read_file(file("options")), "--tolerance 1/4000000 --law-tolerance 1/100000000\n");
}

TEST_F(SecondChecker, DisagreementsAreInternalErrorsWithBothVerdictsAndTheFiles) {
  stand_in("echo 's CERTIFIED'\n");
  const Result lax = certified(wrong_);
  EXPECT_EQ(lax.code, 4);
  for (const std::string& part :
       {std::string("the two checkers disagree"), scene_, wrong_,
        std::string("the certifier says REFUTED (line 2: "), std::string("CERTIFIED\n")}) {
    EXPECT_TRUE(holds(lax.err, part)) << part << "\n" << lax.err;
  }
  EXPECT_FALSE(holds(lax.out, "s "));
  stand_in("echo 'c line 7: a wrong letter'; echo 's INVALID'; exit 2\n");
  const Result strict = certified(history_);
  EXPECT_EQ(strict.code, 4);
  EXPECT_TRUE(holds(strict.err,
                    "the certifier says CERTIFIED, the proved checker INVALID: line 7: a wrong "
                    "letter"))
      << strict.err;
}

TEST_F(SecondChecker, TheReasonAndItsLineAreThoseOfTheSecond) {
  stand_in("echo 'c 3 flips'; echo 'c line 5: an edge is not there'; echo 's UNDECIDED'; exit 3\n");
  const Result result = certified(history_, {"--report", file("r.json")});
  EXPECT_EQ(result.code, 3);
  EXPECT_TRUE(holds(result.out, "c proved checker: UNDECIDED: line 5: an edge is not there\n"))
      << result.out;
  EXPECT_TRUE(
      holds(result.err, ": line 5: the proved checker does not decide it: an edge is not there\n"))
      << result.err;
  EXPECT_EQ(json("r.json")["proved_checker"], "UNDECIDED: line 5: an edge is not there");
  EXPECT_EQ(json("r.json")["verdict"], "UNDECIDED");
}

// Whatever becomes of its process, nothing is certified.
TEST_F(SecondChecker, OneThatSaysNothingCertifiesNothing) {
  for (const auto& [script, code, words] :
       {std::tuple{"echo broken >&2; exit 4\n", 4, "ends with exit code 4 and says: broken"},
        std::tuple{"", 4, "ends with exit code 0 and says nothing"},
        std::tuple{"echo 's CERTIFIED'; kill -9 $$\n", 4, "ends with signal 9"},
        std::tuple{"echo 's CERTIFIED'; echo more\n", 4, "says: more"},
        std::tuple{"exit 5\n", 5, "out of memory"},
        std::tuple{"echo 'Fatal error: not enough memory' >&2; exit 2\n", 5, "out of memory"}}) {
    stand_in(script);
    const Result result = certified(history_);
    EXPECT_EQ(result.code, code) << script << result.err;
    EXPECT_TRUE(holds(result.err, words)) << script << result.err;
    EXPECT_FALSE(holds(result.out, "s ")) << result.out;
  }
}

}  // namespace
}  // namespace voroproof::internal
