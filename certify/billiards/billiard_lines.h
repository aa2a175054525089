// The recorded paths of the disks of a billiard: lines, or parabolas under gravity, from turn to
// turn.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "filtered/billiards/billiard_gaps.h"

namespace voroproof::internal {

// A time, exactly and enclosed.
struct BilliardTime {
  Rational exact;
  DoubleBall near;
  explicit BilliardTime(const Rational& t);
};

// A piece of a path, from the claim that turned the disk to the next one that does.
struct BilliardLine {
  BilliardTime from;
  Flight<Rational> exact;  // exact.t0 is from.exact
  Flight<DoubleBall> near;
  std::int64_t claim = -1;         // by which the disk turned, counted from 0; -1 at the start
  std::optional<BilliardPair> by;  // the collision that it was
  std::int64_t turns = 0;          // claims that turned it, with this one
};

// The lines of one disk in a window of time: the one that it is on at the beginning comes first.
using BilliardPath = std::vector<BilliardLine>;

}  // namespace voroproof::internal
