// Writing a history of a billiard (docs/formats.md, section 21).
#pragma once

#include <string>

#include "exact/billiard_events.h"
#include "history/history_reader.h"
#include "history/output_file.h"

namespace voroproof::internal {

// The lines of a history in the one form that this project writes, each with its end: call
// header(), then event() in the order of the history, then end() or stopped().
class BilliardHistoryLines {
 public:
  explicit BilliardHistoryLines(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}

  std::string header(const std::string& scene_sha256, const Rational& horizon,
                     const std::string& producer);
  std::string event(const BilliardEvent& event);

  // The run covered the whole horizon. The counts are those of the events.
  std::string end() const;
  // The run stopped early at t.
  std::string stopped(double t, const std::string& reason) const;

  const HistoryCounts& counts() const { return counts_; }

 private:
  std::string vector_text(const CompactVec3& v) const;
  std::string pair_text(const std::array<std::optional<CompactVec3>, 2>& pair) const;

  std::size_t dimension_;
  std::string horizon_;
  HistoryCounts counts_;
};

// Writes them into a file, which appears at close() only, and never without a last line. Throws
// OutputError where the file cannot be written.
class BilliardHistoryWriter {
 public:
  BilliardHistoryWriter(const std::string& path, int dimension)
      : path_(path), file_(path), lines_(dimension) {}

  void header(const std::string& scene_sha256, const Rational& horizon,
              const std::string& producer) {
    file_.write(lines_.header(scene_sha256, horizon, producer));
  }
  void write(const BilliardEvent& event) { file_.write(lines_.event(event)); }
  void end() {
    complete_ = true;
    file_.write(lines_.end());
  }
  void stopped(double t, const std::string& reason) { file_.write(lines_.stopped(t, reason)); }

  void close() { file_.commit(); }
  // Closes, too, but a history that stopped does not replace one that is complete, as that of
  // HistoryWriter. Returns the path of what was written.
  std::string close_beside_complete();

  const HistoryCounts& counts() const { return lines_.counts(); }

  // Whether it writes into a stream (OutputFile).
  bool is_stream() const { return file_.is_stream(); }

 private:
  std::string path_;
  OutputFile file_;
  BilliardHistoryLines lines_;
  bool complete_ = false;
};

}  // namespace voroproof::internal
