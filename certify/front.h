// Where the truth has come to: the instant of the last event proved, and what is going on at it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "filtered/search/moment.h"

namespace voroproof::internal {

struct Front {
  Moment moment;       // moment of the last event proved
  int instant = 0;     // numbers the instants at which events were proved
  bool begun = false;  // the diagram at 0+ is proved, and lives have begun

  // The pair of which the claim being checked is a collision.
  std::optional<std::pair<GenId, GenId>> colliding;
  // The disks whose motion has changed, and whose lives have not begun anew yet: nothing is looked
  // for of these.
  std::vector<GenId> turning;
};

}  // namespace voroproof::internal
