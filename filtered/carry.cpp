#include "filtered/carry.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace voroproof {

namespace {

// Pairs of states looked at in one proof: bounds the cost where pasts are long.
constexpr std::size_t kMaxPairs = std::size_t{1} << 18;

// What a state came of: a maneuver, or one collision, or two at one instant whose normals are at
// right angles. Neither of these two changes the velocities along the other's normal, so that what
// both do to the disk is the sum of what each would do alone.
struct Past {
  DiskState before;
  const Motion::ManeuverRecord* maneuver = nullptr;
  // The partners before; of two the second's normal, seen from the disk, is to the left.
  std::vector<DiskState> partners;
};

// The partner in the collision that began state s, before all that the collision does not depend
// on.
DiskState partner_in(const Motion& motion, const DiskState& s) {
  const Motion::Origin o = motion.origin(s.g, s.id);
  DiskState p{o.partner, o.partner_before};
  while (p.id > 0 && motion.right_angle(s.id, p.id) != 0) {
    p.id = motion.origin(p.g, p.id).before;
  }
  return p;
}

Past past_of(const Motion& motion, const DiskState& s) {
  const Motion::Origin o = motion.origin(s.g, s.id);
  Past past;
  past.before = {s.g, o.before};
  past.maneuver = o.maneuver;
  if (o.maneuver != nullptr) return past;
  past.partners.push_back(partner_in(motion, s));
  const int turn = o.before > 0 ? motion.right_angle(o.before, s.id) : 0;
  if (turn == 0) return past;
  past.partners.push_back(partner_in(motion, past.before));
  if (turn > 0) std::swap(past.partners[0], past.partners[1]);
  past.before.id = motion.origin(s.g, past.before.id).before;
  return past;
}

// What a walk through the pasts of both in step finds.
struct Equations {
  std::vector<Image> points, vectors;
  // Whether they hold for one kind of isometries only.
  bool of_one_kind = false;
};

// What an isometry that reflects, or one that does not, has to solve. nullopt: the pasts differ.
std::optional<Equations> equations(const Motion& motion, std::span<const DiskState> from,
                                   std::span<const DiskState> to, bool reflects) {
  using Pair = std::array<int, 4>;
  const MotionInput& in = motion.input();
  Equations out;
  std::set<Pair> seen;
  std::vector<Pair> open;
  const auto look_at = [&](DiskState a, DiskState b) {
    const Pair p{a.g, a.id, b.g, b.id};
    if (seen.insert(p).second) open.push_back(p);
  };
  for (std::size_t k = 0; k < from.size(); ++k) look_at(from[k], to[k]);
  while (!open.empty()) {
    if (seen.size() > kMaxPairs) return std::nullopt;
    const auto [ga, ida, gb, idb] = open.back();
    open.pop_back();
    if ((ga == container_id) != (gb == container_id)) return std::nullopt;
    if (ga == container_id) {
      const Vector o{in.container_x, in.container_y};
      out.points.push_back({o, o});
      continue;
    }
    if ((ida > 0) != (idb > 0)) return std::nullopt;
    if (ida <= 0) {
      const DiskInput& a = in.disks[ga];
      const DiskInput& b = in.disks[gb];
      if (a.radius != b.radius || a.mass != b.mass ||
          motion.initial_time(ga) != motion.initial_time(gb)) {
        return std::nullopt;
      }
      out.points.push_back({{a.x, a.y}, {b.x, b.y}});
      out.vectors.push_back({{a.vx, a.vy}, {b.vx, b.vy}});
      continue;
    }
    const Past a = past_of(motion, {ga, ida}), b = past_of(motion, {gb, idb});
    if ((a.maneuver == nullptr) != (b.maneuver == nullptr) ||
        a.partners.size() != b.partners.size()) {
      return std::nullopt;
    }
    if (a.maneuver != nullptr) {
      if (a.maneuver->t != b.maneuver->t) return std::nullopt;
      out.vectors.push_back({{a.maneuver->vx, a.maneuver->vy}, {b.maneuver->vx, b.maneuver->vy}});
    } else if (a.partners.size() == 1) {
      look_at(a.partners[0], b.partners[0]);
    } else {
      // A reflection turns left into right.
      out.of_one_kind = true;
      for (const std::size_t k : {0, 1}) look_at(a.partners[k], b.partners[reflects ? 1 - k : k]);
    }
    look_at(a.before, b.before);
  }
  return out;
}

}  // namespace

std::vector<Isometry> carry(const Motion& motion, std::span<const DiskState> from,
                            std::span<const DiskState> to) {
  std::vector<Isometry> out;
  for (const bool reflects : {false, true}) {
    const auto found = equations(motion, from, to, reflects);
    if (!found) continue;
    for (const Isometry& g : isometries(found->points, found->vectors)) {
      if (!found->of_one_kind || g.reflects == reflects) out.push_back(g);
    }
    if (!found->of_one_kind) break;
  }
  return out;
}

DiskState state_before(const Motion& motion, DiskState s, int records) {
  while (s.id > records) s.id = motion.origin(s.g, s.id).before;
  return s;
}

namespace {

// The turn, by a right angle, from the direction from disk g to a onto that from g to b, where a
// quarter turn carries one pair onto the other: 1 to the left, -1 to the right, 0 none proved.
int quarter_turn(const Motion& motion, const DiskState& g, const DiskState& a, const DiskState& b) {
  for (const bool swapped : {false, true}) {
    const PairStates to = swapped ? PairStates{b, g} : PairStates{g, b};
    for (const Isometry& f : carry(motion, PairStates{g, a}, to)) {
      if (f.reflects || sgn(f.a) != 0) continue;
      return swapped ? -sgn(f.b) : sgn(f.b);
    }
  }
  return 0;
}

// Whether the directions from disk g to a and b may be at right angles, as far as doubles tell.
// That of a maneuver of g or of a collision with the container is not looked at.
bool may_be_right_angle(const Motion& motion, GenId g, GenId a, GenId b, const DoubleBall& now) {
  if (a == container_id || a == g || a == b) return false;
  const Site<DoubleBall> at = motion.site(g, now), at_a = motion.site(a, now),
                         at_b = motion.site(b, now);
  return !is_certain(sign((at_a.x - at.x) * (at_b.x - at.x) + (at_a.y - at.y) * (at_b.y - at.y)));
}

}  // namespace

void note_right_angles(Motion& motion, int records, double lo, double hi) {
  const DoubleBall now = DoubleBall::hull(lo, hi);
  const auto before = [&](GenId g) {
    return state_before(motion, {g, motion.state_id(g)}, records);
  };
  for (int id = records + 1; id <= motion.records(); ++id) {
    const auto [i, j] = motion.generators_of(id);
    if (i == container_id || i == j) continue;  // a collision of two disks
    for (const GenId g : {i, j}) {
      const GenId b = g == i ? j : i;
      for (int first = motion.origin(g, id).before; first > records;) {
        const Motion::Origin o = motion.origin(g, first);
        if (may_be_right_angle(motion, g, o.partner, b, now)) {
          const int turn = quarter_turn(motion, before(g), before(o.partner), before(b));
          if (turn != 0) motion.note_right_angle(first, id, turn);
        }
        first = o.before;
      }
    }
  }
}

}  // namespace voroproof
