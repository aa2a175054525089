// Converts between billiards as the library's header has them (voroproof/billiard.h) and those of
// the program.
#pragma once

#include <string>

#include "exact/billiard_events.h"
#include "library/values.h"
#include "voroproof/billiard.h"

namespace voroproof::internal {

// By which errors name a history that no file holds.
inline constexpr const char* history_in_memory = "history";

// Appends the event, its numbers rounded.
void append(voroproof::BilliardHistory& history, const BilliardEvent& event);

// The text of the history's file. Throws InputError where an event is none that a file can
// state; all else is left to the reader.
std::string history_text(const voroproof::BilliardHistory& history);

}  // namespace voroproof::internal
