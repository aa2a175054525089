#include "engine/sliced_run.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "exact/patience.h"

namespace voroproof::internal {

namespace {

// Events that a follower hands over at a time.
constexpr std::size_t kChunk = 1024;
// Between two looks at whether the run is still wanted, while nothing is there to tell.
constexpr std::chrono::milliseconds kLook(10);
// The disks that turn or change their square in a slice, per disk. Each slice begins with a diagram
// from scratch, which costs about as much as a flip a disk; but shorter slices take less memory.
constexpr double kWork = 4;
// The first slices are shorter, for others to begin soon, and the last ones, for no thread to be
// left alone at the end.
constexpr double kWorkOfFirst = 1.5, kWorkOfLast = 1.5;
// A slice takes no more than this of a thread's part of what is to come.
constexpr double kPart = 1.65;
// In a short run the first slice is at most kPartOfFirst of a thread's share plus kMoreOfFirst per
// disk. Its thread may do the more because it starts earlier: the others lead into later slices.
constexpr double kPartOfFirst = 1.1, kMoreOfFirst = 0.2;
// Less than this, per disk, is not worth a diagram from scratch and the memory of another slice.
constexpr double kLeastWork = 0.1;

}  // namespace

std::uint64_t work_of_slice(int slice, double ahead, int disks, int threads) {
  const double all = ahead / disks, part = all / threads;
  double work =
      slice == 0 ? kPartOfFirst * part + kMoreOfFirst : std::max(kWorkOfLast, kPart * part);
  if (work > all - kLeastWork) work = kWork;  // to the end, also where the estimate is low
  return static_cast<std::uint64_t>(disks * std::min({kWork, kWorkOfFirst * (slice + 1), work}));
}

SlicedRun::SlicedRun(MotionInput input, std::vector<ManeuverInput> maneuvers,
                     const EngineOptions& options)
    : options_(options),
      leader_(std::move(input), std::move(maneuvers), options.motion),
      diagram_(leader_.motion().size()) {}

SlicedRun::~SlicedRun() { end(); }

bool SlicedRun::possible() const { return leader_.motion().size() > 2 && leader_.possible(); }

void SlicedRun::end() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

// ---- The threads that compute. ----

void SlicedRun::work() {
  const Patience patience([this] { return !ending_; });
  std::unique_ptr<ComputedMotion> motion;
  for (;;) {
    if (options_.slice_hooks.pause) options_.slice_hooks.pause();
    Slice* slice = nullptr;
    SliceWork::Kind work = SliceWork::Kind::none;
    {
      std::unique_lock lock(mutex_);
      work = find_work(lock, slice);
    }
    if (work == SliceWork::Kind::none) return;
    std::exception_ptr failure;
    try {
      if (work == SliceWork::Kind::lead) {
        lead(*slice);
      } else {
        const ComputedMotion& leaders = leader_.motion();
        if (!motion)
          motion =
              std::make_unique<ComputedMotion>(leaders.input(), leaders.options(), leaders.log());
        follow(*slice, *motion);
      }
    } catch (...) {
      failure = std::current_exception();
    }
    if (!failure) continue;
    {
      const std::lock_guard lock(mutex_);
      (work == SliceWork::Kind::lead ? leader_failure_ : slice->failure) = failure;
      if (work == SliceWork::Kind::lead) is_leading_ = false;
    }
    changed_.notify_all();
    return;
  }
}

SliceWork::Kind SlicedRun::find_work(std::unique_lock<std::mutex>& lock, Slice*& slice) {
  for (;;) {
    if (ending_) return SliceWork::Kind::none;
    const SliceWork work = next_work(
        slices_.size(), [this](std::size_t k) { return slices_[k]->led; },
        [this](std::size_t k) { return slices_[k]->taken; }, options_.threads,
        !is_leading_ && !all_led_ && !leader_failure_, !leader_failure_);
    if (work.kind != SliceWork::Kind::none) {
      slice = slices_[work.slice].get();
      (work.kind == SliceWork::Kind::lead ? is_leading_ : slice->taken) = true;
      return work.kind;
    }
    if (all_led_ || leader_failure_) return work.kind;
    changed_.wait(lock);
  }
}

// The slice that is led into has its begin; there is another after it unless it is the last.
void SlicedRun::lead(Slice& slice) {
  ComputedMotion& motion = leader_.motion();
  const SliceHooks& hooks = options_.slice_hooks;
  const std::uint64_t work = hooks.work ? hooks.work(slice.number)
                                        : work_of_slice(slice.number, leader_.work_ahead(),
                                                        motion.size(), options_.threads);
  const std::optional<double> border = leader_.lead(slice.turns, work, hooks.border);
  std::unique_ptr<Slice> next;
  if (border) {
    next = std::make_unique<Slice>();
    next->number = slice.number + 1;
    next->begin = *border;
    next->start = motion.snapshot();
    if (options_.keep) next->kept = {next->start, motion.lasting_states(), leader_.collapses()};
  }
  slice.end = border ? to_rational(*border) : motion.input().horizon;
  {
    const std::lock_guard lock(mutex_);
    slice.led = true;
    is_leading_ = false;
    all_led_ = !border;
    if (next) slices_.push_back(std::move(next));
  }
  changed_.notify_all();
}

void SlicedRun::follow(Slice& slice, ComputedMotion& motion) {
  motion.follow(slice.start);
  slice.start = {};
  Follower follower(motion, slice.begin, options_.profile);
  follower.construct();
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return slice.led || leader_failure_ || ending_; });
    if (!slice.led) return;
  }
  follower.settle(slice.turns, slice.end);
  if (options_.slice_hooks.diagram) options_.slice_hooks.diagram(slice.number, follower.diagram());
  {
    std::vector<Quad> first = follower.diagram().quads();
    const std::lock_guard lock(mutex_);
    slice.first = std::move(first);
    slice.settled = true;
  }
  changed_.notify_all();
  Chunk chunk;
  chunk.reserve(kChunk + 64);
  follower.run(chunk, [&] {
    chunk.end_instant();
    if (chunk.size() >= kChunk) publish(slice, chunk, follower.stats());
  });
  publish(slice, chunk, follower.stats());
  std::vector<Quad> last = follower.diagram().quads();
  slice.turns = {};
  {
    const std::lock_guard lock(mutex_);
    slice.last = std::move(last);
    slice.stats = follower.stats();
    slice.stats.replays = motion.replays();
    slice.stats.highest_bits = motion.highest_bits();
    slice.stats.goal_bits = motion.goal_bits();
    slice.diagram = follower.diagram();
    slice.done = true;
  }
  changed_.notify_all();
}

