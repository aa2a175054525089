// Whole numbers and fractions, how they are read, and how a verdict ends the work.
#pragma once

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cstdint>
#include <string>

#include "kernel/kernel.h"

namespace voroproof_kernel {

using Int = boost::multiprecision::mpz_int;
using Rat = boost::multiprecision::mpq_rational;
using Vec = std::array<Rat, 2>;

// A verdict that ends the work; line 0: the line at hand.
struct Stop {
  Verdict verdict;
  std::string reason;
  std::int64_t line = 0;
};
[[noreturn]] inline void refute(std::string why) { throw Stop{Verdict::refuted, std::move(why)}; }
[[noreturn]] inline void undecided(std::string why) {
  throw Stop{Verdict::undecided, std::move(why)};
}
[[noreturn]] inline void invalid(std::string why, std::int64_t line = 0) {
  throw Stop{Verdict::invalid, std::move(why), line};
}

inline int sgn(const Int& x) { return x.sign(); }
inline int sgn(const Rat& x) { return x.sign(); }
inline Rat square(const Rat& x) { return x * x; }
inline Rat dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Rat norm2(const Vec& a) { return dot(a, a); }
inline Vec minus(const Vec& a, const Vec& b) { return {Rat(a[0] - b[0]), Rat(a[1] - b[1])}; }

Rat power_of_two(long exponent);
// The value of a finite binary64, exactly.
Rat exactly(double x);
// The binary64 nearest to x (ties to even), by whole numbers; throws Stop where there is none.
Rat nearest_binary64(const Rat& x);
// The value of an exact string: decimal, fraction or hexadecimal float. Throws Stop (invalid).
Rat exact_string(const std::string& text);
// An upper bound of the length of v, less than 2^-60 of it too great.
Rat length_above(const Vec& v);
// For messages: nine digits after the point.
std::string about(const Rat& x);

}  // namespace voroproof_kernel
