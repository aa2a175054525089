#include "certify/kernel/algebra.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <regex>
#include <sstream>

namespace voroproof_kernel {

Rat power(int base, long exponent) {
  const Int p = pow(Int(base), static_cast<unsigned>(std::labs(exponent)));
  return exponent < 0 ? Rat(1, p) : Rat(p);
}

// frexp and the scaling by 2^53 are exact: no floating-point operation here rounds.
Rat exactly(double x) {
  int exponent;
  const double fraction = std::frexp(x, &exponent);
  return Int(static_cast<std::int64_t>(std::ldexp(fraction, 53))) * power(2, exponent - 53);
}

Rat nearest_binary64(const Rat& x) {
  if (x == 0) return 0;
  const Rat size = abs(x);
  long e = static_cast<long>(msb(numerator(size))) - static_cast<long>(msb(denominator(size))) - 53;
  if (size >= power(2, e + 53)) ++e;
  e = std::max(e, -1074L);  // size / 2^e has 53 bits before its point, or this is subnormal
  const Rat scaled = size * power(2, -e);
  Int n = numerator(scaled) / denominator(scaled);
  const Rat rest = scaled - n;
  if (rest > Rat(1, 2) || (rest == Rat(1, 2) && n % 2 == 1)) ++n;
  const Rat nearest = n * power(2, e);
  if (nearest >= power(2, 1024)) invalid("a number beyond binary64");
  return x < 0 ? -nearest : nearest;
}

Rat exact_string(const std::string& text) {
  static const std::regex fraction("(-?)([0-9]+)/([0-9]+)"),
      decimal("(-?)([0-9]+)(?:[.]([0-9]+))?(?:[eE]([-+]?[0-9]{1,9}))?"),
      hexadecimal("(-?)0[xX]([0-9a-fA-F]+)(?:[.]([0-9a-fA-F]+))?(?:[pP]([-+]?[0-9]{1,9}))?");
  if (text.size() > 4096) invalid("an exact number of more than 4096 characters");
  const auto whole = [](std::string digits, const char* prefix = "") {
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));  // not octal
    return Int(prefix + digits);
  };
  std::smatch m;
  Rat value;
  if (std::regex_match(text, m, fraction)) {
    if (whole(m[3]) == 0) invalid("a fraction with denominator zero");
    value = Rat(whole(m[2]), whole(m[3]));
  } else {
    const bool hex = std::regex_match(text, m, hexadecimal);
    if (!hex && !std::regex_match(text, m, decimal)) invalid("not an exact number");
    const long exponent = m[4].matched ? std::stol(m[4]) : 0;
    if (std::labs(exponent) > (hex ? 1200 : 400)) invalid("the exponent of an exact number");
    value = whole(m[2].str() + m[3].str(), hex ? "0x" : "") *
            power(hex ? 2 : 10, exponent - (hex ? 4 : 1) * m[3].length());
  }
  return m[1].length() == 1 ? -value : value;
}

// sqrt(p/q) = sqrt(p q)/q.
Rat length_above(const Vec& v) {
  const Rat n = norm2(v);
  if (n == 0) return 0;
  const Int radicand = (numerator(n) * denominator(n)) << 124;
  return Rat(sqrt(radicand) + 1, denominator(n) << 62);
}

std::int64_t truncated(const Rat& x, unsigned bits) {
  const Int n = numerator(x) / denominator(x);
  if (abs(n) >> bits != 0) undecided("a disk is farther out than places and images are counted");
  return n.convert_to<std::int64_t>();
}

std::string about(const Rat& x) {
  std::ostringstream text;
  text << std::setprecision(12) << x.convert_to<double>();
  return text.str();
}

