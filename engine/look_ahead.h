// How far the searches for flips look ahead.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

// Twice the mean life of a search's result in the last stretches of the run. While nothing happens
// a result lives as long as the look-ahead, which therefore grows by factors; where much happens
// the searches that go on cost about as much as those that events ask for.
class LookAhead {
 public:
  LookAhead() = default;
  // The first searches, at time t, look so far ahead, and no other beyond `horizon`. Before them
  // `searches` were made. The first search of each edge does not count: what is known then is of
  // edges that have not come to the end of their lives.
  LookAhead(double first, double t, double horizon, std::uint64_t edges, std::uint64_t searches)
      : window_(first),
        horizon_(horizon),
        edges_(edges),
        before_{t, searches + edges},
        latest_(before_) {}

  // To where a search that begins at `from` looks.
  double end(double from) const {
    return std::min(std::max(from + window_, next_above(from)), horizon_);
  }

  // Another search is made, the one with this number, and no event is to come before `frontier`.
  void count(std::uint64_t searches, double frontier) {
    if (searches % kBlock != 0 || searches <= before_.searches) return;
    if (!(frontier > before_.t)) return;  // all of them at one instant
    const double made = static_cast<double>(searches - before_.searches);
    const double life = (frontier - before_.t) * static_cast<double>(edges_) / made;
    window_ = std::fmax(2 * life, 1e-9 * horizon_);
    // Many results end together: a stretch has several of each edge.
    if (searches - latest_.searches >= std::max(kBlock, 4 * edges_)) {
      before_ = std::exchange(latest_, {frontier, searches});
    }
  }

 private:
  static constexpr std::uint64_t kBlock = 4096;

  struct Begin {
    double t = 0;
    std::uint64_t searches = 0;
  };

  double window_ = 0, horizon_ = 0;
  std::uint64_t edges_ = 0;
  Begin before_, latest_;  // begins of the last stretches
};

}  // namespace voroproof::internal
