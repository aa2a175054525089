// A file that claims a history, whoever wrote it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "history/history_file.h"

namespace voroproof {

class HistorySource {
 public:
  virtual ~HistorySource() = default;
  virtual const HistoryHeader& header() const = 0;
  virtual std::optional<Event> next() = 0;
  virtual std::int64_t line() const = 0;
  virtual const std::variant<HistoryEnd, HistoryStop>& ending() const = 0;
  virtual const HistoryCounts& counts() const = 0;
  virtual bool counts_match() const = 0;
  virtual std::vector<std::string> remarks() const = 0;
};

// Opens a history; ids must be below disk_count. Throws InputError.
std::unique_ptr<HistorySource> open_history(const std::string& path, int disk_count);

}  // namespace voroproof
