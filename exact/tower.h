// Elements of towers of real quadratic extensions of the rationals.
//
// An element is a rational, or a + b sqrt(r), where r > 0 is the radicand of a
// registered radical and a, b, r are elements over radicals of lower rank. Sums,
// products and quotients stay of this form; the multiplication rule is
// (a + b s)(c + d s) = (ac + bd r) + (ad + bc) s with s = sqrt(r).
//
// Radicals need not be independent: with sqrt(2), sqrt(3) and sqrt(6) registered
// one number has several forms. Signs are right nevertheless, because they are
// decided by values: a + b s vanishes iff a^2 = b^2 r and sign a = -sign b (or
// both are zero), and for opposite signs its sign is sign(a) sign(a^2 - b^2 r),
// a question one rank lower. An interval enclosure is tried first and settles all
// but the (nearly) vanishing elements. Likewise for division: the norm
// a^2 - b^2 r may vanish although a + b s does not; then a = b s and the element
// is 2a. See C. Yap, Fundamental Problems of Algorithmic Algebra (Oxford 2000),
// chapter 6, and C. Li, S. Pion, C. Yap, "Recent progress in exact geometric
// computation", J. Logic Algebr. Program. 64 (2005).
//
// Values share immutable nodes: copies are cheap, and const use from several
// threads is safe. Taking new square roots changes the field and is not.
#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "exact/ball.h"
#include "exact/rational.h"

namespace voroproof::internal {

class RadicalField;
struct Radical;

class Tower {
 public:
  Tower() = default;  // zero
  Tower(int n) : value_(Rational(n)) {}
  Tower(long n) : value_(Rational(n)) {}
  Tower(double) = delete;  // say to_rational(x)
  template <class Expression>
  Tower(const __gmp_expr<mpq_t, Expression>& q) : value_(Rational(q)) {}

  // Whether the element is held as a plain rational. An element that is held
  // over radicals may still have a rational value.
  bool is_rational() const { return std::holds_alternative<Rational>(value_); }
  // Throws std::bad_variant_access unless is_rational().
  const Rational& rational() const { return std::get<Rational>(value_); }

  // Mixing elements of two fields throws std::invalid_argument; a result with
  // coefficients beyond the field's budget throws BudgetExceeded. Plain rationals
  // know no field: theirs is the one made last in this thread (RadicalField), and
  // without any they have no budget. Division by an element of value zero throws
  // std::domain_error. Each operation asks whether it is still wanted (Patience).
  friend Tower operator+(const Tower& x, const Tower& y);
  friend Tower operator-(const Tower& x, const Tower& y);
  friend Tower operator*(const Tower& x, const Tower& y);
  friend Tower operator/(const Tower& x, const Tower& y);
  Tower operator-() const;
  Tower& operator+=(const Tower& y) { return *this = *this + y; }
  Tower& operator-=(const Tower& y) { return *this = *this - y; }
  Tower& operator*=(const Tower& y) { return *this = *this * y; }
  Tower& operator/=(const Tower& y) { return *this = *this / y; }

  // Comparisons of values, exact.
  friend bool operator==(const Tower& x, const Tower& y);
  friend std::strong_ordering operator<=>(const Tower& x, const Tower& y);

  // The sign of the value: never unknown. May throw BudgetExceeded.
  friend Sign sign(const Tower& x);

  // The value, computed with that precision.
  friend Ball ball(const Tower& x, Ball::Precision precision);

  // The largest bit_size among the rational coefficients.
  friend std::size_t bit_size(const Tower& x);

 private:
  friend class RadicalField;
  struct Node;
  class Evaluation;

  static Tower make(const Radical* radical, Tower a, Tower b);
  static Tower plain(Rational q);  // the result of an operation on plain rationals
  static const Radical* common_top(const Tower& x, const Tower& y);
  static std::optional<Rational> structural_ratio(const Tower& x, const Tower& y);

  const Node& node() const;
  const Radical* top() const;  // the radical of the highest rank; null for a plain rational
  // This element as a + b sqrt(radical), for a radical of rank at least that of top().
  const Tower& constant_part(const Radical* radical) const;
  const Tower& radical_part(const Radical* radical) const;
  Tower norm() const;     // a^2 - b^2 r
  Tower inverse() const;  // throws std::domain_error for zero

  std::variant<Rational, std::shared_ptr<const Node>> value_;
};

Ball ball(const Tower& x, Ball::Precision precision);

// Binary64 bounds lo <= x <= hi; neighbours or equal unless x is so close to a
// binary64 that 1024 bits do not tell them apart.
std::pair<double, double> double_interval(const Tower& x);

// The binary64 nearest to x, ties to even, with the conventions of round_nearest(const Rational&).
double round_nearest(const Tower& x);

// A decision needed more than the stated budget.
class BudgetExceeded : public std::runtime_error {
 public:
  BudgetExceeded(std::size_t bits, unsigned long degree);

  const std::size_t bits;      // size of the coefficient that was asked for
  const unsigned long degree;  // the field's over the rationals, if its radicals are independent
};

struct Radical {
  Tower radicand;  // > 0, over radicals of lower rank
  std::size_t rank;
  const RadicalField* field;
};

// The registry of the radicals of one tower. It must outlive its elements. While it
// lives, and no later one does, the arithmetic of plain rationals in the thread that
// made it keeps to its budget; fields of one thread end in the reverse of their order.
class RadicalField {
 public:
  struct Budget {
    std::size_t radicals = 6;
    std::size_t coefficient_bits = std::size_t{1} << 16;
  };

  RadicalField() : RadicalField(Budget{}) {}
  explicit RadicalField(Budget budget);
  ~RadicalField();
  RadicalField(const RadicalField&) = delete;
  RadicalField& operator=(const RadicalField&) = delete;

  // The nonnegative square root. No radical is added for zero, for the square of
  // a rational, nor when x = q^2 r with q rational (found structurally for
  // q != 1, by value for q = 1) and r a registered radicand. Throws
  // std::domain_error for x < 0, BudgetExceeded when a radical too many is
  // needed, std::invalid_argument for an element of another field.
  Tower sqrt(const Tower& x);

  std::size_t size() const { return radicals_.size(); }
  const Budget& budget() const { return budget_; }

 private:
  Budget budget_;
  const RadicalField* outer_;  // whose turn it is again afterwards
  std::vector<std::unique_ptr<const Radical>> radicals_;
};

}  // namespace voroproof::internal
