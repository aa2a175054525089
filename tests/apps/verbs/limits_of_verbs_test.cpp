// The user's limits on every verb that computes: each ends a run that would exceed it.
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

// A command that computes, and what ends it. Words that begin with @ are files of the test; out is
// the one that the command writes.
struct Computing {
  std::string verb;
  std::string many_events;  // a command for which two events are not enough
  std::string many_bits;    // a command for which 64 bits are not enough; empty: no such option
  std::string much_memory;  // a command for which a megabyte is not enough
  bool has_result = false;  // whether it writes what it has when it reaches a limit
};

// The rest of a command of the verb about an instant or a window of time.
Computing query(const std::string& name, const std::string& of_instant, const std::string& more) {
  const std::string verb = "query " + name, end = of_instant.empty() ? more : " " + more;
  const auto command = [&](const std::string& files, const std::string& t) {
    return verb + " " + files + (of_instant.empty() ? " " : " --at " + t) + end + " -o @out";
  };
  const std::string tie = "@tie.scene.json @tie.history.jsonl";
  return {verb, command("@a.scene.json @a.history.jsonl", "15"),
          command(of_instant.empty() ? tie : "@tie.scene.json", "0"),
          command("@large.scene.json @a.history.jsonl", "15")};
}

const std::string at = "at";

std::vector<Computing> computing_verbs() {
  const std::string a = " @a.scene.json @a.history.jsonl ",
                    tie = " @tie.scene.json @tie.history.jsonl ",
                    large = " @large.scene.json @a.history.jsonl ";
  return {
      {"simulate", "simulate @a.scene.json -o @out --quiet",
       "simulate @a.scene.json -o @out --quiet", "simulate @large.scene.json -o @out --quiet",
       true},
      {"certify", "certify" + a + "--report @out", "certify" + a + "--report @out",
       "certify" + large + "--report @out", true},
      {"snapshot", "snapshot" + a + "--at 15 -o @out", "snapshot @tie.scene.json --at 0 -o @out",
       "snapshot @large.scene.json --at 0 -o @out"},
      query("nearest", at, "--point 0 0"),
      query("neighbours", at, "--disk 1"),
      query("closest", at, ""),
      query("offset", at, "--probe 1/2"),
      query("voids", at, "--probe 1/2"),
      query("critical", at, ""),
      query("neighbours-over", "", "--disk 1"),
      query("gap-over", "", "--pair 0 1"),
      query("closest-over", "", ""),
      query("tunnel", "", "--pair 0 1 --probe 1/2"),
      query("void", "", "--vertex 0 1 -1 --probe 1/2"),
      query("voids-over", "", "--probe 1/2"),
      {"movie", "movie" + a + "-o @out", "movie" + tie + "-o @out", "movie" + large + "-o @out"},
      {"clearance", "clearance" + a + "-o @out", "clearance" + tie + "-o @out",
       "clearance" + large + "-o @out"},
      {"index", "index" + a + "-o @out", "", "index" + large + "-o @out"},
      {"convert", "convert @a.history.jsonl --scene @a.scene.json --format evtsq -o @out", "",
       "convert @large.scene.json --format disks -o @out"},
  };
}

// Why a verb lacks --max-events, --max-bits or both. docs/trust.md says so.
const std::map<std::string, std::string> lacks_bits{
    {"convert",
     "it decides nothing from rounded numbers: its fractions are exact, and their size "
     "is bounded by that of the file's"},
    {"index",
     "it judges nothing; where the history lacks its first diagram that is constructed by the "
     "certifier's usual options"},
};
const std::map<std::string, std::string> lacks_both{
    {"plan", "it computes no history, in fractions whose size is bounded by that of the plan's"},
    {"generate reference", "scenes have no events, and are drawn in binary64"},
    {"generate grid", "as generate reference"},
    {"generate swarm", "as generate reference"},
    {"generate formation", "as generate reference"},
    {"diagram", "disks at rest have no events, and their predicates few bits"},
    {"render", "it draws a diagram that is given, in binary64"},
    {"page", "it writes a page that is the same each time"},
    {"explain", "it puts a report into words"},
    {"validate", "it reads each file once and computes nothing"},
    {"corpus list", "it reads the cases once and computes nothing"},
    {"corpus show", "as corpus list"},
    {"truth", "its questions are of few generators with few bits"},
    {"corpus run",
     "each run of a program and each certification has --timeout and --memory; the "
     "verdicts of the cases are those of the certifier's usual options"},
    {"minimize", "as corpus run"},
    {"help", "it computes nothing"},
};

class LimitsOfVerbs : public Cli {
 protected:
  void SetUp() override {
    must({"generate", "reference", "--n", "30", "--seed", "3", "--horizon", "20", "--density",
          "0.2", "-o", file("a.scene.json")});
    must({"simulate", file("a.scene.json"), "-o", file("a.history.jsonl"), "--quiet"});
    must({"generate", "grid", "--n", "5000", "-o", file("large.scene.json")});
    // Four disks on one circle, by numbers of 60 digits, in a history without its first diagram.
    const std::string x = "3." + std::string(60, '3') + "1", y = "1." + std::string(60, '1') + "7";
    const auto disk = [](const std::string& u, const std::string& v) {
      return R"({"center":[")" + u + R"(",")" + v + R"("],"radius":1,"velocity":[0,0]})";
    };
    directory_.write("tie.scene.json", R"({"format":"voroproof-scene","version":1,"horizon":4,)"
                                       R"("container":{"center":[0,0],"radius":10},"disks":[)" +
                                           disk(x, y) + "," + disk("-" + y, x) + "," +
                                           disk("-" + x, "-" + y) + "," + disk(y, "-" + x) + "]}");
    must({"simulate", file("tie.scene.json"), "-o", file("tie.history.jsonl"), "--quiet"});
    std::string history = directory_.read("tie.history.jsonl");
    const std::size_t from = history.find(",\"initial\"");
    directory_.write("tie.history.jsonl", history.erase(from, history.find("]]") + 2 - from));
    files_ = directory_.number_of_files();
  }

