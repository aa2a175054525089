// The verb certify, run as a user would, with scenes and histories made for it.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {

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

  std::string written(const std::string& name, const std::string& text) const {
    const std::string path = file(name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  // A scene of disks of mass 1 in a container of radius 100.
  std::string scene(const std::string& horizon, const std::string& disks,
                    const std::string& maneuvers = "") const {
    return written("small.scene.json",
                   R"({"format":"voroproof-scene","version":1,"horizon":)" + horizon +
                       R"(,"container":{"center":[0,0],"radius":100},"disks":[)" + disks +
                       R"(],"maneuvers":[)" + maneuvers + "]}");
  }
  static std::string disk(const std::string& center, const std::string& radius,
                          const std::string& velocity) {
    return R"({"center":[)" + center + R"(],"radius":)" + radius + R"(,"velocity":[)" + velocity +
           R"(],"mass":1})";
  }

  static std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

}  // namespace voroproof::internal
