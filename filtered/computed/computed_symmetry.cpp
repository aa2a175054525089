#include "filtered/computed/computed_symmetry.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "filtered/search/edge_predicates.h"

namespace voroproof::internal {

Rational ComputedSymmetry::radius(const DiskState& s) const {
  const MotionInput& in = motion_.input();
  return s.g == container_id ? Rational(-in.container_radius) : in.disks[s.g].radius.value();
}

namespace {

bool may_vanish(const DoubleBall& x) { return !is_certain(sign(x)); }

template <class T>
T squared_distance(const Site<T>& a, const Site<T>& b) {
  const T dx = a.x - b.x, dy = a.y - b.y;
  return dx * dx + dy * dy;
}

}  // namespace

bool ComputedSymmetry::always_cotangent(const QuadStates& q, const DoubleBall& t) const {
  return mirrored_in_pairs(q, t) || turned_about_a_point(q);
}

bool ComputedSymmetry::mirrored_in_pairs(const QuadStates& q, const DoubleBall& t) const {
  std::array<Site<DoubleBall>, 4> at;
  for (int k = 0; k < 4; ++k) at[k] = motion_.site(q[k].g, t);
  const auto as_far = [&](int a, int b, int c, int d) {
    return may_vanish(squared_distance(at[a], at[b]) - squared_distance(at[c], at[d]));
  };
  for (const auto& [a, b, c, d] : {std::array{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}}) {
    if (radius(q[a]) != radius(q[b]) || radius(q[c]) != radius(q[d])) continue;
    // A past may be long: mostly the present tells.
    if (!as_far(a, c, b, d) || !as_far(a, d, b, c)) continue;
    const auto found =
        carry(QuadStates{q[a], q[b], q[c], q[d]}, QuadStates{q[b], q[a], q[d], q[c]});
    if (std::any_of(found.begin(), found.end(), [](const Isometry& g) { return g.reflects; })) {
      return true;
    }
  }
  return false;
}

bool ComputedSymmetry::mirrored_between(const QuadStates& q, double lo, double hi) const {
  std::array<Site<DoubleBall>, 4> at;
  std::array<Site<DdBall>, 4> at_lo, at_hi;
  for (int k = 0; k < 4; ++k) {
    at[k] = motion_.site(q[k].g, DoubleBall::hull(lo, hi));
    at_lo[k] = motion_.site(q[k].g, DdBall(lo));
    at_hi[k] = motion_.site(q[k].g, DdBall(hi));
  }
  // a to c and b to d for good, then a to c and b to d and back.
  for (const auto& [a, b, c, d] : {std::array{0, 1, 2, 3},
                                   {0, 3, 2, 1},
                                   {0, 1, 3, 2},
                                   {0, 2, 3, 1},
                                   {0, 2, 1, 3},
                                   {0, 3, 1, 2}}) {
    if (radius(q[a]) != radius(q[c]) || radius(q[b]) != radius(q[d])) continue;
    // A half turn would bring them back, too.
    if (may_vanish(at[a].x + at[c].x - at[b].x - at[d].x) &&
        may_vanish(at[a].y + at[c].y - at[b].y - at[d].y)) {
      continue;
    }
    const Sign before =
        sign(squared_distance(at_lo[a], at_lo[d]) - squared_distance(at_lo[b], at_lo[c]));
    const Sign after =
        sign(squared_distance(at_hi[a], at_hi[d]) - squared_distance(at_hi[b], at_hi[c]));
    if (is_certain(before) && after == -before &&
        may_vanish(squared_distance(at[a], at[b]) - squared_distance(at[c], at[d])) &&
        !carry(PairStates{q[a], q[b]}, PairStates{q[c], q[d]}).empty()) {
      return true;
    }
  }
  return false;
}

bool ComputedSymmetry::turned_about_a_point(const QuadStates& q) const {
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

// Whether an isometry certainly carries q onto four of the others. Sites at the instant tell
// which four, and in which order, can be meant.
bool ComputedSymmetry::carried_into(const QuadStates& q, const std::vector<DiskState>& others,
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

namespace {

// The circle that touches three generators, their contact points counterclockwise: centre, radius.
std::array<DoubleBall, 3> circle_touching(const Motion& motion, const DiskState& a,
                                          const DiskState& b, const DiskState& c,
                                          const DoubleBall& now) {
  return tangent_circle(tangent_triple(a.g, motion.site(a.g, now), b.g, motion.site(b.g, now), c.g,
                                       motion.site(c.g, now)));
}

}  // namespace

// The generators that, as far as doubles can tell, touch the circle of the flip at the instant,
// with their states before it.
std::vector<DiskState> ComputedSymmetry::near_circle(const QuadStates& flip,
                                                     const Coincidence& known,
                                                     const DoubleBall& now) const {
  const std::array<DoubleBall, 3> circle = circle_touching(motion_, flip[0], flip[1], flip[2], now);
  std::vector<DiskState> out;
  for (GenId g = container_id; g < motion_.size(); ++g) {
    const Site<DoubleBall> s = motion_.site(g, now);
    // |c - c_g| = rho + r_g; for the container, R - rho.
    const DoubleBall reach = circle[2] + s.r;
    if (may_vanish(squared_distance(s, {circle[0], circle[1], s.r}) - reach * reach)) {
      out.push_back(before(state_of(motion_, g), known));
    }
  }
  return out;
}

// Whether x certainly touches the circle on which the cluster has its contact points.
bool ComputedSymmetry::joins(const DiskState& x, const QuadStates& cluster,
                             const DoubleBall& now) const {
  for (int left_out = 0; left_out < 4; ++left_out) {
    QuadStates q = cluster;
    q[left_out] = x;
    if (always_cotangent(q, now)) return true;
  }
  return false;
}

// Whether an isometry that certainly carries the circle onto itself carries one of the generators
// that touch it onto x: one, say, that carries three of them onto three, their contact points in
// the same order (a reflection: in the opposite one). `circle` begins with three in their order.
bool ComputedSymmetry::is_image(const DiskState& x, const std::vector<DiskState>& circle,
                                const DoubleBall& now) const {
  const auto touched = circle_touching(motion_, circle[0], circle[1], circle[2], now);
  std::vector<std::array<DoubleBall, 2>> contacts;
  std::vector<Site<DoubleBall>> at;
  for (const DiskState& s : circle) {
    const Site<DoubleBall> p = motion_.site(s.g, now);
    const DoubleBall reach = touched[2] + p.r;
    contacts.push_back({(p.x - touched[0]) / reach, (p.y - touched[1]) / reach});
    at.push_back(p);
  }
  const Site<DoubleBall> at_x = motion_.site(x.g, now);
  const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto &p = contacts[i], &q = contacts[j], &r = contacts[k];
    return sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  };
  const std::size_t n = circle.size();
  for (std::size_t m = 0; m < n; ++m) {
    if (!may_vanish(at[m].r - at_x.r)) continue;
    // The places that another may go to if this one goes to x, by radius and distance: mostly none.
    std::vector<std::pair<std::size_t, std::size_t>> moves;
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t image = 0; image < n; ++image) {
        if (may_vanish(at[k].r - at[image].r) &&
            may_vanish(squared_distance(at[k], at[m]) - squared_distance(at[image], at_x))) {
          moves.emplace_back(k, image);
        }
      }
    }
    for (const auto& [a, to_a] : moves) {
      for (const auto& [b, to_b] : moves) {
        if (b <= a ||
            !may_vanish(squared_distance(at[a], at[b]) - squared_distance(at[to_a], at[to_b]))) {
          continue;
        }
        for (const auto& [c, to_c] : moves) {
          if (c <= b) continue;
          const Sign order = turn(a, b, c), image = turn(to_a, to_b, to_c);
          if (!is_certain(order) || !is_certain(image)) continue;
          const auto found = carry(QuadStates{circle[a], circle[b], circle[c], circle[m]},
                                   QuadStates{circle[to_a], circle[to_b], circle[to_c], x});
          for (const Isometry& g : found) {
            if (g.reflects == (order != image)) return true;
          }
        }
      }
    }
  }
  return false;
}

