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

// Parts are read in their order, proved by all threads, and their results added in their order.
class PartwiseCertifier {
 public:
  // `task`: none for the whole.
  PartwiseCertifier(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options, const ShardTask* task)
      : scene_(scene),
        input_(input),
        options_(options),
        task_(task),
        reader_(scene, input, history, options, total_.remarks, task != nullptr) {}

  Shard run() {
    skip();
    begin_ = place();
    prove_all();
    // A shard without a part has no faults.
    if (task_ != nullptr && finished_ == first_) total_.verdict = Verdict::certified;
    return {begin_, over_ ? std::nullopt : place(), std::move(total_)};
  }

 private:
  struct Work {
    Part part;
    std::optional<Cut> end;  // where somebody wants to know that it is reached
    Certificate certificate;
    std::exception_ptr error;
  };
  using Token = std::shared_ptr<Work>;

  // Reads what is before the first part to be proved.
  void skip() {
    if (task_ == nullptr) return;
    if (task_->start) reader_.start_at(*task_->start);
    while (!reader_.done() && is_before_shard()) {
      if (options_.monitor && !options_.monitor(reader_.begins_at(), 0)) {
        throw CertificationInterrupted{};
      }
      reader_.next();
    }
    if (task_->from && place() != task_->from) throw OtherHistory();
    first_ = finished_ = reader_.number();
  }
  bool is_before_shard() const {
    if (task_->from) return static_cast<std::int64_t>(reader_.number()) < task_->from->part;
    return shard_of_next() < task_->number;
  }
  int shard_of_next() const {
    return shard_of(reader_.begins_at(), round_nearest(reader_.header().horizon), task_->of);
  }
  std::optional<Cut> place() const {
    return task_ == nullptr || reader_.done() ? std::nullopt : std::optional(reader_.cut());
  }

  void prove_all() {
    namespace tbb = oneapi::tbb;
    const auto threads = static_cast<std::size_t>(options_.threads);
    // As many threads are allowed as are asked for, also more than the machine has.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(options_.threads);
    arena.execute([&] {
      // The number of parts that are in memory at once.
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
    if (!over_ && finished_ != reader_.number()) {
      throw std::logic_error("a part of the history was not proved");
    }
  }

  // The next part, or null. What comes before a line that cannot be read may be refuted.
  Token read() {
    if (first_bad_ != kNone || reader_.done()) return nullptr;
    if (task_ != nullptr && shard_of_next() > task_->number) return nullptr;
    try {
      std::optional<Part> part = reader_.next();
      const bool due = task_ != nullptr && task_->is_due && task_->is_due();
      return std::make_shared<Work>(
          Work{std::move(*part), due ? place() : std::nullopt, {}, nullptr});
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
    std::optional<GivenMotion>& motion = motions_.local();
    try {
      CertifyOptions options = options_;
      options.monitor = [this, number](double t, std::int64_t events) {
        return report(number, t, events);
      };
      // More bits than at first are forgotten, so that no part depends on those before it.
      if (!motion || motion->is_raised())
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
    if (!error_) append(total_, std::move(work.certificate));
    ++finished_;
    if (!over_ && work.end) task_->proved({begin_, work.end, total_});
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
  const ShardTask* task_;
  std::optional<Cut> begin_;  // where the shard begins
  Certificate total_;         // result of the parts that are finished
  PartReader reader_;
  std::exception_ptr unreadable_;
  // The first part that is not proved right: later ones do not matter.
  std::atomic<std::size_t> first_bad_ = kNone;
  oneapi::tbb::enumerable_thread_specific<std::optional<GivenMotion>> motions_;
  bool over_ = false;  // a part was not proved right, and is the last in total_
  std::exception_ptr error_;
  std::size_t first_ = 0;     // the number of the first part to be proved
  std::size_t finished_ = 0;  // the first part that is not in total_
  std::mutex mutex_;          // guards total_ and finished_, which report() reads
};

}  // namespace

Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options) {
  return PartwiseCertifier(scene, input, history, options, nullptr).run().certificate;
}

Shard certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                       const CertifyOptions& options, const ShardTask& task) {
  return PartwiseCertifier(scene, input, history, options, &task).run();
}

Cut start_of(const Scene& scene, const MotionInput& input, HistorySource& history,
             const CertifyOptions& options) {
  std::vector<std::string> remarks;
  return PartReader(scene, input, history, options, remarks, true).cut();
}

}  // namespace voroproof::internal
