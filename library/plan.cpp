#include "voroproof/plan.h"

#include "history/json_text.h"
#include "history/plan_file.h"
#include "library/planning/planner.h"
#include "library/values.h"

namespace voroproof {
namespace {

std::string text_of(const Number& number) {
  return internal::number_text(internal::rational(number));
}

std::string pair_text(const Number& x, const Number& y) {
  return "[" + text_of(x) + "," + text_of(y) + "]";
}

// The task as a plan file, so that it is checked as one.
internal::PlanTask checked(const PlanTask& task) {
  std::string text =
      R"({"format":"voroproof-plan","version":1,"name":)" + internal::string_text(task.name) +
      R"(,"container":{"center":)" + pair_text(task.container_x, task.container_y) +
      ",\"radius\":" + text_of(task.container_radius) + "},\"arrive\":" + text_of(task.arrive) +
      ",\"clearance\":" + text_of(task.clearance) + ",\"vehicles\":[";
  const char* separator = "";
  for (std::size_t id = 0; id < task.vehicles.size(); ++id) {
    const Vehicle& v = task.vehicles[id];
    text += separator;
    text += "\n{\"id\":" + std::to_string(id) + ",\"radius\":" + text_of(v.radius) +
            ",\"start\":" + pair_text(v.start_x, v.start_y) +
            ",\"goal\":" + pair_text(v.goal_x, v.goal_y) + "}";
    separator = ",";
  }
  text += "]}";
  return internal::without_lines("plan", [&] { return internal::parse_plan(text, "plan"); });
}

Approach value_of(const internal::Approach& a) {
  return {a.i, a.j, internal::number(a.t), internal::enclosure_value(internal::gap(a))};
}

}  // namespace

Plan make_plan(const PlanTask& task, const std::function<bool(std::size_t)>& monitor) {
  return internal::with_public_errors([&] {
    const internal::PlanResult result = internal::make_plan(checked(task), monitor);
    Plan plan;
    plan.found = result.found();
    plan.scene = internal::scene_value(internal::scene_of(result.plan));
    if (result.nearest) plan.nearest = value_of(*result.nearest);
    if (result.impossible) plan.conflict = value_of(*result.impossible);
    if (result.unsolved) plan.conflict = value_of(*result.unsolved);
    plan.avoided = result.avoided.size();
    return plan;
  });
}

}  // namespace voroproof
