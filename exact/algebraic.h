// Real algebraic numbers: a polynomial and an interval that isolates one of its roots,
// of odd multiplicity.
//
// Two numbers are compared by bisection until their intervals part. Numbers that
// stay together are equal iff the greatest common divisor of their polynomials has
// a root in the common interval; nothing is ever called equal for being near
// (C. Yap, Fundamental Problems of Algorithmic Algebra, Oxford 2000, chapters 6
// and 7). A number that is not equal to the other parts from it at last.
//
// All templates are instantiated for Rational and Tower.
#pragma once

#include <compare>
#include <memory>
#include <vector>

#include "exact/polynomial.h"
#include "exact/rational.h"
#include "exact/roots.h"

namespace voroproof::internal {

// A value: const use from several threads is safe. Over a tower every operation
// that asks for signs of new elements may throw BudgetExceeded.
template <class T>
class AlgebraicNumber {
 public:
  AlgebraicNumber(const Rational& q) : interval_{q, q} {}
  // The root of f that `root` isolates (as RootInterval states).
  AlgebraicNumber(const Polynomial<T>& f, const RootInterval& root);

  // A polynomial with this root and no other in interval(); it changes its sign there.
  Polynomial<T> polynomial() const;
  const RootInterval& interval() const { return interval_; }
  // Whether the number is known to be the rational interval().lo.
  bool is_point() const { return interval_.is_point(); }
  // Whether g is polynomial() itself. False says nothing.
  bool is_root_of(const Polynomial<T>& g) const { return equation_ && g == equation_->polynomial; }

  // Narrows interval() to at most `width` > 0.
  void refine(const Rational& width);

  friend std::strong_ordering operator<=>(const AlgebraicNumber& x, const AlgebraicNumber& y) {
    return compare(x, y);
  }
  friend bool operator==(const AlgebraicNumber& x, const AlgebraicNumber& y) {
    return compare(x, y) == 0;
  }

  template <class U>
  friend std::strong_ordering compare(const AlgebraicNumber<U>& x, const AlgebraicNumber<U>& y);
  template <class U>
  friend std::strong_ordering compare(const AlgebraicNumber<U>& x, const Rational& q);
  template <class U>
  friend double round_nearest(const AlgebraicNumber<U>& x);
  template <class U>
  friend std::vector<AlgebraicNumber<U>> real_roots(const Polynomial<U>& f, const Rational& lo,
                                                    const Rational& hi);

 private:
  // The facts about a number's polynomial, shared by copies and conjugates.
  struct Equation {
    explicit Equation(const Polynomial<T>& f) : polynomial(f), sign_at(f) {}
    Polynomial<T> polynomial;
    SignEvaluator<T> sign_at;
  };

  AlgebraicNumber(std::shared_ptr<const Equation> equation, const RootInterval& root);
  static AlgebraicNumber make(const std::shared_ptr<const Equation>& equation,
                              const RootInterval& root);
  void halve();  // is_point() must be false
  static bool equal(const AlgebraicNumber& x, const AlgebraicNumber& y);

  RootInterval interval_;
  std::shared_ptr<const Equation> equation_;  // may be null for a point
  Sign at_lo_ = Sign::zero;                   // sign of the polynomial at interval_.lo
};

// The distinct real roots of f in [lo, hi], in increasing order. Errors as for
// isolate_roots.
template <class T>
std::vector<AlgebraicNumber<T>> real_roots(const Polynomial<T>& f, const Rational& lo,
                                           const Rational& hi);

template <class T>
std::strong_ordering compare(const AlgebraicNumber<T>& x, const AlgebraicNumber<T>& y);
template <class T>
std::strong_ordering compare(const AlgebraicNumber<T>& x, const Rational& q);

// The nearest binary64, ties to even, with the conventions of
// round_nearest(const Rational&).
template <class T>
double round_nearest(const AlgebraicNumber<T>& x);

// The sign of g at x, and its signs just before and just after x; g is any
// polynomial, for signs_around not zero (or std::invalid_argument).
template <class T>
Sign sign_at(const Polynomial<T>& g, const AlgebraicNumber<T>& x);
template <class T>
SignsAround signs_around(const Polynomial<T>& g, const AlgebraicNumber<T>& x);

// A rational number strictly between two numbers that differ. Over a tower it may throw
// BudgetExceeded, as compare() may.
template <class T>
Rational rational_between(AlgebraicNumber<T> x, AlgebraicNumber<T> y);

// The part around x of an interval that contains x, in which g, any polynomial, has no root but
// perhaps x itself.
template <class T>
RootInterval clear_of(const Polynomial<T>& g, const AlgebraicNumber<T>& x, RootInterval within);

}  // namespace voroproof::internal