Form operator+(Form p, const Form& q) {
  for (std::size_t k = 0; k < p.size(); ++k) p[k] += q[k];
  return p;
}
Form operator-(Form p, const Form& q) {
  for (std::size_t k = 0; k < p.size(); ++k) p[k] -= q[k];
  return p;
}
Form operator*(const Form& p, const Form& q) {
  Form r(p.size() + q.size() - 1);
  if (&p == &q) {  // a square: half the products
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        eval_multiply_add(r[i + j].backend(), p[i].backend(), p[j].backend());
    }
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] <<= 1;
      if (i % 2 == 0) eval_multiply_add(r[i].backend(), p[i / 2].backend(), p[i / 2].backend());
    }
    return r;
  }
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (std::size_t j = 0; j < q.size(); ++j) {
      eval_multiply_add(r[i + j].backend(), p[i].backend(), q[j].backend());
    }
  }
  return r;
}
// The form over both halves: the right half is z = 1 + 2 w, the left half its mirror image.
std::array<Form, 2> halves(const Form& p) {
  std::array<Form, 2> both{p, p};
  std::reverse(both[0].begin(), both[0].end());
  for (Form& q : both) {
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
      for (std::size_t k = q.size() - 1; k-- > i;) q[k] += q[k + 1];
    }
    for (std::size_t k = 1; k < q.size(); ++k) q[k] <<= k;
  }
  std::reverse(both[0].begin(), both[0].end());
  return both;
}

bool is_zero(const Form& p) {
  return std::all_of(p.begin(), p.end(), [](const Int& c) { return c == 0; });
}

int variations(const Form& p) {
  int changes = 0, last = 0;
  for (const Int& c : p) {
    changes += sgn(c) * last < 0;
    if (c != 0) last = sgn(c);
  }
  return changes;
}

namespace {

// Removes zero coefficients at the ends (roots at the ends of the interval) and common factors.
void make_primitive(Form& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  p.erase(p.begin(), std::find_if(p.begin(), p.end(), [](const Int& c) { return c != 0; }));
  Int content = 0;
  for (const Int& c : p) content = gcd(content, c);
  for (Int& c : p) c /= content;
}

// p modulo q and p / q, by whole numbers, up to one constant.
Form remainder(Form p, const Form& q, Form& quotient) {
  quotient.assign(p.size() < q.size() ? 0 : p.size() - q.size() + 1, 0);
  for (; p.size() >= q.size(); p.pop_back()) {
    const std::size_t shift = p.size() - q.size();
    const Int g = gcd(p.back(), q.back()), up = q.back() / g, by = p.back() / g;
    for (Form* form : {&p, &quotient}) {
      for (Int& c : *form) c *= up;
    }
    for (std::size_t k = 0; k < q.size(); ++k) p[k + shift] -= by * q[k];
    quotient[shift] = by;
  }
  return p;
}

}  // namespace

Form common(Form p, Form q) {
  make_primitive(p);
  make_primitive(q);
  for (Form unused; !q.empty(); std::swap(p, q)) {
    if (p.size() < q.size()) std::swap(p, q);
    p = remainder(std::move(p), q, unused);
    make_primitive(p);
  }
  return p;
}

Form squarefree(const Form& p) {
  Form whole(p), derivative, result;
  make_primitive(whole);
  for (std::size_t k = 1; k < whole.size(); ++k) derivative.push_back(k * whole[k]);
  remainder(whole, common(whole, derivative), result);
  return result;
}

Form polynomial(const std::vector<Rat>& coefficients) {
  Int scale = 1;
  for (const Rat& c : coefficients) scale = lcm(scale, denominator(c));
  Form p;
  for (const Rat& c : coefficients) p.push_back(numerator(c) * (scale / denominator(c)));
  while (p.size() > 1 && p.back() == 0) p.pop_back();
  return p;
}

Form over(const Form& p, const Rat& a, const Rat& b) {
  const Int &m = denominator(a), &n = denominator(b);
  const Form t{numerator(a) * n, numerator(b) * m}, one{m * n, m * n};
  Form result{p.back()}, ones = one;
  for (std::size_t k = p.size() - 1; k-- > 0; ones = ones * one) {
    result = result * t;
    for (std::size_t i = 0; i < ones.size(); ++i) result[i] += p[k] * ones[i];
  }
  return result;
}

int sign_at(const Form& p, const Rat& t) { return sgn(over(p, t, t).front()); }

int sign_beside(const Form& p, const Rat& t, int side) {
  const Form f = side < 0 ? over(p, t - 1, t) : over(p, t, t + 1);
  int sign = 0;
  for (const Int& c : f) {
    if (side < 0 ? c != 0 : sign == 0) sign = sgn(c);
  }
  return sign;
}

}  // namespace voroproof_kernel
