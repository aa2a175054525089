// Univariate polynomials over the rationals or over a tower of square roots.
//
// Over the rationals, greatest common divisors come from the primitive polynomial
// remainder sequence over the integers, which keeps coefficients near the size of
// subresultants (D. Knuth, The Art of Computer Programming 2, section 4.6.1);
// over a tower, from Euclid's algorithm with monic remainders. A tower polynomial
// whose coefficients are all rational takes the rational path.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "exact/rational.h"
#include "exact/tower.h"

namespace voroproof::internal {

// T is Rational or Tower. The leading coefficient is proved nonzero: every
// operation that can lower the degree asks for signs, and so may throw
// BudgetExceeded over a tower.
template <class T>
class Polynomial {
 public:
  Polynomial() = default;  // zero
  // Coefficients from the constant term up; vanishing leading ones are dropped.
  explicit Polynomial(std::vector<T> coefficients) : coefficients_(std::move(coefficients)) {
    while (!coefficients_.empty() && sign(coefficients_.back()) == Sign::zero) {
      coefficients_.pop_back();
    }
  }
  Polynomial(std::initializer_list<T> coefficients) : Polynomial(std::vector<T>(coefficients)) {}

  // -1 for the zero polynomial.
  int degree() const { return static_cast<int>(coefficients_.size()) - 1; }
  bool is_zero() const { return coefficients_.empty(); }
  // The coefficient of x^i, 0 <= i <= degree().
  const T& operator[](int i) const { return coefficients_[static_cast<std::size_t>(i)]; }
  const T& leading() const { return coefficients_.back(); }
  const std::vector<T>& coefficients() const { return coefficients_; }

  T evaluate(const T& x) const {
    T value = 0;
    for (int i = degree(); i >= 0; --i) value = value * x + (*this)[i];
    return value;
  }

  Polynomial derivative() const {
    std::vector<T> result;
    for (int i = 1; i <= degree(); ++i) result.push_back((*this)[i] * T(i));
    return Polynomial(std::move(result));
  }

  Polynomial operator-() const {
    std::vector<T> result;
    for (const T& c : coefficients_) result.push_back(-c);
    return Polynomial(std::move(result));
  }
  friend Polynomial operator+(const Polynomial& f, const Polynomial& g) {
    const Polynomial& longer = f.degree() < g.degree() ? g : f;
    const Polynomial& shorter = f.degree() < g.degree() ? f : g;
    std::vector<T> result = longer.coefficients_;
    for (std::size_t i = 0; i < shorter.coefficients_.size(); ++i) {
      result[i] += shorter.coefficients_[i];
    }
    return Polynomial(std::move(result));
  }
  friend Polynomial operator-(const Polynomial& f, const Polynomial& g) { return f + -g; }
  friend Polynomial operator*(const Polynomial& f, const Polynomial& g) {
    if (f.is_zero() || g.is_zero()) return {};
    std::vector<T> result(f.coefficients_.size() + g.coefficients_.size() - 1);
    for (int i = 0; i <= f.degree(); ++i) {
      for (int j = 0; j <= g.degree(); ++j) result[static_cast<std::size_t>(i + j)] += f[i] * g[j];
    }
    return Polynomial(std::move(result));
  }
  friend Polynomial operator*(const Polynomial& f, const T& scalar) {
    std::vector<T> result;
    for (const T& c : f.coefficients_) result.push_back(c * scalar);
    return Polynomial(std::move(result));
  }
  friend Polynomial operator*(const T& scalar, const Polynomial& f) { return f * scalar; }
  friend bool operator==(const Polynomial& f, const Polynomial& g) {
    return f.coefficients_ == g.coefficients_;
  }

