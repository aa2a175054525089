// Rational numbers in little memory.
#pragma once

#include "exact/rational.h"

namespace voroproof::internal {

// A rational number of which a scene has many. Nearly all of them are a binary64 or, as the square
// of one, the sum of two: these are held as such, in two words, and nothing is allocated. Any other
// number it holds as a Rational.
class CompactRational {
 public:
  CompactRational() = default;
  // Precondition: x is finite.
  CompactRational(double x) : leading_(x + 0.0) {}  // not -0
  CompactRational(const Rational& q);
  CompactRational(const CompactRational& other);
  CompactRational(CompactRational&& other) noexcept : CompactRational() { swap(other); }
  CompactRational& operator=(CompactRational other) noexcept {
    swap(other);
    return *this;
  }
  ~CompactRational() {
    if (is_allocated()) delete exact_;
  }

  Rational value() const;
  operator Rational() const { return value(); }
  // The number where it is not leading() + second(), else null; valid as long as this object.
  const Rational* exact() const { return is_allocated() ? exact_ : nullptr; }
  // The nearest binary64, ties to even, and what the number has beyond it. Precondition: !exact().
  double leading() const { return leading_; }
  double second() const { return second_; }
  bool is_double() const { return !is_allocated() && second_ == 0; }

  // There is one form for each value.
  friend bool operator==(const CompactRational& a, const CompactRational& b) {
    if (a.is_allocated() || b.is_allocated()) {
      return a.is_allocated() && b.is_allocated() && *a.exact_ == *b.exact_;
    }
    return a.leading_ == b.leading_ && a.second_ == b.second_;
  }
  friend bool operator<(const CompactRational& a, const CompactRational& b) {
    if (a.is_double() && b.is_double()) return a.leading_ < b.leading_;
    return a.value() < b.value();
  }
  friend int sgn(const CompactRational& a) {
    if (a.is_allocated()) return ::sgn(*a.exact_);
    return (a.leading_ > 0) - (a.leading_ < 0);
  }
  friend CompactRational square(const CompactRational& a);
  friend CompactRational operator-(const CompactRational& a, const CompactRational& b);

 private:
  bool is_allocated() const { return leading_ != leading_; }
  void swap(CompactRational& other) noexcept;

  double leading_ = 0;  // NaN where the number is at exact_
  union {
    double second_ = 0;
    const Rational* exact_;
  };
};

double round_nearest(const CompactRational& q);

}  // namespace voroproof::internal
