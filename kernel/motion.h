// What is judged: the files, the options, and the paths of the disks that the claims define.
#pragma once

#include <memory>
#include <vector>

#include "kernel/diagram.h"
#include "kernel/edge.h"

namespace voroproof_kernel {

struct Problem {
  Scene scene;
  History history;
  Options options;
  Rat tolerance, law_tolerance, horizon;
  std::vector<std::vector<Leg>> legs;  // of generator g at [g + 1], one for each turn

  bool exact() const { return options.truth == Truth::exact; }
  int disks() const { return static_cast<int>(scene.disks.size()); }
  Rat radius(int g) const { return g == container ? Rat(-scene.radius) : scene.disks[g].radius; }
};

// The gap |d(t)|^2 - reach^2 = A s^2 + 2 B s + C of two on their lines, s = t - start.
struct Gap {
  Rat start, a, b, c;
  Gap(const Leg& i, const Leg& j);
  explicit Gap(const Rat& t) : start(t) {}
  Rat value(const Rat& t) const { return (a * (t - start) + 2 * b) * (t - start) + c; }
  Rat slope(const Rat& t) const { return a * (t - start) + b; }  // half the derivative
  bool has_roots() const { return a > 0 && b * b > a * c; }
};

// The disks that a claim turns.
inline std::vector<int> turned(const Claim& c) {
  if (c.kind == Claim::Kind::flip) return {};
  if (c.kind == Claim::Kind::maneuver || c.i == container) return {c.j};
  return {c.i, c.j};
}

// A walk along the claims: the diagram and the leg on which each generator is.
struct Walk {
  const Problem& problem;
  std::unique_ptr<Diagram> diagram;  // none for fewer than two disks
  std::vector<std::size_t> leg_of;

  explicit Walk(const Problem& p);
  const Leg& leg(int g) const { return problem.legs[g + 1][leg_of[g + 1]]; }
  // The edge that a flip names; throws Stop (refuted) if there is none. Counts quadruplets without
  // orientation where these are allowed.
  int edge_of(const Claim& flip, std::int64_t* unoriented) const;
  void apply(const Claim& claim);
};

// Checks maneuvers, centres, velocities, and that each disk's motion is determined; fills p.legs.
void trace_paths(Problem& p, Counts& counts);
// Checks that the collisions are those of the paths.
void check_contacts(const Problem& p, Counts& counts, std::int64_t& line);

}  // namespace voroproof_kernel
