// Lines of a history in their usual form, read at a glance.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "history/events.h"

namespace voroproof::internal {

// Reads what needs no second look: keys in the writer's order, JSON numbers only. simdjson does the
// work: it splits many lines at once, and its parser's memory is used again.
class PlainLineReader {
 public:
  PlainLineReader();
  PlainLineReader(PlainLineReader&&) noexcept;
  PlainLineReader& operator=(PlainLineReader&&) noexcept;
  ~PlainLineReader();

  // The event of a line that is right in form. Nothing where it is anything else: then the strict
  // reader tells what, and what is wrong with it. Ids must be at most last_id. `begin`: how many
  // bytes of the file are before the line. `text`: the line, and as much as is at hand of what
  // follows it in the file. A file is read from its beginning to its end, though lines may be
  // skipped.
  std::optional<Event> event(std::string_view line, std::string_view text, std::int64_t begin,
                             int last_id);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace voroproof::internal
