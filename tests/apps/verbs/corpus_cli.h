// The verb corpus on a small corpus that is made for the test.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {

// Six small cases: two in general position, three with ties, one made to be undecided.
class CorpusCli : public Cli {
 protected:
  void SetUp() override {
    add("generic", "three",
        {"reference", "--n", "3", "--seed", "1", "--density", "0.2", "--horizon", "20"});
    add("generic", "eight",
        {"reference", "--n", "8", "--seed", "2", "--density", "0.2", "--horizon", "20"});
    add("ties", "lattice-at-rest", {"grid", "--n", "9", "--motion", "rest", "--horizon", "1"});
    add("ties", "lattice-shears", {"grid", "--n", "9", "--motion", "shear", "--horizon", "5"});
    add("ties", "formation", {"swarm", "--n", "6", "--horizon", "20"});
    write("cases/stops/slide/scene.scene.json",
          R"({"format":"voroproof-scene","version":1,"container":{"center":[0,0],"radius":10},)"
          R"("horizon":6,"disks":[{"center":[0,5],"radius":1,"velocity":[0,1]},)"
          R"({"center":[0,-5],"radius":2,"velocity":[0,0]}],)"
          R"("maneuvers":[{"t":4,"disk":0,"velocity":[1,0]}]})");
    EXPECT_EQ(run({"simulate", path("stops/slide/scene.scene.json"), "-o",
                   path("stops/slide/exact.history.jsonl")})
                  .code,
              3);
    describe("stops", "slide", Json::array(), Json::array(), "undecided");
  }

  std::string cases() const { return file("cases"); }
  std::string path(const std::string& name) const { return cases() + "/" + name; }

  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(std::filesystem::path(file(name)).parent_path());
    std::ofstream(file(name), std::ios::binary) << bytes;
  }

  void describe(const std::string& family, const std::string& name, const Json& instants,
                const Json& wrong, const std::string& verdict = "certified") const {
    const Json story = "The story of " + name + ": <b>ties</b> & \"symmetry\".";
    const Json all = {{"format", "voroproof-case"},
                      {"version", 1},
                      {"name", name},
                      {"family", family},
                      {"tags", {"tag-" + name}},
                      {"story", story},
                      {"verdict", verdict},
                      {"instants", instants},
                      {"truth", {"by hand"}},
                      {"wrong", wrong}};
    write("cases/" + family + "/" + name + "/case.json", all.dump());
  }

  void add(const std::string& family, const std::string& name, Arguments generate) const {
    const std::string folder = family + "/" + name + "/";
    std::filesystem::create_directories(path(folder + "wrong"));
    const std::string scene = path(folder + "scene.scene.json");
    generate.insert(generate.begin(), "generate");
    generate.insert(generate.end(), {"-o", scene});
    must(generate);
    const std::string history = path(folder + "exact.history.jsonl");
    must({"simulate", scene, "-o", history, "--quiet"});
    must({"snapshot", scene, "--at", "1/3", "-o", path(folder + "diagram-0.diagram.json")});
    must({"render", path(folder + "diagram-0.diagram.json"), "-o", path(folder + "picture.svg")});
    std::vector<std::string> lines = lines_of(read_bytes(history));
    Json wrong = Json::array();
    for (std::size_t k = lines.size() - 2; k > 0 && wrong.empty(); --k) {
      if (lines[k].find("flip") == std::string::npos) continue;
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
      std::string text;
      for (const std::string& line : lines) text += line + '\n';
      write("cases/" + folder + "wrong/dropped-flip.history.jsonl", text);
      wrong.push_back({{"file", "wrong/dropped-flip.history.jsonl"},
                       {"class", "dropped-flip"},
                       {"kind", "missing event"},
                       {"truth", "exact"}});
    }
    describe(family, name, {"1/3"}, wrong);
  }

  // `corpus run` on these cases, its JSON in report.json. Without a limit of memory, which
  // sanitizers do not bear.
  Arguments run_words(const Arguments& more) const {
    Arguments words{"corpus", "run", "--corpus", cases(), "--json", file("report.json")};
    if (std::find(more.begin(), more.end(), "--memory") == more.end()) {
      words.insert(words.end(), {"--memory", "0"});
    }
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  Result run_corpus(const Arguments& more = {}) const {
    const Result result = run(run_words(more));
    EXPECT_EQ(result.err, "");
    return result;
  }

  // The same against a command, with one case.
  Json against(const std::string& command, const std::string& name, Arguments more = {}) const {
    more.insert(more.end(), {"--against", command, "--case", name});
    const Result result = run_corpus(more);
    const Json report = json("report.json");
    EXPECT_EQ(report["results"].size(), 1u);
    const Json found = report["results"][0];
    EXPECT_EQ(result.code, found["passed"].get<bool>() ? 0 : 1) << result.out;
    return found;
  }

  // How many cases of a family ended so, by the report's own counts.
  int count(const std::string& family, const std::string& outcome) const {
    const Json report = json("report.json");
    for (const Json& f : report["families"]) {
      if (f["family"] == family) return f["outcomes"][outcome];
    }
    ADD_FAILURE() << family;
    return -1;
  }

  static std::string simulate() {
    return std::string(VOROPROOF_PROGRAM) + " simulate {scene} -o {history} --quiet";
  }
  static std::string example() { return std::string(VOROPROOF_EXAMPLE) + " {scene} {history}"; }
};

}  // namespace voroproof::internal