 private:
  std::vector<T> coefficients_;
};

// The same polynomial over the rationals, if every coefficient is held as one.
inline std::optional<Polynomial<Rational>> as_rational(const Polynomial<Tower>& f) {
  std::vector<Rational> coefficients;
  for (const Tower& c : f.coefficients()) {
    if (!c.is_rational()) return std::nullopt;
    coefficients.push_back(c.rational());
  }
  return Polynomial<Rational>(std::move(coefficients));
}

inline std::optional<Polynomial<Rational>> as_rational(const Polynomial<Rational>& f) { return f; }

inline Polynomial<Tower> over_tower(const Polynomial<Rational>& f) {
  return Polynomial<Tower>(std::vector<Tower>(f.coefficients().begin(), f.coefficients().end()));
}

template <class T>
struct Division {
  Polynomial<T> quotient, remainder;
};

// f = quotient * g + remainder, degree(remainder) < degree(g). Throws
// std::domain_error for g = 0.
template <class T>
Division<T> divide(const Polynomial<T>& f, const Polynomial<T>& g) {
  if (g.is_zero()) throw std::domain_error("division by the zero polynomial");
  if (f.degree() < g.degree()) return {{}, f};
  std::vector<T> remainder = f.coefficients();
  std::vector<T> quotient(remainder.size() - g.coefficients().size() + 1);
  const bool monic = g.leading() == T(1);
  for (std::size_t shift = quotient.size(); shift-- > 0;) {
    const T top = std::move(remainder.back());
    remainder.pop_back();  // vanishes by the choice of the quotient's coefficient
    T& q = quotient[shift];
    q = monic ? top : T(top / g.leading());
    for (int i = 0; i < g.degree(); ++i) remainder[shift + static_cast<std::size_t>(i)] -= q * g[i];
  }
  return {Polynomial<T>(std::move(quotient)), Polynomial<T>(std::move(remainder))};
}

// ---- Over the integers ---------------------------------------------------------

// Divides by the positive content; the zero polynomial stays.
inline void make_primitive(std::vector<Integer>& f) {
  Integer content;
  for (const Integer& c : f) content = gcd(content, c);
  if (content == 0 || content == 1) return;
  for (Integer& c : f) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
}

// The primitive integer polynomial that is a positive multiple of f.
inline std::vector<Integer> primitive_integers(const Polynomial<Rational>& f) {
  Integer denominator = 1;
  for (const Rational& c : f.coefficients()) denominator = lcm(denominator, c.get_den());
  std::vector<Integer> result;
  for (const Rational& c : f.coefficients()) {
    result.push_back(c.get_num() * (denominator / c.get_den()));
  }
  make_primitive(result);
  return result;
}

inline Polynomial<Rational> from_integers(const std::vector<Integer>& f) {
  return Polynomial<Rational>(std::vector<Rational>(f.begin(), f.end()));
}

// A primitive associate of the remainder of f by g, both normalized, g not zero.
inline std::vector<Integer> primitive_remainder(std::vector<Integer> f,
                                                const std::vector<Integer>& g) {
  while (f.size() >= g.size()) {
    const Integer common = gcd(f.back(), g.back());
    const Integer scale_f = g.back() / common;
    const Integer scale_g = f.back() / common;
    const std::size_t shift = f.size() - g.size();
    for (Integer& c : f) c *= scale_f;
    for (std::size_t i = 0; i < g.size(); ++i) f[shift + i] -= scale_g * g[i];
    while (!f.empty() && f.back() == 0) f.pop_back();
  }
  make_primitive(f);
  return f;
}

// ---- Greatest common divisor -----------------------------------------------------

// f divided by its leading coefficient; zero stays zero.
template <class T>
Polynomial<T> monic(const Polynomial<T>& f) {
  if (f.is_zero()) return f;
  return f * T(T(1) / f.leading());
}

// Monic; zero iff both are.
inline Polynomial<Rational> gcd(const Polynomial<Rational>& f, const Polynomial<Rational>& g) {
  std::vector<Integer> a = primitive_integers(f);
  std::vector<Integer> b = primitive_integers(g);
  while (!b.empty()) {
    std::vector<Integer> r = primitive_remainder(std::move(a), b);
    a = std::move(b);
    b = std::move(r);
  }
  return monic(from_integers(a));
}

inline Polynomial<Tower> gcd(const Polynomial<Tower>& f, const Polynomial<Tower>& g) {
  if (const auto p = as_rational(f), q = as_rational(g); p && q) return over_tower(gcd(*p, *q));
  Polynomial<Tower> a = f;
  Polynomial<Tower> b = monic(g);
  while (!b.is_zero()) {
    Polynomial<Tower> r = monic(divide(a, b).remainder);
    a = std::move(b);
    b = std::move(r);
  }
  return monic(a);
}

// f / gcd(f, f'), up to a nonzero constant: the distinct roots of f, each once.
// Throws std::invalid_argument for f = 0.
template <class T>
Polynomial<T> square_free_part(const Polynomial<T>& f) {
  if (f.is_zero()) throw std::invalid_argument("square-free part of the zero polynomial");
  const Polynomial<T> repeated = gcd(f, f.derivative());
  if (repeated.degree() == 0) return f;
  return divide(f, repeated).quotient;
}

}  // namespace voroproof::internal
