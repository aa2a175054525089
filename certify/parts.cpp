#include "certify/parts.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "certify/checker.h"
#include "history/error.h"

namespace voroproof {

namespace {

// The smallest parts are so many times smaller than most.
constexpr int kSmall = 8;

struct ReadClaim {
  ReadClaim(Event&& e, std::int64_t l) : event(std::move(e)), line(l) {}
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
    if (taken_ < claims_.size()) return std::move(claims_[taken_++].event);
    taken_ = claims_.size() + 1;
    return ended_ ? std::nullopt : rest_->next();
  }
  std::int64_t line() const override {
    if (taken_ > claims_.size()) return rest_ != nullptr ? rest_->line() : next_line_;
    return taken_ == 0 ? 1 : claims_[taken_ - 1].line;
  }
  // Of a part that is not the last: that it does not stop.
  const std::variant<HistoryEnd, HistoryStop>& ending() const override {
    static const std::variant<HistoryEnd, HistoryStop> goes_on;
    return rest_ != nullptr ? rest_->ending() : goes_on;
  }
  // Of the last part only.
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
        size_(std::max(options.least_part, options.least_part * scene.disks.size() / 512)),
        horizon_(header_.horizon.get_d()) {}

  Certificate run() {
    std::exception_ptr unreadable;
    {
      std::vector<std::jthread> helpers;
      const Closing closing{*this};  // before the helpers are waited for, whatever happens
      for (int k = 1; k < options_.threads; ++k) helpers.emplace_back([this] { help(); });
      std::optional<Motion> motion;
      try {
        read_parts(motion);
      } catch (const InputError&) {
        // What comes before it may be refuted.
        unreadable = std::current_exception();
      }
      while (std::optional<Part> part = take(false)) prove(*part, motion);
    }
    for (Result& r : results_) {
      if (r.error) std::rethrow_exception(r.error);
      add(total_, std::move(r.certificate));
      if (total_.verdict != Verdict::certified) return std::move(total_);
    }
    if (unreadable) std::rethrow_exception(unreadable);
    return std::move(total_);
  }

 private:
  struct Part {
    std::size_t number;
    std::unique_ptr<Section> section;
    std::vector<Diagram::HalfEdge> places;  // of its claims, as reading took them
    Replay replay;                          // before it
    std::optional<double> begin;            // none for the first part
    std::optional<PartEnd> end;             // none for the last
  };
  struct Result {
    bool good = false;  // proved right
    Certificate certificate;
    std::exception_ptr error;
  };
  struct Closing {
    PartwiseCertifier& parts;
    ~Closing() { parts.close(); }
  };

  // The next claim, or null. Reads a little ahead, so that what a claim is about is in the caches
  // when it is taken.
  const ReadClaim* next_claim() {
    constexpr std::size_t kAhead = 4;
    while (ahead_.size() < kAhead && !exhausted_) {
      std::optional<Event> event = history_.next();
      exhausted_ = !event;
      if (!event) break;
      replay_.prefetch(*event);
      ahead_.emplace_back(std::move(*event), history_.line());
    }
    return ahead_.empty() ? nullptr : &ahead_.front();
  }

  void read_parts(std::optional<Motion>& motion) {
    std::vector<ReadClaim> claims;
    std::vector<Diagram::HalfEdge> places;  // theirs
    const ReadClaim* next = next_claim();
    Replay before = replay_;      // the present part
    std::optional<double> begin;  // of it
    // Collisions and maneuvers at t = 0 come before the initial diagram.
    bool clear = true;
    const auto take_next = [&] {
      const auto place = clear ? replay_.take(next->event) : std::nullopt;
      clear = place.has_value();
      places.push_back(place.value_or(-1));
      claims.push_back(std::move(ahead_.front()));
      ahead_.pop_front();
      next = next_claim();
    };
    while (next && clear && time(next->event) == 0 &&
           !std::holds_alternative<FlipEvent>(next->event)) {
      take_next();
    }
    try {
      take_initial_diagram();
      before.diagram() = replay_.diagram();
    } catch (const std::invalid_argument&) {
      clear = false;  // for the first part to say why
    } catch (const Undecided&) {
      clear = false;
    }
    while (next && clear) {
      const double last = claims.empty() ? 0 : time(claims.back().event);
      if (claims.size() >= least_size(last, in_parts_ + claims.size()) &&
          time(next->event) - last > gap_) {
        const double until = last + 0.5 * (time(next->event) - last);
        in_parts_ += claims.size();
        auto section = std::make_unique<Section>(header_, std::exchange(claims, {}), nullptr, true);
        section->set_next_line(next->line);
        start({started_++, std::move(section), std::exchange(places, {}), std::move(before), begin,
               PartEnd{until, replay_.diagram()}},
              motion);
        if (stopped()) return;
        claims.reserve(size_);
        places.reserve(size_);
        before = replay_;
        begin = until;
      }
      take_next();
    }
    const bool ended = next == nullptr;
    std::move(ahead_.begin(), ahead_.end(), std::back_inserter(claims));
    start({started_++, std::make_unique<Section>(header_, std::move(claims), &history_, ended),
           std::move(places), std::move(before), begin, std::nullopt},
          motion);
  }

