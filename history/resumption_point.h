// Where a history that was cut off can be taken up.
#pragma once

#include <cstdint>

namespace voroproof::internal {

// Looks at the events of a history, whose times are rounded to nearest, and keeps the last place
// between two of them at which a double certainly is later than the one and earlier than the other:
// the last instant of a history that was cut off may be told in part only.
class ResumptionPoint {
 public:
  // The next event is at time t.
  void see(double t) {
    const double middle = last_ + 0.5 * (t - last_);
    if (last_ < middle && middle < t) {
      t0_ = middle;
      events_ = seen_;
    }
    last_ = t;
    ++seen_;
  }

  // So many events come before the place, and this time, more than 0, is there; 0 and 0 if there is
  // none.
  std::uint64_t events() const { return events_; }
  double t0() const { return t0_; }

 private:
  double last_ = 0, t0_ = 0;
  std::uint64_t seen_ = 0, events_ = 0;
};

}  // namespace voroproof::internal
