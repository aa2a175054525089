#include "filtered/search/resting_ties.h"

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
  if (framed_.is_infinity(g)) return {0, 0, 0, 1};
  const GeneratorRow<Rational> r = row(exact(base), exact(g));
  return g == container_id ? GeneratorRow<Rational>{-r.x, -r.y, -r.s, -r.p} : r;
}

// Seen from a disk, l or r, both circles touch this disk and the first two or the last two of three
// others. With the rows of all kinds of generators of one sign the in-circle function is G +
// sqrt(Gamma) C; it vanishes where both touch the same four. They are one where from the first the
// contacts with the disk and with the last two are counterclockwise.
bool RestingTies::is_point(const Quad& q) const {
  if (certainly_apart(q)) return false;
  const bool turned = q.l == container_id;
  const GenId base = turned ? q.r : q.l;
  const GeneratorRow<Rational> a = row_of(base, turned ? q.e : q.s),
                               b = row_of(base, turned ? q.l : q.r),
                               c = row_of(base, turned ? q.s : q.e);
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
