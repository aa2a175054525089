#include "apps/answers/plan_report.h"

#include <nlohmann/json.hpp>

#include "history/json_text.h"

namespace voroproof::internal {
namespace {

using Json = nlohmann::ordered_json;

Json number(const Rational& q) { return Json::parse(number_text(q)); }
Json point(const Point2& p) { return {number(p.x), number(p.y)}; }

Json approach_json(const Approach& approach) {
  const Enclosure enclosed = gap(approach);
  return {{"pair", {approach.i, approach.j}},
          {"t", number(approach.t)},
          {"gap", {{"from", enclosed.lo}, {"to", enclosed.hi}}},
          {"distance_squared", number(approach.distance2)}};
}

Json vehicles_json(const Plan& plan) {
  Json all = Json::array();
  for (std::size_t i = 0; i < plan.timetables.size(); ++i) {
    const Vehicle& vehicle = plan.task.vehicles[i];
    Json way = Json::array();
    for (const Knot& knot : plan.timetables[i]) {
      const Point2 here = place(vehicle, knot.progress);
      way.push_back({number(time_of(plan.task, knot.step)), number(here.x), number(here.y)});
    }
    all.push_back({{"id", i},
                   {"radius", number(vehicle.radius)},
                   {"start", point(vehicle.start)},
                   {"goal", point(vehicle.goal)},
                   {"way", std::move(way)}});
  }
  return all;
}

}  // namespace

std::string plan_report_text(const PlanRun& run, const PlanResult& result) {
  const PlanTask& task = result.plan.task;
  Json json = Json::object();
  json["format"] = "voroproof-plan-report";
  json["version"] = 1;
  json["producer"] = run.producer;
  json["plan"] = task.name;
  json["found"] = result.found();
  if (!run.scene_sha256.empty()) json["scene_sha256"] = run.scene_sha256;
  json["assignment"] = run.assignment;
  json["container"] = {{"center", point(task.container_center)},
                       {"radius", number(task.container_radius)}};
  json["clearance"] = number(task.clearance);
  json["arrive"] = number(task.arrive);
  if (result.impossible) json["impossible"] = approach_json(*result.impossible);
  if (result.unsolved) json["unsolved"] = approach_json(*result.unsolved);
  if (result.nearest) json["minimum_gap"] = approach_json(*result.nearest);
  json["speed_changes"] = speed_changes(result.plan);
  json["avoided"] = Json::array();
  for (const Avoidance& avoidance : result.avoided) {
    Json entry = approach_json(avoidance.predicted);
    entry["place"] = {round_nearest(avoidance.place.x), round_nearest(avoidance.place.y)};
    entry["changed"] = avoidance.vehicle;
    entry["by"] = avoidance.slowed ? "slowing" : "rescheduling";
    json["avoided"].push_back(std::move(entry));
  }
  json["vehicles"] = vehicles_json(result.plan);
  return json.dump(1) + "\n";
}

}  // namespace voroproof::internal
