#include "filtered/search/resting_ties.h"

#include <algorithm>
#include <array>

namespace voroproof::internal {

// Whether doubles prove that no circle touches all four.
bool RestingTies::certainly_apart(const Quad& q) const {
  const auto at = [&](GenId g) { return motion_.site(g, DoubleBall(0.0)); };
  return is_certain(sign(framed_.cotangency(at, q.l, q.r, q.s, q.e)));
}

Site<Rational> RestingTies::exact(GenId g) const {
  const MotionInput& input = motion_.input();
  if (g == container_id) {
    return {input.container_x, input.container_y, Rational(-input.container_radius)};
  }
  const DiskInput& d = input.disks[g];
  return {d.x.value(), d.y.value(), d.radius.value()};
}

// A generator seen from a disk, exactly; the sign of the row is such that p is positive.
GeneratorRow<Rational> RestingTies::row_of(GenId base, GenId g) const {
  const auto at = [&](GenId k) { return exact(k); };
  const GeneratorRow<Rational> r = framed_.row_of(at, base, g);
  return g == container_id && !framed_.is_infinity(g)
             ? GeneratorRow<Rational>{-r.x, -r.y, -r.s, -r.p}
             : r;
}

// Seen from a disk, both circles touch this disk and the first two or the last two of three others.
// With the rows of all kinds of generators of one sign the in-circle function is G + sqrt(Gamma) C;
// it vanishes where both touch the same four. They are one where from the first the contacts with
// the disk and with the last two are counterclockwise.
bool RestingTies::is_point(const Quad& q) const {
  if (certainly_apart(q)) return false;
  std::array<GenId, 4> around{q.l, q.s, q.r, q.e};
  if (framed_.has_walls()) {
    if (framed_.is_at_infinity(start_vertex(q)) || framed_.is_at_infinity(end_vertex(q))) {
      return false;
    }
    if (std::all_of(around.begin(), around.end(), [&](GenId g) { return framed_.is_wall(g); })) {
      const auto at = [&](GenId g) { return exact(g); };
      return sign(framed_.tangency_between_walls(at, start_vertex(q), q.e)) == Sign::zero;
    }
  }
  // From a disk on: one of the edge's two, where one of these is a disk.
  for (const int first : {0, 2, 1, 3}) {
    if (!framed_.is_disk(around[first])) continue;
    std::rotate(around.begin(), around.begin() + first, around.end());
    break;
  }
  const GenId base = around[0];
  const GeneratorRow<Rational> a = row_of(base, around[1]), b = row_of(base, around[2]),
                               c = row_of(base, around[3]);
  const Site<Rational> origin = exact(base);
  const TangentTriple<Rational> m(origin, a, b, false), n(origin, b, c, false);
  const InCircleParts<Rational> parts(m, c);
  const Rational A = c.x * m.sp - c.s * m.xp + c.p * m.xs, B = c.y * m.sp - c.s * m.yp + c.p * m.ys,
                 C = parts.c();
  const Sign f = sign(Rational(A * A + B * B - C * C));
  if (sign_with_root(sign(parts.g()), sign(C), f) != Sign::zero) return false;
  const Rational x = -m.sp * (n.xp * m.yp - n.yp * m.xp), y = n.xp * m.xp + n.yp * m.yp;
  return sign_with_root(sign(x), sign(y), sign(Rational(x * x - gamma(m) * y * y))) ==
         Sign::positive;
}

}  // namespace voroproof::internal
