// Changes of texts: of bytes, of lines, and of the numbers and words that a format is made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace voroproof::internal::fuzz {

// Random integers, the same on every system, quick to seed (Steele, Lea, Flood, "Fast splittable
// pseudorandom number generators", 2014).
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : next() % bound; }

 private:
  std::uint64_t state_;
};

inline constexpr std::size_t longest_input = 1 << 13;  // bytes

// The text with a few changes, at most longest_input bytes of it. Pieces of `other` may get into
// it.
std::string mutated(std::string text, std::string_view other, Chance& chance);

}  // namespace voroproof::internal::fuzz
