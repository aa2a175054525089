// The divisor of whole numbers without GMP, against GMP's.
#include "certify/kernel/gcd.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <random>

namespace voroproof_kernel {
namespace {

using Own = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                          boost::multiprecision::et_off>;
using Gmp = boost::multiprecision::mpz_int;

TEST(KernelGcd, IsThatOfGmp) {
  std::mt19937_64 random(1);
  const auto below = [&](std::uint64_t n) { return random() % n; };
  const auto any = [&](unsigned bits) {
    Own x = 0;
    for (unsigned k = 0; k < bits; k += 64) x = (x << 64) + random();
    // Also powers of two and their neighbours.
    if (below(4) == 0) x = (Own(1) << below(bits)) + below(3) - 1;
    return Own(x >> below(64));
  };
  for (int k = 0; k < 30000; ++k) {
    const Own common = any(1 + below(300));
    Own a = any(1 + below(600)) * common, b = any(1 + below(600)) * common;
    if (below(8) == 0) a = -a;
    if (below(8) == 0) b = a + below(3);
    EXPECT_EQ(gcd(a, b).str(), gcd(Gmp(a.str()), Gmp(b.str())).str()) << a << " " << b;
    const boost::multiprecision::cpp_rational fraction(a.str() + "/" + Own(abs(b) + 1).str());
    EXPECT_EQ(gcd(Gmp(numerator(fraction).str()), Gmp(denominator(fraction).str())), 1);
  }
  // Consecutive Fibonacci numbers have the longest sequences of quotients, all of them 1.
  Own x = 1, y = 1;
  for (int k = 0; k < 3000; ++k) x = std::exchange(y, x + y);
  EXPECT_EQ(gcd(x, y), 1);
  EXPECT_EQ(gcd(Own(x * 12345), Own(y * 12345)), 12345);
}

}  // namespace
}  // namespace voroproof_kernel
