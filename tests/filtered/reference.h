// A real number known to some thousand bits, by nothing but MPFR with directed rounding: the truth
// that balls are held against.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <array>

#include "exact/rational.h"

namespace voroproof::internal::testing {

class Reference {
 public:
  // Sums of any two doubles are exact at this precision.
  static constexpr mpfr_prec_t kBits = 4500;

  explicit Reference(double x = 0) : Reference(0) { set(x); }
  Reference(double x, double y) : Reference(x) { *this = *this + Reference(y); }
  Reference(const Reference& o) : Reference(0) { *this = o; }
  Reference& operator=(const Reference& o) {
    mpfr_set(lo_, o.lo_, MPFR_RNDD);
    mpfr_set(hi_, o.hi_, MPFR_RNDU);
    return *this;
  }
  ~Reference() { mpfr_clears(lo_, hi_, nullptr); }

  // Whether the number is certainly in [center - radius, center + radius], up to 2^-4000 of itself.
  bool within(const Reference& center, double radius) const {
    const Reference low = center - Reference(radius), high = center + Reference(radius);
    return mpfr_cmp(hi_, low.lo_) >= 0 && mpfr_cmp(lo_, high.hi_) <= 0;
  }
  // Whether `s` is possible as the sign.
  bool may_have(Sign s) const {
    switch (s) {
      case Sign::positive:
        return mpfr_sgn(hi_) > 0;
      case Sign::negative:
        return mpfr_sgn(lo_) < 0;
      case Sign::zero:
        return mpfr_sgn(lo_) <= 0 && mpfr_sgn(hi_) >= 0;
      case Sign::unknown:
        break;
    }
    return true;
  }
  double rounded() const { return mpfr_get_d(lo_, MPFR_RNDN); }

  friend Reference operator+(const Reference& a, const Reference& b) {
    Reference r;
    mpfr_add(r.lo_, a.lo_, b.lo_, MPFR_RNDD);
    mpfr_add(r.hi_, a.hi_, b.hi_, MPFR_RNDU);
    return r;
  }
  friend Reference operator-(const Reference& a) {
    Reference r;
    mpfr_neg(r.lo_, a.hi_, MPFR_RNDD);
    mpfr_neg(r.hi_, a.lo_, MPFR_RNDU);
    return r;
  }
  friend Reference operator-(const Reference& a, const Reference& b) { return a + -b; }
  friend Reference operator*(const Reference& a, const Reference& b) {
    return hull(a, b, mpfr_mul);
  }
  // b is certainly not zero.
  friend Reference operator/(const Reference& a, const Reference& b) {
    return hull(a, b, mpfr_div);
  }
  // The square root of a number that is not negative.
  friend Reference sqrt(const Reference& a) {
    Reference r;
    if (mpfr_sgn(a.lo_) > 0) mpfr_sqrt(r.lo_, a.lo_, MPFR_RNDD);
    mpfr_sqrt(r.hi_, a.hi_, MPFR_RNDU);
    return r;
  }

 private:
  explicit Reference(int) {
    mpfr_init2(lo_, kBits);
    mpfr_init2(hi_, kBits);
    mpfr_set_zero(lo_, 1);
    mpfr_set_zero(hi_, 1);
  }
  void set(double x) {
    mpfr_set_d(lo_, x, MPFR_RNDD);
    mpfr_set_d(hi_, x, MPFR_RNDU);
  }
  template <class Operation>
  static Reference hull(const Reference& a, const Reference& b, Operation operation) {
    Reference r, s;
    bool first = true;
    for (mpfr_srcptr x : {a.lo_, a.hi_}) {
      for (mpfr_srcptr y : {b.lo_, b.hi_}) {
        operation(s.lo_, x, y, MPFR_RNDD);
        operation(s.hi_, x, y, MPFR_RNDU);
        if (first || mpfr_cmp(s.lo_, r.lo_) < 0) mpfr_set(r.lo_, s.lo_, MPFR_RNDD);
        if (first || mpfr_cmp(s.hi_, r.hi_) > 0) mpfr_set(r.hi_, s.hi_, MPFR_RNDU);
        first = false;
      }
    }
    return r;
  }

  mpfr_t lo_, hi_;
};

}  // namespace voroproof::internal::testing
