// The changes to the motion of disks so far: the log from which every state can be computed.
#pragma once

#include <cstddef>
#include <deque>
#include <mutex>

#include "exact/generators.h"
#include "exact/rational.h"

namespace voroproof::internal {

// It grows at its end and never changes otherwise. One thread appends; others may read what was
// appended before they were told of it.
class MotionLog {
 public:
  struct Maneuver {
    Rational t, vx, vy;
  };
  // A collision of i < j; a maneuver of i has j = i.
  struct Record {
    GenId i, j;
    int before_i, before_j;  // the states before it: Motion::state_id
    double t_i, t_j;         // their reference times
    double t_ref;            // and that of the states after it
    int maneuver;            // its index, or -1
  };

  MotionLog() = default;
  // A log of its own that begins with so many records of the other, which may be growing.
  MotionLog(const MotionLog& other, std::size_t records) {
    const std::lock_guard lock(other.mutex_);
    records_.assign(other.records_.begin(),
                    other.records_.begin() + static_cast<std::ptrdiff_t>(records));
    maneuvers_ = other.maneuvers_;
  }

  void append(const Record& r) {
    const std::lock_guard lock(mutex_);
    records_.push_back(r);
  }
  // Returns the maneuver's index, for a record.
  int append(Maneuver m) {
    const std::lock_guard lock(mutex_);
    maneuvers_.push_back(std::move(m));
    return static_cast<int>(maneuvers_.size()) - 1;
  }
  // The references are valid for as long as the log.
  const Record& record(std::size_t k) const {
    const std::lock_guard lock(mutex_);
    return records_[k];
  }
  const Maneuver& maneuver(int index) const {
    const std::lock_guard lock(mutex_);
    return maneuvers_[index];
  }

 private:
  mutable std::mutex mutex_;
  std::deque<Record> records_;  // its elements stay where they are
  std::deque<Maneuver> maneuvers_;
};

}  // namespace voroproof::internal
