#include "history/paths_world.h"

#include <algorithm>
#include <utility>

#include "history/error.h"

namespace voroproof::internal {

namespace {

// Adds the disk that follows the path.
void add_disk(World& world, const GivenPath& path, const Rational& growth, const Rational& start) {
  const std::vector<Waypoint>& w = path.waypoints;
  const int disk = static_cast<int>(world.disks.size());
  Vec3 v = velocity(w[0], w[1]);
  WorldDisk first{
      w[0].t - start, std::nullopt, {w[0].at[0], w[0].at[1], path.radius, v[0], v[1], growth}};
  const Rational end = w.back().t - start;
  if (end < world.horizon) first.leave = end;
  world.disks.push_back(std::move(first));
  for (std::size_t k = 1; k + 1 < w.size(); ++k) {
    const Vec3 next = velocity(w[k], w[k + 1]);
    const bool turns = next != v;
    if (!turns && growth == 0) continue;
    WorldManeuver maneuver{w[k].t - start, disk, {}, {}, {}, {}};
    if (turns) maneuver.velocity = Point2{next[0], next[1]};
    if (growth != 0) maneuver.radius = path.radius;
    world.maneuvers.push_back(std::move(maneuver));
    v = next;
  }
}

}  // namespace

World world_of_paths(const GivenPaths& given, const Rational& growth, const std::string& file) {
  require_straight_in_plane(given, file);
  World world;
  world.missing = given.missing;
  if (given.paths.empty()) return world;
  if (given.paths.size() > static_cast<std::size_t>(max_disks)) {
    throw InputError(file, 0, "", "more disks than a scene may have");
  }
  const auto [start, end] = time_of(given.paths);
  world.horizon = end - start;
  for (const GivenPath& path : given.paths) {
    if (path.waypoints.size() == 1) {
      world.missing.push_back(path.name + ", which has one waypoint");
    } else {
      add_disk(world, path, growth, start);
    }
  }
  std::vector<WorldManeuver>& maneuvers = world.maneuvers;
  if (maneuvers.size() > static_cast<std::size_t>(max_maneuvers)) {
    throw InputError(file, 0, "", "more maneuvers than a scene may have");
  }
  std::stable_sort(maneuvers.begin(), maneuvers.end(),
                   [](const WorldManeuver& a, const WorldManeuver& b) { return a.t < b.t; });
  return world;
}

}  // namespace voroproof::internal
