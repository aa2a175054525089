// A history of which no more than so many events are looked at.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "history/history_source.h"

namespace voroproof::internal {

// A history cut short: where the whole one has more than `events` (> 0) events, this one is like a
// history that stopped after so many, for `reason`.
class LimitedHistory final : public HistorySource {
 public:
  LimitedHistory(std::unique_ptr<HistorySource> whole, std::uint64_t events, std::string reason)
      : whole_(std::move(whole)), left_(events) {
    stop_.reason = std::move(reason);
  }

  const HistoryHeader& header() const override { return whole_->header(); }
  std::int64_t line() const override { return whole_->line(); }
  std::int64_t offset() const override { return whole_->offset(); }
  void keep_digest() override { whole_->keep_digest(); }
  void settle(std::int64_t offset) override { whole_->settle(offset); }
  Sha256 digest_up_to(std::int64_t offset) override { return whole_->digest_up_to(offset); }
  std::string content_sha256() override { return whole_->content_sha256(); }
  void require_unchanged() override { whole_->require_unchanged(); }
  const HistoryCounts& counts() const override { return whole_->counts(); }
  bool counts_match() const override { return cut_ || whole_->counts_match(); }
  std::vector<std::string> remarks() const override { return whole_->remarks(); }
  std::optional<std::int64_t> shadow_line(const Quad& q, double lo, double hi) const override {
    return whole_->shadow_line(q, lo, hi);
  }
  const std::variant<HistoryEnd, HistoryStop>& ending() const override {
    return cut_ ? ending_ : whole_->ending();
  }

  std::optional<Event> next() override {
    if (cut_) return std::nullopt;
    std::optional<Event> event = whole_->next();
    if (!event) return event;
    if (left_ == 0) {
      cut_ = true;
      ending_ = stop_;
      return std::nullopt;
    }
    --left_;
    stop_.t = time(*event);
    return event;
  }

 private:
  std::unique_ptr<HistorySource> whole_;
  std::uint64_t left_;
  bool cut_ = false;
  HistoryStop stop_;  // as it would be after the last event read
  std::variant<HistoryEnd, HistoryStop> ending_;
};

}  // namespace voroproof::internal
