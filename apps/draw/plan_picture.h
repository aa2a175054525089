// Pictures of plans.
#pragma once

#include <string>

#include "apps/draw/plan_drawing.h"

namespace voroproof::internal {

// Draws the plan into a picture file: each vehicle at its start (outlined) and at its goal
// (filled), its way as a dotted line, a dot where it changes its speed, a cross at each conjunction
// that was predicted and is avoided, and the nearest pair at its nearest, in red, with the line
// between. Ids where there are at most 60 vehicles. Errors as for write_picture.
void draw_plan(const PlanDrawing& drawing, const std::string& path, int size);

}  // namespace voroproof::internal
