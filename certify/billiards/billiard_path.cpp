#include "certify/billiards/billiard_path.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace voroproof::internal {
namespace {

// x = units * 2^exponent, for a finite x that is not zero.
struct Dyadic {
  long long units;
  int exponent;
  explicit Dyadic(double x) {
    units = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
    exponent -= 53;
  }
};

void set(Integer& z, long long x) {
  static_assert(sizeof(long) == sizeof(long long));
  z = static_cast<long>(x);
}

// Numbers that are needed for the length of a call: these keep their memory.
struct Scratch {
  Integer passed, way, other;
};
Scratch& scratch() {
  thread_local Scratch numbers;
  return numbers;
}

// a - b in units of 2^exponent, of which both are whole numbers.
void set_difference(Integer& z, double a, double b, int& exponent) {
  if (a == 0 || b == 0) {
    const double x = a == 0 ? -b : a;
    if (x == 0) {
      z = 0;
      exponent = 0;
      return;
    }
    const Dyadic only(x);
    set(z, only.units);
    exponent = only.exponent;
    return;
  }
  const Dyadic first(a), second(b);
  exponent = std::min(first.exponent, second.exponent);
  Integer& other = scratch().other;
  set(z, first.units);
  set(other, second.units);
  z <<= static_cast<unsigned long>(first.exponent - exponent);
  other <<= static_cast<unsigned long>(second.exponent - exponent);
  z -= other;
}

Rational times_power(const Integer& units, long exponent) {
  return exponent < 0 ? Rational(Rational(units) >> static_cast<unsigned long>(-exponent))
                      : Rational(Rational(units) << static_cast<unsigned long>(exponent));
}

}  // namespace

Vec3 value_of(const CompactVec3& v) { return {v[0].value(), v[1].value(), v[2].value()}; }

ExactPlace::ExactPlace(const Vec3& place) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = place[axis].get_d();
    if (x != 0 && to_rational(x) == place[axis]) {
      const Dyadic dyadic(x);
      Integer units;
      set(units, dyadic.units);
      add(axis, units, dyadic.exponent);
    } else if (place[axis] != 0) {
      if (!rest_) rest_.emplace();
      (*rest_)[axis] = place[axis];
    }
  }
}

void ExactPlace::add(std::size_t axis, const Integer& units, long exponent) {
  if (exponent < exponent_) {
    for (Integer& all : units_) all <<= static_cast<unsigned long>(exponent_ - exponent);
    exponent_ = exponent;
  }
  if (exponent == exponent_) {
    units_[axis] += units;
  } else {
    Integer& shifted = scratch().other;
    shifted = units << static_cast<unsigned long>(exponent - exponent_);
    units_[axis] += shifted;
  }
}

void ExactPlace::move(const CompactVec3& velocity, const CompactRational& from,
                      const CompactRational& to) {
  const bool plain = from.is_double() && to.is_double() && velocity[0].is_double() &&
                     velocity[1].is_double() && velocity[2].is_double();
  if (!plain) {
    const Rational passed = to.value() - from.value();
    return move(value_of(velocity) * passed);
  }
  auto& [passed, way, other] = scratch();
  int exponent = 0;
  set_difference(passed, to.leading(), from.leading(), exponent);
  if (passed == 0) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double v = velocity[axis].leading();
    if (v == 0) continue;
    const Dyadic dyadic(v);
    mpz_mul_si(way.get_mpz_t(), passed.get_mpz_t(), static_cast<long>(dyadic.units));
    add(axis, way, static_cast<long>(exponent) + dyadic.exponent);
  }
}

void ExactPlace::move(const Vec3& by) { rest_ = rest_ ? *rest_ + by : by; }

Vec3 ExactPlace::value() const {
  Vec3 place;
  for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = times_power(units_[axis], exponent_);
  return rest_ ? place + *rest_ : place;
}

Vector3<DoubleBall> ExactPlace::near() const {
  Vector3<DoubleBall> place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (units_[axis] == 0) {
      place[axis] = DoubleBall(0);
      continue;
    }
    long exponent = 0;  // the mantissa is rounded towards zero
    const double mantissa = mpz_get_d_2exp(&exponent, units_[axis].get_mpz_t());
    const double x =
        std::ldexp(mantissa, static_cast<int>(std::clamp(exponent + exponent_, -4000L, 4000L)));
    place[axis] = {x, std::fabs(x) * 0x1p-52 + DBL_MIN};
  }
  if (!rest_) return place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    place[axis] = place[axis] + enclosed((*rest_)[axis]);
  }
  return place;
}

BilliardPath::BilliardPath(const BilliardDisk& disk, const Vec3& gravity) : last_(disk.center) {
  for (const Rational& g : gravity) {
    if (g != 0 && !disk.fixed) gravity_ = gravity;
  }
  BilliardLine line{BilliardTime(0), {}, {}, -1, {}, 0};
  for (std::size_t axis = 0; axis < 3; ++axis) line.velocity[axis] = disk.velocity[axis];
  line.near = {line.from.near, last_.near(), enclosed(line.velocity)};
  lines_.push_back(std::move(line));
}

Vec3 BilliardPath::fall(const BilliardLine& line, const Rational& to) const {
  const Rational passed = to - line.from.value();
  return *gravity_ * Rational(passed * passed / 2);
}

Flight<Rational> BilliardPath::exact(std::size_t k) const {
  Vec3 place = last_.value();
  for (std::size_t m = lines_.size() - 1; m > k; --m) {
    const BilliardLine& line = lines_[m - 1];
    const Rational to = lines_[m].from.value();
    place = place - value_of(line.velocity) * Rational(to - line.from.value());
    if (gravity_) place = place - fall(line, to);
  }
  return {lines_[k].from.value(), place, value_of(lines_[k].velocity)};
}

void BilliardPath::turn(const BilliardTime& t, const CompactVec3& velocity, std::int64_t claim,
                        const std::optional<BilliardPair>& by) {
  const BilliardLine& before = lines_.back();
  last_.move(before.velocity, before.from.exact, t.exact);
  if (gravity_) last_.move(fall(before, t.value()));
  lines_.push_back(
      {t, velocity, {t.near, last_.near(), enclosed(velocity)}, claim, by, before.turns + 1});
}

}  // namespace voroproof::internal
