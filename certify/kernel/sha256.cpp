// SHA-256 (FIPS 180-4): which scene a history is of. No proof uses it.
#include <bit>
#include <numeric>

#include "certify/kernel/files.h"

namespace voroproof_kernel {

std::string sha256(const std::string& text) {
  constexpr std::uint32_t constants[] = {
      0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
      0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
      0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
      0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
      0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
      0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
      0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
      0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
      0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
      0xc67178f2};
  std::array<std::uint32_t, 8> state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                     0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::string padded = text + '\x80';
  padded.resize((text.size() + 72) / 64 * 64);
  const std::uint64_t bits = std::uint64_t{8} * text.size();
  for (int k = 0; k < 8; ++k) padded[padded.size() - 1 - k] = static_cast<char>(bits >> 8 * k);
  const auto turns = [](std::uint32_t x, int a, int b, int c) {
    return std::rotr(x, a) ^ std::rotr(x, b) ^ std::rotr(x, c);
  };
  for (std::size_t at = 0; at < padded.size(); at += 64) {
    std::uint32_t w[64];
    for (int k = 0; k < 16; ++k) {
      w[k] = std::accumulate(padded.begin() + at + 4 * k, padded.begin() + at + 4 * k + 4, 0u,
                             [](std::uint32_t word, unsigned char c) { return word << 8 | c; });
    }
    for (int k = 16; k < 64; ++k) {
      const std::uint32_t x = w[k - 15], y = w[k - 2];
      w[k] = w[k - 16] + w[k - 7] + (std::rotr(x, 7) ^ std::rotr(x, 18) ^ x >> 3) +
             (std::rotr(y, 17) ^ std::rotr(y, 19) ^ y >> 10);
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (int k = 0; k < 64; ++k) {
      const std::uint32_t x = h + turns(e, 6, 11, 25) + ((e & f) ^ (~e & g)) + constants[k] + w[k];
      const std::uint32_t y = turns(a, 2, 13, 22) + ((a & b) ^ (a & c) ^ (b & c));
      h = std::exchange(g, std::exchange(f, std::exchange(e, d + x)));
      d = std::exchange(c, std::exchange(b, std::exchange(a, x + y)));
    }
    const std::uint32_t added[] = {a, b, c, d, e, f, g, h};
    for (int k = 0; k < 8; ++k) state[k] += added[k];
  }
  std::string hex;
  for (const std::uint32_t word : state) {
    for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[word >> shift & 15];
  }
  return hex;
}

}  // namespace voroproof_kernel
