#include "certify/parts.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "certify/checker.h"
#include "history/error.h"

namespace voroproof {

namespace {

struct ReadClaim {
  Event event;
  std::int64_t line;
};

// A part of a history as a history.
class Section : public HistorySource {
 public:
  // `rest`: the history, where the part is the last; `ended` where it has given all its claims.
  Section(HistoryHeader header, std::vector<ReadClaim> claims, HistorySource* rest, bool ended)
      : header_(std::move(header)), claims_(std::move(claims)), rest_(rest), ended_(ended) {}

  void set_next_line(std::int64_t line) { next_line_ = line; }

  const HistoryHeader& header() const override { return header_; }
  std::optional<Event> next() override {
    if (taken_ < claims_.size()) return claims_[taken_++].event;
    taken_ = claims_.size() + 1;
    return ended_ ? std::nullopt : rest_->next();
  }
  std::int64_t line() const override {
    if (taken_ > claims_.size()) return rest_ != nullptr ? rest_->line() : next_line_;
    return taken_ == 0 ? 1 : claims_[taken_ - 1].line;
  }
  // Of the last part only.
  const std::variant<HistoryEnd, HistoryStop>& ending() const override { return rest_->ending(); }
  const HistoryCounts& counts() const override { return rest_->counts(); }
  bool counts_match() const override { return rest_->counts_match(); }
  std::vector<std::string> remarks() const override { return {}; }
  std::optional<std::int64_t> shadow_line(const Quad&, double, double) const override {
    return std::nullopt;
  }

 private:
  HistoryHeader header_;
  std::vector<ReadClaim> claims_;
  std::size_t taken_ = 0;
  HistorySource* rest_;
  bool ended_;
  std::int64_t next_line_ = 0;  // of the claim after the part
};

void add(Certificate& total, Certificate&& part) {
  if (part.first_resolved && !total.first_resolved) {
    total.first_resolved = std::move(part.first_resolved);
    total.first_resolved_prefix = total.prefix_events + part.first_resolved_prefix;
  }
  total.verdict = part.verdict;
  total.divergence = std::move(part.divergence);
  total.reason = std::move(part.reason);
  total.reason_line = part.reason_line;
  total.prefix_events += part.prefix_events;
  total.prefix_t = part.prefix_t;
  total.flips += part.flips;
  total.collisions += part.collisions;
  total.maneuvers += part.maneuvers;
  total.edge_lives += part.edge_lives;
  total.pair_lives += part.pair_lives;
  total.beyond_filter += part.beyond_filter;
  total.simultaneous += part.simultaneous;
  total.swaps += part.swaps;
  total.resolved += part.resolved;
  total.highest_bits = std::max(total.highest_bits, part.highest_bits);
  total.tiers += part.tiers;
  for (std::string& remark : part.remarks) {
    if (std::find(total.remarks.begin(), total.remarks.end(), remark) == total.remarks.end()) {
      total.remarks.push_back(std::move(remark));
    }
  }
}

class PartwiseCertifier {
 public:
  PartwiseCertifier(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options)
      : scene_(scene),
        input_(input),
        history_(history),
        options_(options),
        header_(history.header()),
        replay_(scene, options),
        gap_(8 * round_up(options.tolerance)),
        size_(std::max(options.least_part, options.least_part / 4096 * scene.disks.size())) {}

  ~PartwiseCertifier() { cancelled_ = true; }  // the futures wait

  Certificate run() {
    std::exception_ptr unreadable;
    try {
      read_parts();
    } catch (const InputError&) {
      // What comes before it may be refuted.
      unreadable = std::current_exception();
    }
    while (!running_.empty() && good_) collect();
    if (good_ && unreadable) std::rethrow_exception(unreadable);
    if (interrupted_) throw CertificationInterrupted{};
    return std::move(total_);
  }

 private:
  std::optional<ReadClaim> read() {
    auto event = history_.next();
    if (!event) return std::nullopt;
    return ReadClaim{std::move(*event), history_.line()};
  }

