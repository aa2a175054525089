// Lines of a history in the form that this project writes, read at a glance.
#pragma once

#include <optional>
#include <string_view>

#include "history/events.h"

namespace voroproof {

// The event of a line that is right in form, as the writer would write it: keys in its order, no
// spaces, JSON numbers only. Nothing where it is anything else: then the strict reader tells what,
// and what is wrong with it. Ids must be at most last_id.
std::optional<Event> plain_event(std::string_view line, int last_id);

}  // namespace voroproof
