// simulate --resume: what a run has left that did not come to its end, taken up.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
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

  std::size_t events_in(const std::string& name) const {
    std::size_t events = 0;
    for (const std::string& line : lines_of(read_bytes(file(name)))) {
      events += line.starts_with("{\"t\":") ? 1 : 0;
    }
    return events;
  }
  // In whatever file it is.
  std::size_t most_events() const {
    std::size_t most = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file(""))) {
      most = std::max(most, events_in(entry.path().filename().string()));
    }
    return most;
  }

  // Another scene, whose history is some times as long as what is written at a time.
  void take_longer_scene() {
    scene_ = reference(100, "600");
    const std::string undisturbed = file("b.history.jsonl");
    must({"simulate", scene_, "-o", undisturbed});
    whole_ = read_bytes(undisturbed);
    std::filesystem::remove(undisturbed);
  }

  // Ends a run by a signal once more than so many bytes are written, unless it is over before.
  Result end_beyond(std::uintmax_t bytes, int number) const {
    const pid_t child = start(resume());
    const std::string written = history_ + "." + std::to_string(child) + ".0.tmp";
    for (;;) {
      siginfo_t ended{};
      waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
      if (ended.si_pid == child) break;
      std::error_code error;
      const std::uintmax_t size = std::filesystem::file_size(written, error);
      if (!error && size > bytes) {
        kill(child, number);
        break;
      }
      usleep(200);
    }
    return finish(child);
  }

  // Ends runs by a signal until something is kept.
  void keep(int number) const {
    for (int k = 0; !std::filesystem::exists(history_ + ".kept"); ++k) {
      ASSERT_LT(k, 50);
      std::filesystem::remove(history_);
      end_beyond(0, number);
    }
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
  expect_whole();
}

// What was reached is there whatever ends the runs, and each goes on from it.
TEST_F(Resume, GoesOnFromWhereARunWasEnded) {
  take_longer_scene();
  for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
    keep(number);
    Arguments arguments = resume();
    arguments.erase(arguments.end() - 1);  // --quiet
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("takes up "), std::string::npos) << result.err;
    EXPECT_TRUE(read_bytes(history_) == whole_);
    EXPECT_EQ(directory_.number_of_files(), 2u);
    std::filesystem::remove(history_);
  }
}

// Each run gets a little further, until one comes to the end.
TEST_F(Resume, ALoopOfEndedRunsEnds) {
  take_longer_scene();
  std::size_t before = 0;
  for (int k = 0;; ++k) {
    ASSERT_LT(k, 50);
    const Result result = end_beyond(read_bytes(history_).size(), SIGTERM);
    EXPECT_GE(most_events(), before);
    before = most_events();
    if (result.code == 0) break;
    EXPECT_EQ(result.code, 6) << result.err;
  }
  EXPECT_TRUE(read_bytes(history_) == whole_);
}

// A long history of which nothing is kept, and runs that end long before they are there.
TEST_F(Resume, NoEndingLosesEvents) {
  const std::string long_one = whole_.substr(0, whole_.rfind("{\"end\""));
  const std::size_t events = std::count(long_one.begin(), long_one.end(), '\n') - 1;
  for (const char* name :
       {"a.history.jsonl", "a.history.jsonl.partial", "a.history.jsonl.999999999.0.tmp"}) {
    directory_.write(name, long_one);
    for (const Arguments& limit : {Arguments{"--max-events", "50"},
                                   {"--max-bits", "64"},
                                   {"--time-limit", "1/100"},
                                   {"--max-memory", "40"}}) {
      run(resume(limit));
      EXPECT_GE(most_events(), events) << limit[0] << ' ' << name;
    }
    for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGKILL}) {
      const pid_t child = start(resume());
      usleep(10000);
      kill(child, number);
      finish(child);
      EXPECT_GE(most_events(), events) << number << ' ' << name;
    }
    expect_whole();
    std::filesystem::remove(history_);
  }
}

// What is kept is of some bytes: of others nothing is taken up.
TEST_F(Resume, OfAnAlteredHistoryIsRight) {
  take_longer_scene();
  for (int k = 0; k < 4; ++k) {
    keep(SIGTERM);
    std::string text = read_bytes(history_);
    const std::size_t kept =
        std::stoul(read_bytes(history_ + ".kept")
                       .substr(read_bytes(history_ + ".kept").find("\"bytes\":") + 8));
    ASSERT_LE(kept, text.size());
    std::size_t flip = text.rfind("{\"t\"", text.find("\"flip\"", kept * (k + 1) / 6));
    if (k % 2 == 0) {
      text.erase(flip, text.find('\n', flip) + 1 - flip);
    } else {
      const std::size_t digit = text.find(',', flip) - 1;
      text[digit] = text[digit] == '3' ? '4' : '3';
    }
    directory_.write("a.history.jsonl", text);
    if (k == 3) {
      std::string state = read_bytes(history_ + ".kept");
      state[state.size() / 2] ^= 1;
      directory_.write("a.history.jsonl.kept", state);
    }
    expect_whole();
    std::filesystem::remove(history_);
  }
}

TEST_F(Resume, AnotherFileOfTheNameThatIsKeptInIsRefused) {
  directory_.write("a.history.jsonl.kept", "the user's");
  refused(resume(), "a.history.jsonl.kept is there");
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

}  // namespace
}  // namespace voroproof::internal
