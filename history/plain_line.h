// Lines of a history in their usual form, read at a glance.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "history/events.h"

namespace voroproof::internal {

// Reads what needs no second look: keys in the writer's order, JSON numbers only. simdjson does the
// work, and its parser's memory is used again for every line.
class PlainLineReader {
 public:
  PlainLineReader();
  PlainLineReader(PlainLineReader&&) noexcept;
  PlainLineReader& operator=(PlainLineReader&&) noexcept;
  ~PlainLineReader();

  // The event of a line that is right in form. Nothing where it is anything else: then the strict
  // reader tells what, and what is wrong with it. Ids must be at most last_id.
  std::optional<Event> event(std::string_view line, int last_id);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace voroproof::internal
