// Whether a diagram that a history leads to can be the Voronoi diagram of the disks at an instant.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "history/diagram_file.h"

namespace voroproof::internal {

// A generator where it is at an instant, as it moves since the time `since`.
struct PlacedGenerator {
  MovingSite<Ball> site;
  double since = 0;
};

// All generators at one instant, the container first.
using PlacedGenerators = std::vector<PlacedGenerator>;

// Centre and radius of the circle of a vertex, in that order x, y, rho. `site` says where a
// generator is.
std::array<Ball, 3> circle_of(const Triple& generators,
                              const std::function<Site<Ball>(GenId)>& site);

// The evidence that an edge is illegal: its fourth generator lies `depth` inside the circle of one
// of its vertices.
struct IllegalEdge {
  Quad edge;
  DiagramVertex circle;
  GenId inside = 0;
  double depth = 0;
};

// How far the times of a right history may be off, and how deep rounded places may put a generator
// into a circle, in units of the largest coordinate that a place in the container can have.
inline constexpr double snapshot_time_tolerance = 1e-6;
inline constexpr double snapshot_depth_tolerance = 1e-9;

// An edge that is illegal for certain and beyond these tolerances: at the instant of the diagram
// and a tolerance before and after it, as its generators move at the instant. An edge beside a disk
// that turned just before is not judged. Where there is no such edge the diagram may be wrong all
// the same: only a certificate says that it is right.
std::optional<IllegalEdge> illegal_edge(const PlacedGenerators& generators,
                                        const DiagramFile& diagram);

}  // namespace voroproof::internal
