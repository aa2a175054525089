// When what a run has reached is to outlive the process.
#pragma once

#include <chrono>
#include <cstdint>

namespace voroproof::internal {

// Tells every so many seconds that it is time.
class Checkpoints {
 public:
  explicit Checkpoints(std::uint64_t seconds) : interval_(seconds) {}
  bool due() {
    const Clock::time_point now = Clock::now();
    if (now < last_ + interval_) return false;
    last_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::chrono::seconds interval_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace voroproof::internal
