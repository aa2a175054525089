// The rounded numbers that leave a motion: times, velocities and centres rounded to nearest,
// centres in the scene's coordinates.
#include "filtered/computed/computed_motion.h"
#include "filtered/motion/exact_motion.h"

namespace voroproof::internal {

// A coordinate of disk g just after the last collision, its own, known roughly: 0 and 1 its centre,
// 2 and 3 its velocity, 4 the time.
double ComputedMotion::round_coordinate(const DdBall& rough, GenId g, int which) {
  const DdBall near = which < 2 ? in_scene(rough, which) : rough;
  if (options_.filters && rounds_to_leading(near)) return near.hi;
  const MotionState<Ball>& b = balls(g);
  const auto placed = [&](const Ball& x) {
    return moved_ ? x + Ball(input().origin[which], states_->bits_at(0)) : x;
  };
  const Ball value = which == 0   ? placed(b.x + b.vx * states_->last_delay_ball())
                     : which == 1 ? placed(b.y + b.vy * states_->last_delay_ball())
                     : which == 2 ? b.vx
                     : which == 3 ? b.vy
                                  : states_->last_time_ball();
  double out = 0;
  if (value.round_to_double(out)) return out;
  // Either a number on a rounding boundary (zero and short dyadic numbers are), or
  // not enough bits: ask the exact state first, it is the only proof of a tie.
  ExactMotion exact(*this);
  const int id = state_[g + 1];
  const ExactMotion::State& s = exact.state(id, g);
  const Tower& start = exact.start(id, g);
  const Tower dt = start - Tower(s.t_ref);
  switch (which) {
    case 0:
      return round_nearest(s.x + s.vx * dt + Tower(input().origin[0]));
    case 1:
      return round_nearest(s.y + s.vy * dt + Tower(input().origin[1]));
    case 2:
      return round_nearest(s.vx);
    case 3:
      return round_nearest(s.vy);
    default:
      return round_nearest(start);
  }
}

}  // namespace voroproof::internal
