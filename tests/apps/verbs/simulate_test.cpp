// The verb simulate: its files depend on nothing but the scene, and a run that stops leaves what it
// found.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/apps/verbs/cli.h"
#include "tests/apps/verbs/small_scenes.h"

namespace voroproof::internal {
namespace {

TEST_F(Cli, TheHistoryDependsOnTheSceneAlone) {
  const std::string scene = reference(40, "30");
  const Result first = must({"simulate", scene, "-o", file("a.history.jsonl")});
  EXPECT_EQ(std::count(first.out.begin(), first.out.end(), '\n'), 1);
  const std::string bytes = directory_.read("a.history.jsonl");
  EXPECT_GT(lines_of(bytes).size(), 100u);
  const std::vector<Arguments> variants{{"--threads", "2"},
                                        {"--threads", "8", "--stats", file("stats.json")},
                                        {"--quiet"},
                                        {"--horizon", "30"},
                                        {"--horizon", "0xfp1"}};
  for (const Arguments& variant : variants) {
    Arguments arguments{"simulate", scene, "-o", file("b.history.jsonl")};
    arguments.insert(arguments.end(), variant.begin(), variant.end());
    const Result result = must(arguments);
    EXPECT_TRUE(directory_.read("b.history.jsonl") == bytes) << ::testing::PrintToString(variant);
    EXPECT_EQ(result.out.empty(), variant.front() == "--quiet");
  }
  for (const auto& [name, value] : {std::pair("VOROPROOF_START_BITS", "64"),
                                    {"VOROPROOF_START_BITS", "4096"},
                                    {"VOROPROOF_FILTERS", "off"}}) {
    const Environment set(name, value);
    must({"simulate", scene, "-o", file("b.history.jsonl"), "--stats", file("stats.json")});
    EXPECT_TRUE(directory_.read("b.history.jsonl") == bytes) << name << '=' << value;
    const std::string options = json("stats.json")["options"].dump();
    EXPECT_NE(options.find(value == std::string("off") ? "\"filters\":false" : value),
              options.npos);
  }
}

TEST_F(Cli, TheHorizonMayBeExactAndIsRecorded) {
  const std::string scene = directory_.write("a.scene.json", scene_text(two_disks));
  must({"simulate", scene, "-o", file("a.history.jsonl"), "--horizon", "10/3"});
  const std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl"));
  EXPECT_EQ(Json::parse(lines.front())["horizon"], "10/3");
  EXPECT_DOUBLE_EQ(Json::parse(lines.back())["end"]["t"].is_string()
                       ? 10.0 / 3
                       : Json::parse(lines.back())["end"]["t"].get<double>(),
                   10.0 / 3);
  must({"validate", file("a.history.jsonl")});
  // A prefix of what a longer run says: the same events up to there.
  must({"simulate", scene, "-o", file("b.history.jsonl")});
  const std::vector<std::string> longer = lines_of(directory_.read("b.history.jsonl"));
  ASSERT_LE(lines.size(), longer.size());
  EXPECT_TRUE(std::equal(lines.begin() + 1, lines.end() - 1, longer.begin() + 1));
}

TEST_F(Cli, StatisticsAgreeWithTheHistory) {
  const std::string scene = reference(30, "20");
  must({"simulate", scene, "-o", file("a.history.jsonl"), "--stats", file("stats.json"),
        "--threads", "2"});
  std::int64_t flips = 0, wall = 0, disks = 0;
  for (const std::string& line : lines_of(directory_.read("a.history.jsonl"))) {
    const Json event = Json::parse(line);
    flips += event.contains("flip");
    if (event.contains("collide")) ++(event["collide"][0] == -1 ? wall : disks);
  }
  EXPECT_GT(flips, 0);
  EXPECT_GT(wall, 0);
  EXPECT_GT(disks, 0);
  const Json stats = json("stats.json");
  EXPECT_EQ(stats["outcome"], "complete");
  EXPECT_EQ(stats["disks"], 30);
  EXPECT_EQ(stats["events"]["flips"]["all"], flips);
  std::int64_t sum = 0;
  for (const auto& [kind, number] : stats["events"]["flips"].items()) {
    if (kind != "all") sum += number.get<std::int64_t>();
  }
  EXPECT_EQ(sum, flips);
  EXPECT_EQ(stats["events"]["collisions"]["container"], wall);
  EXPECT_EQ(stats["events"]["collisions"]["disks"], disks);
  EXPECT_GE(stats["predicted"]["flips"], flips);
  EXPECT_GE(stats["predicted"]["collisions"], wall + disks);
  EXPECT_EQ(stats["options"]["threads"], 2);
  for (const char* step : {"step1_flip_times", "step2_collision_times", "step3_queue", "step4_move",
                           "initial_diagram"}) {
    EXPECT_GT(stats["seconds"][step], 0) << step;
    EXPECT_LT(stats["seconds"][step], stats["seconds"]["total"]) << step;
  }
}

TEST_F(Cli, ARunThatStopsSaysWhere) {
  // The disk loses the normal part of its velocity at ever shorter intervals.
  const std::string scene = directory_.write("lone.scene.json",
                                             R"({"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 10, "restitution": 0.5}, "horizon": 1000,
 "disks": [{"center": [3, 0], "radius": 1, "velocity": [0.25, 1]}]})");
  const std::string history = file("a.history.jsonl");
  const Result result = run({"simulate", scene, "-o", history, "--stats", file("stats.json")});
  EXPECT_EQ(result.code, 3);
  EXPECT_EQ(result.err.rfind("voroproof: stopped at t = ", 0), 0u) << result.err;
  EXPECT_EQ(lines_of(result.err).size(), 1u);
  const std::vector<std::string> lines = lines_of(directory_.read("a.history.jsonl"));
  const Json stop = Json::parse(lines.back())["stopped"];
  EXPECT_NE(stop["reason"].get<std::string>().find("inelastic collapse"), std::string::npos);
  EXPECT_LT(stop["t"], 1000);
  EXPECT_GT(lines.size(), 10u);
  EXPECT_EQ(json("stats.json")["outcome"], "stopped");
  EXPECT_EQ(json("stats.json")["reason"], stop["reason"]);
  must({"validate", history});

