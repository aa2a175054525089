// The order of what one instant changes (docs/formats.md, section 6): collisions, the smallest pair
// first; maneuvers; collisions that these bring about; flips. Claims that commute may be exchanged.
#include <algorithm>

#include "certify/checker.h"
#include "certify/wording.h"

namespace voroproof::internal {

// No flip at this instant has been claimed of a generator that turns at it, now.
void Checker::require_no_flip_yet(GenId i, GenId j) {
  for (const GenId g : {i, j}) {
    if (g == container_id || std::find(flipped_.begin(), flipped_.end(), g) == flipped_.end()) {
      continue;
    }
    refute(Fault::wrong_order, "disk " + std::to_string(g) +
                                   " turns at the same instant as an edge of it flips, and comes "
                                   "before that");
  }
}

// At t = 0 no pair has a life yet that the collision of i and j would end.
void Checker::require_first_at_start(GenId i, GenId j) {
  const std::pair pair(i, j);
  const Instant now = chronology_.present(Moment::at(Rational(0)));
  for (const GenId g : {i, j}) {
    if (g == container_id) continue;
    for (GenId other = container_id; other < motion_.size(); ++other) {
      const std::pair<GenId, GenId> near = std::minmax(g, other);
      if (g == other || !(near < pair) || replay_.partners(near.first, near.second) ||
          contacts_.certainly_apart(near.first, near.second, now)) {
        continue;
      }
      if (contacts_.from(near.first, near.second, now, 0).kind == NextContact::Kind::now) {
        refute(Fault::wrong_order, "generators " + text_of(near.first, near.second) +
                                       " touch and approach at the same instant and come first");
      }
    }
  }
}

// Exact truth: puts what has just been proved to turn at the present instant where the format's
// order has it, among those that turned before it.
//
// That order takes the smallest of the pairs that are due, all of them before a maneuver. A pair
// that has not turned since was due already when a greater one was claimed, and comes before it. It
// shares no disk with what it passes; but a blow in its right place may make another pair due, that
// of one of its disks and a disk which turns later. Then the claims do not commute.
void Checker::place_turn(const Turn& turn) {
  const auto is_maneuver = [](const Turn& t) { return t.i == t.j; };
  const auto involves = [](const Turn& t, GenId g) {
    return g != container_id && (g == t.i || g == t.j);
  };
  const auto maneuvers_end =
      std::find_if(turns_.rbegin(), turns_.rend(), is_maneuver).base();  // begin() where none is
  const auto since = std::find_if(turns_.rbegin(), turns_.rend(), [&](const Turn& t) {
                       return involves(t, turn.i) || involves(t, turn.j);
                     }).base();
  auto place = since;
  if (is_maneuver(turn)) {
    if (maneuvers_end == turns_.begin()) {
      place = turns_.end();
    } else if (since <= maneuvers_end) {
      place = maneuvers_end;
    } else {
      refute(Fault::wrong_order, "the maneuver of disk " + std::to_string(turn.i) +
                                     " at the same instant comes before the collision of "
                                     "generators " +
                                     text_of((since - 1)->i, (since - 1)->j));
    }
  } else {
    // What a maneuver made due waits for the last of them.
    const bool waits = since != turns_.begin() && is_maneuver(*(since - 1));
    if (waits) place = std::max(since, maneuvers_end);
    place = std::find_if(place, turns_.end(), [&](const Turn& t) {
      return is_maneuver(t) || std::pair(turn.i, turn.j) < std::pair(t.i, t.j);
    });
  }
  for (auto later = place; later != turns_.end(); ++later) {
    for (const auto& [x, state] :
         {std::pair(later->i, later->state_i), {later->j, later->state_j}}) {
      const bool turned =
          std::any_of(place, later, [&, g = x](const Turn& t) { return involves(t, g); });
      if (x == container_id || turned) continue;
      for (const GenId g : {turn.i, turn.j}) {
        const auto [i, j] = std::minmax(g, x);
        if (g == container_id ||
            (!is_maneuver(*later) && std::pair(later->i, later->j) <= std::pair(i, j)) ||
            !would_collide(g, {x, state})) {
          continue;
        }
        refute(Fault::wrong_order, "generators " + text_of(turn.i, turn.j) +
                                       " turn at the same instant and come earlier, and after "
                                       "them " +
                                       text_of(i, j));
      }
    }
  }
  turns_.insert(place, turn);
}

// Whether g, as it moves since it turned at the present instant, touches and approaches another in
// an earlier state. Throws Undecided.
bool Checker::would_collide(GenId g, const DiskState& other) const {
  if (contacts_.certainly_apart(std::min(g, other.g), std::max(g, other.g),
                                chronology_.instant(frontier_))) {
    return false;
  }
  try {
    ExactMotion exact(motion_);
    const Tower now = exact.start(motion_.state_id(g), g);
    const auto site = [&](GenId of, int id) -> MovingSite<Tower> {
      const ExactMotion::State& s = exact.state(id, of);
      const Tower dt = now - Tower(s.t_ref);
      return {s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, exact.radius(of)};
    };
    const Contact<Tower> k(site(g, motion_.state_id(g)), site(other.g, other.id));
    return sign(k.c) == Sign::zero && sign(k.b) == Sign::negative;
  } catch (const BudgetExceeded& e) {
    throw Undecided(
        std::string("the order of the collisions of one instant is not decided: ") + e.what(),
        std::min(g, other.g), std::max(g, other.g));
  }
}

}  // namespace voroproof::internal
