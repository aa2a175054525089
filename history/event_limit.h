// How many events of a history are looked at, where that is limited.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "history/history_reader.h"

namespace voroproof::internal {

// A history has more events than are to be looked at.
class EventLimitReached : public std::runtime_error {
 public:
  explicit EventLimitReached(std::uint64_t events);
};

// While it lives, a history that this thread reads, of whichever format, may have so many events
// (0: any number): the reader throws EventLimitReached in place of handing out one more. Each
// history is counted on its own. At most one lives in a thread at a time.
class EventLimit {
 public:
  explicit EventLimit(std::uint64_t events);
  EventLimit(const EventLimit&) = delete;
  EventLimit& operator=(const EventLimit&) = delete;
  ~EventLimit();

  // For readers: the events so far, with the one that is to be handed out.
  static void check(std::int64_t events);
  static void check(const HistoryCounts& counts) { check(counts.all()); }
};

}  // namespace voroproof::internal
