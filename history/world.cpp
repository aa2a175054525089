#include "history/world.h"

namespace voroproof::internal {
namespace {

void begin(WorldPath& path, const World& world, const WorldDisk& disk) {
  if (disk.enter > world.horizon) return;
  path.push_back({PieceStart::enters, disk.enter, std::nullopt, disk.state});
}

// Precondition: the maneuver is one of that disk, and not before one that is there.
void extend(WorldPath& path, const World& world, const WorldManeuver& maneuver) {
  if (maneuver.t > world.horizon) return;
  WorldPiece& before = path.back();
  before.to = maneuver.t;
  GrowingDisk state = after(before.state, maneuver.t - before.from);
  if (maneuver.center) {
    state.x = maneuver.center->x;
    state.y = maneuver.center->y;
  }
  if (maneuver.velocity) {
    state.vx = maneuver.velocity->x;
    state.vy = maneuver.velocity->y;
  }
  if (maneuver.radius) state.radius = *maneuver.radius;
  if (maneuver.growth) state.growth = *maneuver.growth;
  path.push_back({maneuver.is_jump() ? PieceStart::jumps : PieceStart::turns, maneuver.t,
                  std::nullopt, std::move(state)});
}

void finish(WorldPath& path, const World& world, const WorldDisk& disk) {
  if (!path.empty() && disk.leave && *disk.leave <= world.horizon) path.back().to = disk.leave;
}

}  // namespace

WorldMotion World::motion() const {
  WorldMotion motion{circle, horizon, std::vector<WorldPath>(disks.size())};
  for (std::size_t i = 0; i < disks.size(); ++i) begin(motion.paths[i], *this, disks[i]);
  for (const WorldManeuver& maneuver : maneuvers) {
    extend(motion.paths[static_cast<std::size_t>(maneuver.disk)], *this, maneuver);
  }
  for (std::size_t i = 0; i < disks.size(); ++i) finish(motion.paths[i], *this, disks[i]);
  return motion;
}

}  // namespace voroproof::internal