void SlicedRun::publish(Slice& slice, Chunk& chunk, const EngineStats& stats) {
  if (options_.slice_hooks.pause) options_.slice_hooks.pause();
  chunk.stats = stats;
  Chunk next;
  next.reserve(kChunk + 64);
  {
    const std::lock_guard lock(mutex_);
    slice.chunks.push_back(std::exchange(chunk, std::move(next)));
  }
  changed_.notify_all();
}

// ---- The thread that tells. ----

std::optional<Outcome> SlicedRun::run(EventSink& sink) {
  slices_.push_back(std::make_unique<Slice>());
  slices_.back()->start = leader_.motion().snapshot();
  try {
    for (int k = 0; k < options_.threads; ++k) threads_.emplace_back([this] { work(); });
    const bool complete = tell_slices(sink);
    end();
    if (complete) return outcome(Outcome::Kind::complete);
  } catch (const GivenUp&) {
    end();
    if (!told_.begun) sink.begin({});
    keep_quietly([this] { keep(); });
    return outcome(Outcome::Kind::interrupted);
  } catch (const Undecided&) {
    end();
  } catch (...) {
    end();
    throw;
  }
  return std::nullopt;
}

Outcome SlicedRun::outcome(Outcome::Kind kind) {
  Outcome outcome;
  outcome.kind = kind;
  outcome.t =
      kind == Outcome::Kind::complete ? round_nearest(leader_.motion().input().horizon) : told_.t;
  if (kind == Outcome::Kind::interrupted) outcome.reason = "interrupted";
  stats_.add(leader_.stats());
  stats_.add(present_);
  stats_.end = outcome.t;
  const ComputedMotion& motion = leader_.motion();
  stats_.replays += motion.replays();
  stats_.highest_bits = std::max(stats_.highest_bits, motion.highest_bits());
  stats_.goal_bits = std::max(stats_.goal_bits, motion.goal_bits());
  return outcome;
}

