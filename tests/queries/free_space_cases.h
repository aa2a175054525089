// Scenes with radii of a probe, for tests of the free space.
#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "tests/queries/brute_moment.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {

struct Case {
  BruteMoment moment;
  std::vector<Rational> probes;
};

inline std::deque<Case> cases() {
  Random random(9);
  std::deque<Case> all;
  for (const int n : {0, 1, 2, 3, 4, 9, 25}) {
    for (const double density : {0.1, 0.35}) {
      Case c{BruteMoment(random_scene(
                 {.n = n, .rmin = 2, .rmax = 12, .density = n > 3 ? density : 0}, random)),
             {}};
      for (const int tenths : {1, 17, 40, 73, 150, 400}) c.probes.emplace_back(tenths, 10);
      all.push_back(std::move(c));
    }
  }
  // A disk beside the centre: the ends of its ellipse are the only extremes.
  all.push_back({BruteMoment(scene_of(10, 1, {disk(3, 0, 2, 0, 0)})),
                 {Rational(1, 2), Rational(5, 2), 3, Rational(11, 2), 6}});
  return all;
}

}  // namespace voroproof::internal::testing
