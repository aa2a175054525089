// The changes of velocity that a scene asks for.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "exact/generators.h"
#include "exact/rational.h"

namespace voroproof::internal {

struct ManeuverInput {
  Rational t;
  GenId disk;
  Rational vx, vy;
};

// The maneuvers that are still to come.
class Maneuvers {
 public:
  // Sorted by time; those after the horizon are left out.
  Maneuvers(std::vector<ManeuverInput> all, const Rational& horizon) : all_(std::move(all)) {
    while (!all_.empty() && all_.back().t > horizon) all_.pop_back();
  }

  bool has_next() const { return next_ < all_.size(); }
  // Precondition of both: there is one. The reference is valid for as long as this.
  const Rational& next_time() const { return all_[next_].t; }
  // All of the next time, in the order of their disks.
  std::vector<ManeuverInput> take() {
    std::vector<ManeuverInput> together;
    const Rational t = next_time();
    while (has_next() && next_time() == t) together.push_back(all_[next_++]);
    std::sort(together.begin(), together.end(),
              [](const auto& a, const auto& b) { return a.disk < b.disk; });
    return together;
  }
  // Rounded down; infinite if there is none.
  double next_down() const {
    return has_next() ? round_down(next_time()) : std::numeric_limits<double>::infinity();
  }

 private:
  std::vector<ManeuverInput> all_;
  std::size_t next_ = 0;
};

}  // namespace voroproof::internal
