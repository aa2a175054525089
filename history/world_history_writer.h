// Writing a history of a world (docs/formats.md, section 20).
#pragma once

#include <string>

#include "exact/rational.h"
#include "history/output_file.h"
#include "history/world_history.h"

namespace voroproof::internal {

// Writes a history in the one form that this project writes. Call header(), then write() in the
// order of the history, then end() or stopped(), then close(); the file appears at close() only,
// and never without a last line. Nothing is kept in memory but a buffer and a line.
// Edges may be named either way, but for those at which disks appear; they are written canonical.
// Throws OutputError where the file cannot be written, std::logic_error where the calls come in
// another order or a value has no place in a history (t decreases, fault_of()).
class WorldHistoryWriter {
 public:
  explicit WorldHistoryWriter(const std::string& path);

  void header(const WorldHistoryHeader& header);
  void write(const WorldEvent& event);

  // The events so far outlive the process, as OutputFile says.
  void flush() { file_.flush(); }

  // The run covered the whole horizon. The counts are those of the events written.
  void end();
  // The run stopped early at t.
  void stopped(const Rational& t, const std::string& reason);

  void close();
  // Closes, too, but a history that stopped does not replace one that is complete, as that of
  // HistoryWriter. Returns the path of what was written.
  std::string close_beside_complete();

  const WorldCounts& counts() const { return counts_; }

  // Whether it writes into a stream (OutputFile).
  bool is_stream() const { return file_.is_stream(); }

 private:
  enum class State { fresh, open, ended, closed };

  void require(State state) const;
  void advance_to(const Rational& t);

  std::string path_;
  OutputFile file_;
  State state_ = State::fresh;
  bool complete_ = false;
  std::string horizon_;
  Rational last_t_;
  WorldCounts counts_;
};

}  // namespace voroproof::internal
