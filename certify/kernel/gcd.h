// The greatest common divisor of whole numbers without GMP: Lehmer's, where Boost's subtracts bit
// by bit. Fractions in a browser spend half their time on it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace boost::multiprecision::backends {

// Found by argument-dependent lookup before Boost's template.
inline void eval_gcd(cpp_int_backend<>& result, const cpp_int_backend<>& a,
                     const cpp_int_backend<>& b) {
  using Int = number<cpp_int_backend<>, et_off>;
  Int x = abs(Int(a)), y = abs(Int(b));
  if (x < y) x.swap(y);
  while (y != 0) {
    // Steps of Euclid's algorithm on the leading bits (u, v), for as long as their quotients are
    // those of x and y, whatever the other bits are: u + A, v + C and u + B, v + D bound these.
    const std::size_t bits = msb(x) + 1, shift = bits > 62 ? bits - 62 : 0;
    std::int64_t u = static_cast<std::int64_t>(Int(x >> shift));
    std::int64_t v = static_cast<std::int64_t>(Int(y >> shift));
    std::int64_t A = 1, B = 0, C = 0, D = 1;
    while (v + C != 0 && v + D != 0) {
      const std::int64_t q = (u + A) / (v + C), limit = std::int64_t{1} << 30;
      if (q != (u + B) / (v + D) || q >= limit) break;
      const std::int64_t next[] = {A - q * C, B - q * D, u - q * v};
      if (std::max(std::abs(next[0]), std::abs(next[1])) >= limit) break;
      A = std::exchange(C, next[0]);
      B = std::exchange(D, next[1]);
      u = std::exchange(v, next[2]);
    }
    if (B == 0) {
      x %= y;
      x.swap(y);
    } else {
      const Int next = A * x + B * y;
      y = C * x + D * y;
      x = next;
    }
  }
  result.swap(x.backend());
}

}  // namespace boost::multiprecision::backends
