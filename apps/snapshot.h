// The diagram at one instant, with coordinates.
#pragma once

#include <functional>
#include <string>

#include "history/diagram_file.h"
#include "history/scene.h"
#include "kinetic/engine.h"

namespace voroproof {

// The diagram just after all events at the exact time t >= 0, which may lie beyond the scene's
// horizon: the motion is followed up to t and the diagram at t built from nothing but the positions
// and velocities there. The edges are exact; the coordinates are computed with 160 bits, and more
// where the motion is known better, and rounded to nearest.
//
// Throws Undecided where the engine stops before t, and Interrupted where the monitor says so.
DiagramFile snapshot(const Scene& scene, const Rational& t, const EngineOptions& options = {});

// The diagram at t according to a history of the scene: the edges are those of its initial diagram
// after its flips up to t, the disks are where its last recorded centres and velocities put them.
// What the history does not record, the engine computes. Throws InputError besides: see
// recorded_moment().
DiagramFile snapshot(const Scene& scene, const std::string& history_path, const Rational& t,
                     const EngineOptions& options = {});

}  // namespace voroproof
