// Long work without Python's lock, that signals and a callable of the caller's can end.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <thread>
#include <utility>

#include "voroproof/error.h"
#include "voroproof/simulate.h"

namespace voroproof::python {

// A monitor for the library. In the thread that made it, it takes the lock every 50 ms, lets Python
// handle signals, and calls `progress`, which may be None; what these raise ends the work, and so
// does False from `progress`. In other threads it only says whether the work has been ended.
class Attention {
 public:
  explicit Attention(pybind11::object progress) : progress_(std::move(progress)) {}

  template <class... Facts>
  bool operator()(const Facts&... facts) {
    if (ended_) return false;
    if (std::this_thread::get_id() != caller_) return true;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return true;
    next_ = now + std::chrono::milliseconds(50);
    const pybind11::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      if (!progress_.is_none() && progress_(facts...).is(pybind11::bool_(false))) ended_ = true;
    } catch (pybind11::error_already_set& error) {
      raised_ = std::move(error);
      ended_ = true;
    }
    return !ended_;
  }

  // Calls `progress` once more, with the facts at the end.
  template <class... Facts>
  void report(const Facts&... facts) {
    if (!progress_.is_none() && !ended_) progress_(facts...);
  }

  // Does the work without the lock; throws what a signal or `progress` raised.
  template <class Work>
  auto spend(Work&& work) {
    try {
      auto result = without_lock(std::forward<Work>(work));
      rethrow();
      return result;
    } catch (const Interrupted&) {
      rethrow();
      throw;
    }
  }

  template <class Work>
  static auto without_lock(Work&& work) {
    const pybind11::gil_scoped_release release;
    return std::forward<Work>(work)();
  }

 private:
  void rethrow() {
    if (raised_) throw *std::exchange(raised_, std::nullopt);
  }

  pybind11::object progress_;
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<bool> ended_ = false;
  std::chrono::steady_clock::time_point next_{};
  std::optional<pybind11::error_already_set> raised_;
};

// The attention must outlive the options.
inline SimulateOptions simulate_options(int threads, int max_bits, std::uint64_t max_events,
                                        Attention& attention) {
  SimulateOptions options;
  options.threads = threads;
  options.max_bits = max_bits;
  options.max_events = max_events;
  options.monitor = [&](double t, std::uint64_t events) { return attention(t, events); };
  return options;
}

}  // namespace voroproof::python