namespace {

// Whether the circles that the two flips touch, each in its cyclic order, certainly are one: there
// is one circle that touches three generators in a given cyclic order.
bool on_one_circle(const QuadStates& a, const QuadStates& b) {
  // Where the generators of a are in b.
  std::vector<int> place;
  for (const DiskState& s : a) {
    const auto it = std::find(b.begin(), b.end(), s);
    if (it != b.end()) place.push_back(static_cast<int>(it - b.begin()));
  }
  if (place.size() < 3) return false;
  // The order must be the same, but for where it begins.
  int descents = 0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    descents += place[k] > place[(k + 1) % place.size()];
  }
  return descents == 1;
}

// The generators that touch the circle of flips[k], as far as the flips tell.
std::vector<DiskState> circle_of(const std::vector<QuadStates>& flips, std::size_t k) {
  std::vector<DiskState> circle;
  std::vector<char> seen(flips.size(), 0);
  std::vector<std::size_t> open{k};
  seen[k] = 1;
  while (!open.empty()) {
    const QuadStates f = flips[open.back()];
    open.pop_back();
    for (const DiskState& s : f) {
      if (std::find(circle.begin(), circle.end(), s) == circle.end()) circle.push_back(s);
    }
    for (std::size_t other = 0; other < flips.size(); ++other) {
      if (seen[other] != 0 || !on_one_circle(f, flips[other])) continue;
      seen[other] = 1;
      open.push_back(other);
    }
  }
  return circle;
}

}  // namespace

