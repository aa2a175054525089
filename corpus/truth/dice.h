// Numbers for the lines of the truth set: the same ones everywhere.
#pragma once

#include <cmath>
#include <cstdint>

namespace voroproof::truth {

// SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", OOPSLA
// 2014), one stream for each line of each file. Whole numbers and powers of two only: no result
// depends on a rounding.
class Dice {
 public:
  Dice(std::uint64_t file, std::uint64_t line) : state_(file * 0x9e3779b97f4a7c15u + line) {
    next();
    state_ ^= line << 32;
  }

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // From lo to hi, both included.
  int whole(int lo, int hi) {
    return lo + static_cast<int>(next() % static_cast<std::uint64_t>(hi - lo + 1));
  }
  bool one_in(int n) { return whole(1, n) == 1; }
  int sign() { return one_in(2) ? 1 : -1; }
  // A multiple of 2^-bits in (-1, 1).
  double fraction(int bits) {
    const auto k = static_cast<double>(next() >> (64 - bits));
    return sign() * std::ldexp(k, -bits);
  }

 private:
  std::uint64_t state_;
};

}  // namespace voroproof::truth
