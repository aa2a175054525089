#include "apps/run/self_check.h"

#include <utility>

#include "library/maneuver_input.h"

namespace voroproof::internal {

// The history as far as it has come: the certifier waits for the rest.
class SelfCheck::Live : public HistorySource {
 public:
  explicit Live(HistoryHeader header) : header_(std::move(header)) {}

  const HistoryHeader& header() const override { return header_; }
  std::int64_t line() const override { return line_; }
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return ending_; }
  const HistoryCounts& counts() const override { return counts_; }
  bool counts_match() const override { return true; }
  std::vector<std::string> remarks() const override { return {}; }
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

  std::optional<Event> next() override {
    while (taken_ == batch_.size()) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return closed_ || !queue_.empty(); });
      if (dropped_) throw CertificationInterrupted{};
      if (queue_.empty()) return std::nullopt;
      batch_ = std::move(queue_.front());
      queue_.pop_front();
      taken_ = 0;
      lock.unlock();
      changed_.notify_all();
    }
    ++line_;
    return std::move(batch_[taken_++]);
  }

  // ---- For the engine's thread. ----
  void add(Batch&& batch) {
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return over_ || queue_.size() < max_batches; });
      queue_.push_back(std::move(batch));
    }
    changed_.notify_all();
  }
  void close(const std::variant<HistoryEnd, HistoryStop>& ending, bool dropped) {
    {
      const std::lock_guard lock(mutex_);
      ending_ = ending;
      closed_ = true;
      dropped_ = dropped;
    }
    changed_.notify_all();
  }
  bool over() {
    const std::lock_guard lock(mutex_);
    return over_;
  }

  // The certifier asks for nothing more.
  void end() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
  }

 private:
  HistoryHeader header_;
  HistoryCounts counts_;
  Batch batch_;
  std::size_t taken_ = 0;
  std::int64_t line_ = 1;  // as in the history file

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_.
  std::deque<Batch> queue_;
  bool closed_ = false, dropped_ = false, over_ = false;
  std::variant<HistoryEnd, HistoryStop> ending_;
};

SelfCheck::SelfCheck(const Scene& scene, const CertifyOptions& options)
    : scene_(scene), options_(options) {}

SelfCheck::~SelfCheck() {
  if (thread_.joinable()) {
    live_->close(HistoryEnd{}, true);
    thread_.join();
  }
}

void SelfCheck::begin(const HistoryHeader& header) {
  live_ = std::make_unique<Live>(header);
  thread_ = std::thread([this] {
    try {
      certificate_ = certify(scene_, *live_, options_);
    } catch (...) {
      error_ = std::current_exception();
    }
    live_->end();
  });
}

void SelfCheck::event(const Event& event) {
  batch_.push_back(event);
  if (batch_.size() == batch_size) live_->add(std::exchange(batch_, {}));
}

bool SelfCheck::over() { return live_ && live_->over(); }

Certificate SelfCheck::finish(const std::variant<HistoryEnd, HistoryStop>& ending) {
  if (!batch_.empty()) live_->add(std::exchange(batch_, {}));
  live_->close(ending, false);
  thread_.join();
  if (error_) std::rethrow_exception(error_);
  return std::move(*certificate_);
}

}  // namespace voroproof::internal
