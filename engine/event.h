// An event of the queue.
#pragma once

#include <utility>

#include "filtered/search/moment.h"

namespace voroproof::internal {

// A flip or contact that a search has found, maneuvers, or the horizon.
struct FoundEvent : Moment {
  FoundEvent(Moment moment, int queue_item) : Moment(std::move(moment)), item(queue_item) {}
  int item;  // in the queue
};

}  // namespace voroproof::internal
