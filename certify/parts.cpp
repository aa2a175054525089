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

// The proof of parts by the recorded truth.
class RecordedParts {
 public:
  RecordedParts(const Scene& scene, const MotionInput& input) : scene_(scene), input_(input) {}

  PartTruth truth() {
    return {.prove = [this](Part& part, const CertifyOptions& options) {
      return prove(part, options);
    }};
  }

 private:
  Certificate prove(Part& part, const CertifyOptions& options) {
    // The motion of the last part that this thread proved, none at first. A disk that has moved by
    // the end of an earlier part is restarted by every later one.
    std::optional<GivenMotion>& motion = motions_.local();
    try {
      // More bits than at first are forgotten, so that no part depends on those before it.
      if (!motion || motion->is_raised())
        motion.emplace(checked_input(input_, part.claims->header()), options.motion);
      Checker checker(scene_, *motion, *part.claims, options, std::move(part.replay), part.begin,
                      std::move(part.places));
      return checker.run(part.end ? &*part.end : nullptr);
    } catch (...) {
      motion.reset();
      throw;
    }
  }

  const Scene& scene_;
  const MotionInput& input_;
  oneapi::tbb::enumerable_thread_specific<std::optional<GivenMotion>> motions_;
};

// Parts are read in their order, proved by all threads, and their results added in their order.
class PartwiseCertifier {
 public:
  // `task`: none for the whole.
  PartwiseCertifier(const Scene& scene, const MotionInput& input, HistorySource& history,
                    const CertifyOptions& options, PartTruth truth, const ShardTask* task)
      : options_(options),
        truth_(std::move(truth)),
        task_(task),
        reader_(scene, input, history, options, total_.remarks, task != nullptr) {}

  Shard run() {
    skip();
    begin_ = place();
    prove_all();
    if (!not_proved_.empty()) judge_rest();
    // A shard without a part has no faults.
    if (task_ != nullptr && finished_ == first_) total_.verdict = Verdict::certified;
    return {begin_, over_ ? std::nullopt : place(), std::move(total_)};
  }

 private:
  struct Work {
    Part part;
    std::optional<Cut> end;  // where somebody wants to know that it is reached
    bool is_rest = false;    // it is to be judged by that
    Certificate certificate{};
    std::exception_ptr error{};
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
    if (error_) after_total([this] { std::rethrow_exception(error_); });
    if (!over_ && unreadable_) std::rethrow_exception(unreadable_);
    if (!over_ && finished_ != reader_.number()) {
      throw std::logic_error("a part of the history was not proved");
    }
  }

  // The action comes after all that is in the total.
  template <class Do>
  void after_total(const Do& action) const {
    try {
      action();
    } catch (CertificationInterrupted& interrupted) {
      interrupted.prefix_events += total_.prefix_events;
      throw;
    }
  }

  // From the first part that is not proved on.
  void judge_rest() {
    Part part = std::move(not_proved_.front().part);
    if (part.number == 0) total_ = {};  // the diagram was proposed for other claims, perhaps
    std::vector<std::shared_ptr<const ClaimList>> lists{part.list};
    for (std::size_t k = 1; k < not_proved_.size(); ++k) lists.push_back(not_proved_[k].part.list);
    not_proved_.clear();
    if (!reader_.done()) lists.push_back(reader_.rest().list);
    part.claims = reader_.rest(std::move(lists));
    CertifyOptions options = options_;
    if (options_.monitor) {
      options.monitor = [this](double t, std::int64_t events) {
        return options_.monitor(t, total_.prefix_events + events);
      };
    }
    after_total([&] { append(total_, truth_.rest(part, options)); });
  }

  // The next part, or null. What comes before a line that cannot be read may be refuted.
  Token read() {
    if (first_bad_ != kNone || reader_.done()) return nullptr;
    if (task_ != nullptr && shard_of_next() > task_->number) return nullptr;
    std::optional<Part> part;
    try {
      part = reader_.next();
    } catch (const InputError&) {
      unreadable_ = std::current_exception();
      if (!truth_.rest) return nullptr;
      part = reader_.rest();
    }
    const bool due = task_ != nullptr && task_->is_due && task_->is_due();
    Token work = std::make_shared<Work>(Work{*std::move(part), due ? place() : std::nullopt});
    lead(*work);
    return work;
  }

