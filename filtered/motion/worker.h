// A thread that does one job at a time for another one, the only one that may call what is public.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace voroproof::internal {

class Worker {
 public:
  Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  // Gives up a job that is being done: it is told when it asks (Patience).
  ~Worker();

  // Precondition: the last job was waited for.
  void start(std::function<void()> job);
  bool is_working() const { return working_; }
  // Waits until the job is done; does it in the calling thread if the other one has not begun.
  // Throws what the job threw, and, where the waiting thread is asked to give up, GivenUp; the job
  // may go on then.
  void wait();

 private:
  void work();
  void do_job(std::unique_lock<std::mutex>& lock);

  bool working_ = false;  // set by the calling thread: a job was started and not waited for
  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> job_;  // null when it is done
  bool begun_ = false;
  std::exception_ptr failure_;
  bool asleep_ = false, awaited_ = false;  // who has to be woken
  std::atomic<bool> leaving_ = false;
  std::thread thread_;
};

}  // namespace voroproof::internal
