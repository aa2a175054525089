#include "kernel/numbers.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace voroproof_kernel {

Rat power_of_two(long exponent) {
  const Int p = Int(1) << (exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? Rat(1, p) : Rat(p);
}

// frexp and the scaling by 2^53 are exact: no floating-point operation here rounds.
Rat exactly(double x) {
  int exponent;
  const double fraction = std::frexp(x, &exponent);
  return Rat(Int(static_cast<std::int64_t>(std::ldexp(fraction, 53)))) *
         power_of_two(exponent - 53);
}

Rat nearest_binary64(const Rat& x) {
  if (x == 0) return 0;
  const Int p = abs(numerator(x)), q = denominator(x);
  // The quotient p 2^-e / q has 53 or 54 bits before its point; one more step makes it 53.
  long e = static_cast<long>(msb(p)) - static_cast<long>(msb(q)) - 53;
  const auto scaled = [&](long by) { return Rat(p, q) * power_of_two(-by); };
  if (scaled(e) >= power_of_two(53)) ++e;
  if (e < -1074) e = -1074;
  const Rat y = scaled(e);
  Int n = numerator(y) / denominator(y);
  const Rat rest = y - n;
  if (rest > Rat(1, 2) || (rest == Rat(1, 2) && n % 2 == 1)) ++n;
  const Rat r = n * power_of_two(e);
  if (r >= power_of_two(1024)) invalid("a number beyond binary64");
  return x < 0 ? Rat(-r) : r;
}

Rat exact_string(const std::string& text) {
  if (text.size() > 4096) invalid("an exact number of more than 4096 characters");
  const char* at = text.c_str();
  const bool minus = *at == '-';
  if (minus) ++at;
  const bool hex = at[0] == '0' && (at[1] == 'x' || at[1] == 'X');
  if (hex) at += 2;
  const auto digits = [&](bool with_letters) {
    const char* begin = at;
    while ((*at >= '0' && *at <= '9') || (with_letters && std::isxdigit(*at))) ++at;
    if (at == begin) invalid("not an exact number");
    return std::string(begin, at);
  };
  // With leading zeros GMP would read octal digits.
  const auto whole = [&](std::string word) {
    word.erase(0, std::min(word.find_first_not_of('0'), word.size() - 1));
    return Int((hex ? "0x" : "") + word);
  };
  const std::string first = digits(hex);
  Rat value;
  if (!hex && *at == '/') {
    ++at;
    const Int below = whole(digits(false));
    if (below == 0) invalid("a fraction with denominator zero");
    value = Rat(whole(first), below);
  } else {
    const std::string rest = *at == '.' ? (++at, digits(hex)) : "";
    long exponent = 0;
    if (*at == (hex ? 'p' : 'e') || *at == (hex ? 'P' : 'E')) {
      const bool down = *++at == '-';
      if (*at == '-' || *at == '+') ++at;
      const std::string word = digits(false);
      exponent = word.size() > 9 ? 1000000000 : std::stol(word);
      if (exponent > (hex ? 1200 : 400)) invalid("the exponent of an exact number is too large");
      if (down) exponent = -exponent;
    }
    value = whole(first + rest);
    const long scale = exponent - static_cast<long>(rest.size()) * (hex ? 4 : 1);
    const Int power = pow(Int(hex ? 2 : 10), static_cast<unsigned>(std::labs(scale)));
    if (scale < 0) {
      value /= power;
    } else {
      value *= power;
    }
  }
  if (at != text.c_str() + text.size()) invalid("not an exact number");
  return minus ? Rat(-value) : value;
}

Rat length_above(const Vec& v) {
  const Rat n = norm2(v);
  if (n == 0) return 0;
  // sqrt(p/q) = sqrt(p q)/q, with the root's argument scaled to at least 124 bits.
  const Int p = numerator(n), q = denominator(n);
  Int radicand = p * q;
  const long bits = static_cast<long>(msb(radicand));
  const long scale = bits < 124 ? (125 - bits + 1) / 2 : 0;
  radicand <<= 2 * scale;
  return Rat(Int(sqrt(radicand) + 1), q) * power_of_two(-scale);
}

std::string about(const Rat& x) {
  std::string digits = Int(abs(numerator(x)) * 1000000000 / denominator(x)).str();
  if (digits.size() < 10) digits.insert(0, 10 - digits.size(), '0');
  digits.insert(digits.size() - 9, 1, '.');
  return (x < 0 ? "-" : "") + digits;
}

}  // namespace voroproof_kernel
