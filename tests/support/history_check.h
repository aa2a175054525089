// A history held against the oracles: everything the formats promise of it, by other means than
// the engine's.
#pragma once

#include <string>

#include "tests/oracle/brute_force.h"
#include "tests/oracle/motion.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

oracle::MotionScene oracle_scene(const Scene& scene);
std::vector<oracle::Quadruple> quadruples(const std::vector<Quad>& edges);

// The collisions and maneuvers of a run in their order, for the oracle of motion. Throws
// std::runtime_error for a maneuver that the scene does not have.
std::vector<oracle::MotionRecord> motion_records(const Scene& scene, const RecordedRun& run);

struct HistoryCheck {
  // Instants between events at which the whole diagram is computed anew, spread evenly.
  int brute_force_instants = 4;
  // Instants between events at which every edge is examined for being legal.
  int legality_instants = 40;
  // Whether flips of one recorded time are of one instant, so that the smallest comes first. They
  // are not where instants are nearer to each other than binary64 tells apart.
  bool one_time_is_one_instant = true;
};

// What `check_history` looked at; a test that claims something must have seen some of it.
struct CheckCounts {
  int brute_force = 0, cgal = 0, legality = 0, flip_times = 0, ties = 0;
  // Instants left out: a point touched something, where tangent circles mean nothing.
  int skipped = 0;
  CheckCounts& operator+=(const CheckCounts& o);
};

// Holds a complete run against
// - the motion: collisions and maneuvers in the recorded order happen, in high precision, at
//   times and with states that round to the recorded ones; no contact was missed;
// - the order of what is simultaneous: smallest approaching pair first, maneuvers by disk, then
//   collisions again, then flips, each of the smallest illegal edge (docs/formats.md);
// - the diagram: valid replay; between events no edge is illegal, the largest id decides what is
//   cotangent for ever, and the brute-force diagram and CGAL's agree; a flip that is alone at its
//   instant happens within half a unit in the last place of its time;
// - the end: the engine's diagram is the replayed one.
// Returns the first fault, or an empty string.
std::string check_history(const Scene& scene, const RecordedRun& run,
                          const HistoryCheck& check = {}, CheckCounts* counts = nullptr);

}  // namespace voroproof::internal::testing
