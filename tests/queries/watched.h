// A scene with its history and its paths, and random scenes with a bit of everything.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "library/queries/history_cursor.h"
#include "library/queries/paths.h"
#include "tests/queries/scene_history.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"

namespace voroproof::internal::testing {

inline Diagram no_initial() { throw std::logic_error("the history has its initial diagram"); }

struct Watched {
  explicit Watched(const Scene& scene)
      : run(scene),
        cursor(run.scene, run.history, no_initial),
        paths(run.scene, cursor, run.history) {}
  SceneHistory run;
  HistoryCursor cursor;
  Paths paths;

  // Centres in doubles, by the way through the file.
  std::vector<Vec2> centres(double t) const {
    const Rational at = to_rational(t);
    const std::vector<RecordedState> states =
        recorded_moment(run.scene, run.history, at, Move::colliding, false, no_initial)
            .states.value();
    std::vector<Vec2> all;
    for (const RecordedState& s : states) {
      const ExactVec2 p = position_at(s, at);
      all.push_back({p[0].get_d(), p[1].get_d()});
    }
    return all;
  }
  double gap(const std::vector<Vec2>& at, GenId i, GenId j) const {
    const auto radius = [&](GenId g) { return round_nearest(run.scene.disks[g].radius); };
    if (i == container_id) {
      return run.scene.container_radius.get_d() - radius(j) -
             std::hypot(at[j][0] - run.scene.cx.get_d(), at[j][1] - run.scene.cy.get_d());
    }
    return std::hypot(at[j][0] - at[i][0], at[j][1] - at[i][1]) - radius(i) - radius(j);
  }
  GenId size() const { return static_cast<GenId>(run.scene.disks.size()); }
};

inline Scene crowd(int n, unsigned seed, int maneuvers = 3) {
  Random random(seed);
  return random_scene({.n = n, .horizon = 16, .density = 0.15, .maneuvers = maneuvers}, random);
}

}  // namespace voroproof::internal::testing
