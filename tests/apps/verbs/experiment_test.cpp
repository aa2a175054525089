// The verb experiment and the members of the paper's data sets, as a user runs them.
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <random>
#include <thread>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

using ExperimentCli = Cli;

TEST_F(ExperimentCli, WritesJsonAndCsv) {
  const Arguments arguments{"experiment", "restitution", "--scale",      "0.05",  "--horizon",
                            "25",         "-o",          file("r.json"), "--csv", file("r.csv")};
  const Result result = must(arguments);
  EXPECT_EQ(lines_of(result.out).size(), 5u);
  const Json all = json("r.json");
  EXPECT_EQ(all["set"], "restitution");
  ASSERT_EQ(all["members"].size(), 5u);
  for (int k = 0; k < 5; ++k) {
    const Json& member = all["members"][k];
    EXPECT_EQ(member["n"], 15);
    EXPECT_EQ(member["flip_frequency"].size(), 3u);
    std::uint64_t sum = 0;
    for (const Json& count : member["flip_frequency"]) sum += count.get<std::uint64_t>();
    EXPECT_EQ(member["flips"], sum);
    EXPECT_GE(member["predicted"]["flips"], member["flips"]);
  }
  const std::string table = directory_.read("r.csv");
  EXPECT_EQ(lines_of(table).size(), 6u);
  // The table depends on the options alone.
  must(arguments);
  EXPECT_EQ(directory_.read("r.csv"), table);
}

