#include "library/planning/wall_clearance.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "exact/patience.h"
#include "library/planning/clearance.h"

namespace voroproof::internal {

namespace {

Enclosure negated(const Enclosure& e) { return {-e.hi + 0.0, -e.lo + 0.0}; }

// By how much the disk sticks out of the container: the gap with its sign turned, as that of two
// disks.
Approach excess(const WallApproach& a) { return {a.disk, a.disk, a.t, a.distance2, a.room}; }

// Whether the first of two comes before the second: by gap, time and disk.
bool is_nearer(const WallApproach& a, const WallApproach& b) {
  const auto order = compare_gaps(excess(a), excess(b));
  return order > 0 || (order == 0 && std::tie(a.t, a.disk) < std::tie(b.t, b.disk));
}

// At a contact the rounded place, of which `offset` is the one from the container's centre, tells,
// too: the ends of a spell are those of the places.
bool is_below(const WallApproach& a, const Point2& offset, const Rational& distance) {
  const Rational limit = a.room - distance, limit2 = limit * limit;
  return limit < 0 || (a.distance2 > limit2 && offset.x * offset.x + offset.y * offset.y > limit2);
}

}  // namespace

// A leg with what is true at its ends.
struct WallClearance::Leg {
  WallApproach first, last;
  Point2 a, b;  // offsets of the centre from the container's
  bool is_first_below, is_last_below;
};

Enclosure gap(const WallApproach& approach) {
  return negated(root_less(approach.distance2, approach.room));
}

bool keeps_clear(const WallApproach& approach, const Rational& clearance, Touching touching) {
  const Rational room = approach.room - clearance;
  if (room < 0) return false;
  const Rational limit2 = room * room;
  return clearance == 0 && touching == Touching::is_too_near ? approach.distance2 < limit2
                                                             : approach.distance2 <= limit2;
}

WallClearance::WallClearance(const GivenPaths& given, std::function<bool()> go_on)
    : given_(given), go_on_(std::move(go_on)) {}

WallApproach WallClearance::at(int disk, const Waypoint& waypoint) const {
  const Rational room =
      given_.container->radius - given_.paths[static_cast<std::size_t>(disk)].radius;
  const Rational x = waypoint.at[0] - given_.container->center.x,
                 y = waypoint.at[1] - given_.container->center.y;
  const bool touches = given_.contacts.contains({container_id, disk, waypoint.t});
  return {disk, waypoint.t, touches ? Rational(room * room) : Rational(x * x + y * y), room};
}

std::optional<WallApproach> WallClearance::least() const {
  std::optional<WallApproach> least;
  for (std::size_t g = 0; g < given_.paths.size(); ++g) {
    if (!go_on_()) throw Interrupted();
    for (const Waypoint& waypoint : given_.paths[g].waypoints) {
      WallApproach here = at(static_cast<int>(g), waypoint);
      if (!least || is_nearer(here, *least)) least = std::move(here);
    }
  }
  return least;
}

// The parts of a leg in which the gap is less than the distance: none, all of it, or one at an end
// or at both, up to where |a + s (b - a)| = limit: s = -h -+ sqrt(h^2 - c).
std::vector<WallSpell> WallClearance::parts(const Leg& leg, const Rational& distance) const {
  std::vector<WallSpell> found;
  const Rational &from = leg.first.t, &to = leg.last.t, limit = leg.first.room - distance;
  if (!leg.is_first_below && !leg.is_last_below) return found;
  if (limit < 0 || nearest_to_origin(leg.a, leg.b).second > limit * limit) {
    const bool is_last = is_nearer(leg.last, leg.first);
    return {{enclosure(from), enclosure(to), is_last ? leg.last : leg.first}};
  }
  const Rational ux = leg.b.x - leg.a.x, uy = leg.b.y - leg.a.y, u2 = ux * ux + uy * uy;
  const Rational length = to - from, h = (leg.a.x * ux + leg.a.y * uy) / u2;
  const Rational c = (leg.a.x * leg.a.x + leg.a.y * leg.a.y - limit * limit) / u2;
  const Rational root2 = (h * h - c) * length * length, middle = from - h * length;
  if (leg.is_first_below) {
    found.push_back({enclosure(from), negated(root_less(root2, middle)), leg.first});
  }
  if (leg.is_last_below) {
    found.push_back({root_less(root2, -middle), enclosure(to), leg.last});
  }
  return found;
}

std::vector<WallSpell> WallClearance::spells_below(const Rational& distance) const {
  std::vector<WallSpell> spells;
  const Point2& o = given_.container->center;
  for (std::size_t g = 0; g < given_.paths.size(); ++g) {
    if (!go_on_()) throw Interrupted();
    const std::vector<Waypoint>& w = given_.paths[g].waypoints;
    bool goes_on = false;  // whether the last spell reaches the waypoint
    for (std::size_t k = 0; k + 1 < w.size() || k == 0; ++k) {
      const Waypoint &p = w[k], &q = w[std::min(k + 1, w.size() - 1)];
      Leg leg{at(static_cast<int>(g), p),
              at(static_cast<int>(g), q),
              {p.at[0] - o.x, p.at[1] - o.y},
              {q.at[0] - o.x, q.at[1] - o.y},
              false,
              false};
      leg.is_first_below = is_below(leg.first, leg.a, distance);
      leg.is_last_below = is_below(leg.last, leg.b, distance);
      for (WallSpell& part : parts(leg, distance)) {
        if (goes_on) {
          spells.back().to = part.to;
          if (is_nearer(part.nearest, spells.back().nearest)) spells.back().nearest = part.nearest;
          goes_on = false;
        } else {
          spells.push_back(std::move(part));
        }
      }
      goes_on = leg.is_last_below;
    }
  }
  return spells;
}

}  // namespace voroproof::internal
