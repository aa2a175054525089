#include "filtered/motion/worker.h"

#include <chrono>
#include <utility>

#include "exact/patience.h"

namespace voroproof::internal {

namespace {

// To wake a thread costs the one that does so some ten microseconds. So a thread without a job
// looks for the next one of its own accord, for a while.
constexpr std::chrono::microseconds kNap(50);
constexpr int kNaps = 200;
// The time between two looks at whether a job is still wanted.
constexpr std::chrono::milliseconds kLook(5);

}  // namespace

Worker::Worker() : thread_([this] { work(); }) {}

Worker::~Worker() {
  leaving_ = true;
  { const std::lock_guard lock(mutex_); }
  changed_.notify_all();
  thread_.join();
}

void Worker::start(std::function<void()> job) {
  bool is_asleep = false;
  {
    const std::lock_guard lock(mutex_);
    job_ = std::move(job);
    is_asleep = asleep_;
  }
  working_ = true;
  if (is_asleep) changed_.notify_all();
}

void Worker::wait() {
  if (!working_) return;
  std::unique_lock lock(mutex_);
  if (job_ && !begun_) {
    do_job(lock);
  } else {
    awaited_ = true;
    while (!changed_.wait_for(lock, kLook, [this] { return !job_; })) Patience::ask_now();
    awaited_ = false;
  }
  working_ = false;
  if (const std::exception_ptr failure = std::exchange(failure_, nullptr)) {
    std::rethrow_exception(failure);
  }
}

// The lock is not held meanwhile.
void Worker::do_job(std::unique_lock<std::mutex>& lock) {
  begun_ = true;
  lock.unlock();
  std::exception_ptr failure;
  try {
    job_();
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  job_ = nullptr;
  begun_ = false;
  failure_ = failure;
}

void Worker::work() {
  const Patience patience([this] { return !leaving_; });
  std::unique_lock lock(mutex_);
  for (int naps = 0; !leaving_;) {
    if (job_ && !begun_) {
      do_job(lock);
      if (awaited_) changed_.notify_all();
      naps = 0;
    } else if (naps < kNaps) {
      ++naps;
      lock.unlock();
      std::this_thread::sleep_for(kNap);
      lock.lock();
    } else {
      asleep_ = true;
      changed_.wait(lock, [this] { return leaving_ || (job_ && !begun_); });
      asleep_ = false;
    }
  }
}

}  // namespace voroproof::internal
