// Where a probe, a disk of a given radius, fits between the generators: what Instant and
// RecordedMotion say of it (docs/queries.md, "Clearance").
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "voroproof/history.h"
#include "voroproof/number.h"

namespace voroproof {

// A point of the diagram. The clearance of a point is its distance from the nearest generator; the
// centre of a probe can be where the clearance is at least the probe's radius.
struct ClearancePlace {
  enum class Kind {
    vertex,  // the V-vertex of three generators, counterclockwise and the smallest first
    gate,    // the middle of the gap of two generators, a disk first
    far,     // on the edge of a disk and the container, across from the disk
  };
  Kind kind = Kind::vertex;
  std::vector<int> generators;  // three of a vertex, two else
};

// A V-edge as a way from end to end: probes larger than `closes` do not pass, because of `at`.
struct Tunnel {
  Edge edge;  // canonical
  Enclosure closes;
  ClearancePlace at;
};

// The place of a void's greatest clearance: beyond it the void vanishes.
struct VanishingVoid {
  Enclosure vanishes;
  // The smallest such place; none without disks: then it is the container's centre.
  std::optional<ClearancePlace> at;
};

// A component of the places at which the probe's centre can be.
struct Void {
  std::vector<std::array<int, 3>> vertices;  // the V-vertices in it, sorted
  std::vector<Tunnel> tunnels;               // the V-edges in it that are open, sorted
  VanishingVoid widest;
};

// The radii of probes at which something changes, of all probes.
struct CriticalRadii {
  std::vector<Tunnel> tunnels;       // every V-edge, sorted
  std::vector<VanishingVoid> voids;  // every place of locally greatest clearance, sorted
};

// An end of an arc: the point of the V-edge of i and j at which the clearance is the probe's
// radius, left (1) or right (-1) of the axis from the centre of disk i to its gate with j.
struct OffsetPoint {
  int i = 0, j = 0, side = 1;
  Enclosure x, y;
};

// An arc of the boundary of the places for the probe's centre: of the circle at the probe's
// distance from the generator, counterclockwise around its centre; without ends all of the circle.
struct OffsetArc {
  int generator = 0;
  std::optional<OffsetPoint> from, to;
};

// A spell in which a probe passes or fits. The ends are enclosed.
struct Opening {
  Enclosure from, to;
};

// A void over time.
struct VoidLife {
  Enclosure from, to;
  // The voids, by their indices, out of which it came about: two or more have joined, or one has
  // parted; none where it is there from the start, or where a place has opened for the probe.
  std::vector<std::size_t> before;
  // Those into which it goes; none at the end of the window, or where it vanishes.
  std::vector<std::size_t> after;
  std::optional<ClearancePlace> at;  // a place in it at the beginning; none without disks
};

}  // namespace voroproof
