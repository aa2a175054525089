// Lines of a history in their usual form, read at a glance.
#pragma once

#include <optional>
#include <string_view>

#include "history/events.h"

namespace voroproof::internal {

// The event of a line that is right in form and needs no second look: members in the writer's
// order, JSON numbers only, between the tokens nothing or spaces. Nothing where it is anything
// else: then the strict reader tells what, and what is wrong with it. Ids must be at most
// `last_id`.
std::optional<Event> plain_event(std::string_view line, int last_id);

}  // namespace voroproof::internal
