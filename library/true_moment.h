// The true motion of a scene and its diagram at one instant.
#pragma once

#include <memory>
#include <string>

#include "engine/engine.h"
#include "exact/topology/diagram.h"
#include "filtered/computed/computed_motion.h"
#include "history/scene.h"

namespace voroproof::internal {

// The engine with the motion that is in force at the exact time t, which may lie beyond the scene's
// horizon. Throws Undecided where it stops before t, and Interrupted where the monitor says so.
std::unique_ptr<Engine> run_to(const Scene& scene, const Rational& t, const EngineOptions& options);

// The diagram just after all events at t, from nothing but the motion in force there.
Diagram diagram_at(Motion& motion, const Rational& t);

struct TrueMoment {
  ComputedMotion motion;  // in force at t
  Diagram diagram;
};

// The moment by the engine or, with a history, whose path is not empty, by its collisions: see
// replayed_motion(), also for the errors.
TrueMoment true_moment(const Scene& scene, const std::string& history_path, const Rational& t,
                       const EngineOptions& options);

}  // namespace voroproof::internal
