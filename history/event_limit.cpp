#include "history/event_limit.h"

#include <string>

namespace voroproof::internal {
namespace {

thread_local std::uint64_t most_events = 0;

}  // namespace

EventLimitReached::EventLimitReached(std::uint64_t events)
    : std::runtime_error("the history has more than " + std::to_string(events) + " events") {}

EventLimit::EventLimit(std::uint64_t events) { most_events = events; }

EventLimit::~EventLimit() { most_events = 0; }

void EventLimit::check(std::int64_t events) {
  if (most_events == 0) return;
  if (static_cast<std::uint64_t>(events) > most_events) throw EventLimitReached(most_events);
}

}  // namespace voroproof::internal
