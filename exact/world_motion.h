// How the disks of a world move: they pass through each other, grow, come and go. Nothing turns by
// itself, so that every path is given.
#pragma once

#include <optional>
#include <vector>

#include "exact/point2.h"
#include "exact/rational.h"

namespace voroproof::internal {

// A disk at one time, and how it goes on.
struct GrowingDisk {
  Rational x, y, radius;    // radius >= 0
  Rational vx, vy, growth;  // velocity; growth of the radius in a unit of time
};
// The state a time after that of `state`.
inline GrowingDisk after(const GrowingDisk& state, const Rational& passed) {
  GrowingDisk later = state;
  later.x += state.vx * passed;
  later.y += state.vy * passed;
  later.radius += state.growth * passed;
  return later;
}

// The round frame.
struct WorldCircle {
  Point2 center;
  Rational radius, growth;  // radius > 0 at 0, and up to the horizon
};

// How a piece of a path begins: what the disk does at that time.
enum class PieceStart { enters, turns, jumps };

// A part of a path on which nothing changes, in force for from <= t < to, or up to the horizon.
struct WorldPiece {
  PieceStart start;
  Rational from;
  std::optional<Rational> to;
  GrowingDisk state;  // at `from`
};

// The pieces that begin up to the horizon, the horizon included, in order. The end of the last one
// is the time at which the disk leaves, if it does so up to the horizon.
using WorldPath = std::vector<WorldPiece>;

// The state at t, just after what happens then; none where the disk is not there.
inline std::optional<GrowingDisk> state_at(const WorldPath& path, const Rational& t) {
  for (auto piece = path.rbegin(); piece != path.rend(); ++piece) {
    if (t < piece->from) continue;
    if (piece->to && *piece->to <= t) break;
    return after(piece->state, t - piece->from);
  }
  return std::nullopt;
}

struct WorldMotion {
  std::optional<WorldCircle> circle;  // none: the frame is the plane
  Rational horizon;                   // >= 0
  std::vector<WorldPath> paths;       // by disk; empty for one that does not enter
};

}  // namespace voroproof::internal
