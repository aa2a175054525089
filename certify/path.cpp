#include "certify/path.h"

#include <cmath>

#include "certify/fingerprint.h"

namespace voroproof::internal {

using dd_detail::fast_two_sum;
using dd_detail::two_prod;
using dd_detail::two_sum;

// Shewchuk's GROW-EXPANSION: exact as long as nothing overflows. Zeros are left out. False where
// the sum becomes too long.
bool DyadicSum::add(double x) {
  double q = x;
  int count = 0;
  std::array<double, kMax + 2> out;
  for (int k = 0; k < size_; ++k) {
    double sum, error;
    two_sum(q, part_[k], sum, error);
    if (error != 0) out[count++] = error;
    q = sum;
  }
  if (q != 0) out[count++] = q;
  if (count > kMax) return false;
  for (int k = 0; k < count; ++k) part_[k] = out[k];
  size_ = count;
  return true;
}

// Shewchuk's COMPRESS: as few parts as possible, the greatest a good approximation of the sum.
void DyadicSum::compress() {
  if (size_ == 0) return;
  double q = part_[size_ - 1];
  int bottom = size_ - 1;
  for (int k = size_ - 2; k >= 0; --k) {
    double sum, error;
    fast_two_sum(q, part_[k], sum, error);
    if (error != 0) {
      part_[bottom--] = sum;
      q = error;
    } else {
      q = sum;
    }
  }
  part_[bottom] = q;
  int top = 0;
  for (int k = bottom + 1; k < size_; ++k) {
    double sum, error;
    fast_two_sum(part_[k], q, sum, error);
    if (error != 0) part_[top++] = error;
    q = sum;
  }
  part_[top] = q;
  size_ = top + 1;
}

bool DyadicSum::add_way(double v, double t, double s) {
  if (v == 0) return true;
  // t - s = d + e and v d = a + b, v e = f + g, exactly while the errors are no denormal numbers.
  double d, e, a, b, f, g;
  two_sum(t, -s, d, e);
  two_prod(v, d, a, b);
  two_prod(v, e, f, g);
  constexpr double least = 0x1p-900, greatest = 0x1p900;
  for (const double product : {a, f}) {
    const double size = std::fabs(product);
    if (!(product == 0 ? true : size > least && size < greatest)) return false;
  }
  if ((a == 0 && d != 0) || (f == 0 && e != 0)) return false;
  if (!(std::fabs(v) < greatest && std::fabs(d) < greatest)) return false;
  // One by one: where the four stand in a list, g++ 12 copies it through a register of AVX and does
  // not clear the register's upper half, for which code without AVX pays later.
  const auto added = [this](double x) { return x == 0 || add(x); };
  if (!(added(g) && added(f) && added(b) && added(a))) return false;
  compress();
  return true;
}

DdBall DyadicSum::near() const {
  if (size_ == 0) return {};
  DdBall out(part_[size_ - 1]);
  if (size_ > 1) out.lo = part_[size_ - 2];
  // What is left is less than the last place of what follows it.
  if (size_ > 2) out.rad = 2 * std::fabs(part_[size_ - 3]);
  return out;
}

Rational DyadicSum::exact() const {
  Rational sum;
  for (int k = 0; k < size_; ++k) sum += to_rational(part_[k]);
  return sum;
}

void DyadicSum::add_to(Fingerprint& fingerprint) const {
  fingerprint.add(size_);
  for (int k = 0; k < size_; ++k) fingerprint.add(part_[k]);
}

Velocity::Velocity(const CompactRational& x, const CompactRational& y)
    : near{round_nearest(x), round_nearest(y)} {
  if (!x.is_double() || !y.is_double()) {
    exact = std::make_shared<const ExactVec2>(ExactVec2{x.value(), y.value()});
  }
}

ExactVec2 Velocity::value() const {
  return exact ? *exact : ExactVec2{to_rational(near[0]), to_rational(near[1])};
}

void Velocity::add_to(Fingerprint& fingerprint) const {
  fingerprint.add(near[0]);
  fingerprint.add(near[1]);
  fingerprint.add(exact != nullptr);
  if (exact) fingerprint.add(*exact);
}

Path::Path(const CompactRational& x, const CompactRational& y, const Velocity& v) : velocity_(v) {
  if (x.is_double() && y.is_double()) {
    x_ = DyadicSum(x.leading());
    y_ = DyadicSum(y.leading());
  } else {
    exact_ = std::make_shared<const Exact>(Exact{0, {x.value(), y.value()}});
  }
}

void Path::turn(double t, const Velocity& v) {
  if (!exact_ && !velocity_.exact) {
    const DyadicSum x = x_, y = y_;
    if (x_.add_way(velocity_.near[0], t, t_) && y_.add_way(velocity_.near[1], t, t_)) {
      t_ = t;
      velocity_ = v;
      return;
    }
    x_ = x;
    y_ = y;
  }
  turn(to_rational(t), v);
}

void Path::turn(const Rational& t, const Velocity& v) {
  exact_ = std::make_shared<const Exact>(Exact{t, at(t)});
  velocity_ = v;
}

Rational Path::since() const { return exact_ ? exact_->t : to_rational(t_); }

ExactVec2 Path::at(const Rational& t) const {
  const Rational dt = t - since();
  const ExactVec2 v = velocity_.value();
  if (exact_) return {exact_->p[0] + v[0] * dt, exact_->p[1] + v[1] * dt};
  return {x_.exact() + v[0] * dt, y_.exact() + v[1] * dt};
}

void Path::add_to(Fingerprint& fingerprint) const {
  velocity_.add_to(fingerprint);
  fingerprint.add(exact_ != nullptr);
  if (exact_) {
    fingerprint.add(exact_->t);
    fingerprint.add(exact_->p);
    return;
  }
  fingerprint.add(t_);
  x_.add_to(fingerprint);
  y_.add_to(fingerprint);
}

std::optional<Path::Start> Path::start() const {
  if (exact_ || velocity_.exact) return std::nullopt;
  return Start{t_, x_.near(), y_.near()};
}

std::optional<std::array<DdBall, 2>> Path::near(double t) const {
  if (exact_ || velocity_.exact) return std::nullopt;
  const DdBall dt = DdBall(t) - DdBall(t_);
  return std::array<DdBall, 2>{x_.near() + DdBall(velocity_.near[0]) * dt,
                               y_.near() + DdBall(velocity_.near[1]) * dt};
}

}  // namespace voroproof::internal
