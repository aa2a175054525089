// Faults must never be certified; what means the same must never be refuted.
#include "tests/certify/mutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "certify/report.h"
#include "corpus/generate.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/lattice_scene.h"

namespace voroproof::testing {
namespace {

CertifyOptions options_for(Truth truth, double tolerance = 1e-6) {
  CertifyOptions o;
  o.truth = truth;
  o.tolerance = to_rational(tolerance);
  return o;
}

// The scene with all lengths multiplied by a power of two.
Scene scaled(Scene scene, int exponent) {
  const Rational unit = to_rational(std::ldexp(1.0, exponent));
  for (Rational* x : {&scene.cx, &scene.cy, &scene.container_radius}) *x *= unit;
  for (DiskSpec& d : scene.disks) {
    for (CompactRational* x : {&d.x, &d.y, &d.radius, &d.vx, &d.vy}) *x *= unit;
  }
  return scene;
}

// Scenes of all families, small enough for thousands of certificates.
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
    // Where polynomials of degree eight in the lengths leave the range of doubles.
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

TEST(Mutation, RightHistoriesAreCertified) {
  Random random(1);
  for (const Scene& scene : some_scenes(random, 10)) {
    const RecordedRun r = run(scene);
    if (!r.complete()) continue;
    const ClaimedHistory h = claimed_history(scene, r);
    for (const Truth truth : {Truth::exact, Truth::recorded}) {
      CertifyOptions options = options_for(truth);
      options.least_part = 1;
      const Certificate c = certify(scene, h, options);
      EXPECT_EQ(c.verdict, Verdict::certified) << reason_line(c) << "\n"
                                               << text(h) << text(scene) << static_cast<int>(truth);
    }
  }
}

TEST(Mutation, NoFaultIsCertified) {
  // VOROPROOF_MUTANTS asks for more.
  const char* asked = std::getenv("VOROPROOF_MUTANTS");
  const int wanted = asked != nullptr ? std::atoi(asked) : 2000;
  Random random(asked != nullptr ? 77 : 2);
  std::array<int, static_cast<int>(Mutation::count)> made{}, refuted{}, undecided{};
  int total = 0;
  while (total < wanted) {
    for (const Scene& scene : some_scenes(random, 1)) {
      const RecordedRun r = run(scene);
      if (!r.complete()) continue;
      const ClaimedHistory right = claimed_history(scene, r);
      for (int kind = 0; kind < static_cast<int>(Mutation::count); ++kind) {
        for (int attempt = 0; attempt < 3; ++attempt) {
          const double tolerance = 1e-6;
          const Truth truth = attempt == 0 ? Truth::exact : Truth::recorded;
          // The recorded motion is near the true one, by which `right` was written, and no more.
          const double slack = truth == Truth::exact ? 0 : 1e-9;
          const auto wrong =
              mutate(scene, right, static_cast<Mutation>(kind), tolerance, slack, random);
          if (!wrong) continue;
          CertifyOptions options = options_for(truth, tolerance);
          // In parts as small as can be, in the last attempt.
          options.least_part = attempt == 2 ? 1 : 16384;
          const Certificate c = certify(scene, *wrong, options);
          ++made[kind];
          ++total;
          refuted[kind] += c.verdict == Verdict::refuted;
          undecided[kind] += c.verdict == Verdict::undecided;
          EXPECT_NE(c.verdict, Verdict::certified)
              << mutation_names[kind] << " truth " << static_cast<int>(truth) << "\nright:\n"
              << text(right) << "wrong:\n"
              << text(*wrong) << text(scene);
          if (c.verdict == Verdict::certified) return;
        }
      }
    }
  }
  for (int kind = 0; kind < static_cast<int>(Mutation::count); ++kind) {
    std::cout << mutation_names[kind] << ": " << made[kind] << " made, " << refuted[kind]
              << " refuted, " << undecided[kind] << " undecided\n";
    EXPECT_GT(made[kind], 0) << mutation_names[kind];
  }
}

}  // namespace
}  // namespace voroproof::testing
