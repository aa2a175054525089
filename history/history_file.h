// History files: every event of the diagram of a scene, one JSON object a line (docs/formats.md).
#pragma once

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
#include "history/output_file.h"
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
};

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

// Writes a history in the one form that this project writes. Call header(), then the events in the
// order of the history, then end() or stopped(), then close(); the file appears at close() only,
// and never without a last line. Nothing is kept in memory but a buffer.
// Edges may be named either way; they are written canonical. Extensions go at the end of a line.
// Throws OutputError where the file cannot be written, std::logic_error where the calls come in
// another order or a value has no place in a history (t decreases, not finite).
class HistoryWriter {
 public:
  explicit HistoryWriter(const std::string& path);

  void header(const HistoryHeader& header);
  // Writes this initial diagram in place of the header's.
  void header(const HistoryHeader& header, const std::vector<Quad>& initial);
  void flip(double t, const Quad& quad, const Extensions& extensions = {});
  // These write the doubles of the event; `exact` is not looked at.
  void collide(const CollideEvent& event, const Extensions& extensions = {});
  void maneuver(const ManeuverEvent& event, const Extensions& extensions = {});
  void write(const Event& event, const Extensions& extensions = {});

  // The events so far outlive the process, as OutputFile says.
  void flush() { file_.flush(); }

  // For a history that another one may go on from: what is written of it is known, and stays where
  // the process ends before it has its name (AtomicFile::outlive()). follow_content() comes first.
  void follow_content() { file_.follow_content(); }
  OutputFile::Written written() {
    file_.flush();
    return file_.written();
  }
  void outlive() { file_.outlive(); }
  void discard() { file_.discard(); }
  // Begins with that part of another history, up to its event at time `last`, in place of a header
  // and so many events. Throws InputError where the file has another beginning.
  void begin_with(const std::string& path, const OutputFile::Written& part, const Rational& horizon,
                  const HistoryCounts& counts, double last);

  // The run covered the whole horizon. The counts are those of the events written.
  void end(const Extensions& extensions = {});

  // The run stopped early at t. `events` are those in question; only their kinds and ids are
  // written.
  void stopped(double t, const std::string& reason, const std::vector<Event>& events,
               const Extensions& extensions = {});

  void close();
  // Closes, too, but a history that stopped does not replace one that is complete: it gets the name
  // with ".partial" at its end. Returns the path of what was written.
  std::string close_beside_complete();
  // Closes it as a file whose name has ".partial" at its end, and returns that.
  std::string close_as_partial();

  // After an OutputError for which no room was left: closes the history as one that stopped, for
  // that reason, at the last event that is on the disk. Gives its path as above; with `replace` it
  // replaces a complete one, too. Nothing where not even one event is there, or the error was
  // another one.
  std::optional<std::string> close_short(const std::string& reason, bool replace);

  const HistoryCounts& counts() const { return counts_; }

  // Whether it writes into a stream (OutputFile).
  bool is_stream() const { return file_.is_stream(); }

 private:
  enum class State { fresh, open, ended, closed };

  void put(const HistoryHeader& header, const std::vector<Quad>* initial);
  void close_line(char* out, const Extensions& extensions);
  void require(State state) const;
  void advance_to(double t);

  std::string path_;
  OutputFile file_;
  State state_ = State::fresh;
  bool complete_ = false;
  std::string horizon_;
  double last_t_ = 0;
  HistoryCounts counts_;
};

// Whether there is a file of that name whose last line says that it is the history of a whole run.
// Nothing else of the file is looked at.
bool is_complete_history(const std::string& path);

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

  // The hash of the content, as LineSource has it.
  void keep_digest() { lines_.keep_digest(); }
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
