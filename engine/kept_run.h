// The state of a run from which another process can go on with it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/event_sink.h"
#include "engine/inelastic_collapse.h"
#include "engine/maneuvers.h"
#include "exact/ball.h"
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

// A disk that has turned: at time t it was at (x, y). `state` is Motion::state_id().
struct KeptDisk {
  GenId disk = 0;
  int state = 0;
  double t = 0;
  Ball x, y, vx, vy;
};

// A run at a time t0 at which nothing happens. Together with its history up to there, which has so
// many events, it is all that it takes to go on.
struct KeptRun {
  double t0 = 0;
  std::uint64_t events = 0;
  double last = 0;            // the time of the last of them, rounded
  EngineStats stats;          // the numbers of events, and of flips that settled the first diagram
  std::vector<Quad> diagram;  // at t0
  // Records of the log with which an instant begins whose rounded time is that of the one before.
  std::vector<int> divisions;
  // The states beyond double-doubles: see MotionStates.
  int goal_bits = 0;
  double bits_per_time = 0;
  std::int64_t v_scale = 0;
  Ball::Precision bits = 64;  // precision of the balls
  std::vector<KeptDisk> disks;
  std::vector<InelasticCollapse::Past> collapses;  // per disk, or none
};

// Keeps a run that was given up. That need not be possible, and may not take long: whoever gave it
// up waits.
void keep_quietly(const std::function<void()>& keep);

// Sets what is kept of a motion. Throws Undecided where the motion's last states cannot be had, and
// GivenUp.
void keep_motion(ComputedMotion& motion, KeptRun& kept);

// Makes a motion, which is as at its start, that which was kept, from the collisions and maneuvers
// of the history, which are told to it in their order. None of them is computed: each is noted in
// the log, with enclosures of what the history says, and the last states are those that were kept.
// What is proved of simultaneous collisions is proved again, since the proofs rest on the log
// alone. Throws OtherRun where what is told is not of that run.
class ReturnOfMotion final : public EventSink {
 public:
  // Both outlive this; so does what `maneuvers` refers to, which gives the next ones of the scene.
  ReturnOfMotion(ComputedMotion& motion, const KeptRun& kept,
                 std::function<std::vector<ManeuverInput>()> maneuvers);

  void begin(const std::vector<Quad>&) override {}
  void flip(double, const Quad&) override {}
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override;
  void maneuver(double t, GenId disk, const RoundedState& state) override;

  // All is told.
  void finish();

 private:
  void begin_turn(double t);
  void end_instant();
  TurnedState turned(GenId g, double t, const RoundedState& told);

  ComputedMotion& motion_;
  const KeptRun& kept_;
  std::function<std::vector<ManeuverInput>()> next_maneuvers_;
  std::vector<ManeuverInput> together_;  // maneuvers of one instant, not told yet
  std::vector<const KeptDisk*> disks_;   // by their numbers; null once its last turn is told
  MotionStates::Snapshot full_;
  double t_ = 0;                   // time of the present instant
  int begin_ = 0;                  // its first record
  std::size_t next_division_ = 0;  // index into kept_.divisions
};

}  // namespace voroproof::internal
