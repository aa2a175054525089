// When an edge collapses, by real algebraic numbers alone: no filter, no window. For motions
// without collisions in their past, so that all numbers are rational.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "exact/predicates.h"
#include "filtered/search/collapse.h"
#include "tests/support/compact_arithmetic.h"

namespace voroproof::internal::testing {

class CollapseTruth {
 public:
  CollapseTruth(const MotionInput& in, const Quad& q) : in_(in), q_(q) {
    const auto of = [](const CompactRational& x) { return Tower(x.value()); };
    const auto path = [&](GenId g) -> Site<Polynomial<Tower>> {
      if (g == container_id) {
        return {{Tower(in.container_x)},
                {Tower(in.container_y)},
                {Tower(Rational(-in.container_radius))}};
      }
      const DiskInput& d = in.disks[g];
      return {{of(d.x), of(d.vx)}, {of(d.y), of(d.vy)}, {of(d.radius)}};
    };
    const auto l = path(q.l), r = path(q.r), s = path(q.s), e = path(q.e);
    // For equal radii f = -C^2; a root of even multiplicity is no obstacle here, but C is
    // easier.
    polynomial_ = cocircularity(e, l, r, s);
    const auto equal = [&](const auto& x) { return x.r == l.r; };
    if (!equal(r) || !equal(s) || !equal(e)) polynomial_ = cotangency(l, r, s, e);
  }

  const Polynomial<Tower>& polynomial() const { return polynomial_; }

  // The first collapse later than `start` (not at it) and no later than `end`.
  std::optional<ExactTime> after(const ExactTime& start, const Rational& end) const {
    const auto roots = real_roots(polynomial_, Rational(0), Rational(end + 1));
    for (std::size_t k = 0; k < roots.size(); ++k) {
      if (!(roots[k] > start)) continue;
      if (compare(roots[k], end) > 0) break;
      if (collapses(roots[k])) return roots[k];
    }
    return std::nullopt;
  }

  // Whether the edge is legal at a time at which nothing is cotangent.
  bool legal(const Rational& t) const {
    const auto [exist, signs] = look(t);
    return exist && signs[0] == Sign::positive && signs[1] == Sign::positive;
  }

 private:
  struct Look {
    bool exist;
    std::array<Sign, 2> signs;
  };

  Site<Rational> site(GenId g, const Rational& t) const {
    if (g == container_id) {
      return {in_.container_x, in_.container_y, Rational(-in_.container_radius)};
    }
    const DiskInput& d = in_.disks[g];
    return {Rational(d.x + t * d.vx), Rational(d.y + t * d.vy), d.radius};
  }

  // Both circles and both in-circle signs at one time.
  Look look(const Rational& t) const {
    const auto triple = [&](GenId a, GenId b, GenId c) {
      const auto v = disk_first(a, b, c);
      return TangentTriple<Rational>(site(v[0], t), site(v[1], t), site(v[2], t),
                                     v[1] == container_id || v[2] == container_id);
    };
    const auto start = triple(q_.l, q_.s, q_.r), end = triple(q_.r, q_.e, q_.l);
    const Sign f = sign(cotangency(site(q_.l, t), site(q_.r, t), site(q_.s, t), site(q_.e, t)));
    return {circle_exists(start) == Sign::positive && circle_exists(end) == Sign::positive,
            {incircle(start, site(q_.e, t), q_.e == container_id, f),
             incircle(end, site(q_.s, t), q_.s == container_id, f)}};
  }

  // Both signs negative just after the root, where the circles exist around it. "Just" is
  // 2^-200 here: no scene of the tests has two different events as near as that.
  bool collapses(ExactTime root) const {
    const Rational hair(Integer(1), Integer(1) << 200);
    root.refine(hair);
    const Look before = look(root.interval().lo - hair), after = look(root.interval().hi + hair);
    if (before.exist != after.exist) throw std::logic_error("a circle appears at a collapse");
    return after.exist && after.signs[0] == Sign::negative && after.signs[1] == Sign::negative;
  }

  const MotionInput& in_;
  Quad q_;
  Polynomial<Tower> polynomial_;
};

}  // namespace voroproof::internal::testing
