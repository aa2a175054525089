// The thread that does jobs for another one.
#include "filtered/motion/worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "exact/patience.h"

namespace voroproof::internal {
namespace {

TEST(Worker, DoesOneJobAfterTheOther) {
  Worker worker;
  int sum = 0;
  for (int k = 1; k <= 1000; ++k) {
    worker.start([&, k] { sum += k; });
    EXPECT_TRUE(worker.is_working());
    worker.wait();
    EXPECT_FALSE(worker.is_working());
  }
  EXPECT_EQ(sum, 500500);
  worker.wait();
}

// The worker does so, too, when it has been without a job for so long that it has to be woken.
TEST(Worker, WorksInItsOwnThread) {
  Worker worker;
  for (const int pause : {0, 60}) {
    std::this_thread::sleep_for(std::chrono::milliseconds(pause));
    std::atomic<bool> done = false;
    std::thread::id id;
    worker.start([&] {
      id = std::this_thread::get_id();
      done = true;
    });
    while (!done) std::this_thread::yield();
    worker.wait();
    EXPECT_NE(id, std::this_thread::get_id());
  }
}

// The waiting thread may have taken the job, which the other one must leave alone then, as must one
// that falls asleep or wakes up meanwhile.
TEST(Worker, LongJobsAreDoneOnceByEitherThread) {
  Worker worker;
  std::atomic<int> done = 0;
  for (int k = 0; k < 40; ++k) {
    if (k % 8 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(40));
    worker.start([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(k % 4 == 0 ? 50 : 1));
      ++done;
    });
    worker.wait();
    EXPECT_EQ(done, k + 1);
  }
}

TEST(Worker, ThrowsWhatTheJobThrew) {
  Worker worker;
  worker.start([] { throw std::runtime_error("a job"); });
  EXPECT_THROW(worker.wait(), std::runtime_error);
  int done = 0;
  worker.start([&] { ++done; });
  worker.wait();
  EXPECT_EQ(done, 1);
}

TEST(Worker, WaitingMayBeGivenUpAndSoMayTheJob) {
  std::atomic<bool> begun = false, given_up = false;
  {
    Worker worker;
    worker.start([&] {
      begun = true;
      try {
        for (;;) Patience::ask();
      } catch (const GivenUp&) {
        given_up = true;
        throw;
      }
    });
    while (!begun) std::this_thread::yield();
    const Patience none([] { return false; });
    EXPECT_THROW(worker.wait(), GivenUp);
    EXPECT_TRUE(worker.is_working());
    EXPECT_FALSE(given_up);
  }
  EXPECT_TRUE(given_up);
}

}  // namespace
}  // namespace voroproof::internal
