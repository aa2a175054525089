// simulate --resume: what a run has left that did not come to its end, taken up.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <string>
#include <thread>

#include "tests/apps/verbs/cli.h"

namespace voroproof::internal {
namespace {

class Resume : public Cli {
 protected:
  void SetUp() override {
    scene_ = reference(30, "60");
    history_ = file("a.history.jsonl");
    must({"simulate", scene_, "-o", history_});
    whole_ = read_bytes(history_);
    std::filesystem::remove(history_);
  }

  Arguments resume(const Arguments& more = {}) const {
    Arguments arguments{"simulate", scene_, "-o", history_, "--resume", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  // The run comes to its end, and leaves nothing but the scene and the history.
  void expect_whole(const Arguments& more = {}) const {
    const Result result = run(resume(more));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_TRUE(read_bytes(history_) == whole_);
    EXPECT_EQ(directory_.number_of_files(), 2u);
  }

  // The history with one text replaced where it first occurs.
  std::string with(const std::string& from, const std::string& to) const {
    std::string text = whole_;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, from.size(), to);
  }

  // The history up to its last line, with another number behind that text in its first collision.
  std::string with_another_number(const std::string& behind) const {
    std::string text = whole_.substr(0, whole_.find("{\"end\""));
    const std::size_t from = text.find(behind, text.find("\"collide\"")) + behind.size();
    return text.replace(from, text.find_first_of(",]", from) - from, "0.125");
  }

  std::string scene_, history_, whole_;
};

// The file of a killed process ends anywhere, also within a line.
TEST_F(Resume, WhatAKilledProcessLeftWhereverItEnds) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 100; ++k) {
    const std::size_t size = random() % (whole_.size() + 1);
    directory_.write("a.history.jsonl.999999999.0.tmp", whole_.substr(0, size));
    expect_whole(k % 2 == 0 ? Arguments{} : Arguments{"--threads", "2"});
    std::filesystem::remove(history_);
  }
}

// Killed in earnest, again and again, until a run comes to its end.
TEST_F(Resume, OfProcessesThatAreKilled) {
  const std::string scene = reference(100, "100");
  const std::string undisturbed = file("b.history.jsonl");
  must({"simulate", scene, "-o", undisturbed});
  whole_ = read_bytes(undisturbed);
  std::filesystem::remove(undisturbed);
  std::mt19937_64 random(2);
  for (int k = 0; k < 20; ++k) {
    const pid_t child = start(resume({"--checkpoint", "1"}));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 100000));
    kill(child, SIGKILL);
    finish(child);
  }
  expect_whole();
}

TEST_F(Resume, OfAStoppedAndAnInterruptedRun) {
  for (const char* events : {"1", "50", "100"}) {
    const Result stopped = run(resume({"--max-events", events}));
    EXPECT_EQ(stopped.code, 3);
    expect_whole();
    std::filesystem::remove(history_);
  }
  // One of these is the interruption's; none is a harm.
  const pid_t child = start(resume());
  kill(child, SIGINT);
  finish(child);
  expect_whole({"--self-check"});
}

// The one that goes farther is taken up, and what was beside it is removed.
TEST_F(Resume, TheFarthestOfSeveral) {
  directory_.write("a.history.jsonl", whole_.substr(0, whole_.size() / 4));
  directory_.write("a.history.jsonl.partial", whole_.substr(0, whole_.size() / 2));
  Arguments arguments = resume();
  arguments.erase(arguments.end() - 1);  // --quiet
  const Result result = run(arguments);
  EXPECT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("a.history.jsonl.partial at t = "), std::string::npos) << result.err;
  EXPECT_TRUE(read_bytes(history_) == whole_);
  EXPECT_EQ(directory_.number_of_files(), 2u);
}

TEST_F(Resume, OfACompleteHistoryIsNothing) {
  directory_.write("a.history.jsonl", whole_);
  const auto time = std::filesystem::last_write_time(history_);
  expect_whole();
  EXPECT_EQ(std::filesystem::last_write_time(history_), time);
}

// A process may be killed between the last two of its acts: its history has its name, and what it
// took up is still there.
TEST_F(Resume, RemovesWhatIsLeftBesideACompleteHistory) {
  const std::string half = whole_.substr(0, whole_.size() / 2);
  directory_.write("a.history.jsonl", whole_);
  directory_.write("a.history.jsonl.partial", half);
  directory_.write("a.history.jsonl.999999999.0.tmp", half);
  expect_whole();
  directory_.write("a.history.jsonl.partial", with("\"horizon\":60", "\"horizon\":61"));
  EXPECT_EQ(run(resume()).code, 0);
  EXPECT_EQ(directory_.number_of_files(), 3u);
}

TEST_F(Resume, OfAnotherRunIsRefused) {
  directory_.write("a.history.jsonl", with("\"scene_sha256\":\"", "\"scene_sha256\":\"0"));
  refused(resume(), "a.history.jsonl");
  std::string other = whole_;
  const std::size_t hash = other.find("\"scene_sha256\":\"") + 16;
  other[hash] = other[hash] == '0' ? '1' : '0';
  directory_.write("a.history.jsonl", other);
  refused(resume(), "is the history of another scene");
  directory_.write("a.history.jsonl", with("\"horizon\":60", "\"horizon\":61"));
  refused(resume(), "has the horizon 61, not 60");
  directory_.write("a.history.jsonl", with("voroproof ", "careless "));
  refused(resume(), "was written by careless");
}

// What is compressed is cut off within its compression.
TEST_F(Resume, OfACompressedHistory) {
  for (const char* ending : {".gz", ".zst"}) {
    history_ = file(std::string("a.history.jsonl") + ending);
    must({"simulate", scene_, "-o", history_});
    whole_ = read_bytes(history_);
    std::filesystem::remove(history_);
    for (const std::size_t size : {whole_.size() / 2, whole_.size() - 1}) {
      directory_.write(std::string("a.history.jsonl") + ending + ".999999999.0.tmp",
                       whole_.substr(0, size));
      expect_whole();
      std::filesystem::remove(history_);
    }
  }
}

TEST_F(Resume, OfAStreamIsRefused) {
  refused({"simulate", scene_, "-o", "-", "--resume"}, "written into a stream");
}

// What is told is held against what is computed.
TEST_F(Resume, OfAChangedHistoryIsRefused) {
  directory_.write("a.history.jsonl", with_another_number("\"v\":[["));
  refused(resume(), "a disk has another velocity");
  directory_.write("a.history.jsonl", with_another_number("\"p\":[["));
  refused(resume(), "a disk turns at another place");
  std::string text = whole_.substr(0, whole_.find("{\"end\""));
  const std::size_t flip = text.rfind("{\"t\"", text.find("\"flip\""));
  text.erase(flip, text.find('\n', flip) + 1 - flip);
  directory_.write("a.history.jsonl", text);
  const Result result = run(resume());
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(directory_.number_of_files(), 2u);
}

}  // namespace
}  // namespace voroproof::internal
