#include "apps/plan_drawing.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "apps/diagram_geometry.h"
#include "history/error.h"
#include "history/file_bytes.h"

namespace voroproof {
namespace {

using Json = nlohmann::json;

constexpr std::size_t max_report = std::size_t{1} << 28;

Vec2 vec(const Point2& p) { return {round_nearest(p.x), round_nearest(p.y)}; }

// Of a report: numbers are JSON numbers or, where no double is exact, fractions as text.
double number(const Json& json) {
  double value = 0;
  if (json.is_string()) {
    const auto q = parse_rational(json.get<std::string>());
    if (!q) throw std::invalid_argument("not a number: " + json.get<std::string>());
    value = round_nearest(*q);
  } else {
    value = json.get<double>();
  }
  if (!std::isfinite(value)) throw std::invalid_argument("not a finite number");
  return value;
}

Vec2 vec(const Json& json) { return {number(json.at(0)), number(json.at(1))}; }

PlanDrawing drawing_of(const Json& report) {
  PlanDrawing drawing;
  const Json& container = report.at("container");
  drawing.container_center = vec(container.at("center"));
  drawing.container_radius = number(container.at("radius"));
  for (const Json& vehicle : report.at("vehicles")) {
    PlanDrawing::DrawnVehicle drawn{number(vehicle.at("radius")), {}};
    for (const Json& knot : vehicle.at("way")) {
      drawn.way.push_back({number(knot.at(0)), {number(knot.at(1)), number(knot.at(2))}});
    }
    if (drawn.way.size() < 2) throw std::invalid_argument("a way of fewer than two places");
    drawing.vehicles.push_back(std::move(drawn));
  }
  for (const Json& conjunction : report.at("avoided")) {
    drawing.conjunctions.push_back(vec(conjunction.at("place")));
  }
  if (report.contains("minimum_gap")) {
    const Json& gap = report.at("minimum_gap");
    const PlanDrawing::Pair pair{gap.at("pair").at(0), gap.at("pair").at(1), number(gap.at("t"))};
    for (const int i : {pair.i, pair.j}) {
      if (i < 0 || i >= static_cast<int>(drawing.vehicles.size())) {
        throw std::invalid_argument("minimum_gap: no vehicle " + std::to_string(i));
      }
    }
    drawing.nearest = pair;
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
  const std::string bytes = file_bytes(path, max_report);
  const auto fault = [&](const std::exception& e) {
    return InputError(path, 0, "", std::string("not a report of a plan: ") + e.what());
  };
  try {
    const Json report = Json::parse(bytes);
    if (report.at("format") != "voroproof-plan-report" || report.at("version") != 1) {
      throw InputError(path, 0, "format", "not a report of a plan, version 1");
    }
    return drawing_of(report);
  } catch (const Json::exception& e) {
    throw fault(e);
  } catch (const std::invalid_argument& e) {
    throw fault(e);
  }
}

}  // namespace voroproof
