// certify and simulate for many scenes.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class Lists : public Cli {
 protected:
  std::string scene(const std::string& name, const std::string& seed,
                    const std::string& horizon = "20") const {
    const std::string path = file(name + ".scene.json");
    must({"generate", "reference", "--n", "8", "--seed", seed, "--horizon", horizon, "--density",
          "0.2", "-o", path});
    return path;
  }
  std::string history(const std::string& name) const { return file(name + ".history.jsonl"); }
  std::string line(const std::string& name) const {
    return file(name + ".scene.json") + '\t' + history(name) + '\n';
  }

  // A list of three scenes.
  std::string three() const {
    scene("a", "1");
    scene("b", "2");
    scene("c", "3");
    return directory_.write("list", "# three\n\n" + line("a") + line("b") + line("c"));
  }
  Arguments verdicts(const Json& table) const {
    Arguments all;
    for (const Json& row : table["rows"]) all.push_back(row["verdict"]);
    return all;
  }
};

// Leaves out the line of the first flip.
std::string without_flip(std::string text) {
  const std::size_t flip = text.find("\"flip\"");
  const std::size_t begin = text.rfind('\n', flip), end = text.find('\n', flip);
  return text.erase(begin, end - begin);
}

TEST_F(Lists, EveryRunHasItsRowAndTheWorstIsTheExitCode) {
  const std::string list = three();
  const Result simulated = must({"simulate", "--list", list, "--json", file("s.json")});
  EXPECT_EQ(lines_of(simulated.out).back(), "c 3 scenes: 3 COMPLETE");
  EXPECT_EQ(verdicts(json("s.json")), (Arguments{"COMPLETE", "COMPLETE", "COMPLETE"}));
  // The histories are those of single runs.
  must({"simulate", file("b.scene.json"), "-o", file("single"), "--quiet"});
  EXPECT_EQ(directory_.read("single"), read_bytes(history("b")));
  const Result good = must({"certify", "--list", list, "--json", file("good.json")});
  EXPECT_EQ(lines_of(good.out).back(), "c 3 scenes: 3 CERTIFIED");

  directory_.write("b.history.jsonl", without_flip(read_bytes(history("b"))));
  std::filesystem::remove(history("c"));
  const Result bad = run(
      {"certify", "--list", list, "--json", file("c.json"), "--csv", file("c.csv"), "--jobs", "2"});
  EXPECT_EQ(bad.code, 1) << bad.err;
  EXPECT_EQ(verdicts(json("c.json")), (Arguments{"CERTIFIED", "REFUTED", "INVALID"}));
  EXPECT_NE(json("c.json")["rows"][1]["reason"].get<std::string>().find("line "),
            std::string::npos);
  EXPECT_NE(json("c.json")["rows"][2]["reason"].get<std::string>().find("cannot read"),
            std::string::npos);
  const Arguments csv = lines_of(directory_.read("c.csv"));
  ASSERT_EQ(csv.size(), 4u);
  EXPECT_EQ(csv[0], "scene,history,verdict,exit_code,events,t,reason,says\r");
  EXPECT_EQ(csv[1].rfind(file("a.scene.json") + ',' + history("a") + ",CERTIFIED,0,", 0), 0u);
  EXPECT_NE(csv[1].find(",20,"), std::string::npos) << csv[1];
  // The order of the rows is that of the list, however many run side by side.
  const Result again = run({"certify", "--list", list, "--json", file("d.json")});
  EXPECT_EQ(directory_.read("d.json"), directory_.read("c.json"));
  directory_.write("list", line("a") + line("c"));
  EXPECT_EQ(run({"certify", "--list", list}).code, 2);
}

// A table says of each verdict what it is about, and what was accepted.
TEST_F(Lists, SayWhatTheVerdictsAreAbout) {
  const std::string list = three();
  must({"simulate", "--list", list});
  const Arguments words{"certify", "--list",       list,    "--events",   "collisions",
                        "--json",  file("c.json"), "--csv", file("c.csv")};
  for (const char* time : {"first", "kept"}) {
    const Result out = must(words);
    EXPECT_EQ(lines_of(out.out).back(), "c 3 scenes: 3 CERTIFIED (collisions alone)") << time;
    for (const Json& row : json("c.json")["rows"]) {
      EXPECT_EQ(row["verdict"], "CERTIFIED (collisions alone)");
      EXPECT_EQ(row["says"][0].get<std::string>().rfind("collisions and maneuvers, exact", 0), 0u);
      EXPECT_EQ(row["says"][1].get<std::string>().rfind("flips were not judged", 0), 0u);
    }
    EXPECT_NE(lines_of(directory_.read("c.csv"))[1].find("flips were not judged"),
              std::string::npos);
  }
}

TEST_F(Lists, RowsOfTheSameFilesAndOptionsAreKept) {
  const std::string list = three(), table = file("c.json");
  must({"simulate", "--list", list});
  must({"certify", "--list", list, "--json", table});
  // A row that is kept says what the table said, be it true or not.
  const auto mark = [&] {
    Json marked = json("c.json");
    for (Json& row : marked["rows"]) row["events"] = 12345;
    directory_.write("c.json", marked.dump());
  };
  const auto kept = [&](const Arguments& more) {
    mark();
    Arguments words{"certify", "--list", list, "--json", table};
    words.insert(words.end(), more.begin(), more.end());
    run(words);
    Arguments names;
    const Json now = json("c.json");
    for (const Json& row : now["rows"]) {
      names.push_back(row["events"] == 12345 ? "kept" : "run");
    }
    return names;
  };
  EXPECT_EQ(kept({}), (Arguments{"kept", "kept", "kept"}));
  EXPECT_EQ(kept({"--time-limit", "100", "--jobs", "2"}), (Arguments{"kept", "kept", "kept"}));
  EXPECT_EQ(kept({"--strict"}), (Arguments{"run", "run", "run"}));
  must({"certify", "--list", list, "--json", table, "--strict"});
  directory_.write("b.history.jsonl", without_flip(read_bytes(history("b"))));
  EXPECT_EQ(kept({"--strict"}), (Arguments{"kept", "run", "kept"}));
  // Compression does not change a content.
  std::filesystem::remove(history("c"));
  EXPECT_EQ(kept({"--strict"}), (Arguments{"kept", "kept", "run"}));
}