void SlicedRun::ask_monitor() const {
  if (options_.monitor && !options_.monitor(told_.t, told_.events)) throw GivenUp();
}

template <class Ready>
void SlicedRun::wait_until(std::unique_lock<std::mutex>& lock, const Ready& ready) {
  while (!changed_.wait_for(lock, kLook, ready)) {
    lock.unlock();
    ask_monitor();
    lock.lock();
  }
}

// Returns whether the history is complete; if not, two slices do not join.
bool SlicedRun::tell_slices(EventSink& sink) {
  for (;;) {
    Slice* slice = nullptr;
    {
      std::unique_lock lock(mutex_);
      slice = slices_.front().get();
    }
    if (!tell_slice(*slice, sink)) return false;
    if (options_.keep) join(*slice);
    if (options_.keep && options_.is_to_keep()) keep();
    bool is_last = false;
    {
      std::unique_lock lock(mutex_);
      is_last = slices_.size() == 1;
      last_ = std::move(slice->last);
      stats_.add(slice->stats);
      present_ = {};
      ++stats_.slices;
      if (slice->number == 0) stats_.settling_flips = slice->stats.settling_flips;
      if (is_last) diagram_ = std::move(slice->diagram);
      slices_.pop_front();
    }
    changed_.notify_all();
    if (is_last) return true;
  }
}

// All of the slice is told: the run may be kept as it is at the begin of the next one, if there is
// one.
void SlicedRun::join(const Slice& slice) {
  join_.reset();
  Slice* next = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (slices_.size() > 1) next = slices_[1].get();
  }
  if (next == nullptr) return;
  join_ = {{}, *std::exchange(next->kept, std::nullopt)};
  KeptRun& kept = join_->run;
  kept.t0 = next->begin;
  kept.events = told_.events;
  kept.last = told_.t;
  kept.stats = stats_;
  kept.stats.add(slice.stats);
  kept.stats.settling_flips =
      slice.number == 0 ? slice.stats.settling_flips : stats_.settling_flips;
  kept.diagram = slice.last;
  kept.divisions = divisions_;
  kept.collapses = std::move(join_->begin.collapses);
  options_.mark();
}

void SlicedRun::keep() {
  if (!join_) return;
  auto [kept, begin] = *std::exchange(join_, std::nullopt);
  const ComputedMotion& leaders = leader_.motion();
  ComputedMotion motion(leaders.input(), leaders.options(), leaders.log());
  begin.motion.full = begin.states->get();
  motion.follow(begin.motion);
  keep_motion(motion, kept);
  options_.keep(std::move(kept));
}

bool SlicedRun::tell_slice(Slice& slice, EventSink& sink) {
  std::unique_lock lock(mutex_);
  const auto failed = [&] { return slice.failure || leader_failure_; };
  const auto require_none = [&] {
    if (slice.failure) std::rethrow_exception(slice.failure);
    if (leader_failure_) std::rethrow_exception(leader_failure_);
  };
  wait_until(lock, [&] { return slice.settled || failed(); });
  require_none();
  if (slice.number == 0) {
    const std::vector<Quad> first = std::move(slice.first);
    lock.unlock();
    sink.begin(first);
    told_.begun = true;
    lock.lock();
  } else if (slice.first != last_) {
    return false;
  }
  for (;;) {
    wait_until(lock, [&] { return !slice.chunks.empty() || slice.done || failed(); });
    require_none();
    if (slice.chunks.empty()) return true;
    const Chunk chunk = std::move(slice.chunks.front());
    slice.chunks.pop_front();
    lock.unlock();
    chunk.tell(sink, [&](double t, std::uint64_t events, int turns) {
      if (options_.max_events > 0 && told_.events + events > options_.max_events) {
        throw Undecided("more events than allowed");
      }
      if (told_.t == t && told_.events > 0) divisions_.push_back(turns_ + turns);
      told_.t = t;
      told_.events += events;
    });
    turns_ += chunk.turns();
    present_ = chunk.stats;
    ask_monitor();
    lock.lock();
  }
}

}  // namespace voroproof::internal
