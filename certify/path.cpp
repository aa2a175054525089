#include "certify/path.h"

#include <algorithm>
#include <cmath>

#include "certify/fingerprint.h"

namespace voroproof::internal {

using dd_detail::fast_two_sum;
using dd_detail::two_prod;
using dd_detail::two_sum;

namespace {

// Such a sum at work: smallest first.
struct Expansion {
  static constexpr int kMax = 8;  // the four of a sum and the four that are added to them
  std::array<double, kMax> part;
  int size = 0;

  // Shewchuk's GROW-EXPANSION: exact as long as nothing overflows. Zeros are left out.
  void add(double x) {
    double q = x;
    int count = 0;
    for (int k = 0; k < size; ++k) {
      double sum, error;
      two_sum(q, part[k], sum, error);
      if (error != 0) part[count++] = error;
      q = sum;
    }
    if (q != 0) part[count++] = q;
    size = count;
  }

  // Shewchuk's COMPRESS: as few parts as possible, the greatest a good approximation of the sum.
  void compress() {
    if (size == 0) return;
    double q = part[size - 1];
    int bottom = size - 1;
    for (int k = size - 2; k >= 0; --k) {
      double sum, error;
      fast_two_sum(q, part[k], sum, error);
      if (error != 0) {
        part[bottom--] = sum;
        q = error;
      } else {
        q = sum;
      }
    }
    part[bottom] = q;
    int top = 0;
    for (int k = bottom + 1; k < size; ++k) {
      double sum, error;
      fast_two_sum(part[k], q, sum, error);
      if (error != 0) part[top++] = error;
      q = sum;
    }
    part[top] = q;
    size = top + 1;
  }
};

}  // namespace

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
  Expansion sum;
  for (int k = size() - 1; k >= 0; --k) sum.part[sum.size++] = part_[k];
  for (const double x : {g, f, b, a}) {
    if (x != 0) sum.add(x);
  }
  sum.compress();
  if (sum.size > kMax) return false;
  for (int k = 0; k < kMax; ++k) part_[k] = k < sum.size ? sum.part[sum.size - 1 - k] : 0;
  return true;
}

int DyadicSum::size() const {
  return static_cast<int>(std::find(part_.begin(), part_.end(), 0) - part_.begin());
}

Rational DyadicSum::exact() const {
  Rational sum;
  for (int k = size() - 1; k >= 0; --k) sum += to_rational(part_[k]);
  return sum;
}

void DyadicSum::add_to(Fingerprint& fingerprint) const {
  fingerprint.add(size());
  for (int k = size() - 1; k >= 0; --k) fingerprint.add(part_[k]);
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
    const DyadicSum x = x_;
    if (x_.add_way(velocity_.near[0], t, t_)) {
      if (y_.add_way(velocity_.near[1], t, t_)) {
        t_ = t;
        velocity_ = v;
        return;
      }
      x_ = x;
    }
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
