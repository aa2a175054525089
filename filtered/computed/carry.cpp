#include "filtered/computed/carry.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace voroproof::internal {

namespace {

// Pairs of states looked at in one proof: bounds the cost where pasts are long.
constexpr std::size_t kMaxPairs = std::size_t{1} << 18;

// The state p of a disk before all that its collision with this id, which follows at the same
// instant, does not depend on.
DiskState independent(const ComputedMotion& motion, DiskState p, int id) {
  while (p.id > 0 && motion.relations().right_angle(id, p.id) != 0)
    p.id = motion.origin(p.g, p.id).before;
  return p;
}

// The first and the last collision of a disk in its cradle.
int first_of(const Cradle& c, GenId g) { return c.ids[g == c.far_end ? 1 : 0]; }
int last_of(const Cradle& c, GenId g) { return c.ids[g == c.far_end ? 1 : 2]; }

// A change of a disk's velocity along one direction at one instant: a collision, or a cradle of
// which the disk is an end.
struct Blow {
  int id;  // id of the last collision
  // Who the outcome depends on: the partner; in a cradle the middle and the other end.
  std::vector<DiskState> partners;
};

Blow blow_of(const ComputedMotion& motion, const DiskState& s) {
  const Cradle* c = motion.relations().cradle(s.id);
  if (c == nullptr || last_of(*c, s.g) != s.id) {
    const ComputedMotion::Origin o = motion.origin(s.g, s.id);
    return {s.id, {independent(motion, {o.partner, o.partner_before}, s.id)}};
  }
  Blow out{s.id, {}};
  if (s.g == c->middle) return out;
  for (const GenId g : {c->middle, s.g == c->end ? c->far_end : c->end}) {
    const int first = first_of(*c, g);
    out.partners.push_back(independent(motion, {g, motion.origin(g, first).before}, first));
  }
  return out;
}

// The origin of a state: a maneuver, or the blows of one instant whose directions are at right
// angles. Neither of two such changes the velocities along the other's direction, so that what both
// do to the disk is the sum of what each would do alone.
struct Past {
  DiskState before;
  const MotionStates::Maneuver* maneuver = nullptr;
  std::vector<Blow> blows;  // if two, the second's normal, seen from the disk, is to the left
};

// The past with as many blows as there are, going back, before a maneuver or a collision that is
// not at right angles to them. nullopt: that happens within a cradle.
std::optional<Past> past_by_blows(const ComputedMotion& motion, const DiskState& s) {
  Past past;
  DiskState& now = past.before;
  std::vector<const Cradle*> cradles;
  for (now = s; now.id > 0;) {
    const ComputedMotion::Origin o = motion.origin(now.g, now.id);
    const Cradle* c = motion.relations().cradle(now.id);
    if (c == nullptr || std::find(cradles.begin(), cradles.end(), c) == cradles.end()) {
      if (o.maneuver != nullptr ||
          !std::all_of(past.blows.begin(), past.blows.end(), [&](const Blow& b) {
            return motion.relations().right_angle(b.id, now.id) != 0;
          })) {
        break;
      }
      past.blows.push_back(blow_of(motion, now));
      if (c != nullptr && last_of(*c, now.g) == now.id) cradles.push_back(c);
    }
    now.id = o.before;
  }
  if (std::any_of(cradles.begin(), cradles.end(),
                  [&](const Cradle* c) { return now.id >= first_of(*c, now.g); })) {
    return std::nullopt;
  }
  std::erase_if(past.blows, [](const Blow& b) { return b.partners.empty(); });
  if (past.blows.size() == 2 &&
      motion.relations().right_angle(past.blows[0].id, past.blows[1].id) < 0) {
    std::swap(past.blows[0], past.blows[1]);
  }
  return past;
}

Past past_of(const ComputedMotion& motion, const DiskState& s) {
  const ComputedMotion::Origin o = motion.origin(s.g, s.id);
  if (o.maneuver != nullptr) return {{s.g, o.before}, o.maneuver, {}};
  if (auto past = past_by_blows(motion, s)) return *std::move(past);
  return {{s.g, o.before}, nullptr, {{s.id, {{o.partner, o.partner_before}}}}};
}

// The equations that a walk through both pasts in step finds.
struct Equations {
  std::vector<Image> points, vectors;
  // Whether they hold for one kind of isometries only.
  bool of_one_kind = false;
};

// The equations for an isometry that reflects, or for one that does not. nullopt: the pasts differ.
std::optional<Equations> equations(const ComputedMotion& motion, std::span<const DiskState> from,
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
      if (a.radius != b.radius || a.mass != b.mass) return std::nullopt;
      out.points.push_back({{a.x, a.y}, {b.x, b.y}});
      out.vectors.push_back({{a.vx, a.vy}, {b.vx, b.vy}});
      continue;
    }
    const Past a = past_of(motion, {ga, ida}), b = past_of(motion, {gb, idb});
    if ((a.maneuver == nullptr) != (b.maneuver == nullptr) || a.blows.size() != b.blows.size()) {
      return std::nullopt;
    }
    if (a.maneuver != nullptr) {
      if (a.maneuver->t != b.maneuver->t) return std::nullopt;
      out.vectors.push_back({{a.maneuver->vx, a.maneuver->vy}, {b.maneuver->vx, b.maneuver->vy}});
    }
    // A reflection turns left into right.
    const bool swap = a.blows.size() == 2 && reflects;
    if (a.blows.size() == 2) out.of_one_kind = true;
    for (std::size_t k = 0; k < a.blows.size(); ++k) {
      const auto &p = a.blows[k].partners, &q = b.blows[swap ? 1 - k : k].partners;
      if (p.size() != q.size()) return std::nullopt;
      for (std::size_t m = 0; m < p.size(); ++m) look_at(p[m], q[m]);
    }
    look_at(a.before, b.before);
  }
  return out;
}

}  // namespace

