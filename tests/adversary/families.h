// Families of scenes for wrong worlds.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string_view>

#include "tests/adversary/claims.h"

namespace voroproof::internal::adversary {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // [low, high)
  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  // Logarithms uniform over [low, high).
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  // From low to high, both included.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double p) { return uniform(0, 1) < p; }

 private:
  std::mt19937_64 engine_;
};

enum class Family {
  generic,
  equal_radii,
  points,
  dense,
  log_radii,
  two,
  maneuvers,
  inelastic,
  wall_laws,
  tiny,            // radii 1e-7 .. 1e-3 on collision course
  tiny_fast,       // the same with speeds up to 1e7: smaller than their way in a tolerance
  fast,            // disks of usual size with speeds 1e3 .. 1e7
  near_miss,       // pairs that pass at 1e-9 .. 1e-3
  stranger,        // one disk is very fast for a moment
  lattice,         // small integers: ties and symmetry
  mirror,          // mirror-symmetric: ties that last
  touching,        // lattice, some touch at 0
  touch_maneuver,  // pairs at rest that touch and are sent into each other
  horizon_touch,   // an event within the tolerance of the horizon
  resting,         // points that hit a disk head-on, most of them without restitution
  crowded,         // flips and maneuvers within a few tolerances of each other
  meeting,         // points that meet: at a disk, at the wall, at a maneuver, at the horizon
  round,           // an edge collapses at the instant at which one of its generators turns
  large,           // n = 20 .. 60; the last, since it is drawn less often
  count
};
inline constexpr std::array<std::string_view, static_cast<int>(Family::count)> family_names{
    "generic",       "equal radii", "points",    "dense",   "log radii", "two",
    "maneuvers",     "inelastic",   "wall laws", "tiny",    "tiny fast", "fast",
    "near miss",     "stranger",    "lattice",   "mirror",  "touching",  "touch maneuver",
    "horizon touch", "resting",     "crowded",   "meeting", "round",     "large"};

inline std::string_view name(Family f) { return family_names[static_cast<std::size_t>(f)]; }

// Whether the family's right histories can be told by long double: no ties that last.
inline bool in_general_position(Family f) {
  return f != Family::lattice && f != Family::mirror && f != Family::touching &&
         f != Family::resting && f != Family::meeting && f != Family::round;
}

// A scene of the family. Its disks are apart or touch exactly.
SceneData scene_of(Family family, Random& random);

}  // namespace voroproof::internal::adversary