// The rows of several seeds are those of one seed after another, whatever number of threads.
TEST_F(ExperimentCli, RunsSeveralSeedsOnSeveralThreads) {
  const auto table = [&](const Arguments& more, std::string* words = nullptr) {
    Arguments arguments{"experiment", "size",         "--scale", "0.01",          "--horizon",
                        "30",         "--members",    "4",       "--predictions", "off",
                        "-o",         file("r.json"), "--csv",   file("r.csv")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = must(arguments);
    if (words != nullptr) *words = result.out;
    return lines_of(directory_.read("r.csv"));
  };
  std::vector<std::string> expected{table({"--seed", "7"})[0]};
  const std::vector<std::string> first = table({"--seed", "7"}), second = table({"--seed", "8"});
  for (std::size_t k = 1; k < first.size(); ++k) {
    EXPECT_NE(first[k], second[k]);
    expected.insert(expected.end(), {first[k], second[k]});
  }
  std::string words;
  EXPECT_EQ(table({"--seed", "7", "--seeds", "2"}, &words), expected);
  EXPECT_EQ(lines_of(words).size(), 8u);
  EXPECT_EQ(words.find("size 1, seed 7: n 10; flips "), 0u);
  for (const char* threads : {"2", "3", "16"}) {
    std::string same;
    EXPECT_EQ(table({"--seed", "7", "--seeds", "2", "--threads", threads}, &same), expected);
    EXPECT_EQ(same, words);
  }
}

class ResumedExperiment : public ExperimentCli {
 protected:
  Arguments experiment(const Arguments& more = {}) const {
    Arguments arguments{"experiment", "speed", "--scale",       "0.012",      "--horizon", "100",
                        "--seeds",    "2",     "--predictions", "off",        "--threads", "2",
                        "-o",         result_, "--csv",         file("r.csv")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  std::string result_ = file("r.json"), partial_ = file("r.json.partial");
};

// What a limit stops is run again, and nothing else.
TEST_F(ResumedExperiment, TakesUpWhatIsComplete) {
  const std::string words = must(experiment()).out;
  const std::string table = directory_.read("r.csv");
  EXPECT_FALSE(std::filesystem::exists(partial_));
  const Result stopped = run(experiment({"--max-events", "900"}));
  EXPECT_EQ(stopped.code, 3);
  EXPECT_NE(stopped.err.find("stopped at t = "), std::string::npos);
  EXPECT_EQ(json("r.json")["members"].size(), 20u);
  const Json left = json("r.json.partial")["members"];
  EXPECT_GT(left.size(), 2u);
  EXPECT_LT(left.size(), 20u);
  EXPECT_EQ(must(experiment({"--resume"})).out, words);
  EXPECT_EQ(directory_.read("r.csv"), table);
  EXPECT_FALSE(std::filesystem::exists(partial_));
  // The seconds tell which runs were taken over.
  const Json all = json("r.json")["members"];
  for (const Json& member : left) {
    EXPECT_EQ(std::count(all.begin(), all.end(), member), 1) << member["k"] << member["seed"];
  }
}

TEST_F(ResumedExperiment, OfProcessesThatAreKilled) {
  must(experiment());
  const std::string table = directory_.read("r.csv");
  std::mt19937 random(1);
  int killed = 0;
  for (int turn = 0; turn < 200; ++turn) {
    std::filesystem::remove(result_);
    const pid_t child = start(experiment({"--resume"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(1 + random() % 30));
    kill(child, turn % 3 == 0 ? SIGTERM : SIGKILL);
    const Result result = finish(child);
    killed += result.code != 0;
    // What has its name is whole, also where the process was killed when it had just named it.
    if (std::filesystem::exists(result_)) {
      EXPECT_EQ(json("r.json")["members"].size(), 20u);
    }
    if (result.code == 0) {
      EXPECT_EQ(directory_.read("r.csv"), table);
    }
    if (killed >= 20) break;
  }
  EXPECT_GT(killed, 0);
  must(experiment({"--resume"}));
  EXPECT_EQ(directory_.read("r.csv"), table);
}

TEST_F(ResumedExperiment, IsOfTheSameExperiment) {
  EXPECT_EQ(run(experiment({"--max-events", "900"})).code, 3);
  const std::string left = directory_.read("r.json.partial");
  std::filesystem::remove(result_);
  std::filesystem::remove(file("r.csv"));
  const auto refuses = [&](const std::string& message, const std::function<void(Json&)>& what) {
    Json s = Json::parse(left);
    what(s);
    directory_.write("r.json.partial", s.dump());
    refused(experiment({"--resume"}), message);
  };
  refuses("version of the program", [](Json& s) { s["producer"] = "voroproof 0.0.9"; });
  refuses("another set", [](Json& s) { s["set"] = "size"; });
  refuses("another scale", [](Json& s) { s["scale"] = 0.5; });
  refuses("another horizon", [](Json& s) { s["members"][0]["horizon"] = 7; });
  refuses("another choice of predictions", [](Json& s) {
    s["members"][0]["predicted"] = {
        {"flips", 1}, {"flips_before_contact", 1}, {"roots", 1}, {"collisions", 1}};
  });
  refuses("not of an experiment", [](Json& s) { s["members"][0].erase("flips"); });
  refuses("is something else", [](Json& s) { s["format"] = "voroproof-report"; });
  directory_.write("r.json.partial", "precious");
  refused(experiment(), "is something else");
  EXPECT_EQ(directory_.read("r.json.partial"), "precious");
  refused({"experiment", "size", "--scale", "0.01", "--resume", "-o", "-"}, "stream");
  refused({"experiment", "size", "--seed", "18446744073709551615", "--seeds", "2", "-o",
           file("q.json")},
          "--seed");
}

TEST_F(ExperimentCli, RefusesOptionsWithoutMeaning) {
  refused({"experiment", "colour", "-o", file("r.json")}, "colour");
  refused({"experiment", "speed", "--scale", "0", "-o", file("r.json")}, "--scale");
  refused({"experiment", "speed", "--horizon", "0", "-o", file("r.json")}, "--horizon");
  refused({"experiment", "speed", "--horizon", "1e300", "-o", file("r.json")}, "--horizon");
}

TEST_F(ExperimentCli, GeneratesMembersOfDataSets) {
  must({"generate", "reference", "--set", "restitution:2", "--seed", "5", "--horizon", "10", "-o",
        file("a.scene.json")});
  must({"generate", "reference", "--n", "300", "--restitution", "0.7", "--seed", "5", "--horizon",
        "10", "-o", file("b.scene.json")});
  EXPECT_EQ(directory_.read("a.scene.json"), directory_.read("b.scene.json"));
  const auto bad = [&](const std::string& set) {
    refused({"generate", "reference", "--set", set, "-o", file("c.scene.json")}, "--set");
  };
  bad("speed");
  bad("speed:11");
  bad("speed:1x");
  refused({"generate", "reference", "--set", "speed:1", "--n", "3", "-o", file("c.scene.json")},
          "excludes");
}

}  // namespace
}  // namespace voroproof::internal
