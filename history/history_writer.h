// Writing a history (docs/formats.md, section 3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/rational.h"
#include "history/events.h"
#include "history/extensions.h"
#include "history/history_reader.h"
#include "history/output_file.h"

namespace voroproof::internal {

// The ending of the name that a history that stopped gets beside a complete one.
inline constexpr const char* partial_ending = ".partial";

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
  // with partial_ending. Returns the path of what was written.
  std::string close_beside_complete();
  // Closes it as a file whose name has that ending, and returns the name.
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

}  // namespace voroproof::internal