  // How many claims the present part has to have before it may end, when `read` have been read up
  // to the time t. The first part and the last ones are small: at the beginning other threads wait
  // for it, at the end for each other. Those that have come tell how many are to come.
  std::size_t least_size(double t, std::size_t read) const {
    if (started_ == 0) return size_ / kSmall;
    if (!(t > 0)) return size_;
    const double to_come = static_cast<double>(read) * (horizon_ / t - 1);
    return static_cast<std::size_t>(
        std::clamp(0.5 * to_come, static_cast<double>(size_) / kSmall, static_cast<double>(size_)));
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

  // ---- The threads: the reader proves parts too, where enough of them wait. ----
  void start(Part&& part, std::optional<Motion>& motion) {
    std::size_t waiting = 0;
    {
      const std::lock_guard lock(mutex_);
      waiting_.push_back(std::move(part));
      waiting = waiting_.size();
    }
    changed_.notify_one();
    for (; waiting >= static_cast<std::size_t>(options_.threads); --waiting) {
      if (std::optional<Part> mine = take(false)) prove(*mine, motion);
    }
  }

  // The first part that nobody has taken, if there is one; `wait`: or if there may be.
  std::optional<Part> take(bool wait) {
    std::unique_lock lock(mutex_);
    if (wait) changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return std::nullopt;
    Part part = std::move(waiting_.front());
    waiting_.pop_front();
    return part;
  }

  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

  void help() {
    // Made while the first part is read. Where it cannot be made, the first part says why.
    std::optional<Motion> motion;
    try {
      motion.emplace(checked_input(input_, header_), options_.motion);
    } catch (...) {
      motion.reset();
    }
    while (std::optional<Part> part = take(true)) prove(*part, motion);
  }

  // `motion`: of the last part that this thread proved, none at first. A disk that has moved by the
  // end of an earlier part is restarted by every later one.
  void prove(Part& part, std::optional<Motion>& motion) {
    Result result;
    if (part.number <= first_bad_) {
      try {
        CertifyOptions options = options_;
        options.monitor = [this, number = part.number](double t, std::int64_t events) {
          return report(number, t, events);
        };
        // More bits than at first are forgotten, so that no part depends on those before it.
        if (!motion || motion->replays() > 0)
          motion.emplace(checked_input(input_, header_), options.motion);
        Checker checker(scene_, *motion, *part.section, options, std::move(part.replay), part.begin,
                        std::move(part.places));
        result.certificate = checker.run(part.end ? &*part.end : nullptr);
      } catch (...) {
        result.error = std::current_exception();
        motion.reset();
      }
    }
    result.good = !result.error && result.certificate.verdict == Verdict::certified;
    const std::lock_guard lock(mutex_);
    if (!result.good && part.number < first_bad_) first_bad_ = part.number;
    if (results_.size() <= part.number) results_.resize(part.number + 1);
    results_[part.number] = std::move(result);
  }

  bool stopped() const { return first_bad_ != std::numeric_limits<std::size_t>::max(); }

  // The progress of the earliest part is that of the whole.
  bool report(std::size_t number, double t, std::int64_t events) {
    if (number > first_bad_) return false;
    if (!options_.monitor) return true;
    const std::lock_guard lock(mutex_);
    while (counted_ < number && counted_ < results_.size() && results_[counted_].good) {
      counted_events_ += results_[counted_++].certificate.prefix_events;
    }
    return counted_ < number || options_.monitor(t, counted_events_ + events);
  }

  const Scene& scene_;
  const MotionInput& input_;
  HistorySource& history_;
  const CertifyOptions& options_;
  HistoryHeader header_;
  Replay replay_;     // of the claims taken
  double gap_;        // between the claims on both sides of an end, so that no two swap across it
  std::size_t size_;  // claims of a part, at least
  double horizon_;    // nearly
  std::deque<ReadClaim> ahead_;  // of the history, read and not yet taken
  bool exhausted_ = false;       // nothing is left in it
  std::size_t started_ = 0;
  std::size_t in_parts_ = 0;  // claims, of all parts before the present one
  Certificate total_;
  // The first part that is not proved right: later ones do not matter.
  std::atomic<std::size_t> first_bad_ = std::numeric_limits<std::size_t>::max();

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_.
  bool closed_ = false;
  std::deque<Part> waiting_;
  std::vector<Result> results_;
  std::size_t counted_ = 0;  // so many parts are proved, and have so many events
  std::int64_t counted_events_ = 0;
};

}  // namespace

Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options) {
  return PartwiseCertifier(scene, input, history, options).run();
}

}  // namespace voroproof
