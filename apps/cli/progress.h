// A line on the terminal that tells how far a run has come.
#pragma once

#include <chrono>
#include <cstdint>

namespace voroproof::internal {

// Written to stderr a few times a second and wiped out at the end. Silent where stderr is no
// terminal.
class Progress {
 public:
  Progress(double horizon, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // The run has reached the time t with that many events.
  void report(double t, std::uint64_t events);

 private:
  using Clock = std::chrono::steady_clock;

  bool shown_;
  bool dirty_ = false;  // something stands on the line
  double horizon_;
  Clock::time_point start_, next_;
};

}  // namespace voroproof::internal
