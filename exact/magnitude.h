// Bounds of errors whose exponent is wide: balls of thousands of bits have radii far below
// binary64.
#pragma once

#include <mag.h>

#include <cstdint>

namespace voroproof::internal {

// A nonnegative upper bound, infinite where nothing is known: Arb's mag_t, 30 bits with an exponent
// of any size. Every operation rounds up.
class Magnitude {
 public:
  Magnitude() { mag_init(value_); }
  Magnitude(const Magnitude& o) { mag_init_set(value_, o.value_); }
  Magnitude& operator=(const Magnitude& o) {
    mag_set(value_, o.value_);
    return *this;
  }
  ~Magnitude() { mag_clear(value_); }

  explicit Magnitude(const mag_t value) { mag_init_set(value_, value); }
  // A bound of |x| from above; infinite for what is not a number.
  static Magnitude of(double x) {
    Magnitude m;
    mag_set_d(m.value_, x);
    return m;
  }
  static Magnitude power_of_two(std::int64_t e) {
    Magnitude m;
    mag_set_ui_2exp_si(m.value_, 1, e);
    return m;
  }
  static Magnitude infinite() {
    Magnitude m;
    mag_inf(m.value_);
    return m;
  }

  const mag_struct* value() const { return value_; }
  bool is_zero() const { return mag_is_zero(value_) != 0; }
  bool is_infinite() const { return mag_is_inf(value_) != 0; }
  // floor(log2) of a bound that is not zero, within +-2^62; 2^62 where it is infinite.
  std::int64_t exponent() const {
    constexpr std::int64_t most = std::int64_t{1} << 62;
    if (is_infinite()) return most;
    // Exponents beyond 62 bits are not stored in place.
    if (COEFF_IS_MPZ(MAG_EXP(value_))) return fmpz_sgn(MAG_EXPREF(value_)) * most;
    return MAG_EXP(value_) - 1;
  }
  // +inf where it is too large for a double, a small positive number where it is too small.
  double to_double() const { return mag_get_d(value_); }
  // a 2^k.
  Magnitude scaled(std::int64_t k) const {
    Magnitude m;
    mag_mul_2exp_si(m.value_, value_, k);
    return m;
  }
  friend bool operator<(const Magnitude& a, const Magnitude& b) {
    return mag_cmp(a.value_, b.value_) < 0;
  }

 private:
  mag_t value_;
};

}  // namespace voroproof::internal
