#include "certify/world/world_geometry.h"

#include <algorithm>
#include <compare>
#include <utility>

#include "exact/ball.h"
#include "exact/simplest.h"

namespace voroproof::internal {

namespace {

using Poly = WorldPolynomial;
using Row = GeneratorRow<Poly>;

TangentTriple<Poly> triple(const WorldCourses& motion, GenId base, const Row& j, const Row& k) {
  const Course& c = motion.course(base);
  return {Site<Poly>{c.x, c.y, c.r}, j, k, false};
}

// Times are narrowed to so many bits of all the time there is, and taken for a rational with a
// denominator of no more than so many bits if they are one: comparisons of equal times that are
// rational are cheap.
constexpr unsigned long kBits = 60;
constexpr unsigned long kDenominatorBits = 24;

void tidy(WorldTime& t, const Poly& f, const Rational& until) {
  if (sgn(until) > 0) t.refine(until >> kBits);
  if (t.is_point()) return;
  const auto [lo, hi] = t.interval();
  if (sgn(lo) <= 0) return;
  const Rational simple = simplest_between(lo, hi);
  if (bit_size(Rational(simple.get_den())) > kDenominatorBits) return;
  if (sign_at(f, simple) == Sign::zero) t = WorldTime(simple);
}

// Signs are told by balls of so many bits first.
constexpr Ball::Precision kBallBits = 128;

Ball ball_around(const RootInterval& at) {
  Ball x((at.lo + at.hi) / 2, kBallBits);
  if (!at.is_point()) x.widen(Magnitude::of(round_up(Rational((at.hi - at.lo) / 2))));
  return x;
}

Sign rough_sign(const Poly& f, const WorldTime& t) {
  const Ball x = ball_around(t.interval());
  Ball value(kBallBits);
  for (int i = f.degree(); i >= 0; --i) value = value * x + Ball(f[i], kBallBits);
  return sign(value);
}

}  // namespace

Row world_row(const WorldCourses& motion, GenId base, GenId g) {
  if (g < 0 && !motion.has_circle()) return {{}, {}, {}, Poly{Rational(1)}};
  const Course &b = motion.course(base), &c = motion.course(g);
  if (g < 0) {
    Row row{b.x - c.x, b.y - c.y, c.r + b.r, {}};
    row.p = row.s * row.s - row.x * row.x - row.y * row.y;
    return row;
  }
  Row row{c.x - b.x, c.y - b.y, c.r - b.r, {}};
  row.p = row.x * row.x + row.y * row.y - row.s * row.s;
  return row;
}

Poly world_tangency(const WorldCourses& motion, GenId g, GenId h) {
  return g < 0 ? world_row(motion, h, g).p : world_row(motion, g, h).p;
}

SignsThen signs_then(const Poly& f, const WorldTime& t) {
  if (f.is_zero()) return {Sign::zero, Sign::zero};
  if (f.degree() == 0) return {sign(f[0]), sign(f[0])};
  if (const Sign s = rough_sign(f, t); is_certain(s)) return {s, s};
  if (t.is_point()) {
    const Rational& at = t.interval().lo;
    const Sign now = sign_at(f, at);
    Poly g = f;
    Sign after = now;
    while (after == Sign::zero) {
      g = g.derivative();
      after = sign_at(g, at);
    }
    return {now, after};
  }
  const Sign now = sign_at(f, t);
  return {now, now != Sign::zero ? now : signs_around(f, t).after};
}

namespace {

// The sign of u + sqrt(gamma) v, where gamma may vanish: then d = u^2 vanishes with u.
Sign sign_at_once(Sign u, Sign v, Sign d) {
  if (d == Sign::zero) return u == v ? u : Sign::zero;
  return sign_with_root(u, v, d);
}

}  // namespace

Sign RootedForm::at(const WorldTime& t) const {
  return sign_at_once(signs_then(u, t).at, signs_then(v, t).at, signs_then(d, t).at);
}
Sign RootedForm::after(const WorldTime& t) const {
  if (u.is_zero()) return signs_then(v, t).after;
  const Sign of_d = signs_then(d, t).after;
  if (of_d == Sign::positive) return signs_then(u, t).after;
  if (of_d == Sign::negative) return signs_then(v, t).after;
  return sign_with_root(signs_then(u, t).after, signs_then(v, t).after, of_d);
}
Sign RootedForm::at(const Rational& t) const {
  return sign_at_once(sign(u.evaluate(t)), sign(v.evaluate(t)), sign(d.evaluate(t)));
}

// Where d vanishes for good, u vanishes at roots of v only, gamma being positive.
const Poly* RootedForm::changes() const {
  if (!u.is_zero() && !d.is_zero()) return &d;
  return v.is_zero() ? nullptr : &v;
}

RootedForm conflict(const TangentTriple<Poly>& t, const Row& e) {
  const Poly a = e.x * t.sp - e.s * t.xp + e.p * t.xs;
  const Poly b = e.y * t.sp - e.s * t.yp + e.p * t.ys;
  const Poly c = e.x * t.yp - e.y * t.xp + e.p * t.xy;
  return {t.xp * a + t.yp * b, c, a * a + b * b - c * c};
}

RootedForm existence(const TangentTriple<Poly>& t) {
  return {t.xp * t.xs + t.yp * t.ys, t.xy, t.xs * t.xs + t.ys * t.ys - t.xy * t.xy};
}

Quad with_disk_on_left(const Quad& q) { return q.l < 0 ? reversed(q) : q; }

WorldEdge::WorldEdge(const WorldCourses& motion, const Quad& edge)
    : legal_while_cotangent_(std::max(edge.l, edge.r) > std::max(edge.s, edge.e)),
      start_([&] {
        const Quad q = with_disk_on_left(edge);
        return triple(motion, q.l, world_row(motion, q.l, q.s), world_row(motion, q.l, q.r));
      }()),
      end_([&] {
        const Quad q = with_disk_on_left(edge);
        return triple(motion, q.l, world_row(motion, q.l, q.r), world_row(motion, q.l, q.e));
      }()) {
  const Quad q = with_disk_on_left(edge);
  from_start_ = conflict(start_, world_row(motion, q.l, q.e));
  // The determinants of both functions are the same: their rows are exchanged cyclically.
  const Row s = world_row(motion, q.l, q.s);
  const Poly a = s.x * end_.sp - s.s * end_.xp + s.p * end_.xs;
  const Poly b = s.y * end_.sp - s.s * end_.yp + s.p * end_.ys;
  from_end_ = {end_.xp * a + end_.yp * b, from_start_.v, from_start_.d};
}

bool WorldEdge::is_illegal_after(const WorldTime& t) const {
  const Sign a = from_start_.after(t), b = from_end_.after(t);
  if (a == Sign::negative || b == Sign::negative) return true;
  return a == Sign::zero && b == Sign::zero && !legal_while_cotangent_ && is_point_after(t);
}

// Which of the two circles that touch the base and the last two of the three others the circle at
// the start is, if it touches all: the sine between their directions, times a positive factor.
// Positive where it is the one at the end.
RootedForm WorldEdge::order() const {
  const auto &m = start_, &n = end_;
  const Poly turn = m.sp * (n.yp * m.xp - n.xp * m.yp);
  const Poly along = n.xp * m.xp + n.yp * m.yp;
  return {turn, along, turn * turn - gamma(m) * along * along};
}

bool WorldEdge::is_point_at(const WorldTime& t, bool lenient) const {
  if (from_start_.at(t) != Sign::zero || from_end_.at(t) != Sign::zero) return false;
  // Where C does not vanish the equations of a circle that touches all have one solution.
  if (signs_then(from_start_.v, t).at != Sign::zero) return true;
  const Sign s = order().at(t);
  return s == Sign::positive || (lenient && s == Sign::zero);
}

bool WorldEdge::is_point_after(const WorldTime& t) const {
  if (from_start_.after(t) != Sign::zero || from_end_.after(t) != Sign::zero) return false;
  return signs_then(from_start_.v, t).after != Sign::zero || order().after(t) == Sign::positive;
}

bool WorldEdge::is_point_at(const Rational& t) const {
  if (from_start_.at(t) != Sign::zero || from_end_.at(t) != Sign::zero) return false;
  return sign(from_start_.v.evaluate(t)) != Sign::zero || order().at(t) == Sign::positive;
}

bool is_inside_after(const WorldCourses& motion, GenId g, GenId h, const LazyTime& t) {
  if (g == h) return false;
  if (h < 0 && !motion.has_circle()) return false;
  if (are_apart(motion.rough(), g, h, t.lo(), t.hi())) return false;
  if (signs_then(world_tangency(motion, g, h), t.exact()).after == Sign::positive) return false;
  if (h < 0) return true;
  const Sign larger = signs_then(motion.course(h).r - motion.course(g).r, t.exact()).after;
  return larger == Sign::positive || (larger == Sign::zero && h < g);
}

bool coincide_at(const WorldCourses& motion, GenId g, GenId h, const LazyTime& t) {
  if (g < 0 || h < 0) return false;
  if (are_apart(motion.rough(), g, h, t.lo(), t.hi())) return false;
  const Course &a = motion.course(g), &b = motion.course(h);
  for (const Poly& difference : {a.x - b.x, a.y - b.y, a.r - b.r}) {
    if (!difference.is_zero() && sign_at(difference, t.exact()) != Sign::zero) return false;
  }
  return true;
}

std::vector<WorldTime> roots_after(const Poly& f, const WorldTime& after, const Rational& until) {
  if (f.degree() <= 0) return {};
  const Rational& lo = after.interval().lo;
  if (lo > until) return {};
  std::vector<WorldTime> all;
  for (WorldTime& root : real_roots(f, lo, until)) {
    if (compare(root, after) <= 0) continue;
    tidy(root, f, until);
    all.push_back(std::move(root));
  }
  return all;
}

}  // namespace voroproof::internal
