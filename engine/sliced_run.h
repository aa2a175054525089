// A run of the engine on several threads, in slices of time: docs/design/engine.md, "Slices".
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "engine/engine.h"
#include "engine/follower.h"
#include "engine/kept_run.h"
#include "engine/leader.h"
#include "engine/slice.h"

namespace voroproof::internal {

class SlicedRun {
 public:
  SlicedRun(MotionInput input, std::vector<ManeuverInput> maneuvers, const EngineOptions& options);
  SlicedRun(const SlicedRun&) = delete;
  SlicedRun& operator=(const SlicedRun&) = delete;
  ~SlicedRun();

  // Whether the scene is one for slices.
  bool possible() const;

  // How far the history was told.
  struct Told {
    bool begun = false;
    double t = 0;  // time of the last instant
    std::uint64_t events = 0;
  };
  // Tells the history in whole instants. An outcome only where the horizon is reached or the
  // monitor says no. Else what is told is right, and what comes next is for an engine of one thread
  // to find out: something cannot be decided, or two slices do not join.
  std::optional<Outcome> run(EventSink& sink);

  const Told& told() const { return told_; }
  // For a run with an outcome.
  const EngineStats& stats() const { return stats_; }
  // The diagram at the end of a complete one.
  const Diagram& diagram() const { return diagram_; }
  ComputedMotion& motion() { return leader_.motion(); }

 private:
  void work();
  SliceWork::Kind find_work(std::unique_lock<std::mutex>& lock, Slice*& slice);
  void lead(Slice& slice);
  void follow(Slice& slice, ComputedMotion& motion);
  void publish(Slice& slice, Chunk& chunk, const EngineStats& stats);
  void end();

  bool tell_slices(EventSink& sink);
  void join(const Slice& slice);
  void keep();
  bool tell_slice(Slice& slice, EventSink& sink);
  template <class Ready>
  void wait_until(std::unique_lock<std::mutex>& lock, const Ready& ready);
  void ask_monitor() const;
  Outcome outcome(Outcome::Kind kind);

  EngineOptions options_;
  Leader leader_;
  Told told_;
  EngineStats stats_;
  EngineStats present_;  // statistics of the slice that is being told
  Diagram diagram_;
  std::vector<Quad> last_;      // the diagram at the end of what is told
  int turns_ = 0;               // told
  std::vector<int> divisions_;  // divisions of the told part: see KeptRun
  // The last place where two slices join, as long as it is not kept; the run without its motion.
  struct Join {
    KeptRun run;
    SliceBegin begin;
  };
  std::optional<Join> join_;

  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by mutex_; a slice is used by one thread where it does not say otherwise.
  std::deque<std::unique_ptr<Slice>> slices_;  // those that are not told, in order
  bool is_leading_ = false;
  bool all_led_ = false;
  std::exception_ptr leader_failure_;
  std::atomic<bool> ending_ = false;

  std::vector<std::thread> threads_;  // last: they use the others
};

}  // namespace voroproof::internal
