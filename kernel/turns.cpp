#include "kernel/turns.h"

#include <algorithm>
#include <string>

namespace voroproof_kernel {

namespace {

std::string name(Two two) {
  if (two.first == two.second) return "the maneuver of disk " + std::to_string(two.first);
  return "generators " + std::to_string(two.first) + " and " + std::to_string(two.second);
}

}  // namespace

void Turns::add(const Claim& c, const std::array<const Leg*, 2>& before, const Walk& now) {
  const bool collision = c.kind == Claim::Kind::collision;
  const Turn turn{collision ? Two(c.id[0], c.id[1]) : Two(c.id[1], c.id[1]), before};
  std::vector<Turn>& order = at_[c.t];
  // Behind the last turn of its own disks, and behind the last maneuver.
  std::size_t own = 0, maneuvers = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (order[k].involves(turn.two.first) || order[k].involves(turn.two.second)) own = k + 1;
    if (order[k].is_maneuver()) maneuvers = k + 1;
  }
  std::size_t at = own;
  if (!collision) {
    if (own > maneuvers && maneuvers > 0) {
      refute("the maneuver of disk " + std::to_string(c.id[1]) +
             " comes before a collision that another one at the same instant brought about");
    }
    at = maneuvers > 0 ? maneuvers : order.size();
  } else {
    // What a maneuver brings about comes after all of them.
    if (own > 0 && order[own - 1].is_maneuver()) at = maneuvers;
    while (at < order.size() && !order[at].is_maneuver() && order[at].two < turn.two) ++at;
  }
  require_commutes(turn, order, at, c.t, now);
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(at), turn);
}

// The turn comes before those from `at` on: none of its disks, as it moves now, touches and
// approaches one of theirs, as that moved before, in a pair that comes before its turn.
void Turns::require_commutes(const Turn& turn, const std::vector<Turn>& order, std::size_t at,
                             const Rat& t, const Walk& now) const {
  for (std::size_t k = at; k < order.size(); ++k) {
    const Turn& later = order[k];
    for (int side = 0; side < 2; ++side) {
      const int x = side == 0 ? later.two.first : later.two.second;
      const auto turned = [x](const Turn& other) { return other.involves(x); };
      if (x == container || std::any_of(&order[at], &later, turned)) continue;
      for (const int g : {turn.two.first, turn.two.second}) {
        const Two two = std::minmax(g, x);
        if (g == container || (!later.is_maneuver() && later.two <= two)) continue;
        const Gap gap(*later.before[side], now.leg(g));
        if (gap.value(t) == 0 && sgn(gap.slope(t)) == inwards(two)) {
          refute(name(turn.two) + " come before " + name(later.two) + ", and then " + name(two));
        }
      }
    }
  }
}

}  // namespace voroproof_kernel
