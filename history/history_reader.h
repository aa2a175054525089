// History files: every event of the diagram of a scene, one JSON object a line (docs/formats.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "exact/rational.h"
#include "history/events.h"
#include "history/extensions.h"
#include "history/json_reader.h"
#include "history/line_source.h"
#include "history/scene.h"

namespace voroproof::internal {

struct HistoryHeader {
  std::string scene_sha256;  // 64 lower-case hexadecimal digits
  Rational horizon;
  std::string producer;                      // "name version"
  std::optional<std::vector<Quad>> initial;  // the diagram at 0+: canonical, sorted
  Rational horizon_error{};  // bound of the horizon's error by the format's rounding
  Extensions extensions{};
  bool oriented = true;  // false where the format cannot tell [l,r,s,e] from [l,r,e,s]

  // The certain part of the horizon; no time is before 0.
  Rational certain_horizon() const { return std::max<Rational>(0, horizon - horizon_error); }
};

// The horizon of a history, or that of its scene where it is that, rounded up to the nearest
// binary64.
inline Rational told_horizon(const Rational& horizon, const Rational& of_scene) {
  const bool is_rounded = horizon > of_scene && horizon == to_rational(round_nearest(of_scene));
  return is_rounded ? of_scene : horizon;
}

// Reads it, of that version. `wanted_sha256`: that of the scene, if it is known. Throws InputError.
HistoryHeader read_history_header(JsonReader& json, std::int64_t version, int last_id,
                                  const std::string& wanted_sha256);

struct HistoryCounts {
  std::int64_t flips = 0, collisions = 0, maneuvers = 0;
  void add(const Event& event) {
    ++(std::holds_alternative<FlipEvent>(event)      ? flips
       : std::holds_alternative<CollideEvent>(event) ? collisions
                                                     : maneuvers);
  }
  std::int64_t all() const { return flips + collisions + maneuvers; }
  bool operator==(const HistoryCounts&) const = default;
};

// The last line of a history that covers [0, horizon].
struct HistoryEnd {
  HistoryCounts counts;  // as claimed
};

// The last line of a history that is right up to t only.
struct HistoryStop {
  double t = 0;
  std::string reason;
  std::vector<std::string> events;  // the events in question, each as JSON text
  std::optional<Rational> exact_t;  // where t was written as a string
};

// Limits on the lines of a history; see docs/formats.md.
inline constexpr std::size_t max_header_line = std::size_t{1} << 28;
inline constexpr std::size_t max_event_line = std::size_t{1} << 20;

// A place between two lines of a history file, and what reading them up to there has come to.
struct HistoryPlace {
  std::int64_t offset = 0;         // in bytes of the content
  std::int64_t line = 0;           // the last before it
  double t = 0;                    // no line before the place is of a later time
  HistoryCounts counts;            // counts of the events before it
  std::optional<Sha256> digest{};  // hash of the content before it, where it is to be kept
};

// Reads a history line by line in bounded memory and checks everything that can be checked without
// the scene. Keys may come in any order, edges be named either way and `initial` be in any order:
// what is handed on is canonical. Every member throws InputError, naming the line; a
// reader that threw is of no further use.
class HistoryReader {
 public:
  // Reads the header. If the scene is known: ids must be below its number of disks, and the
  // history be one of a scene with this hash.
  explicit HistoryReader(const std::string& path, int disk_count = max_disks,
                         const std::string& scene_sha256 = {});

  const HistoryHeader& header() const { return header_; }

  // The next event, or nothing after the last; then the last line has been read and is right in
  // form, and nothing follows it. A file without it is incomplete: an InputError.
  std::optional<Event> next();

  // The line of the event that next() gave last; after the last event, that of the last line.
  std::int64_t line() const { return lines_.number(); }

  // The bytes of the content up to the end of that line.
  std::int64_t offset() const { return lines_.offset(); }

  // Goes on at the place, which is taken at its word. False, and nothing is done, where the file is
  // no plain one. Throws InputError where no line ends there. Precondition: next() has not given
  // nothing yet.
  bool skip_to(const HistoryPlace& place);

  // The hash of the content, as LineSource has it, of the header, too. Precondition of the first:
  // next() has not been called.
  void keep_digest() { keeps_digest_ = true; }
  void settle(std::int64_t offset) { lines_.settle(offset); }
  const Sha256& digest_up_to(std::int64_t offset) { return lines_.digest_up_to(offset); }
  std::string content_sha256() { return lines_.content_sha256(); }

  // Those of the line of the event that next() gave last; after the last event, of the last line.
  const Extensions& extensions() const { return extensions_; }

  // The last line, once next() has given nothing.
  const std::variant<HistoryEnd, HistoryStop>& ending() const { return ending_.value(); }

  // The events that next() has given.
  const HistoryCounts& counts() const { return counts_; }

  // Whether the end line, if it is one, claims the counts of the events before it.
  bool counts_match() const;

 private:
  void read_header(std::string_view text, const std::string& wanted_sha256);
  std::optional<Event> next_line();
  // Reads a line that is not in the usual form; returns nothing for the last line.
  std::optional<Event> read_strictly(std::string_view text);
  void check_time(const Number& t, const char* field);

  std::string path_;
  LineSource lines_;
  bool keeps_digest_ = false;
  int last_id_;
  HistoryHeader header_;
  double horizon_ = 0;  // rounded to nearest
  double last_t_ = 0;
  std::optional<Rational> last_exact_t_;
  HistoryCounts counts_;
  Extensions extensions_;
  std::optional<std::variant<HistoryEnd, HistoryStop>> ending_;
};

}  // namespace voroproof::internal
