#include "filtered/computed/computed_motion.h"

#include <string>
#include <utility>

#include "filtered/computed/computed_symmetry.h"
#include "filtered/motion/exact_motion.h"

namespace voroproof::internal {

ComputedMotion::ComputedMotion(MotionInput input, MotionOptions options,
                               std::shared_ptr<MotionLog> log)
    : Motion(std::move(input), options),
      states_(std::make_unique<MotionStates>(*input_, options, std::move(log))),
      rational_(state_.size()) {}

bool ComputedMotion::is_rational(GenId g) const {
  int id = state_[g + 1];
  while (id > 0) {
    const Record& r = states_->record(id - 1);
    if (r.maneuver < 0) return false;
    id = r.before_i;
  }
  return true;
}

ComputedMotion::Origin ComputedMotion::origin(GenId g, int id) const {
  const Record& r = states_->record(id - 1);
  if (r.maneuver >= 0) return {r.before_i, &states_->maneuver(r.maneuver), g, 0};
  if (g == r.i) return {r.before_i, nullptr, r.j, r.before_j};
  return {r.before_j, nullptr, r.i, r.before_i};
}

bool ComputedMotion::raise_precision() {
  if (!states_->raise_goal()) return false;
  for (GenId g = container_id; g < size(); ++g) refresh(g);
  return true;
}

void ComputedMotion::append(const Record& r) {
  states_->append(r);
  for (const GenId g : {r.i, r.j}) {
    if (g == container_id) continue;
    state_[g + 1] = records();
    doubles_[g + 1].t = r.t_ref;
  }
}

Impact ComputedMotion::collide(GenId i, GenId j, double t_near) {
  const auto is_point = [&](GenId g) {
    return g != container_id && sgn(input().disks[g].radius) == 0;
  };
  if (is_point(i) && is_point(j)) {
    throw Undecided("two points meet: a contact without a normal, which the model does not cover",
                    i, j);
  }
  const Record r{i, j, state_[i + 1], state_[j + 1], doubles(i).t, doubles(j).t, t_near, -1};
  append(r);
  states_->apply_rest();
  if (i != container_id) refresh(i);
  refresh(j);
  const auto round_all = [&] {
    Impact out{};
    out.time_dd = states_->last_time();
    double lo = 0, hi = 0;
    enclose(out.time_dd, lo, hi);
    out.time = DoubleBall::hull(lo, hi);
    out.t = round_coordinate(out.time_dd, j, 4);
    const DdBall delay = states_->last_delay();
    const auto state = [&](GenId g) {
      const DdMotion m = double_doubles(g);
      return RoundedState{round_coordinate(m.x + m.vx * delay, g, 0),
                          round_coordinate(m.y + m.vy * delay, g, 1), round_coordinate(m.vx, g, 2),
                          round_coordinate(m.vy, g, 3)};
    };
    if (i != container_id) out.first = state(i);
    out.second = state(j);
    return out;
  };
  for (;;) {
    try {
      return round_all();
    } catch (const BudgetExceeded& budget) {
      // Not provably on a boundary: more bits will tell, up to the limit.
      if (!raise_precision()) {
        throw Undecided(std::string("a coordinate after the collision may lie on a rounding "
                                    "boundary: ") +
                        budget.what());
      }
    }
  }
}

RoundedState ComputedMotion::maneuver(GenId g, const Rational& t, const Rational& vx,
                                      const Rational& vy) {
  const double t_ref = round_nearest(t);
  const int maneuver = states_->append({t, vx, vy});
  RoundedState out{0, 0, round_nearest(vx), round_nearest(vy)};
  for (;;) {
    const Ball::Precision bits = states_->bits_at(t_ref);
    const Site<Ball> at = site(g, Ball(t, bits));
    const std::array<Rational, 2>& o = input().origin;
    if ((at.x + Ball(o[0], bits)).round_to_double(out.px) &&
        (at.y + Ball(o[1], bits)).round_to_double(out.py)) {
      break;
    }
    try {
      ExactMotion exact(*this);
      const Site<Tower> s = exact.site(g, Tower(t));
      out.px = round_nearest(s.x + Tower(o[0]));
      out.py = round_nearest(s.y + Tower(o[1]));
      break;
    } catch (const BudgetExceeded& budget) {
      if (!raise_precision()) {
        throw Undecided(std::string("the position at the maneuver may lie on a rounding "
                                    "boundary: ") +
                        budget.what());
      }
    }
  }
  append({g, g, state_[g + 1], state_[g + 1], doubles(g).t, doubles(g).t, t_ref, maneuver});
  states_->apply_rest();
  refresh(g);
  return out;
}

std::shared_ptr<const Symmetry> ComputedMotion::symmetry() const {
  return std::make_shared<ComputedSymmetry>(*this);
}

void ComputedMotion::note_relations(int records, double lo, double hi) {
  internal::note_relations(*this, records, lo, hi);
}

}  // namespace voroproof::internal
