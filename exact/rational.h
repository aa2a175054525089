// Exact rational numbers and their passage from text and to binary64.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace voroproof::internal {

using Integer = mpz_class;
using Rational = mpq_class;

// Sign of a quantity. `unknown` is what a ball answers when it contains zero and
// more: a value of its own, never to be read as zero.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1, unknown = 2 };

inline Sign sign_of(int s) { return s > 0 ? Sign::positive : s < 0 ? Sign::negative : Sign::zero; }
inline Sign sign(double x) { return sign_of((x > 0) - (x < 0)); }
inline Sign sign(const Rational& q) { return sign_of(sgn(q)); }
// Positive or negative: proved, and not zero.
inline bool is_certain(Sign s) { return s == Sign::positive || s == Sign::negative; }
inline Sign operator-(Sign s) {
  return s == Sign::unknown ? s : static_cast<Sign>(-static_cast<int>(s));
}
inline Sign operator*(Sign a, Sign b) {
  if (a == Sign::zero || b == Sign::zero) return Sign::zero;
  if (a == Sign::unknown || b == Sign::unknown) return Sign::unknown;
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

// The exact value of a finite double.
Rational to_rational(double x);

// q rounded to binary64: to nearest (ties to even), down, up. Values beyond the
// range of binary64 give infinities (nearest, and the outer directions); a
// nonzero value that rounds to zero gives +0 or the smallest subnormal.
double round_nearest(const Rational& q);
double round_down(const Rational& q);
double round_up(const Rational& q);

// The number halfway between neighbours a < b, where the nearest binary64 changes; an infinity
// stands for the power of two that would follow the largest finite one.
Rational rounding_breakpoint(double a, double b);

// The larger of the bit lengths of numerator and denominator.
std::size_t bit_size(const Rational& q);

// The nonnegative square root of q when that is rational, otherwise nullopt.
std::optional<Rational> rational_sqrt(const Rational& q);

// Reads a decimal ("-1.5e3"), a fraction ("1/3", both parts decimal integers) or
// a hexadecimal float ("0x1.8p-3") as the exact value it denotes; nullopt when
// the text is none of these. `reason`, when given, receives a short explanation.
// Bounded: at most max_number_text characters and a decimal exponent of at most
// max_decimal_exponent in magnitude (binary: max_binary_exponent), so that
// hostile text cannot ask for unbounded memory. Refused besides: a leading '+',
// blanks, a point without a digit on both sides, a zero denominator, NaN and inf.
inline constexpr std::size_t max_number_text = 4096;
inline constexpr long max_decimal_exponent = 400;
inline constexpr long max_binary_exponent = 1200;
std::optional<Rational> parse_rational(std::string_view text, std::string* reason = nullptr);

}  // namespace voroproof::internal
