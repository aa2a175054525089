// The common parts of the generators: numbers that are the same on every platform, the square
// lattice, and scenes put together from binary64 numbers.
#pragma once

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "history/scene.h"

namespace voroproof::internal {

struct Vec {
  double x = 0, y = 0;
};

// The margin that comparisons of places add to touching distances. It is far above their rounding
// errors (a few units of 1e-16), so disks that pass are disjoint exactly.
inline constexpr double gap_margin = 1e-9;

inline constexpr double two_pi = 6.283185307179586;

// Uniform numbers in [0, 1), multiples of 2^-53. The standard fixes the sequence
// of the engine, but not those of its own distributions.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

// A number of MPFR. 128 bits and a product that is exact in 192: each result is
// rounded correctly at 128 bits, then once more to binary64, on every platform.
class Real {
 public:
  explicit Real(double x, int bits = 128) {
    mpfr_init2(value_, bits);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;
  ~Real() { mpfr_clear(value_); }
  operator mpfr_ptr() { return value_; }
  // x times this number, in binary64.
  double times(double x) {
    Real product(0, 192);
    mpfr_mul_d(product, value_, x, MPFR_RNDN);
    return mpfr_get_d(product, MPFR_RNDN);
  }

 private:
  mpfr_t value_;
};

// length (cos angle, sin angle).
Vec polar(double angle, double length);
double sine(double angle);

// The shortest decimal of x, for names and comments.
std::string text(double x);

// Throws std::invalid_argument where the condition does not hold.
void require(bool condition, const char* message);
bool finite_and_positive(double x);
bool finite_and_not_negative(double x);

// A scene without disks around the origin, named for its family, n and seed.
Scene empty_scene(std::string family, int n, std::uint64_t seed, double container_radius,
                  double horizon);
// Adds a disk; its mass is the default.
void add_disk(Scene& scene, Vec centre, double radius, Vec velocity);

// A square lattice centred at the origin.
struct Lattice {
  Lattice(int n, double spacing) : half(spacing / 2) {
    while (columns * columns < n) ++columns;
    rows = std::max<long>(1, (n + columns - 1) / columns);
  }
  long column(int i) const { return i % columns; }
  long row(int i) const { return i / columns; }
  // Twice the offset from the centre in units of the spacing: small integers.
  long across(int i) const { return 2 * column(i) - (columns - 1); }
  long up(int i) const { return 2 * row(i) - (rows - 1); }
  Vec centre(int i) const {
    return {half * static_cast<double>(across(i)), half * static_cast<double>(up(i))};
  }
  // Distance of the corners of the full rectangle from the origin.
  double extent() const {
    const auto w = static_cast<double>(columns - 1), h = static_cast<double>(rows - 1);
    return half * std::sqrt(w * w + h * h);
  }

  // The least multiple of the spacing from x on.
  double round_up(double x) const { return 2 * half * std::ceil(x / (2 * half)); }

  long columns = 1, rows = 1;
  double half;
};

}  // namespace voroproof::internal