  void lead(Work& work) {
    if (!truth_.lead) return;
    const std::size_t number = work.part.number;
    try {
      work.is_rest = !truth_.lead(work.part, *reader_.turns(work.part), options_for(number));
    } catch (...) {
      work.error = std::current_exception();
    }
    if (work.is_rest || work.error) note_bad(number);
  }

  void prove(Work& work) {
    const std::size_t number = work.part.number;
    if (number > first_bad_ || work.is_rest || work.error) return;
    try {
      work.certificate = truth_.prove(work.part, options_for(number));
    } catch (...) {
      work.error = std::current_exception();
    }
    if (work.error || work.certificate.verdict != Verdict::certified) note_bad(number);
  }

  CertifyOptions options_for(std::size_t number) {
    CertifyOptions options = options_;
    options.monitor = [this, number](double t, std::int64_t events) {
      return report(number, t, events);
    };
    return options;
  }

  void note_bad(std::size_t number) {
    std::size_t first = first_bad_;
    while (number < first && !first_bad_.compare_exchange_weak(first, number)) {
    }
  }

  void finish(Work& work) {
    if (over_ && !not_proved_.empty()) not_proved_.push_back(std::move(work));
    if (over_) return;
    const std::lock_guard lock(mutex_);
    error_ = work.error;
    over_ = error_ || work.certificate.verdict != Verdict::certified;
    if (over_ && !error_ && truth_.rest) {
      not_proved_.push_back(std::move(work));
      return;
    }
    if (!error_) append(total_, std::move(work.certificate));
    ++finished_;
    if (over_) return;
    if (work.end) task_->proved({begin_, work.end, total_});
    // Short parts are proved before anybody asks.
    if (options_.monitor && !options_.monitor(total_.prefix_t, total_.prefix_events)) {
      error_ = std::make_exception_ptr(CertificationInterrupted{0, total_.prefix_t});
      over_ = true;
      note_bad(work.part.number);
    }
  }

  // The progress of the earliest part is that of the whole.
  bool report(std::size_t number, double t, std::int64_t events) {
    if (number > first_bad_) return false;
    if (!options_.monitor) return true;
    const std::lock_guard lock(mutex_);
    return finished_ < number || options_.monitor(t, total_.prefix_events + events);
  }

  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  const CertifyOptions& options_;
  const PartTruth truth_;
  const ShardTask* task_;
  std::optional<Cut> begin_;  // where the shard begins
  Certificate total_;         // result of the parts that are finished
  PartReader reader_;
  std::exception_ptr unreadable_;
  // The first part that is not proved right: later ones do not matter.
  std::atomic<std::size_t> first_bad_ = kNone;
  bool over_ = false;  // a part was not proved right, and is the last in total_, or not_proved_
  std::exception_ptr error_;
  std::vector<Work> not_proved_;  // the first such part that is to be judged again, and all later
  std::size_t first_ = 0;         // the number of the first part to be proved
  std::size_t finished_ = 0;      // the first part that is not in total_
  std::mutex mutex_;              // guards total_ and finished_, which report() reads
};

}  // namespace

Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options, const PartTruth& truth) {
  return PartwiseCertifier(scene, input, history, options, truth, nullptr).run().certificate;
}

Certificate certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                             const CertifyOptions& options) {
  RecordedParts parts(scene, input);
  return certify_in_parts(scene, input, history, options, parts.truth());
}

Shard certify_in_parts(const Scene& scene, const MotionInput& input, HistorySource& history,
                       const CertifyOptions& options, const ShardTask& task) {
  RecordedParts parts(scene, input);
  return PartwiseCertifier(scene, input, history, options, parts.truth(), &task).run();
}

Cut start_of(const Scene& scene, const MotionInput& input, HistorySource& history,
             const CertifyOptions& options) {
  std::vector<std::string> remarks;
  return PartReader(scene, input, history, options, remarks, true).cut();
}

}  // namespace voroproof::internal
