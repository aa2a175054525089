// Plan files: vehicles that fly from their starts to their goals (docs/formats.md).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal {

struct Vehicle {
  Rational radius;  // >= 0
  Point2 start, goal;
};

// The task of a plan: all vehicles leave at 0 and arrive together. vehicles[k] has the id k.
struct PlanTask {
  Point2 container_center;
  Rational container_radius;
  Rational arrive;     // > 0
  Rational clearance;  // >= 0: between the boundaries of two vehicles
  std::vector<Vehicle> vehicles;
  std::string name;
};

// Reads and checks a plan file: form, values, and that the vehicles lie strictly inside the
// container at both ends. Whether they are far enough from each other there is not looked at.
// Numbers have the limits of a scene. Throws InputError.
PlanTask read_plan(const std::string& path);

// Reads and checks a plan file's bytes as read_plan() does; `file_name` is for messages.
PlanTask parse_plan(std::string_view bytes, const std::string& file_name);

}  // namespace voroproof::internal
