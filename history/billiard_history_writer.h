// Writing a history of a billiard (docs/formats.md, section 21).
#pragma once

#include <string>

#include "exact/billiard_events.h"
#include "history/history_reader.h"
#include "history/output_file.h"

namespace voroproof::internal {

// Writes a history in the one form that this project writes. Call header(), then write() in the
// order of the history, then end() or stopped(), then close(); the file appears at close() only,
// and never without a last line. Throws OutputError where the file cannot be written.
class BilliardHistoryWriter {
 public:
  BilliardHistoryWriter(const std::string& path, int dimension);

  void header(const std::string& scene_sha256, const Rational& horizon,
              const std::string& producer);
  void write(const BilliardEvent& event);

  // The run covered the whole horizon. The counts are those of the events written.
  void end();
  // The run stopped early at t.
  void stopped(double t, const std::string& reason);

  void close() { file_.commit(); }
  // Closes, too, but a history that stopped does not replace one that is complete, as that of
  // HistoryWriter. Returns the path of what was written.
  std::string close_beside_complete();

  const HistoryCounts& counts() const { return counts_; }

  // Whether it writes into a stream (OutputFile).
  bool is_stream() const { return file_.is_stream(); }

 private:
  std::string vector_text(const CompactVec3& v) const;
  std::string pair_text(const std::array<std::optional<CompactVec3>, 2>& pair) const;

  std::string path_;
  OutputFile file_;
  std::size_t dimension_;
  bool complete_ = false;
  std::string horizon_;
  HistoryCounts counts_;
};

}  // namespace voroproof::internal
