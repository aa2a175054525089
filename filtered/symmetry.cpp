#include "filtered/symmetry.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

namespace voroproof {

namespace {

// Pairs of states looked at in one proof: bounds the cost where pasts are long.
constexpr std::size_t kMaxPairs = std::size_t{1} << 18;

}  // namespace

std::vector<Isometry> Symmetry::carry(std::span<const DiskState> from,
                                      std::span<const DiskState> to) const {
  using Pair = std::tuple<GenId, int, GenId, int>;
  const MotionInput& in = motion_.input();
  std::vector<Image> points, vectors;
  std::set<Pair> seen;
  std::vector<Pair> open;
  const auto look_at = [&](DiskState a, DiskState b) {
    const Pair p{a.g, a.id, b.g, b.id};
    if (seen.insert(p).second) open.push_back(p);
  };
  for (std::size_t k = 0; k < from.size(); ++k) look_at(from[k], to[k]);
  while (!open.empty()) {
    if (seen.size() > kMaxPairs) return {};
    const auto [ga, ida, gb, idb] = open.back();
    open.pop_back();
    if ((ga == container_id) != (gb == container_id)) return {};
    if (ga == container_id) {
      const Vector o{in.container_x, in.container_y};
      points.push_back({o, o});
      continue;
    }
    if ((ida > 0) != (idb > 0)) return {};
    if (ida <= 0) {
      const DiskInput& a = in.disks[ga];
      const DiskInput& b = in.disks[gb];
      if (a.radius != b.radius || a.mass != b.mass ||
          motion_.initial_time(ga) != motion_.initial_time(gb)) {
        return {};
      }
      points.push_back({{a.x, a.y}, {b.x, b.y}});
      vectors.push_back({{a.vx, a.vy}, {b.vx, b.vy}});
      continue;
    }
    const Motion::Origin a = motion_.origin(ga, ida), b = motion_.origin(gb, idb);
    if (a.maneuver != nullptr || b.maneuver != nullptr) {
      if (a.maneuver == nullptr || b.maneuver == nullptr || a.maneuver->t != b.maneuver->t) {
        return {};
      }
      vectors.push_back({{a.maneuver->vx, a.maneuver->vy}, {b.maneuver->vx, b.maneuver->vy}});
    } else {
      look_at({a.partner, a.partner_before}, {b.partner, b.partner_before});
    }
    look_at({ga, a.before}, {gb, b.before});
  }
  return isometries(points, vectors);
}

Rational Symmetry::radius(const DiskState& s) const {
  const MotionInput& in = motion_.input();
  return s.g == container_id ? Rational(-in.container_radius) : in.disks[s.g].radius;
}

bool Symmetry::always_cotangent(const QuadStates& q) const {
  return mirrored_in_pairs(q) || turned_about_a_point(q);
}

bool Symmetry::mirrored_in_pairs(const QuadStates& q) const {
  for (const auto& [a, b, c, d] : {std::array{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}}) {
    if (radius(q[a]) != radius(q[b]) || radius(q[c]) != radius(q[d])) continue;
    const auto found =
        carry(QuadStates{q[a], q[b], q[c], q[d]}, QuadStates{q[b], q[a], q[d], q[c]});
    if (std::any_of(found.begin(), found.end(), [](const Isometry& g) { return g.reflects; })) {
      return true;
    }
  }
  return false;
}

bool Symmetry::turned_about_a_point(const QuadStates& q) const {
  std::array<std::vector<Isometry>, 3> onto;
  for (int k = 0; k < 3; ++k) {
    if (radius(q[k + 1]) != radius(q[0])) return false;
  }
  for (int k = 0; k < 3; ++k) {
    onto[k] = carry({&q[0], 1}, {&q[k + 1], 1});
    if (onto[k].empty()) return false;
  }
  for (const Isometry& f : onto[0]) {
    for (const Isometry& g : onto[1]) {
      for (const Isometry& h : onto[2]) {
        if (have_fixed_point(std::array{f, g, h})) return true;
      }
    }
  }
  return false;
}

DiskState Symmetry::before(DiskState s, const Coincidence& known) const {
  while (s.id > known.records) s.id = motion_.origin(s.g, s.id).before;
  return s;
}

namespace {

bool may_vanish(const DoubleBall& x) {
  const Sign s = sign(x);
  return s == Sign::unknown || s == Sign::zero;
}

DoubleBall squared_distance(const Site<DoubleBall>& a, const Site<DoubleBall>& b) {
  const DoubleBall dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

// Whether an isometry certainly carries q onto four of the others. Sites at the instant tell
// which four, and in which order, can be meant.
bool Symmetry::carried_into(const QuadStates& q, const std::vector<DiskState>& others,
                            const DoubleBall& now) const {
  std::array<Site<DoubleBall>, 4> from, to;
  for (int k = 0; k < 4; ++k) from[k] = motion_.site(q[k].g, now);
  std::vector<Site<DoubleBall>> sites;
  for (const DiskState& s : others) sites.push_back(motion_.site(s.g, now));
  QuadStates images = q;
  const auto assign = [&](const auto& self, int k) -> bool {
    if (k == 4) return !carry(q, images).empty();
    for (std::size_t c = 0; c < others.size(); ++c) {
      bool possible = may_vanish(from[k].r - sites[c].r);
      for (int m = 0; m < k && possible; ++m) {
        possible = !(images[m] == others[c]) && may_vanish(squared_distance(from[k], from[m]) -
                                                           squared_distance(sites[c], to[m]));
      }
      if (!possible) continue;
      images[k] = others[c];
      to[k] = sites[c];
      if (self(self, k + 1)) return true;
    }
    return false;
  };
  return assign(assign, 0);
}

// The generators that, as far as doubles can tell, touch the circle of the flip at the instant,
// with their states before it.
std::vector<DiskState> Symmetry::near_circle(const QuadStates& flip, const Coincidence& known,
                                             const DoubleBall& now) const {
  std::array<DiskState, 3> t{flip[0], flip[1], flip[2]};
  if (t[0].g == container_id) std::rotate(t.begin(), t.begin() + 1, t.end());
  const TangentTriple<DoubleBall> triple(motion_.site(t[0].g, now), motion_.site(t[1].g, now),
                                         motion_.site(t[2].g, now),
                                         t[1].g == container_id || t[2].g == container_id);
  const std::array<DoubleBall, 3> circle = tangent_circle(triple);
  std::vector<DiskState> out;
  for (GenId g = container_id; g < motion_.size(); ++g) {
    const Site<DoubleBall> s = motion_.site(g, now);
    // |c - c_g| = rho + r_g; for the container, R - rho.
    const DoubleBall reach = circle[2] + s.r;
    if (may_vanish(squared_distance(s, {circle[0], circle[1], s.r}) - reach * reach)) {
      out.push_back(before(state(g), known));
    }
  }
  return out;
}

// Whether x certainly touches the circle on which the cluster has its contact points.
bool Symmetry::joins(const DiskState& x, const QuadStates& cluster) const {
  for (int left_out = 0; left_out < 4; ++left_out) {
    QuadStates q = cluster;
    q[left_out] = x;
    if (always_cotangent(q)) return true;
  }
  return false;
}

Symmetry::Cotangency Symmetry::cotangency(const QuadStates& q, const Coincidence& known, double lo,
                                          double hi) const {
  QuadStates b = q;
  for (DiskState& s : b) s = before(s, known);
  if (always_cotangent(b)) return Cotangency::every_circle;
  const DoubleBall now = DoubleBall::hull(lo, hi);
  std::vector<QuadStates> flips = known.flips;
  for (QuadStates& f : flips) {
    for (DiskState& s : f) s = before(s, known);
  }
  for (const QuadStates& f : flips) {
    std::vector<DiskState> circle(f.begin(), f.end());
    const auto on_circle = [&](const DiskState& s) {
      return std::find(circle.begin(), circle.end(), s) != circle.end();
    };
    for (const DiskState& x : near_circle(f, known, now)) {
      if (!on_circle(x) && joins(x, f)) circle.push_back(x);
    }
    if (std::all_of(b.begin(), b.end(), on_circle) || carried_into(b, circle, now)) {
      return Cotangency::some_circle;
    }
  }
  return Cotangency::unknown;
}

bool Symmetry::same_contact(const PairStates& a, const PairStates& b) const {
  return !carry(a, b).empty() || !carry(a, PairStates{b[1], b[0]}).empty();
}

bool Symmetry::same_flip(const QuadStates& a, const Ball& time, const QuadStates& b,
                         const RootInterval& root) const {
  const auto bits = time.precision();
  if (sign(time - Ball(root.lo, bits)) != Sign::positive ||
      sign(Ball(root.hi, bits) - time) != Sign::positive) {
    return false;
  }
  double lo = 0, hi = 0;
  time.to_interval(lo, hi);
  return cotangency(b, {{a}, {}, motion_.records()}, lo, hi) != Cotangency::unknown;
}

bool Symmetry::touch(const PairStates& pair, const Coincidence& known) const {
  const PairStates b{before(pair[0], known), before(pair[1], known)};
  return std::any_of(known.contacts.begin(), known.contacts.end(), [&](const PairStates& c) {
    return same_contact(b, {before(c[0], known), before(c[1], known)});
  });
}

}  // namespace voroproof
