// Reading histories of worlds (docs/formats.md, section 20).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "exact/rational.h"
#include "history/line_source.h"
#include "history/scene.h"
#include "history/world_history.h"

namespace voroproof::internal {

// The most bytes of any line: a jump may swallow all disks.
inline constexpr std::size_t max_world_line = std::size_t{1} << 28;

// Reads a history line by line in bounded memory and checks everything that can be checked without
// the world. Keys may come in any order, edges be named either way and `initial` be in any order:
// what is handed on is canonical, but for the edges at which disks appear, of which the host is the
// first generator. Every member throws InputError, naming the line; a reader that threw is of no
// further use.
class WorldHistoryReader {
 public:
  // Reads the header. If the world is known: ids must be below its number of disks, and the history
  // be one of a world with this hash.
  explicit WorldHistoryReader(const std::string& path, int disk_count = max_disks,
                              const std::string& scene_sha256 = {});

  const WorldHistoryHeader& header() const { return header_; }

  // The next event, or nothing after the last; then the last line has been read and is right in
  // form, and nothing follows it. A file without it is incomplete: an InputError.
  std::optional<WorldEvent> next();

  // The line of the event that next() gave last; after the last event, that of the last line.
  std::int64_t line() const { return lines_.number(); }

  // The hash of the whole content, as LineSource has it. Nothing is read afterwards.
  std::string content_sha256() { return lines_.content_sha256(); }

  // The last line, once next() has given nothing.
  const std::variant<WorldEnd, WorldStop>& ending() const { return ending_.value(); }

  // The events that next() has given.
  const WorldCounts& counts() const { return counts_; }

  // Whether the end line, if it is one, claims the counts of the events before it.
  bool counts_match() const;

 private:
  void read_header(std::string_view text, const std::string& wanted_sha256);
  void check_time(const Rational& t, const char* field);

  std::string path_;
  LineSource lines_;
  int last_id_;
  WorldHistoryHeader header_;
  double horizon_ = 0;  // rounded to nearest
  Rational last_t_;
  WorldCounts counts_;
  std::optional<std::variant<WorldEnd, WorldStop>> ending_;
};

}  // namespace voroproof::internal