TEST_F(Lists, SimulatedHistoriesThatAreThereAreKept) {
  const std::string list = three(), table = file("s.json");
  must({"simulate", "--list", list, "--json", table});
  const auto before = std::filesystem::last_write_time(history("a"));
  std::filesystem::remove(history("b"));
  directory_.write("c.history.jsonl", "something else");
  must({"simulate", "--list", list, "--json", table});
  EXPECT_EQ(std::filesystem::last_write_time(history("a")), before);
  for (const std::string name : {"b", "c"}) must({"validate", history(name)});
}

// A limit of the whole would leave nothing for the second run.
TEST_F(Lists, LimitsAreThoseOfEachRun) {
  scene("a", "1", "1000000");
  scene("b", "2", "1000000");
  const std::string list = directory_.write("list", line("a") + line("b"));
  const Result result =
      run({"simulate", "--list", list, "--json", file("s.json"), "--time-limit", "1/2"});
  EXPECT_EQ(result.code, 3) << result.err;
  const Json table = json("s.json");
  EXPECT_EQ(verdicts(table), (Arguments{"STOPPED", "STOPPED"}));
  for (const Json& row : table["rows"]) {
    EXPECT_NE(row["reason"].get<std::string>().find("the time limit"), std::string::npos) << row;
  }
}

TEST_F(Lists, ASignalLeavesATableThatIsContinued) {
  scene("a", "1");
  scene("b", "2", "1000000");
  const std::string list = directory_.write("list", line("a") + line("b"));
  const pid_t child = start({"simulate", "--list", list, "--json", file("s.json")});
  // The second run begins once the first has its row.
  const auto second_has_begun = [&] {
    for (const auto& entry : std::filesystem::directory_iterator(file(""))) {
      if (entry.path().filename().string().starts_with("b.history")) return true;
    }
    return false;
  };
  while (!second_has_begun()) usleep(1000);
  kill(child, SIGTERM);
  EXPECT_EQ(finish(child).code, 6);
  EXPECT_EQ(verdicts(json("s.json")), (Arguments{"COMPLETE", "INTERRUPTED"}));
  // The run that was ended has written what it had reached, and what it takes to go on.
  must({"validate", history("a")});
  EXPECT_NE(read_bytes(history("b")).find("\"stopped\""), std::string::npos);
  for (const auto& entry : std::filesystem::directory_iterator(file(""))) {
    EXPECT_NE(entry.path().extension(), ".tmp");
  }
}

// A row whose file has no end, or nobody writes to, is ended by its own limit.
TEST_F(Lists, PipesAndEndlessDevicesEndWithTheirRuns) {
  scene("a", "1");
  const std::string pipe = file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string first = file("a.scene.json");
  const std::string list = directory_.write(
      "list", first + '\t' + pipe + '\n' + first + "\t/dev/zero\n/dev/zero\t" + pipe + '\n');
  const Result result = run(
      {"certify", "--list", list, "--time-limit", "1/4", "--jobs", "3", "--json", file("c.json")});
  for (const std::string& verdict : verdicts(json("c.json"))) {
    EXPECT_TRUE(verdict == "UNDECIDED" || verdict == "INVALID") << verdict << result.err;
  }
  // The list itself: nobody writes it.
  const Result waited = run({"certify", "--list", pipe, "--time-limit", "1/4"});
  EXPECT_EQ(waited.code, 3) << waited.err;
  EXPECT_NE(waited.err.find("the time limit"), std::string::npos) << waited.err;
}

TEST_F(Lists, BadListsAndOptionsAreRefused) {
  const std::string list = three();
  refused({"certify", "--list", directory_.write("one", "only-one\n")}, "one:1: not the names");
  for (const char* verb : {"certify", "simulate"}) {
    refused({verb, "--list", directory_.write("empty", "")}, "empty: names no scene and history");
    refused({verb, "--list", directory_.write("blank", "# a\n\n")}, "names no scene and history");
  }
  refused({"certify", "--list", directory_.write("tabs", "# x\na\tb\tc\n")},
          "tabs:2: not the names");
  refused({"simulate", "--list", directory_.write("twice", "a h\nb h\n")},
          "h is named for two histories to write");
  refused({"certify", "--list", list, file("a.scene.json")}, "--list");
  refused({"certify", "--list", list, "--report", file("r")}, "--list");
  refused({"certify", "a", "b", "--jobs", "2"}, "--list");
  refused({"certify", "a"}, "history is required (see voroproof certify --help)");
  refused({"certify", "--list", list, "--json", list}, "is an input as well as an output");
  refused({"certify", "--list", list, "--json", directory_.write("other.json", "{}")},
          "other.json: not a table of certify");
}

}  // namespace
}  // namespace voroproof::internal
