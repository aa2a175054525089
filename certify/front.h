// Where the truth has come to: the instant of the last event proved, and what is going on at it.
#pragma once

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "certify/moment.h"

namespace voroproof::internal {

struct Front {
  Moment moment;       // of the last event proved
  int instant = 0;     // numbers the instants at which events were proved
  bool begun = false;  // the diagram at 0+ is proved, and lives have begun

  // What the claim being checked turns: the pair that collides, the disk of the maneuver.
  std::optional<std::pair<GenId, GenId>> colliding;
  std::optional<GenId> maneuvering;
  // The disks whose motion has changed, and whose lives have not begun anew yet: nothing is looked
  // for of these.
  std::vector<GenId> turning;
  std::unordered_map<GenId, int> maneuvered;  // the instants of the disks' last maneuvers

  // Whether the disk has had a maneuver at the present instant.
  bool maneuvered_now(GenId g) const {
    const auto it = maneuvered.find(g);
    return it != maneuvered.end() && it->second == instant;
  }
};

}  // namespace voroproof::internal