  Result limited(const std::string& command, const std::string& option,
                 const std::string& value) const {
    std::istringstream in(command);
    Arguments arguments;
    for (std::string word; in >> word;) {
      arguments.push_back(word.front() == '@' ? file(word.substr(1)) : word);
    }
    arguments.push_back(option);
    arguments.push_back(value);
    return run(arguments);
  }

  // Ends undecided for this reason, which the result has, if there is one.
  void expect_end(const std::string& command, bool has_result, const std::string& option,
                  const std::string& value, const std::string& reason) const {
    const Result result = limited(command, option, value);
    const std::string shown = command + " " + option + " " + value;
    EXPECT_EQ(result.code, 3) << shown << result.err;
    EXPECT_EQ(lines_of(result.err).size(), 1u) << shown << result.err;
    EXPECT_NE(result.err.find(reason), std::string::npos) << shown << result.err;
    EXPECT_EQ(directory_.number_of_files(), files_ + has_result) << shown;
    if (!has_result) return;
    EXPECT_NE(directory_.read("out").find(reason), std::string::npos) << shown;
    std::filesystem::remove(file("out"));
  }

  std::size_t files_ = 0;
};

TEST_F(LimitsOfVerbs, OfEvents) {
  for (const Computing& c : computing_verbs()) {
    const std::string reason = c.verb == "certify" ? "the limit of 2 events" : "more than 2 events";
    expect_end(c.many_events, c.has_result, "--max-events", "2", reason);
  }
}

// As many as allowed are no reason to stop, in either format.
TEST_F(LimitsOfVerbs, OfEventsAsManyAsThereAre) {
  must(
      {"convert", file("a.history.jsonl"), "--scene", file("a.scene.json"), "-o", file("a.evtsq")});
  const std::size_t events = lines_of(directory_.read("a.history.jsonl")).size() - 2;
  for (const std::string from : {"a.history.jsonl", "a.evtsq"}) {
    const std::string to = from == "a.evtsq" ? "history" : "evtsq";
    const std::string command =
        "convert @" + from + " --scene @a.scene.json --format " + to + " -o @out";
    EXPECT_EQ(limited(command, "--max-events", std::to_string(events - 1)).code, 3) << from;
    EXPECT_EQ(directory_.number_of_files(), files_ + 1);
    EXPECT_EQ(limited(command, "--max-events", std::to_string(events)).code, 0) << from;
    std::filesystem::remove(file("out"));
  }
}

TEST_F(LimitsOfVerbs, OfBits) {
  for (const Computing& c : computing_verbs()) {
    if (!c.many_bits.empty()) {
      expect_end(c.many_bits, c.has_result, "--max-bits", "64", " bits");
    }
  }
}

// So short a time, or so little memory, that there is no result yet.
TEST_F(LimitsOfVerbs, OfTimeAndMemory) {
  for (const Computing& c : computing_verbs()) {
    expect_end(c.many_events, false, "--time-limit", "1e-6", "the time limit is reached");
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    expect_end(c.much_memory, false, "--max-memory", "1", "the memory limit");
#endif
  }
}

// Each limit is an option of each verb, or it is said why not.
TEST_F(LimitsOfVerbs, AreOptionsOfEveryVerbThatComputes) {
  std::map<std::string, bool> has_bits;
  for (const Computing& c : computing_verbs()) has_bits[c.verb] = !c.many_bits.empty();
  std::set<std::string> seen;
  const std::function<void(const Json&, const std::string&)> see = [&](const Json& verb,
                                                                       const std::string& name) {
    for (const Json& below : verb["verbs"]) {
      const std::string word = below["name"];
      see(below, name.empty() ? word : name + " " + word);
    }
    if (!verb["verbs"].empty()) return;
    std::set<std::string> options;
    for (const Json& option : verb["options"]) options.insert(option["names"].back());
    const bool computes = has_bits.contains(name);
    EXPECT_NE(computes, lacks_both.contains(name)) << name;
    EXPECT_EQ(options.contains("--max-events"), computes) << name;
    EXPECT_EQ(options.contains("--max-bits"), computes && has_bits[name]) << name;
    EXPECT_NE(computes && has_bits[name], lacks_bits.contains(name) || !computes) << name;
    EXPECT_EQ(options.contains("--time-limit"), name != "help") << name;
    EXPECT_EQ(options.contains("--max-memory"), name != "help") << name;
    seen.insert(name);
  };
  see(Json::parse(must({"help", "--json"}).out), "");
  EXPECT_EQ(seen.size(), has_bits.size() + lacks_both.size());
}

}  // namespace
}  // namespace voroproof::internal