std::vector<Isometry> carry(const ComputedMotion& motion, std::span<const DiskState> from,
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

bool at_rest(const ComputedMotion& motion, DiskState s) {
  while (s.id > 0) {
    const Past past = past_of(motion, s);
    if (past.maneuver != nullptr) {
      return sgn(past.maneuver->vx) == 0 && sgn(past.maneuver->vy) == 0;
    }
    if (!past.blows.empty()) return false;
    s = past.before;
  }
  if (s.g == container_id) return true;
  const DiskInput& d = motion.input().disks[s.g];
  return sgn(d.vx) == 0 && sgn(d.vy) == 0;
}

DiskState state_before(const ComputedMotion& motion, DiskState s, int records) {
  while (s.id > records) s.id = motion.origin(s.g, s.id).before;
  return s;
}

namespace {

// The turn, by a right angle, from the direction from disk g to a onto that from g to b, where a
// quarter turn carries one pair onto the other: 1 to the left, -1 to the right, 0 none proved.
int quarter_turn(const ComputedMotion& motion, const DiskState& g, const DiskState& a,
                 const DiskState& b) {
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
// False where a is g itself, as for a maneuver of g, or the container: these are not looked at.
bool may_be_right_angle(const ComputedMotion& motion, GenId g, GenId a, GenId b,
                        const DoubleBall& now) {
  if (a == container_id || a == g || a == b) return false;
  const Site<DoubleBall> at = motion.site(g, now), at_a = motion.site(a, now),
                         at_b = motion.site(b, now);
  return !is_certain(sign((at_a.x - at.x) * (at_b.x - at.x) + (at_a.y - at.y) * (at_b.y - at.y)));
}

// Whether a half turn about disk g certainly carries a onto b.
bool half_turn(const ComputedMotion& motion, const DiskState& g, const DiskState& a,
               const DiskState& b) {
  const auto found = carry(motion, PairStates{g, a}, PairStates{g, b});
  return std::any_of(found.begin(), found.end(),
                     [](const Isometry& f) { return !f.reflects && f.a == -1; });
}

// The cradle in the middle of which is g and which ends with the collision of this id.
std::optional<Cradle> cradle_ending_with(const ComputedMotion& motion, int id, GenId g,
                                         int records) {
  const auto last_before = [&](GenId x, int k) {
    return independent(motion, {x, motion.origin(x, k).before}, k).id;
  };
  const GenId end = motion.origin(g, id).partner;
  const int second = last_before(g, id);
  if (second <= records || motion.origin(g, second).maneuver != nullptr) return std::nullopt;
  const GenId far_end = motion.origin(g, second).partner;
  const int first = last_before(g, second);
  if (first <= records || far_end == container_id || far_end == end ||
      motion.generators_of(first) != motion.generators_of(id) || last_before(end, id) != first) {
    return std::nullopt;
  }
  for (const int k : {first, second, id}) {
    if (motion.relations().cradle(k) != nullptr) return std::nullopt;
  }
  const MotionInput& in = motion.input();
  if (in.restitution != 1 || in.disks[g].mass != in.disks[end].mass) return std::nullopt;
  const auto before = [&](GenId k) {
    return state_before(motion, {k, motion.state_id(k)}, records);
  };
  if (!half_turn(motion, before(g), before(end), before(far_end))) return std::nullopt;
  return Cradle{end, g, far_end, {first, second, id}};
}

}  // namespace

void note_relations(ComputedMotion& motion, int records, double lo, double hi) {
  if (motion.records() - records < 2) return;
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
        const ComputedMotion::Origin o = motion.origin(g, first);
        if (may_be_right_angle(motion, g, o.partner, b, now)) {
          const int turn = quarter_turn(motion, before(g), before(o.partner), before(b));
          if (turn != 0) motion.relations().note_right_angle(first, id, turn);
        }
        first = o.before;
      }
    }
  }
  for (int id = records + 1; id <= motion.records(); ++id) {
    const auto [i, j] = motion.generators_of(id);
    if (i == container_id || i == j) continue;
    for (const GenId g : {i, j}) {
      if (const auto c = cradle_ending_with(motion, id, g, records))
        motion.relations().note_cradle(*c);
    }
  }
}

}  // namespace voroproof::internal
