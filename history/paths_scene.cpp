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
  const Point2& some = given.paths.front().waypoints.front().at;
  Point2 low = some, high = some;
  Rational radius = 0;
  for (const GivenPath& p : given.paths) {
    radius = std::max(radius, p.radius);
    for (const Waypoint& w : p.waypoints) {
      low = {std::min(low.x, w.at.x), std::min(low.y, w.at.y)};
      high = {std::max(high.x, w.at.x), std::max(high.y, w.at.y)};
    }
  }
  scene.cx = (low.x + high.x) / 2;
  scene.cy = (low.y + high.y) / 2;
  // No waypoint is further from the centre than half of this, less a radius.
  scene.container_radius = (high.x - low.x) + (high.y - low.y) + 2 * radius;
  if (scene.container_radius == 0) scene.container_radius = 1;
}

}  // namespace

Scene scene_of_paths(const GivenPaths& given, const std::string& file) {
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
    Point2 v = w.size() == 1 ? Point2{0, 0} : velocity(w[0], w[1]);
    const Rational mass = p.radius == 0 ? Rational(1) : Rational(p.radius * p.radius);
    scene.disks.push_back({w[0].at.x, w[0].at.y, p.radius, v.x, v.y, mass});
    for (std::size_t k = 1; k + 1 < w.size(); ++k) {
      const Point2 next = velocity(w[k], w[k + 1]);
      if (next.x == v.x && next.y == v.y) continue;
      scene.maneuvers.push_back({Rational(w[k].t - start), disk, next.x, next.y});
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
