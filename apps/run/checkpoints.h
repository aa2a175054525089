// When what a run has reached is to outlive the process.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace voroproof::internal {

// Tells that it is time after so many seconds at the latest, and before whenever as much time has
// passed as a half of what had: a short run, too, leaves no more than a third of it undone.
class Checkpoints {
 public:
  explicit Checkpoints(std::uint64_t seconds) : interval_(seconds) {}
  bool due() {
    const Clock::time_point now = Clock::now();
    if (now < last_ + std::min<Clock::duration>(interval_, (last_ - begin_) / 2 + kFirst)) {
      return false;
    }
    last_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kFirst{1000};
  std::chrono::seconds interval_;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
};

}  // namespace voroproof::internal
