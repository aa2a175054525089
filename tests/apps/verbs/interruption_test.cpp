// Signals at any moment of a command: its files are there whole, or not at all.
#include <csignal>

#include <chrono>
#include <thread>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class Interruption : public Cli {
 protected:
  std::string history(const std::string& scene) const {
    must({"simulate", scene, "-o", file("a.history.jsonl"), "--quiet"});
    return file("a.history.jsonl");
  }

  std::vector<std::string> contents(const std::vector<std::string>& names) const {
    std::vector<std::string> all;
    for (const std::string& name : names) all.push_back(directory_.read(name));
    return all;
  }

  void expect_whole_or_nothing(const Arguments& arguments, const std::vector<std::string>& names) {
    using Clock = std::chrono::steady_clock;
    const std::size_t files = directory_.number_of_files();
    const auto start_of_run = Clock::now();
    ASSERT_EQ(run(arguments).code, 0) << ::testing::PrintToString(arguments);
    const auto length = Clock::now() - start_of_run;
    const std::vector<std::string> whole = contents(names);
    for (const std::string& name : names) std::filesystem::remove(file(name));
    constexpr int moments = 8;
    for (int k = 0; k < moments; ++k) {
      const int signal = k % 2 == 0 ? SIGTERM : SIGINT;
      const pid_t child = start(arguments);
      if (k < moments / 2) {
        std::this_thread::sleep_for(length * k / (moments / 2));
      } else {  // as soon as a file is begun
        siginfo_t ended{};
        while (directory_.number_of_files() == files && ended.si_pid == 0)
          waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
      }
      kill(child, signal);
      const Result result = finish(child);
      if (result.code == 6) {
        EXPECT_EQ(result.err, "voroproof: interrupted\n");
      } else if (result.code != 1000 + signal) {  // which is earlier than its first line
        EXPECT_EQ(result.code, 0) << result.err;
      }
      // Code 6 is right with files where the signal came after all work.
      if (result.code == 0 || std::filesystem::exists(file(names[0]))) {
        EXPECT_EQ(contents(names), whole);
        for (const std::string& name : names) std::filesystem::remove(file(name));
      }
      EXPECT_EQ(directory_.number_of_files(), files) << ::testing::PrintToString(arguments);
    }
  }
};

TEST_F(Interruption, OfQueries) {
  const std::string scene = reference(20, "10"), path = history(scene);
  const std::string answer = file("answer.json");
  expect_whole_or_nothing({"query", "critical", scene, path, "--at", "9", "-o", answer},
                          {"answer.json"});
  expect_whole_or_nothing({"query", "voids-over", scene, path, "--probe", "4", "-o", answer},
                          {"answer.json"});
}

TEST_F(Interruption, OfPlans) {
  expect_whole_or_nothing({"plan", "--preset", "drones58", "-o", file("p.scene.json"), "--report",
                           file("p.json"), "--picture", file("p.png"), "--quiet"},
                          {"p.scene.json", "p.json", "p.png"});
}

TEST_F(Interruption, OfMoviesAndPictures) {
  const std::string scene = reference(60, "60"), path = history(scene);
  expect_whole_or_nothing({"movie", scene, path, "-o", file("m.html")}, {"m.html"});
  const std::string diagram = file("d.json");
  must({"snapshot", scene, path, "--at", "9", "-o", diagram});
  expect_whole_or_nothing({"render", diagram, "--size", "1000", "-o", file("d.png")}, {"d.png"});
}

}  // namespace
}  // namespace voroproof::internal
