// Histories of billiards: version 2 of the history format (docs/formats.md, section 21).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "exact/billiard_events.h"
#include "history/billiard.h"
#include "history/history_reader.h"
#include "history/line_source.h"

namespace voroproof::internal {

// Reads a history line by line in bounded memory and checks what can be checked without knowing how
// the disks move. Every member throws InputError, naming the line; a reader that threw is of no
// further use.
class BilliardHistoryReader {
 public:
  // If the billiard is known: it must outlive the reader, and the history be one of it. Else the
  // first vector tells the dimension. With a text that is read, and the path is a name for
  // messages.
  explicit BilliardHistoryReader(const std::string& path, const Billiard* billiard = nullptr,
                                 std::optional<std::string_view> text = {});

  const HistoryHeader& header() const { return header_; }

  // The next event, or nothing after the last; then the last line has been read and is right in
  // form, and nothing follows it. A file without it is incomplete: an InputError.
  std::optional<BilliardEvent> next();

  // The line that was read last.
  std::int64_t line() const { return lines_.number(); }
  std::string content_sha256() { return lines_.content_sha256(); }

  // The last line, once next() has given nothing.
  const std::variant<HistoryEnd, HistoryStop>& ending() const { return ending_.value(); }
  const HistoryCounts& counts() const { return counts_; }

  // Whether the end line, if it is one, claims the counts of the events before it.
  bool counts_match() const;

 private:
  struct Line;
  void read_header(std::string_view text);
  void read_member(JsonReader& json, std::size_t member, Line& line);
  void require_dimension(const JsonReader& json, std::size_t coordinates);
  CompactVec3 read_vector(JsonReader& json);
  LatticeImage read_image(JsonReader& json);
  void read_vectors(JsonReader& json, std::array<std::optional<CompactVec3>, 2>& vectors,
                    std::size_t& count);
  bool may_be_null(GenId id) const;
  HistoryEnd read_end(JsonReader& json) const;
  BilliardEvent event_of(JsonReader& json, Line& line);
  void check_time(const CompactRational& t, const char* field);

  std::string path_;
  const Billiard* billiard_;
  std::size_t dimension_;  // 0: not known yet
  LineSource lines_;
  HistoryHeader header_;
  double horizon_ = 0;  // rounded to nearest
  CompactRational last_t_;
  HistoryCounts counts_;
  std::optional<std::variant<HistoryEnd, HistoryStop>> ending_;
};

}  // namespace voroproof::internal
