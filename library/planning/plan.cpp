#include "library/planning/plan.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace voroproof::internal {

Timetable even_timetable() { return {{0, 0}, {time_steps, whole_way}}; }

void drop_idle_knots(Timetable& timetable) {
  Timetable kept;
  for (std::size_t k = 0; k < timetable.size(); ++k) {
    const Knot& b = timetable[k];
    if (!kept.empty() && k + 1 < timetable.size()) {
      const Knot &a = kept.back(), &c = timetable[k + 1];
      if ((b.progress - a.progress) * std::int64_t{c.step - b.step} ==
          (c.progress - b.progress) * std::int64_t{b.step - a.step})
        continue;
    }
    kept.push_back(b);
  }
  timetable = std::move(kept);
}

Rational time_of(const PlanTask& task, const Rational& step) {
  return task.arrive * step / time_steps;
}

Point2 place(const Vehicle& vehicle, const Rational& progress) {
  const Rational part = progress / whole_way;
  return {vehicle.start.x + part * (vehicle.goal.x - vehicle.start.x),
          vehicle.start.y + part * (vehicle.goal.y - vehicle.start.y)};
}

Point2 place_at(const Plan& plan, int i, const Rational& t) {
  const Rational step = t * time_steps / plan.task.arrive;
  return place(plan.task.vehicles[i], progress_at<Rational>(plan.timetables[i], step));
}

Plan even_plan(PlanTask task) {
  Plan plan{std::move(task), {}};
  plan.timetables.assign(plan.task.vehicles.size(), even_timetable());
  return plan;
}

Scene scene_of(const Plan& plan) {
  const PlanTask& task = plan.task;
  Scene scene;
  scene.cx = task.container_center.x;
  scene.cy = task.container_center.y;
  scene.container_radius = task.container_radius;
  scene.horizon = task.arrive;
  scene.name = task.name;
  for (std::size_t i = 0; i < task.vehicles.size(); ++i) {
    const Vehicle& v = task.vehicles[i];
    const Timetable& timetable = plan.timetables[i];
    const auto velocity = [&](std::size_t k) -> Point2 {
      if (k + 1 == timetable.size()) return {0, 0};
      const Rational part = Rational(timetable[k + 1].progress - timetable[k].progress) / whole_way;
      const Rational duration = time_of(task, timetable[k + 1].step - timetable[k].step);
      return {part * (v.goal.x - v.start.x) / duration, part * (v.goal.y - v.start.y) / duration};
    };
    const Point2 first = velocity(0);
    scene.disks.push_back({v.start.x, v.start.y, v.radius, first.x, first.y,
                           v.radius == 0 ? Rational(1) : Rational(v.radius * v.radius)});
    if (v.start.x == v.goal.x && v.start.y == v.goal.y) continue;
    for (std::size_t k = 1; k < timetable.size(); ++k) {
      const Point2 next = velocity(k);
      scene.maneuvers.push_back(
          {time_of(task, timetable[k].step), static_cast<int>(i), next.x, next.y});
    }
  }
  std::sort(scene.maneuvers.begin(), scene.maneuvers.end(),
            [](const Maneuver& a, const Maneuver& b) {
              return std::tie(a.t, a.disk) < std::tie(b.t, b.disk);
            });
  return scene;
}

std::size_t speed_changes(const Plan& plan) {
  std::size_t count = 0;
  for (const Timetable& timetable : plan.timetables) count += timetable.size() - 2;
  return count;
}

}  // namespace voroproof::internal
