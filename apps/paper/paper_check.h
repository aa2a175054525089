// The paper's test of correctness (section 7.2), for comparison with what certify proves.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "exact/generators.h"
#include "filtered/motion/options.h"
#include "history/scene.h"

namespace voroproof::internal {

struct PaperCheckOptions {
  double step = 0.1;        // between the regular instants
  double tolerance = 1e-6;  // how far a disk may reach into a circle
  MotionOptions motion{};   // for the first diagram, where the history has none
  // Called now and then; false stops with what has been found so far.
  std::function<bool(double t)> monitor;
};

// A circle into which a disk reaches, or which does not exist (then without generator).
struct Intrusion {
  double t = 0;
  Triple vertex{};
  std::optional<GenId> generator;
  double depth = 0;  // how far it reaches in
};

struct PaperCheckResult {
  std::int64_t regular = 0, midway = 0;  // instants
  std::int64_t circles = 0;
  std::optional<Intrusion> first;  // beyond the tolerance
  double deepest = 0;              // over all, within the tolerance or not
  bool passed() const { return !first; }
};

// Follows the history through its own recorded times, centres and velocities, in plain doubles as
// the paper did, and at every multiple of the step, and midway between any two consecutive times of
// events, computes the tangent circle of every V-vertex and looks for a disk (or the container)
// that reaches into it by more than the tolerance. Ends at the first. A history without initial
// diagram gets the true one. Proves nothing: see docs/experiments.md.
//
// Throws InputError where the history is not one of this scene, or an event lacks its `v` or `p`.
PaperCheckResult paper_check(const Scene& scene, const std::string& history_path,
                             const PaperCheckOptions& options);

}  // namespace voroproof::internal