Symmetry::Cotangency ComputedSymmetry::cotangency(const QuadStates& q, const Coincidence& known,
                                                  double lo, double hi) const {
  QuadStates b = q;
  for (DiskState& s : b) s = before(s, known);
  const DoubleBall now = DoubleBall::hull(lo, hi);
  if (always_cotangent(b, now)) return Cotangency::every_circle;
  std::vector<QuadStates> flips = known.flips;
  for (QuadStates& f : flips) {
    for (DiskState& s : f) s = before(s, known);
  }
  for (std::size_t k = 0; k < flips.size(); ++k) {
    const QuadStates& f = flips[k];
    std::vector<DiskState> circle = circle_of(flips, k);
    const auto on_circle = [&](const DiskState& s) {
      return std::find(circle.begin(), circle.end(), s) != circle.end();
    };
    const std::vector<DiskState> near = near_circle(f, known, now);
    for (std::size_t before = 0; before != circle.size();) {
      before = circle.size();
      for (const DiskState& x : near) {
        if (!on_circle(x) && (joins(x, f, now) || is_image(x, circle, now))) circle.push_back(x);
      }
    }
    if (std::all_of(b.begin(), b.end(), on_circle) || carried_into(b, circle, now)) {
      return Cotangency::some_circle;
    }
  }
  return Cotangency::unknown;
}

bool ComputedSymmetry::same_contact(const PairStates& a, const PairStates& b) const {
  const PairStates swapped{b[1], b[0]};
  return a == b || a == swapped || !carry(a, b).empty() || !carry(a, swapped).empty();
}

bool ComputedSymmetry::same_flip(const QuadStates& a, const Ball& time, const QuadStates& b,
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

std::optional<PairStates> ComputedSymmetry::collision_before(const DiskState& s) const {
  if (s.id <= 0) return std::nullopt;
  const ComputedMotion::Origin from = motion_.origin(s.g, s.id);
  if (from.maneuver != nullptr) return std::nullopt;
  return PairStates{DiskState{s.g, from.before}, DiskState{from.partner, from.partner_before}};
}

bool ComputedSymmetry::touch(const PairStates& pair, const Coincidence& known) const {
  const PairStates b{before(pair[0], known), before(pair[1], known)};
  return std::any_of(known.contacts.begin(), known.contacts.end(), [&](const PairStates& c) {
    return same_contact(b, {before(c[0], known), before(c[1], known)});
  });
}

}  // namespace voroproof::internal
