// The verb minimize: the smallest scene on which a program makes the same mistake.
#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class Minimize : public Cli {
 protected:
  void SetUp() override {
    must({"generate", "reference", "--n", "7", "--seed", "3", "--density", "0.2", "--horizon", "60",
          "-o", file("scene")});
  }
  // An engine that loses its third flip.
  static std::string loses_a_flip() {
    return std::string(VOROPROOF_PROGRAM) +
           " simulate {scene} -o - --quiet | awk '/\"flip\"/ && ++n == 3 {next} {print}' > "
           "{history}";
  }
  Result minimize(const std::string& command, const std::string& output,
                  const Arguments& more = {}) const {
    Arguments words{"minimize",   file("scene"), "--against", command,   "-o",
                    file(output), "--memory",    "0",         "--truth", "exact"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(Minimize, LosesDisksAndKeepsTheMistake) {
  const Result result = minimize(loses_a_flip(), "small");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("refuted: "), std::string::npos) << result.out;
  const Json small = json("small");
  EXPECT_LT(small["disks"].size(), 6u);
  EXPECT_LT(small["horizon"].get<double>(), 60);
  EXPECT_FALSE(small.contains("comment"));
  // Nothing more can be left out.
  std::filesystem::rename(file("small"), file("scene"));
  minimize(loses_a_flip(), "again");
  EXPECT_EQ(json("again"), small);
}

TEST_F(Minimize, IsTheSameSideBySide) {
  // A program that crashes on four disks and more.
  const std::string command = "[ $(grep -c velocity {scene}) -lt 4 ] # {history}";
  minimize(command, "one");
  minimize(command, "three", {"--jobs", "3"});
  EXPECT_EQ(json("one")["disks"].size(), 4u);
  EXPECT_EQ(read_bytes(file("one")), read_bytes(file("three")));
}

TEST_F(Minimize, AProgramThatIsRightIsNoMatter) {
  const Result result =
      minimize(std::string(VOROPROOF_PROGRAM) + " simulate {scene} -o {history} --quiet", "small");
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.err.find("is certified"), std::string::npos) << result.err;
  EXPECT_FALSE(std::filesystem::exists(file("small")));
}

TEST_F(Minimize, ACrashNeedsNoDisks) {
  const Result result = minimize("false {scene} {history}", "small");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(json("small")["disks"].size(), 0u);
  EXPECT_EQ(json("small")["horizon"], 0);
}

// The program's third run interrupts what runs it, which is its parent's parent.
TEST_F(Minimize, AnInterruptionKeepsWhatItCameTo) {
  const std::string runs = file("runs");
  const Result result =
      minimize("echo >> " + runs + "; if [ $(wc -l < " + runs +
                   ") = 3 ]; then kill -INT $(awk '{print $4}' /proc/$PPID/stat); sleep 1000; fi; "
                   "false {scene} {history}",
               "small");
  EXPECT_EQ(result.code, 6) << result.err;
  EXPECT_EQ(run({"validate", file("small")}).code, 0);
}

TEST_F(Minimize, TheCommandNamesBothFiles) {
  EXPECT_EQ(minimize("mysim {scene}", "small").code, 2);
}

}  // namespace
}  // namespace voroproof::internal
