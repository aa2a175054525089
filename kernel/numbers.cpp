#include "kernel/numbers.h"

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

namespace {

// A decimal or hexadecimal number without sign; `text` is what remains after the sign.
Rat plain(const std::string& text, bool hex) {
  const auto bad = [] { invalid("not an exact number"); };
  std::size_t at = hex ? 2 : 0;
  Int digits = 0;
  long shift = 0, seen = 0;
  bool point = false;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '.') {
      if (point) bad();
      point = true;
      continue;
    }
    const int d = c >= '0' && c <= '9'          ? c - '0'
                  : hex && c >= 'a' && c <= 'f' ? c - 'a' + 10
                  : hex && c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                : -1;
    if (d < 0) break;
    digits = digits * (hex ? 16 : 10) + d;
    ++seen;
    if (point) ++shift;
  }
  if (seen == 0 || text[at - 1] == '.') bad();
  long exponent = 0;
  if (at < text.size()) {
    const char mark = text[at++];
    if (hex ? mark != 'p' && mark != 'P' : mark != 'e' && mark != 'E') bad();
    const bool minus = at < text.size() && text[at] == '-';
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    if (at == text.size()) bad();
    for (; at < text.size(); ++at) {
      if (text[at] < '0' || text[at] > '9') bad();
      exponent = exponent * 10 + (text[at] - '0');
      if (exponent > (hex ? 1200 : 400)) invalid("the exponent of an exact number is too large");
    }
    if (minus) exponent = -exponent;
  }
  if (hex) return digits * power_of_two(exponent - 4 * shift);
  exponent -= shift;
  const Int scale = pow(Int(10), static_cast<unsigned>(exponent < 0 ? -exponent : exponent));
  return exponent < 0 ? Rat(digits, scale) : Rat(digits * scale);
}

}  // namespace

Rat exact_string(const std::string& text) {
  if (text.size() > 4096) invalid("an exact number of more than 4096 characters");
  std::string rest = text;
  const bool minus = !rest.empty() && rest[0] == '-';
  if (minus) rest.erase(0, 1);
  if (rest.empty() || rest[0] < '0' || rest[0] > '9') invalid("not an exact number");
  const bool hex = rest.size() > 2 && rest[0] == '0' && (rest[1] == 'x' || rest[1] == 'X');
  const std::size_t slash = rest.find('/');
  Rat value;
  if (slash == std::string::npos) {
    value = plain(rest, hex);
  } else {
    const auto whole = [](const std::string& s) {
      if (s.empty() || s.find_first_not_of("0123456789") != std::string::npos) {
        invalid("not an exact number");
      }
      return numerator(plain(s, false));
    };
    const Int p = whole(rest.substr(0, slash)), q = whole(rest.substr(slash + 1));
    if (q == 0) invalid("a fraction with denominator zero");
    value = Rat(p, q);
  }
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
