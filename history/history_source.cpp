#include "history/history_source.h"

namespace voroproof::internal {

namespace {

class NativeHistory : public HistorySource {
 public:
  NativeHistory(const std::string& path, int disk_count, const std::string& scene_sha256)
      : reader_(path, disk_count, scene_sha256) {}
  const HistoryHeader& header() const override { return reader_.header(); }
  std::optional<Event> next() override { return reader_.next(); }
  std::int64_t line() const override { return reader_.line(); }
  std::int64_t offset() const override { return reader_.offset(); }
  bool skip_to(const HistoryPlace& place) override { return reader_.skip_to(place); }
  void keep_digest() override { reader_.keep_digest(); }
  void settle(std::int64_t offset) override { reader_.settle(offset); }
  Sha256 digest_up_to(std::int64_t offset) override { return reader_.digest_up_to(offset); }
  std::string content_sha256() override { return reader_.content_sha256(); }
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return reader_.ending(); }
  const HistoryCounts& counts() const override { return reader_.counts(); }
  bool counts_match() const override { return reader_.counts_match(); }
  std::vector<std::string> remarks() const override { return {}; }
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

 private:
  HistoryReader reader_;
};

}  // namespace

std::unique_ptr<HistorySource> open_history(const std::string& path, int disk_count,
                                            const std::string& scene_sha256) {
  return std::make_unique<NativeHistory>(path, disk_count, scene_sha256);
}

}  // namespace voroproof::internal
