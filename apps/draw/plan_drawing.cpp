#include "apps/draw/plan_drawing.h"

#include <algorithm>
#include <cmath>

#include "library/diagram_geometry.h"
#include "library/json_field.h"

namespace voroproof::internal {
namespace {

constexpr std::size_t max_report = std::size_t{1} << 28;

Vec2 vec(const Point2& p) { return {round_nearest(p.x), round_nearest(p.y)}; }

Vec2 vec(const JsonField& point) { return {point[0].number(), point[1].number()}; }

PlanDrawing drawing_of(const JsonField& report) {
  PlanDrawing drawing;
  drawing.container_center = vec(report["container"]["center"]);
  drawing.container_radius = report["container"]["radius"].number();
  // Cairo walks along whatever lies beyond the picture.
  const auto require_near = [&](double length, const JsonField& field) {
    if (!(std::fabs(length) <= 4 * drawing.container_radius)) {
      field.fail("far beyond the container");
    }
  };
  for (const JsonField& vehicle : report["vehicles"].elements()) {
    PlanDrawing::DrawnVehicle drawn{vehicle["radius"].number(), {}};
    require_near(drawn.radius, vehicle["radius"]);
    const JsonField way = vehicle["way"];
    for (const JsonField& knot : way.elements()) {
      drawn.way.push_back({knot[0].number(), {knot[1].number(), knot[2].number()}});
      require_near(length(drawn.way.back().at - drawing.container_center), knot);
    }
    if (drawn.way.size() < 2) way.fail("fewer than two places");
    drawing.vehicles.push_back(std::move(drawn));
  }
  for (const JsonField& conjunction : report["avoided"].elements()) {
    drawing.conjunctions.push_back(vec(conjunction["place"]));
  }
  if (report.has("minimum_gap")) {
    const JsonField gap = report["minimum_gap"];
    const auto vehicle = [&](const JsonField& id) {
      const std::int64_t i = id.integer();
      if (i < 0 || i >= static_cast<std::int64_t>(drawing.vehicles.size()))
        id.fail("no vehicle " + std::to_string(i));
      return static_cast<int>(i);
    };
    drawing.nearest = {vehicle(gap["pair"][0]), vehicle(gap["pair"][1]), gap["t"].number()};
  }
  return drawing;
}

}  // namespace

Vec2 PlanDrawing::place(int i, double t) const {
  const std::vector<Knot>& way = vehicles[i].way;
  const auto after = std::find_if(way.begin(), way.end(), [&](const Knot& k) { return k.t > t; });
  if (after == way.begin()) return way.front().at;
  if (after == way.end()) return way.back().at;
  const Knot& before = *std::prev(after);
  return before.at + ((t - before.t) / (after->t - before.t)) * (after->at - before.at);
}

PlanDrawing drawing_of(const PlanResult& result) {
  const Plan& plan = result.plan;
  PlanDrawing drawing;
  drawing.container_center = vec(plan.task.container_center);
  drawing.container_radius = round_nearest(plan.task.container_radius);
  for (std::size_t i = 0; i < plan.timetables.size(); ++i) {
    const Vehicle& vehicle = plan.task.vehicles[i];
    PlanDrawing::DrawnVehicle drawn{round_nearest(vehicle.radius), {}};
    for (const Knot& knot : plan.timetables[i]) {
      drawn.way.push_back(
          {round_nearest(time_of(plan.task, knot.step)), vec(place(vehicle, knot.progress))});
    }
    drawing.vehicles.push_back(std::move(drawn));
  }
  for (const Avoidance& a : result.avoided) drawing.conjunctions.push_back(vec(a.place));
  if (result.nearest) {
    drawing.nearest = {result.nearest->i, result.nearest->j, round_nearest(result.nearest->t)};
  }
  return drawing;
}

PlanDrawing read_plan_report(const std::string& path) {
  const nlohmann::json report = read_report(path, "voroproof-plan-report", max_report);
  return drawing_of(JsonField(report, path));
}

}  // namespace voroproof::internal
