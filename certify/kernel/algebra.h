// Whole numbers, fractions, polynomials over an interval, and how a verdict ends the work.
#pragma once

#include <array>
#ifdef __EMSCRIPTEN__
#include "certify/kernel/gcd.h"
#else
#include <boost/multiprecision/gmp.hpp>
#endif
#include <vector>

#include "certify/kernel/kernel.h"

namespace voroproof_kernel {

namespace numbers = boost::multiprecision;
using numbers::default_ops::eval_multiply_add;
using Int = numbers::number<
#ifdef __EMSCRIPTEN__  // a browser has no GMP
    numbers::cpp_int_backend<>,
#else
    numbers::gmp_int,
#endif
    numbers::et_off>;
using Rat = numbers::number<
#ifdef __EMSCRIPTEN__
    numbers::rational_adaptor<numbers::cpp_int_backend<>>,
#else
    numbers::gmp_rational,
#endif
    numbers::et_off>;
using Vec = std::array<Rat, 3>;  // the third coordinate is 0 in the plane

// A verdict that ends the work; line 0: the line at hand.
struct Stop {
  Verdict verdict;
  std::string reason;
  std::int64_t line = 0;
  bool last = false;  // no rule holds after it, so that no later line is refuted
  Sight sight{};
};
[[noreturn]] inline void refute(std::string why, const Sight& sight = {}) {
  throw Stop{Verdict::refuted, std::move(why), 0, false, sight};
}
[[noreturn]] inline void undecided(std::string why, const Sight& sight = {}) {
  throw Stop{Verdict::undecided, std::move(why), 0, false, sight};
}
[[noreturn]] inline void invalid(std::string why) { throw Stop{Verdict::invalid, std::move(why)}; }

inline int sgn(const Int& x) { return x.sign(); }
inline int sgn(const Rat& x) { return x.sign(); }
inline Rat square(const Rat& x) { return x * x; }
inline Rat dot(const Vec& a, const Vec& b) {
  const Rat sum = a[0] * b[0] + a[1] * b[1];
  return sgn(a[2]) * sgn(b[2]) == 0 ? sum : Rat(sum + a[2] * b[2]);
}
inline Rat norm2(const Vec& a) { return dot(a, a); }
inline Vec plus(const Vec& v, const Rat& k, const Vec& n) {  // v + k n
  return {v[0] + k * n[0], v[1] + k * n[1], sgn(n[2]) == 0 ? v[2] : Rat(v[2] + k * n[2])};
}
inline Vec minus(const Vec& a, const Vec& b) { return plus(a, -1, b); }

Rat power(int base, long exponent);
// The value of a finite binary64, exactly.
Rat exactly(double x);
// The binary64 nearest to x (ties to even), by whole numbers; throws Stop where there is none.
Rat nearest_binary64(const Rat& x);
// The value of an exact string: decimal, fraction or hexadecimal float. Throws Stop (invalid).
Rat exact_string(const std::string& text);
// An upper bound of the length of v, less than 2^-60 of it too great.
Rat length_above(const Vec& v);
// The whole number next to x towards zero. Throws Stop (undecided) where it has more bits than
// that.
std::int64_t truncated(const Rat& x, unsigned bits);
// The number for messages: twelve digits.
std::string about(const Rat& x);

// Over [a, b] time is t = (a + z b)/(1 + z), z in (0, oo). A form of degree d is the polynomial in
// z that (1 + z)^d makes of one in t, by rising powers: the first coefficient is its value at a,
// the last that at b, up to positive factors. At one time a = b a form is a number.
struct Form : std::vector<Int> {
  using std::vector<Int>::vector;
};
Form operator+(Form p, const Form& q);  // both have the same degree
Form operator-(Form p, const Form& q);
Form operator*(const Form& p, const Form& q);
// The forms over the two halves of the interval.
std::array<Form, 2> halves(const Form& p);
bool is_zero(const Form& p);
// Sign changes of the coefficients: at most so many roots in (a, b), and as many modulo 2.
int variations(const Form& p);
// A form with the same roots in (a, b), each of them once. p is not zero.
Form squarefree(const Form& p);
// The roots in (a, b) that both have. Neither is zero.
Form common(Form p, Form q);

// A polynomial with coefficients by rising powers, up to a positive factor; its form over [a, b];
// and the signs of it at t, and just before (-1) or after (1) t.
Form polynomial(const std::vector<Rat>& coefficients);
Form over(const Form& p, const Rat& a, const Rat& b);
int sign_at(const Form& p, const Rat& t);
int sign_beside(const Form& p, const Rat& t, int side);

}  // namespace voroproof_kernel
