#include "certify/parts.h"

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "certify/checker.h"
#include "certify/part_reader.h"
#include "history/error.h"

namespace voroproof::internal {

namespace {

void add(Certificate& total, Certificate&& part) {
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
  total.grazes += part.grazes;
  total.rounding_overlaps += part.rounding_overlaps;
  total.at_horizon += part.at_horizon;
  total.left_out += part.left_out;
  total.proved_anew += part.proved_anew;
  total.computed_velocities += part.computed_velocities;
  total.highest_bits = std::max(total.highest_bits, part.highest_bits);
  total.tiers += part.tiers;
  for (std::string& remark : part.remarks) {
    if (std::find(total.remarks.begin(), total.remarks.end(), remark) == total.remarks.end()) {
      total.remarks.push_back(std::move(remark));
    }
  }
}

// Parts are read in their order, proved by all threads, and their results added in their order.
class PartwiseCertifier {
 public:
  PartwiseCertifier(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options)
      : scene_(scene),
        input_(input),
        options_(options),
        reader_(scene, input, history, options, total_.remarks) {}

  Certificate run() {
    namespace tbb = oneapi::tbb;
    const auto threads = static_cast<std::size_t>(options_.threads);
    // As many threads are allowed as are asked for, also more than the machine has.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(options_.threads);
    arena.execute([&] {
      // So many are in memory at once.
      const std::size_t parts = 2 * threads - 1;
      tbb::parallel_pipeline(
          parts, tbb::make_filter<void, Token>(tbb::filter_mode::serial_in_order,
                                               [this](tbb::flow_control& flow) {
                                                 Token work = read();
                                                 if (!work) flow.stop();
                                                 return work;
                                               }) &
                     tbb::make_filter<Token, Token>(tbb::filter_mode::parallel,
                                                    [this](const Token& work) {
                                                      prove(*work);
                                                      return work;
                                                    }) &
                     tbb::make_filter<Token, void>(tbb::filter_mode::serial_in_order,
                                                   [this](const Token& work) { finish(*work); }));
    });
    try {
      if (error_) std::rethrow_exception(error_);
    } catch (CertificationInterrupted& interrupted) {
      interrupted.prefix_events += total_.prefix_events;
      throw;
    }
    if (!over_ && unreadable_) std::rethrow_exception(unreadable_);
    if (!over_ && !complete_) throw std::logic_error("a part of the history was not proved");
    return std::move(total_);
  }

 private:
  struct Work {
    Part part;
    Certificate certificate;
    std::exception_ptr error;
  };
  using Token = std::shared_ptr<Work>;

  // The next part, or null. What comes before a line that cannot be read may be refuted.
  Token read() {
    if (first_bad_ != kNone) return nullptr;
    try {
      std::optional<Part> part = reader_.next();
      if (!part) return nullptr;
      return std::make_shared<Work>(Work{std::move(*part), {}, nullptr});
    } catch (const InputError&) {
      unreadable_ = std::current_exception();
      return nullptr;
    }
  }

  void prove(Work& work) {
    const std::size_t number = work.part.number;
    if (number > first_bad_) return;
    // The motion of the last part that this thread proved, none at first. A disk that has moved by
    // the end of an earlier part is restarted by every later one.
    std::optional<Motion>& motion = motions_.local();
    try {
      CertifyOptions options = options_;
      options.monitor = [this, number](double t, std::int64_t events) {
        return report(number, t, events);
      };
      // More bits than at first are forgotten, so that no part depends on those before it.
      if (!motion || motion->replays() > 0)
        motion.emplace(checked_input(input_, reader_.header()), options.motion);
      Part& part = work.part;
      Checker checker(scene_, *motion, *part.claims, options, std::move(part.replay), part.begin,
                      std::move(part.places));
      work.certificate = checker.run(part.end ? &*part.end : nullptr);
    } catch (...) {
      work.error = std::current_exception();
      motion.reset();
    }
    if (!work.error && work.certificate.verdict == Verdict::certified) return;
    std::size_t first = first_bad_;
    while (number < first && !first_bad_.compare_exchange_weak(first, number)) {
    }
  }

  void finish(Work& work) {
    if (over_) return;
    const std::lock_guard lock(mutex_);
    error_ = work.error;
    over_ = error_ || work.certificate.verdict != Verdict::certified;
    complete_ = !work.part.end;
    if (!error_) add(total_, std::move(work.certificate));
    ++finished_;
  }

  // The progress of the earliest part is that of the whole.
  bool report(std::size_t number, double t, std::int64_t events) {
    if (number > first_bad_) return false;
    if (!options_.monitor) return true;
    const std::lock_guard lock(mutex_);
    return finished_ < number || options_.monitor(t, total_.prefix_events + events);
  }

  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  const Scene& scene_;
  const MotionInput& input_;
  const CertifyOptions& options_;
  Certificate total_;  // of the parts that are finished
  PartReader reader_;
  std::exception_ptr unreadable_;
  // The first part that is not proved right: later ones do not matter.
  std::atomic<std::size_t> first_bad_ = kNone;
  oneapi::tbb::enumerable_thread_specific<std::optional<Motion>> motions_;
  bool over_ = false;  // a part was not proved right, and is the last in total_
  std::exception_ptr error_;
  bool complete_ = false;  // the last part is in total_
  std::size_t finished_ = 0;
  std::mutex mutex_;  // of total_ and finished_, which report() reads
};

}  // namespace

Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options) {
  return PartwiseCertifier(scene, input, history, options).run();
}

}  // namespace voroproof::internal