  void read_parts() {
    std::vector<ReadClaim> claims;
    std::optional<ReadClaim> next = read();
    std::shared_ptr<Checkpoint> begin;  // of the present part
    // Collisions and maneuvers at t = 0 come before the initial diagram.
    bool clear = true;
    const auto take = [&] {
      clear = clear && replay_.take(next->event);
      claims.push_back(std::move(*next));
      next = read();
    };
    while (next && clear && time(next->event) == 0 &&
           !std::holds_alternative<FlipEvent>(next->event)) {
      take();
    }
    try {
      take_initial_diagram();
    } catch (const std::invalid_argument&) {
      clear = false;  // for the first part to say why
    } catch (const Undecided&) {
      clear = false;
    }
    while (good_ && next && clear) {
      const double last = claims.empty() ? 0 : time(claims.back().event);
      if (claims.size() >= size_ && time(next->event) - last > gap_) {
        const double until = last + 0.5 * (time(next->event) - last);
        auto section = std::make_shared<Section>(header_, std::move(claims), nullptr, true);
        section->set_next_line(next->line);
        claims.clear();
        start(section, begin, until);
        begin = std::make_shared<Checkpoint>(until, replay_);
      }
      take();
    }
    if (!good_) return;
    const bool ended = !next;
    if (next) claims.push_back(std::move(*next));
    start(std::make_shared<Section>(header_, std::move(claims), &history_, ended), begin, {});
  }

  // Throws std::invalid_argument where the file's, or the one proposed, is none.
  void take_initial_diagram() {
    if (replay_.disks() < 2) return;
    if (!header_.initial && options_.propose_initial) {
      Motion motion(input_, options_.motion);
      replay_.move(motion);  // collisions at t = 0
      header_.initial = options_.propose_initial(motion);
      total_.remarks.push_back(constructed_initial_remark);
    }
    replay_.diagram() = diagram_of(replay_.disks(), header_.initial.value_or(std::vector<Quad>()));
  }

  void start(std::shared_ptr<Section> section, std::shared_ptr<const Checkpoint> begin,
             std::optional<double> until) {
    const std::int64_t part = started_++;
    auto work = [this, part, section = std::move(section), begin = std::move(begin), until] {
      CertifyOptions options = options_;
      options.monitor = [this, part](double t, std::int64_t events) {
        return report(part, t, events);
      };
      return Checker(scene_, input_, *section, options).run(begin.get(), until);
    };
    if (options_.threads == 1) {
      running_.push_back(std::async(std::launch::deferred, std::move(work)));
      collect();
      return;
    }
    while (good_ && running_.size() >= static_cast<std::size_t>(options_.threads)) collect();
    if (good_) running_.push_back(std::async(std::launch::async, std::move(work)));
  }

  // Takes over the result of the earliest part that runs.
  void collect() {
    std::future<Certificate> first = std::move(running_.front());
    running_.pop_front();
    try {
      add(total_, first.get());
      good_ = total_.verdict == Verdict::certified;
    } catch (const CertificationInterrupted&) {
      interrupted_ = true;
      good_ = false;
    } catch (...) {
      cancelled_ = true;
      throw;
    }
    if (!good_) cancelled_ = true;
    const std::lock_guard lock(mutex_);
    ++collected_;
    collected_events_ = total_.prefix_events;
  }

  // The progress of the earliest part is that of the whole.
  bool report(std::int64_t part, double t, std::int64_t events) {
    if (cancelled_) return false;
    const std::lock_guard lock(mutex_);
    if (part != collected_ || !options_.monitor) return true;
    if (!options_.monitor(t, collected_events_ + events)) cancelled_ = true;
    return !cancelled_;
  }

  const Scene& scene_;
  const MotionInput& input_;
  HistorySource& history_;
  const CertifyOptions& options_;
  HistoryHeader header_;
  Replay replay_;     // of the claims read
  double gap_;        // between the claims on both sides of an end, so that no two swap across it
  std::size_t size_;  // claims of a part, at least
  Certificate total_;
  bool good_ = true, interrupted_ = false;
  std::int64_t started_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;
  std::int64_t collected_ = 0, collected_events_ = 0;  // guarded by mutex_
  std::deque<std::future<Certificate>> running_;       // last: they use the others
};

}  // namespace

Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options) {
  return PartwiseCertifier(scene, input, history, options).run();
}

}  // namespace voroproof
