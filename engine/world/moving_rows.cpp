#include "engine/world/moving_rows.h"

#include "filtered/numbers/subdivision.h"

namespace voroproof::internal {
namespace {

// A value that is x at `since` and grows by v in a unit of time.
TimePolynomial line(const Rational& since, const Rational& x, const Rational& v) {
  return TimePolynomial{Rational(x - v * since), v};
}

Site<TimePolynomial> resting(const Site<TimePolynomial>& s, const Rational& t) {
  return {TimePolynomial{s.x.evaluate(t)}, TimePolynomial{s.y.evaluate(t)},
          TimePolynomial{s.r.evaluate(t)}};
}

constexpr int kBitsOfBalls = 192;

Site<Ball> values(const Site<TimePolynomial>& s, const Ball& t) {
  return {value(s.x, t), value(s.y, t), value(s.r, t)};
}

}  // namespace

MovingRows::MovingRows(const std::optional<WorldCircle>& circle, int disks, bool filters)
    : sites_(static_cast<std::size_t>(disks)), rough_(disks, filters) {
  if (!circle) return;
  circle_ = Site<TimePolynomial>{TimePolynomial{circle->center.x}, TimePolynomial{circle->center.y},
                                 line(0, circle->radius, circle->growth)};
  rough_.set(container_id, *circle_);
}

MovingRows::MovingRows(const MovingRows* moving, const Rational& t)
    : moving_(moving), rest_(t), rough_(&moving->rough_, t) {
  if (!moving->circle_) return;
  circle_ = resting(*moving->circle_, t);
}

const Site<TimePolynomial>& MovingRows::site(GenId g) const {
  if (!moving_) return *sites_[g];
  const auto known = rested_.find(g);
  if (known != rested_.end()) return known->second;
  return rested_.emplace(g, resting(moving_->site(g), rest_)).first->second;
}

void MovingRows::set(GenId g, const Rational& since, const GrowingDisk& s) {
  const Site<TimePolynomial> site{line(since, s.x, s.vx), line(since, s.y, s.vy),
                                  line(since, s.radius, s.growth)};
  rough_.set(g, site);
  if (moving_) {
    rested_[g] = site;
  } else {
    sites_[g] = site;
  }
}

MovingRows MovingRows::resting_at(const Rational& t) const { return {this, t}; }

GrowingDisk MovingRows::state_at(GenId g, const Rational& t) const {
  const Site<TimePolynomial>& s = site(g);
  const auto slope = [](const TimePolynomial& c) { return c.degree() < 1 ? Rational(0) : c[1]; };
  return {s.x.evaluate(t), s.y.evaluate(t), s.r.evaluate(t), slope(s.x), slope(s.y), slope(s.r)};
}

GeneratorRow<TimePolynomial> MovingRows::row_of(GenId base, GenId g) const {
  if (g != container_id) return row(site(base), site(g));
  if (!circle_) return {TimePolynomial(), TimePolynomial(), TimePolynomial(), TimePolynomial{1}};
  return row_of_circle(site(base), *circle_);
}

Site<Ball> MovingRows::site(GenId g, const Ball& t) const { return values(site(g), t); }

GeneratorRow<Ball> MovingRows::row_of(GenId base, GenId g, const Ball& t) const {
  const Site<Ball> from = site(base, t);
  if (g != container_id) return row(from, site(g, t));
  const Ball zero(t.precision());
  if (!circle_) return {zero, zero, zero, Ball(1.0, t.precision())};
  return row_of_circle(from, values(*circle_, t));
}

TimePolynomial MovingRows::excess(GenId g, GenId j) const {
  return j == container_id ? -(circle_->r + site(g).r) : site(j).r - site(g).r;
}

TimePolynomial MovingRows::tangency_of(GenId a, GenId b) const {
  return a == container_id ? row_of(b, a).p : row_of(a, b).p;
}

Ball ball_about(const WorldTime& t) {
  return MakeBall{kBitsOfBalls}.hull(t.interval().lo, t.interval().hi);
}

Ball value(const TimePolynomial& f, const Ball& t) {
  Ball value(t.precision());
  for (int i = f.degree(); i >= 0; --i) value = value * t + Ball(f[i], t.precision());
  return value;
}

Sign sign_after(const TimePolynomial& f, const WorldTime& t) {
  if (f.is_zero()) return Sign::zero;
  const Sign s = value(f, ball_about(t)).sign();
  return is_certain(s) ? s : signs_around(f, t).after;
}

Sign sign_after(const TimePolynomial& u, const TimePolynomial& gamma, const TimePolynomial& v,
                const WorldTime& t) {
  const Sign of_u = sign_after(u, t), of_v = sign_after(v, t);
  if (of_u == of_v) return of_u;
  return sign_with_root(of_u, of_v, sign_after(u * u - gamma * v * v, t));
}

}  // namespace voroproof::internal
