#include "tests/certify/mutation_scenes.h"

#include <array>
#include <cmath>

#include "corpus/generate.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/lattice_scene.h"

namespace voroproof::internal::testing {

namespace {

// The scene with all lengths multiplied by a power of two.
Scene scaled(Scene scene, int exponent) {
  const Rational unit = to_rational(std::ldexp(1.0, exponent));
  for (Rational* x : {&scene.cx, &scene.cy, &scene.container_radius}) *x *= unit;
  for (DiskInput& d : scene.disks) {
    for (CompactRational* x : {&d.x, &d.y, &d.radius, &d.vx, &d.vy}) *x *= unit;
  }
  return scene;
}

}  // namespace

std::vector<Scene> some_scenes(Random& random, int rounds) {
  std::vector<Scene> scenes;
  for (int k = 0; k < rounds; ++k) {
    scenes.push_back(random_scene({.n = 8, .horizon = 15, .maneuvers = 3}, random));
    scenes.push_back(random_scene({.n = 7, .rmin = 5, .rmax = 5, .horizon = 15}, random));
    scenes.push_back(random_scene({.n = 6, .rmin = 0, .rmax = 0, .horizon = 15}, random));
    scenes.push_back(
        random_scene({.n = 10, .rmin = 0.1, .rmax = 20, .horizon = 10, .density = 0.3}, random));
    scenes.push_back(random_scene({.n = 5, .rmin = 3, .rmax = 3 + 1e-9, .horizon = 15}, random));
    scenes.push_back(random_scene({.n = 2, .horizon = 30}, random));
    // Scenes so large or small that polynomials of degree eight in the lengths leave the range of
    // doubles.
    constexpr std::array exponents{-320, -120, 118, 122, 126, 130, 320};
    scenes.push_back(scaled(random_scene({.n = 8, .horizon = 15}, random),
                            exponents.at(random() % exponents.size())));
    const std::uint64_t seed = random() % 1000;
    for (const auto motion : {GridOptions::Motion::random, GridOptions::Motion::shear}) {
      scenes.push_back(generate_grid({.n = 9, .seed = seed, .motion = motion, .horizon = 12}));
    }
    scenes.push_back(generate_swarm({.n = 6, .seed = seed, .horizon = 20}));
    scenes.push_back(generate_reference({.n = 12, .seed = seed, .density = 0.2, .horizon = 20}));
  }
  for (Scene& s : scenes) {
    if (random() % 3 == 0) s.restitution = Rational(4, 5);
  }
  return scenes;
}

}  // namespace voroproof::internal::testing
