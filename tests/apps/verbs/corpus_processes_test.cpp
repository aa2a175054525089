// The processes of the verb corpus: they end with their time, their memory or an interruption.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/apps/verbs/corpus_cli.h"

namespace voroproof::internal {
namespace {

bool alive(pid_t process) {
  // A zombie whose parent is gone is as good as dead: nobody here may wait for it.
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  return (stat >> number >> name >> state) && state != "Z" && state != "X";
}

// The number of a process that a command wrote to the file, as soon as it did.
pid_t process_in(const std::string& path) {
  for (int k = 0; k < 1000; ++k) {
    std::ifstream in(path);
    pid_t process = 0;
    std::string end;
    if (in >> process >> end) return process;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << path << ": nothing was written";
  return 0;
}

bool dies(pid_t process) {
  for (int k = 0; k < 1000 && alive(process); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return !alive(process);
}

TEST_F(CorpusCli, TheWholeGroupEndsWithItsTime) {
  const std::string note = file("process");
  const Json found = against("sleep 1000 & echo $! end > " + note + "; wait # {scene} {history}",
                             "three", {"--timeout", "0.3"});
  EXPECT_EQ(found["outcome"], "timed out");
  EXPECT_TRUE(dies(process_in(note)));
}

TEST_F(CorpusCli, WhatAProgramLeavesBehindIsKilled) {
  const std::string note = file("process");
  const Json found = against("sleep 1000 & echo $! end > " + note + "; " + simulate(), "three");
  EXPECT_EQ(found["outcome"], "certified");
  EXPECT_TRUE(dies(process_in(note)));
}

// A history up to another horizon is right up to there, and not that of the case.
TEST_F(CorpusCli, AnotherHorizonIsNotCertified) {
  const Json found = against(simulate() + " --horizon 0.001", "three");
  EXPECT_EQ(found["outcome"], "undecided");
  EXPECT_NE(found["reason"].get<std::string>().find("horizon 0.001"), std::string::npos);
}

// Sessions of their own, and no parent any more.
std::string leave_the_group(const std::string& note) {
  return "(setsid sh -c 'echo $$ end > " + note + "; exec sleep 1000' &) ; while [ ! -s " + note +
         " ]; do sleep 0.01; done; ";
}

TEST_F(CorpusCli, WhatLeavesTheGroupIsKilled) {
  const std::string note = file("process");
  const Json ended = against(leave_the_group(note) + simulate(), "three");
  EXPECT_EQ(ended["outcome"], "certified");
  EXPECT_TRUE(dies(process_in(note)));
  std::filesystem::remove(note);
  const Json late = against(leave_the_group(note) + "sleep 1000; : {scene} {history}", "three",
                            {"--timeout", "2"});
  EXPECT_EQ(late["outcome"], "timed out");
  EXPECT_TRUE(dies(process_in(note)));
}

// Killed outright, it takes all processes with it; its scratch files go with the next run.
TEST_F(CorpusCli, WhatAKilledRunLeavesIsRemoved) {
  const TemporaryDirectory scratch;
  ASSERT_EQ(setenv("TMPDIR", scratch.file("").c_str(), 1), 0);
  const std::string note = file("process");
  const pid_t program =
      start(run_words({"--against", leave_the_group(note) + "sleep 1000; : {scene} {history}",
                       "--case", "three", "--timeout", "1000"}));
  const pid_t child = process_in(note);
  EXPECT_TRUE(alive(child));
  kill(program, SIGKILL);
  EXPECT_EQ(finish(program).code, 1000 + SIGKILL);
  EXPECT_TRUE(dies(child));
  EXPECT_EQ(scratch.number_of_files(), 1u);
  // The process that sees to the others may still have the lock.
  for (int k = 0; k < 20 && scratch.number_of_files() > 0; ++k) against(simulate(), "three");
  unsetenv("TMPDIR");
  EXPECT_EQ(scratch.number_of_files(), 0u);
}

TEST_F(CorpusCli, MemoryIsLimited) {
  const Json found = against("dd if=/dev/zero of=/dev/null bs=400M count=1 # {scene} {history}",
                             "three", {"--memory", "200"});
  EXPECT_EQ(found["outcome"], "crashed");
  EXPECT_NE(found["reason"].get<std::string>().find("memory"), std::string::npos) << found;
}

// Interrupted, it leaves no process, no report and no scratch files.
TEST_F(CorpusCli, InterruptionLeavesNothing) {
  const TemporaryDirectory scratch;
  ASSERT_EQ(setenv("TMPDIR", scratch.file("").c_str(), 1), 0);
  const std::string note = file("process");
  const pid_t program = start(
      run_words({"--against", "echo $$ end > " + note + "; sleep 1000; : {scene} {history}",
                 "--html", file("r.html"), "--jobs", "2", "--case", "three", "--timeout", "1000"}));
  const pid_t child = process_in(note);
  EXPECT_TRUE(alive(child));
  kill(program, SIGINT);
  const Result result = finish(program);
  unsetenv("TMPDIR");
  EXPECT_EQ(result.code, 6) << result.err;
  EXPECT_TRUE(dies(child));
  EXPECT_FALSE(std::filesystem::exists(file("report.json")));
  EXPECT_FALSE(std::filesystem::exists(file("r.html")));
  EXPECT_EQ(scratch.number_of_files(), 0u);
}

}  // namespace
}  // namespace voroproof::internal
