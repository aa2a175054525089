// The program, run as a user would.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/history/temporary_directory.h"

namespace voroproof::internal {

using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

struct Result {
  int code = -1;  // of the exit; 1000 + signal where one killed it
  std::string out, err;
};

// A variable of the environment while it lives.
class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;
  ~Environment() { unsetenv(name_); }

 private:
  const char* name_;
};

class Cli : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return directory_.file(name); }

  // Starts the program, its output going to the files `out` and `err`.
  pid_t start(const Arguments& arguments) const {
    std::vector<char*> words{const_cast<char*>(program_.c_str())};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const std::string out = streams_.file("out"), err = streams_.file("err");
    const pid_t child = fork();
    if (child == 0) {
      constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
      dup2(open(out.c_str(), flags, 0600), STDOUT_FILENO);
      dup2(open(err.c_str(), flags, 0600), STDERR_FILENO);
      execv(program_.c_str(), words.data());
      _exit(127);
    }
    return child;
  }

  Result finish(pid_t child) const {
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), streams_.read("out"),
            streams_.read("err")};
  }

  Result run(const Arguments& arguments) const { return finish(start(arguments)); }

  // Runs what must go well.
  Result must(const Arguments& arguments) const {
    Result result = run(arguments);
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    return result;
  }

  // Runs what must be refused with one line, and leave no file behind.
  void refused(const Arguments& arguments, const std::string& message) const {
    const std::size_t files = directory_.number_of_files();
    const Result result = run(arguments);
    const std::string shown = ::testing::PrintToString(arguments);
    EXPECT_EQ(result.code, 2) << shown << result.err;
    EXPECT_EQ(result.out, "") << shown;
    EXPECT_EQ(result.err.substr(0, 11), "voroproof: ") << shown;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << shown << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << shown << result.err;
    EXPECT_EQ(directory_.number_of_files(), files) << shown;
  }

  std::string reference(int n, const std::string& horizon, const std::string& seed = "3") const {
    const std::string path = file("reference.scene.json");
    must({"generate", "reference", "--n", std::to_string(n), "--seed", seed, "--horizon", horizon,
          "--density", "0.2", "-o", path});
    return path;
  }

  Json json(const std::string& name) const { return Json::parse(directory_.read(name)); }

  std::string program_ = VOROPROOF_PROGRAM;
  TemporaryDirectory directory_;
  TemporaryDirectory streams_;
};

inline std::string read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace voroproof::internal
