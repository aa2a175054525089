// A file that claims a history, whoever wrote it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "history/history_reader.h"

namespace voroproof::internal {

class HistorySource {
 public:
  virtual ~HistorySource() = default;
  virtual const HistoryHeader& header() const = 0;
  // The next event; none at the end, however often one asks. Throws InputError.
  virtual std::optional<Event> next() = 0;
  virtual std::int64_t line() const = 0;
  // The bytes of the file's content up to the end of that line; 0 where they are not counted.
  virtual std::int64_t offset() const { return 0; }
  // Goes on at the place, as HistoryReader does. False, and nothing is done, where it cannot.
  virtual bool skip_to(const HistoryPlace&) { return false; }
  // The hash of the content, as HistoryReader has it: of what is no file that of nothing.
  virtual void keep_digest() {}
  virtual void settle(std::int64_t) {}
  virtual Sha256 digest_up_to(std::int64_t) { return {}; }
  virtual std::string content_sha256() { return {}; }
  // To be called after the last event that is of interest, before a verdict is said. Throws
  // InputError where something of the scene is from this file, and it had other bytes then.
  virtual void require_unchanged() {}
  virtual const std::variant<HistoryEnd, HistoryStop>& ending() const = 0;
  virtual const HistoryCounts& counts() const = 0;
  virtual bool counts_match() const = 0;
  // Facts that the file cannot tell.
  virtual std::vector<std::string> remarks() const = 0;
  // The line on which the file says of a root of this edge in [lo, hi] that it is no flip; nothing
  // in formats that do not mention such roots.
  virtual std::optional<std::int64_t> shadow_line(const Quad& q, double lo, double hi) const = 0;
};

// Opens a history of this project's format, as HistoryReader does. Throws InputError.
std::unique_ptr<HistorySource> open_history(const std::string& path, int disk_count,
                                            const std::string& scene_sha256 = {});

}  // namespace voroproof::internal
