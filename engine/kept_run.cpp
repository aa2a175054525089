#include "engine/kept_run.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "engine/engine.h"
#include "exact/patience.h"
#include "filtered/motion/enclosures.h"
#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

namespace {

constexpr double kTiny = std::numeric_limits<double>::min();

// How far the position at the exact time and the velocity may be from what a history says, which is
// rounded to nearest, as is the time.
double error_of(double velocity) { return std::fabs(velocity) * 0x1p-52 + kTiny; }
double error_of(double position, double velocity, double t) {
  return (std::fabs(position) + std::fabs(velocity) * t) * 0x1p-51 + kTiny;
}

TurnedState turned_of(double t, const DdBall& x, const DdBall& y, const DdBall& vx,
                      const DdBall& vy) {
  return {.t = t,
          .x = x.hi,
          .y = y.hi,
          .vx = vx.hi,
          .vy = vy.hi,
          .x2 = x.lo,
          .y2 = y.lo,
          .vx2 = vx.lo,
          .vy2 = vy.lo,
          .ex = std::fmax(x.rad, y.rad),
          .ev = std::fmax(vx.rad, vy.rad)};
}

}  // namespace

void keep_quietly(const std::function<void()>& keep) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point until = Clock::now() + std::chrono::milliseconds(400);
  const Patience patience([until] { return Clock::now() < until; });
  try {
    keep();
  } catch (const GivenUp&) {
  } catch (const Undecided&) {
  }
}

void keep_motion(ComputedMotion& motion, KeptRun& kept) {
  const MotionStates::Snapshot full = motion.snapshot().full;
  kept.goal_bits = full.goal_bits;
  kept.bits_per_time = full.slope;
  kept.v_scale = full.v_scale;
  kept.bits = motion.highest_bits();
  for (GenId g = 0; g < motion.size(); ++g) {
    Patience::ask();
    if (motion.state_id(g) <= 0) continue;
    const double t = motion.doubles(g).t;
    const MovingSite<Ball> s = motion.moving_site(g, Ball(t, kept.bits));
    kept.disks.push_back({g, motion.state_id(g), t, s.x, s.y, s.vx, s.vy});
  }
}

ReturnOfMotion::ReturnOfMotion(ComputedMotion& motion, const KeptRun& kept,
                               std::function<std::vector<ManeuverInput>()> maneuvers)
    : motion_(motion),
      kept_(kept),
      next_maneuvers_(std::move(maneuvers)),
      disks_(motion.size(), nullptr) {
  for (const KeptDisk& d : kept.disks) disks_.at(d.disk) = &d;
  full_.fixed.resize(motion.size() + 1);
  full_.balls.resize(motion.size() + 1);
}

void ReturnOfMotion::collide(double t, GenId i, GenId j, const RoundedState& first,
                             const RoundedState& second) {
  begin_turn(t);
  motion_.log()->append({i, j, motion_.state_id(i), motion_.state_id(j), motion_.doubles(i).t,
                         motion_.doubles(j).t, t, -1});
  const TurnedState of_i = i == container_id ? TurnedState{} : turned(i, t, first);
  motion_.follow(i, of_i, j, turned(j, t, second), kept_.v_scale);
}

void ReturnOfMotion::maneuver(double t, GenId disk, const RoundedState& state) {
  begin_turn(t);
  if (together_.empty()) together_ = next_maneuvers_();
  if (together_.empty() || together_.front().disk != disk ||
      round_nearest(together_.front().t) != t) {
    throw OtherRun("another maneuver is next");
  }
  const ManeuverInput next = together_.front();
  together_.erase(together_.begin());
  const int index = motion_.log()->append(MotionLog::Maneuver{next.t, next.vx, next.vy});
  const int before = motion_.state_id(disk);
  const double t_before = motion_.doubles(disk).t;
  motion_.log()->append({disk, disk, before, before, t_before, t_before, t, index});
  const TurnedState after = turned(disk, t, state);
  motion_.follow(disk, after, disk, after, kept_.v_scale);
}

// The next record is of time t.
void ReturnOfMotion::begin_turn(double t) {
  Patience::ask();
  const bool divided = next_division_ < kept_.divisions.size() &&
                       kept_.divisions[next_division_] == motion_.records();
  if (divided) ++next_division_;
  if (divided || t != t_) end_instant();
  t_ = t;
}

void ReturnOfMotion::end_instant() {
  motion_.note_relations(begin_, next_below(t_), next_above(t_));
  begin_ = motion_.records();
}

// The state of the disk that the next record leaves, of which the history says so much.
TurnedState ReturnOfMotion::turned(GenId g, double t, const RoundedState& told) {
  const KeptDisk* kept = disks_.at(g);
  if (kept == nullptr || kept->state != motion_.records() + 1) {
    const double error = std::fmax(error_of(told.px, told.vx, t), error_of(told.py, told.vy, t));
    return {.t = t,
            .x = told.px,
            .y = told.py,
            .vx = told.vx,
            .vy = told.vy,
            .x2 = 0,
            .y2 = 0,
            .vx2 = 0,
            .vy2 = 0,
            .ex = error,
            .ev = std::fmax(error_of(told.vx), error_of(told.vy))};
  }
  // In the log the state is referred to the time that the history tells.
  const Ball later = Ball(t, kept_.bits) - Ball(kept->t, kept_.bits);
  auto state = std::make_shared<MotionState<Ball>>(MotionState<Ball>{
      kept->x + kept->vx * later, kept->y + kept->vy * later, kept->vx, kept->vy});
  disks_[g] = nullptr;
  full_.balls[g + 1] = state;
  return turned_of(t, dd_of(state->x), dd_of(state->y), dd_of(state->vx), dd_of(state->vy));
}

void ReturnOfMotion::finish() {
  end_instant();
  for (const KeptDisk* d : disks_) {
    if (d != nullptr) throw OtherRun("a turn of disk " + std::to_string(d->disk) + " is missing");
  }
  if (!together_.empty()) throw OtherRun("not all maneuvers of an instant are told");
  MotionSnapshot then;
  for (GenId g = container_id; g < motion_.size(); ++g) {
    then.states.push_back(motion_.state_id(g));
    then.doubles.push_back(motion_.doubles(g));
    then.seconds.push_back(motion_.seconds(g));
  }
  full_.records = static_cast<std::size_t>(motion_.records());
  full_.goal_bits = kept_.goal_bits;
  full_.slope = kept_.bits_per_time;
  full_.v_scale = kept_.v_scale;
  then.full = std::move(full_);
  motion_.follow(then);
}

}  // namespace voroproof::internal
