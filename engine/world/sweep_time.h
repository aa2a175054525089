// When something happens in a sweep: an enclosure, and the exact number where somebody asks for it.
#pragma once

#include <compare>
#include <memory>
#include <optional>

#include "engine/world/rough_edge.h"

namespace voroproof::internal {

// A value. A copy shares what is found out.
class SweepTime {
 public:
  SweepTime(WorldTime t);
  SweepTime(const Rational& t) : SweepTime(WorldTime(t)) {}
  // The collapse of an edge. `rows` outlives it, and the motion of the four generators there does
  // not change while the exact number may be asked for.
  SweepTime(const MovingRows& rows, const Quad& q, const DoubleRoot& root);

  // It is in [lo, hi].
  double lo() const { return known_->lo; }
  double hi() const { return known_->hi; }
  const WorldTime& exact() const;
  double nearest() const;
  // For an edge with the same four generators: up to this time its polynomial has no other root
  // after this one. hi(), if nothing is known.
  double alone_until(const Quad& q) const;

  friend std::strong_ordering compare(const SweepTime& x, const SweepTime& y);
  friend std::strong_ordering compare(const SweepTime& x, const Rational& t);

 private:
  struct Known {
    double lo = 0, hi = 0;
    const MovingRows* rows = nullptr;
    Quad q{};
    double piece_hi = 0;
    std::optional<WorldTime> exact;
  };
  std::shared_ptr<Known> known_;
};

}  // namespace voroproof::internal
