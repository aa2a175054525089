#include "corpus/plan_presets.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "corpus/formations.h"
#include "corpus/generate_shared.h"

namespace voroproof::internal {
namespace {

using Places = std::vector<Point2>;

constexpr int spacing = 5;

PlanTask task_of(const std::string& name, const Places& starts, const Places& goals, int arrive) {
  PlanTask task;
  task.name = "plan-" + name;
  task.arrive = arrive;
  task.clearance = Rational(1, 2);
  double extent = 0;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    task.vehicles.push_back({1, starts[i], goals[i]});
    for (const Point2& p : {starts[i], goals[i]})
      extent = std::max(extent, std::hypot(round_nearest(p.x), round_nearest(p.y)));
  }
  task.container_radius = spacing * (std::ceil(extent / spacing) + 1);
  return task;
}

// Vehicle k flies from the k-th place of a formation on the left to the (k + shift)-th of another
// on the right, as in the paper's Fig. 25.
PlanTask across(const std::string& name, int n, std::string_view from, std::string_view to,
                int shift, int apart, int arrive, int spacing) {
  const Places starts = formation_places(from, n, spacing), ends = formation_places(to, n, spacing);
  Places left, right;
  for (int k = 0; k < n; ++k) {
    const Point2 &start = starts[k], &end = ends[(k + shift) % n];
    left.push_back({start.x - apart / 2, start.y});
    right.push_back({end.x + apart / 2, end.y});
  }
  return task_of(name, left, right, arrive);
}

PlanTask five() {
  Places starts, goals;
  for (int k = 0; k < 5; ++k) starts.push_back({-20, spacing * (k - 2)});
  // The lowest goes to the top, the others make room.
  for (int k = 0; k < 5; ++k) goals.push_back({20, spacing * ((k + 4) % 5 - 2)});
  return task_of("five", starts, goals, 40);
}

// Random places on a grid of 1/64, any two at least a spacing apart.
Places random_places(int n, int radius, Uniform& random) {
  Places places;
  std::vector<Vec> taken;
  while (static_cast<int>(places.size()) < n) {
    const auto coordinate = [&] { return std::floor((2 * random() - 1) * radius * 64) / 64; };
    const double x = coordinate(), y = coordinate();
    if (x * x + y * y > radius * radius) continue;
    if (std::any_of(taken.begin(), taken.end(), [&](Vec p) {
          return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y) < spacing * spacing;
        }))
      continue;
    taken.push_back({x, y});
    places.push_back({to_rational(x), to_rational(y)});
  }
  return places;
}

PlanTask random500() {
  constexpr int n = 500, radius = 1600;
  Uniform random(1);
  const Places starts = random_places(n, radius, random);
  return task_of("random500", starts, random_places(n, radius, random), 400);
}

}  // namespace

PlanTask plan_preset(const std::string& name) {
  if (name == "five") return five();
  if (name == "square-to-circle") return across(name, 20, "frame", "circle", 5, 96, 60, 8);
  if (name == "h-to-y") return across(name, 19, "h", "y", 0, 60, 60, spacing);
  if (name == "drones58") return across(name, 58, "circle", "h", 1, 180, 60, spacing);
  if (name == "random500") return random500();
  throw std::invalid_argument("plan: no preset is called '" + name + "'");
}

const std::vector<std::string>& plan_preset_names() {
  static const std::vector<std::string> names{"five", "square-to-circle", "h-to-y", "drones58",
                                              "random500"};
  return names;
}

}  // namespace voroproof::internal
