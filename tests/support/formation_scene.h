// Small formation flights: a shrinkable description of scenes full of ties that never collide.
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <string>
#include <vector>

#include "history/scene.h"

namespace voroproof::internal::testing {

struct FormationScene {
  int n = 2;
  std::vector<std::string> flight;
};

// Each part of the flight takes 8 units of time, so that many instants are binary64 numbers.
Scene scene_of(const FormationScene& formation);

void showValue(const FormationScene& formation, std::ostream& out);

// 2 to max_disks disks on flights of up to three steps.
rc::Gen<FormationScene> formation_scenes(int max_disks);

}  // namespace voroproof::internal::testing
