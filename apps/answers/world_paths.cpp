#include "apps/answers/world_paths.h"

#include <string>

namespace voroproof::internal {
namespace {

Vec3 center_of(const GrowingDisk& state) { return {state.x, state.y, 0}; }

// The path that goes on with this piece, the last one of `paths` or a new one.
GivenPath& path_of(const WorldPiece& piece, const std::string& name, bool is_first,
                   std::vector<GivenPath>& paths) {
  const GrowingDisk& state = piece.state;
  const bool jumps = piece.start == PieceStart::jumps;
  if (!is_first && !jumps && paths.back().growth == state.growth) return paths.back();
  if (!is_first) paths.back().ends_open = jumps;
  GivenPath path{name,
                 Rational(state.radius - state.growth * piece.from),
                 {{piece.from, center_of(state)}},
                 {},
                 state.growth};
  path.goes_on = !is_first;
  return paths.emplace_back(std::move(path));
}

void add_disk(const WorldPath& pieces, const std::string& name, const Rational& horizon,
              std::vector<GivenPath>& paths) {
  bool is_first = true;
  for (const WorldPiece& piece : pieces) {
    const Rational& end = piece.to ? *piece.to : horizon;
    if (piece.to && end == piece.from) continue;  // it becomes another at once
    GivenPath& path = path_of(piece, name, is_first, paths);
    is_first = false;
    if (piece.from < end)
      path.waypoints.push_back({end, center_of(after(piece.state, end - piece.from))});
  }
  if (!is_first && pieces.back().to) paths.back().ends_open = true;
}

}  // namespace

GivenPaths world_paths(const World& world) {
  const WorldMotion motion = world.motion();
  GivenPaths given;
  for (std::size_t i = 0; i < motion.paths.size(); ++i)
    add_disk(motion.paths[i], std::to_string(i), motion.horizon, given.paths);
  given.meaning = "the motion of the world's disks, their growth and jumps";
  given.missing = world.missing;
  if (motion.circle) given.remarks = {"gaps to the frame are not judged"};
  return given;
}

}  // namespace voroproof::internal
