// A history in memory, to be certified and to be falsified.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/certifier.h"
#include "history/history_source.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

struct ClaimedHistory {
  HistoryHeader header;
  std::vector<voroproof::internal::Event> events;
  HistoryCounts claimed_counts;
  std::optional<HistoryStop> stop;  // in place of an end

  void count();  // makes claimed_counts those of the events
};

// What the engine finds, as it would write it.
ClaimedHistory claimed_history(const Scene& scene, const RecordedRun& run);

// What a file claims; nothing where it is not of the format, or stops early.
std::optional<ClaimedHistory> read_claimed_history(const std::string& path, const Scene& scene);

// One JSON line an event, for messages.
std::string text(const ClaimedHistory& history);

// The history as its own file: the header on line 1, event k on line k + 2.
class MemoryHistory : public HistorySource {
 public:
  explicit MemoryHistory(const ClaimedHistory& history);
  const HistoryHeader& header() const override { return history_.header; }
  std::optional<voroproof::internal::Event> next() override;
  std::int64_t line() const override { return static_cast<std::int64_t>(next_) + 1; }
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return ending_; }
  const HistoryCounts& counts() const override { return counts_; }
  bool counts_match() const override { return counts_ == history_.claimed_counts; }
  std::vector<std::string> remarks() const override { return {}; }
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

 private:
  const ClaimedHistory& history_;
  std::size_t next_ = 0;
  HistoryCounts counts_;
  std::variant<HistoryEnd, HistoryStop> ending_;
};

Certificate certify(const Scene& scene, const ClaimedHistory& history, CertifyOptions options = {});

}  // namespace voroproof::internal::testing
