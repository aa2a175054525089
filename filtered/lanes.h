// Four doubles side by side. Every operation is that of binary64 in each lane, so results are the
// same where the processor computes with four at once and where it does not.
#pragma once

#include <cmath>
#ifdef __FMA__
#include <immintrin.h>
#endif

// Lanes are passed within the project only, which is compiled for one processor.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace voroproof {

using Lanes [[gnu::vector_size(32)]] = double;

inline Lanes abs(const Lanes& a) {
  using Bits [[gnu::vector_size(32)]] = long long;
  return Lanes(Bits(a) & 0x7fffffffffffffffLL);
}

// s + e = a + b, exactly: for doubles and for lanes.
template <class T>
inline void two_sum_of(const T& a, const T& b, T& s, T& e) {
  s = a + b;
  const T bb = s - a;
  e = (a - (s - bb)) + (b - bb);
}

// a b - p exactly, for p the rounded product, while nothing overflows or underflows.
inline double product_error(double a, double b, double p) {
#ifdef __FMA__
  return std::fma(a, b, -p);
#else
  // Dekker's product through Veltkamp's split.
  constexpr double split = 134217729.0;
  const double ca = split * a, cb = split * b;
  const double ah = ca - (ca - a), al = a - ah;
  const double bh = cb - (cb - b), bl = b - bh;
  return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
#endif
}
inline Lanes product_error(const Lanes& a, const Lanes& b, const Lanes& p) {
#ifdef __FMA__
  return Lanes(_mm256_fmsub_pd(a, b, p));
#else
  constexpr double split = 134217729.0;
  const Lanes ca = split * a, cb = split * b;
  const Lanes ah = ca - (ca - a), al = a - ah;
  const Lanes bh = cb - (cb - b), bl = b - bh;
  return ((ah * bh - p) + ah * bl + al * bh) + al * bl;
#endif
}

}  // namespace voroproof
