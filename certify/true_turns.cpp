#include "certify/true_turns.h"

#include "filtered/motion/options.h"

namespace voroproof::internal {

const TrueTurn& ComputedTurns::collide(GenId i, GenId j, const Moment& m) {
  const Impact impact = motion_.collide(i, j, m.middle());
  last_ = {motion_.led(i, j, impact.first, impact.second), m.middle(), impact.time_dd};
  return last_;
}

const TrueTurn& ComputedTurns::maneuver(std::size_t k) {
  const Maneuver& due = scene_.maneuvers[k];
  const RoundedState s = motion_.maneuver(due.disk, due.t, due.vx, due.vy);
  last_ = {motion_.led(due.disk, due.disk, s, s), 0, {}, k};
  return last_;
}

template <class Is>
const TrueTurn& FollowedTurns::take(const Is& is_asked_for) {
  if (all_taken() || !is_asked_for(turns_[next_])) {
    throw Undecided("disks turn in another order than the leader has them turn");
  }
  const TrueTurn& turn = turns_[next_++];
  motion_.follow(turn.led, turn.states);
  return turn;
}

// The leader has taken the contact for which it was proved here: no other is as near.
const TrueTurn& FollowedTurns::collide(GenId i, GenId j, const Moment& m) {
  return take([&](const TrueTurn& turn) {
    return turn.maneuver == TrueTurn::no_maneuver && turn.led.i == i && turn.led.j == j &&
           m.lo <= turn.near && turn.near <= m.hi;
  });
}

const TrueTurn& FollowedTurns::maneuver(std::size_t k) {
  return take([k](const TrueTurn& turn) { return turn.maneuver == k; });
}

}  // namespace voroproof::internal
