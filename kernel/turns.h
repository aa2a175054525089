// The order of the turns of one instant (docs/formats.md, section 6) under the exact truth:
// collisions, the smallest pair first; maneuvers; collisions that these bring about.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "kernel/motion.h"

namespace voroproof_kernel {

using Two = std::pair<int, int>;  // the smaller generator first

// Whether two of this pair that touch approach each other where half the derivative of their gap
// has this sign; where they overlap the gap has it.
inline int inwards(Two two) { return two.first == container ? 1 : -1; }

class Turns {
 public:
  // The claim, a collision or a maneuver, has turned its disks, which have left the legs `before`
  // (null for the container). It comes where the order has it among those of its instant: before
  // some that were claimed before it, of other disks. Throws Stop (refuted) where it makes another
  // of their pairs due there.
  void add(const Claim& c, const std::array<const Leg*, 2>& before, const Walk& now);

  // What is known of earlier times is needed no more.
  void forget_before(const Rat& t) { at_.erase(at_.begin(), at_.lower_bound(t)); }

 private:
  struct Turn {
    Two two;  // twice the disk of a maneuver
    std::array<const Leg*, 2> before;
    bool is_maneuver() const { return two.first == two.second; }
    bool involves(int g) const { return g != container && (two.first == g || two.second == g); }
  };
  void require_commutes(const Turn& turn, const std::vector<Turn>& order, std::size_t at,
                        const Rat& t, const Walk& now) const;

  std::map<Rat, std::vector<Turn>> at_;  // by instant, in the right order
};

}  // namespace voroproof_kernel
