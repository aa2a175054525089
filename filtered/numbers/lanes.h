// Four doubles side by side. Every operation is that of binary64 in each lane, so results are the
// same where the processor computes with four at once and where it does not.
#pragma once

#include <cmath>
#ifdef __AVX__
#include <immintrin.h>
#endif

namespace voroproof::internal {

using Lanes [[gnu::vector_size(32)]] = double;

inline Lanes abs(const Lanes& a) {
  using Bits [[gnu::vector_size(32)]] = long long;
  return Lanes(Bits(a) & 0x7fffffffffffffffLL);
}

inline double abs(double a) { return std::fabs(a); }

// The larger of two, and b where one of them is not a number. g++ does not make one instruction of
// the comparison and the choice, where the processor has one.
inline Lanes larger(const Lanes& a, const Lanes& b) {
#ifdef __AVX__
  return Lanes(_mm256_max_pd(a, b));
#else
  return a > b ? a : b;
#endif
}
inline double larger(double a, double b) { return a > b ? a : b; }
// The smaller of two, likewise.
inline Lanes smaller(const Lanes& a, const Lanes& b) {
#ifdef __AVX__
  return Lanes(_mm256_min_pd(a, b));
#else
  return a < b ? a : b;
#endif
}

inline Lanes square_root(const Lanes& a) {
#ifdef __AVX__
  return Lanes(_mm256_sqrt_pd(a));
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

// A bit for each lane in which a exceeds b, the lowest for the first.
inline unsigned exceeding(const Lanes& a, const Lanes& b) {
#ifdef __AVX__
  return static_cast<unsigned>(_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_GT_OQ)));
#else
  unsigned bits = 0;
  for (int k = 0; k < 4; ++k) bits |= static_cast<unsigned>(a[k] > b[k]) << k;
  return bits;
#endif
}

// Four doubles that follow each other in memory, by one instruction where there is one: g++ copies
// them in halves else, and the processor waits for both.
inline Lanes load(const double* from) {
#ifdef __AVX__
  return Lanes(_mm256_loadu_pd(from));
#else
  return Lanes{from[0], from[1], from[2], from[3]};
#endif
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

}  // namespace voroproof::internal
