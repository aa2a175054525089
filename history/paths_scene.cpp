#include "history/paths_scene.h"

#include <algorithm>

#include "history/error.h"

namespace voroproof::internal {

namespace {

void require_one_time(const GivenPaths& given, const std::string& file) {
  const auto spell = [](const GivenPath& p) {
    return p.waypoints.front().t.get_str() + " to " + p.waypoints.back().t.get_str();
  };
  const GivenPath& first = given.paths.front();
  for (const GivenPath& p : given.paths) {
    if (p.waypoints.front().t == first.waypoints.front().t &&
        p.waypoints.back().t == first.waypoints.back().t) {
      continue;
    }
    throw InputError(file, 0, "disk " + printable(p.name),
                     "is there from " + spell(p) + ", and " + printable(first.name) + " from " +
                         spell(first) + ": all disks of a scene are there all the time (--stay)");
  }
}

// Around all waypoints, and so large that no disk comes near it.
void set_container(Scene& scene, const GivenPaths& given) {
  Vec3 low = given.paths.front().waypoints.front().at, high = low;
  Rational radius = 0;
  for (const GivenPath& p : given.paths) {
    radius = std::max(radius, p.radius);
    for (const Waypoint& w : p.waypoints) {
      for (const std::size_t axis : {0, 1}) {
        low[axis] = std::min(low[axis], w.at[axis]);
        high[axis] = std::max(high[axis], w.at[axis]);
      }
    }
  }
  scene.cx = (low[0] + high[0]) / 2;
  scene.cy = (low[1] + high[1]) / 2;
  // No waypoint is further from the centre than half of this, less a radius.
  scene.container_radius = (high[0] - low[0]) + (high[1] - low[1]) + 2 * radius;
  if (scene.container_radius == 0) scene.container_radius = 1;
}

}  // namespace

Scene scene_of_paths(const GivenPaths& given, const std::string& file) {
  require_straight_in_plane(given, file);
  Scene scene;
  scene.container_radius = 1;
  if (given.paths.empty()) return scene;
  if (given.paths.size() > static_cast<std::size_t>(max_disks)) {
    throw InputError(file, 0, "", "more disks than a scene may have");
  }
  require_one_time(given, file);
  set_container(scene, given);
  const Rational start = given.paths.front().waypoints.front().t;
  scene.horizon = given.paths.front().waypoints.back().t - start;
  for (const GivenPath& p : given.paths) {
    const std::vector<Waypoint>& w = p.waypoints;
    const int disk = static_cast<int>(scene.disks.size());
    Vec3 v = w.size() == 1 ? Vec3{} : velocity(w[0], w[1]);
    const Rational mass = p.radius == 0 ? Rational(1) : Rational(p.radius * p.radius);
    scene.disks.push_back({w[0].at[0], w[0].at[1], p.radius, v[0], v[1], mass});
    for (std::size_t k = 1; k + 1 < w.size(); ++k) {
      const Vec3 next = velocity(w[k], w[k + 1]);
      if (next == v) continue;
      scene.maneuvers.push_back({Rational(w[k].t - start), disk, next[0], next[1]});
      v = next;
    }
  }
  if (scene.maneuvers.size() > static_cast<std::size_t>(max_maneuvers)) {
    throw InputError(file, 0, "", "more maneuvers than a scene may have");
  }
  std::stable_sort(scene.maneuvers.begin(), scene.maneuvers.end(),
                   [](const Maneuver& a, const Maneuver& b) { return a.t < b.t; });
  return scene;
}

}  // namespace voroproof::internal