  // Before the stop there are diagrams, from then on there are none.
  const std::string out = file("a.diagram.json");
  must({"snapshot", scene, history, "--at", "1", "-o", out});
  refused({"snapshot", scene, history, "--at", "999", "-o", file("b")}, "stopped.t: ");
  refused({"snapshot", scene, history, "--at", Json(stop["t"]).dump(), "-o", file("b")},
          "stopped.t: ");
  const Result beyond = run({"snapshot", scene, "--at", "999", "-o", file("b")});
  EXPECT_EQ(beyond.code, 3);
  EXPECT_NE(beyond.err.find("inelastic collapse"), std::string::npos) << beyond.err;
  EXPECT_FALSE(std::filesystem::exists(file("b")));
}

TEST_F(Cli, AnInterruptedRunLeavesAHistoryUpToThere) {
  // More events than anyone waits for, and each soon done: fewer disks soon need so many bits that
  // an event may take as long as a run has to end by itself.
  const std::string scene = reference(2000, "1e5");
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string history = file("a.history.jsonl");
    const pid_t child =
        start({"simulate", scene, "-o", history, "--max-bits", "10000000", "--threads", "2"});
    // Signals are handled when the output has been begun, under a name for the time being.
    while (directory_.number_of_files() < 2) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ASSERT_EQ(waitpid(child, nullptr, WNOHANG), 0);
    }
    // As timeout(1) does: its signal comes twice, or more often here.
    for (int k = 0; k < 200; ++k) kill(child, signal);
    const Result result = finish(child);
    EXPECT_EQ(result.code, 6);
    EXPECT_EQ(result.err.rfind("voroproof: interrupted at t = ", 0), 0u) << result.err;
    EXPECT_EQ(directory_.number_of_files(), 2u);
    const Json last = Json::parse(lines_of(directory_.read("a.history.jsonl")).back());
    EXPECT_EQ(last["stopped"]["reason"], "interrupted");
    must({"validate", history});
    std::filesystem::remove(history);
  }
}

// A complete history is worth more than the beginning of the same one.
TEST_F(Cli, ARunThatStopsLeavesACompleteHistoryAlone) {
  const std::string scene = reference(30, "50"), history = file("a.history.jsonl");
  must({"simulate", scene, "-o", history});
  const std::string complete = directory_.read("a.history.jsonl");
  const Result result = run({"simulate", scene, "-o", history, "--max-events", "5"});
  EXPECT_EQ(result.code, 3);
  EXPECT_NE(result.err.find("a.history.jsonl: is complete and stays"), std::string::npos)
      << result.err;
  EXPECT_EQ(directory_.read("a.history.jsonl"), complete);
  const std::string begun = directory_.read("a.history.jsonl.partial");
  EXPECT_NE(lines_of(begun).back().find("stopped"), std::string::npos);
  // Again: what stopped is replaced by what stopped. And where it is asked for, the complete one.
  EXPECT_EQ(run({"simulate", scene, "-o", history, "--max-events", "3"}).code, 3);
  EXPECT_NE(directory_.read("a.history.jsonl.partial"), begun);
  EXPECT_EQ(run({"simulate", scene, "-o", history, "--max-events", "5", "--replace"}).code, 3);
  EXPECT_EQ(directory_.read("a.history.jsonl"), begun);
  // A complete run replaces whatever there is.
  must({"simulate", scene, "-o", history});
  EXPECT_EQ(directory_.read("a.history.jsonl"), complete);
}

TEST_F(Cli, OutOfMemory) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more address space than the test leaves";
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  GTEST_SKIP() << "sanitizers need more address space than the test leaves";
#endif
#endif
  // Enough for the program itself.
  const auto limited = [&](const std::string& arguments) {
    const std::string command = "ulimit -v 65536; '" VOROPROOF_PROGRAM "' " + arguments + " 2> '" +
                                streams_.file("err") + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  };
  EXPECT_EQ(limited("generate grid --n 2000000 -o '" + file("a.scene.json") + "'"), 5);
  EXPECT_EQ(streams_.read("err"), "voroproof: out of memory\n");
  EXPECT_EQ(directory_.number_of_files(), 0u);
  // Here it is the numbers that find no memory.
  const Environment bits("VOROPROOF_START_BITS", "16000000");
  const std::string scene = reference(100, "30");
  EXPECT_EQ(
      limited("simulate '" + scene + "' -o '" + file("a.history.jsonl") + "' --max-bits 16000000"),
      5);
  EXPECT_EQ(streams_.read("err"), "voroproof: out of memory\n");
  EXPECT_EQ(directory_.number_of_files(), 1u);
}

}  // namespace
}  // namespace voroproof::internal
