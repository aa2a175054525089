// A scene with the replay of its history, at its beginning, and claims for it.
#pragma once

#include <memory>
#include <utility>

#include "certify/replay.h"
#include "tests/certify/claimed_history.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

using HalfEdge = Diagram::HalfEdge;
using Claim = voroproof::internal::Event;

inline CertifyOptions recorded() {
  CertifyOptions options;
  options.truth = Truth::recorded;
  return options;
}

inline CollideEvent collision(double t, GenId i, GenId j, const Vec2& vi, const Vec2& vj) {
  CollideEvent claim{.t = t, .i = i, .j = j};
  if (i != container_id) claim.v[0] = vi;
  claim.v[1] = vj;
  return claim;
}

inline CollideEvent exact_collision(const Rational& t, GenId j, const ExactVec2& v) {
  auto exact = std::make_shared<ExactValues>();
  exact->t = t;
  exact->v[1] = v;
  CollideEvent claim =
      collision(round_nearest(t), container_id, j, {}, {round_nearest(v[0]), round_nearest(v[1])});
  claim.exact = exact;
  return claim;
}

// The scene with the diagram that its history begins with. A run that stops before there is one has
// none.
struct Begun {
  Scene scene;
  CertifyOptions options;
  RecordedRun history;
  Replay replay;

  explicit Begun(Scene of, const CertifyOptions& asked = recorded())
      : scene(std::move(of)), options(asked), history(run(scene)), replay(scene, options) {
    if (!history.initial.empty()) {
      replay.diagram() = diagram_of(static_cast<int>(scene.disks.size()), history.initial);
    }
  }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;
};

// Two large disks with a small one in the gap, which leaves it upwards: the two have an edge on
// both sides of it, with the same four generators.
inline Scene gap_scene() {
  return scene_of(10, 4,
                  {disk(-3, 0, 2, 0, 0), disk(3, 0, 2, 0, 0), disk(0, 0, Rational(1, 2), 0, 1)});
}

}  // namespace voroproof::internal::testing
