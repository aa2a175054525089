#include "certify/turn_order.h"

#include <algorithm>
#include <utility>

#include "certify/wording.h"

namespace voroproof::internal {

namespace {

bool is_maneuver(const Turn& t) { return t.i == t.j; }
bool involves(const Turn& t, GenId g) { return g != container_id && (g == t.i || g == t.j); }

}  // namespace

void TurnOrder::require_no_flip_yet(GenId i, GenId j) const {
  for (const GenId g : {i, j}) {
    if (g == container_id || std::find(flipped_.begin(), flipped_.end(), g) == flipped_.end()) {
      continue;
    }
    refuter_.refute(Fault::wrong_order,
                    "disk " + std::to_string(g) +
                        " turns at the same instant as an edge of it flips, and comes "
                        "before that");
  }
}

void TurnOrder::require_first_at_start(GenId i, GenId j) {
  const std::pair pair(i, j);
  const Instant now = s_.chronology.present(Moment::at(Rational(0)));
  for (const GenId g : {i, j}) {
    if (g == container_id) continue;
    for (GenId other = container_id; other < s_.motion.size(); ++other) {
      const std::pair<GenId, GenId> near = std::minmax(g, other);
      if (g == other || !(near < pair) || s_.replay.partners(near.first, near.second) ||
          s_.contacts.certainly_apart(near.first, near.second, now)) {
        continue;
      }
      if (s_.contacts.from(near.first, near.second, now, 0).kind == NextContact::Kind::now) {
        refuter_.refute(Fault::wrong_order,
                        "generators " + text_of(near.first, near.second) +
                            " touch and approach at the same instant and come first");
      }
    }
  }
}

void TurnOrder::require_no_contact_at_start(GenId g) {
  if (s_.options.truth == Truth::recorded) return;
  const Instant now = s_.chronology.present(Moment::at(Rational(0)));
  for (GenId other = container_id; other < s_.motion.size(); ++other) {
    const auto [i, j] = std::minmax(g, other);
    if (i == j || s_.replay.partners(i, j) || front_.maneuvered_now(other) ||
        s_.contacts.certainly_apart(i, j, now)) {
      continue;
    }
    if (s_.contacts.from(i, j, now, 0).kind == NextContact::Kind::now) {
      throw Refuted{refuter_.missing_contact(i, j, 0, 0)};
    }
  }
}

// The order takes the smallest of the pairs that are due, all of them before a maneuver. A pair
// that has not turned since was due already when a greater one was claimed, and comes before it. It
// shares no disk with what it passes. But in its right place its collision may make another pair
// due: one of its disks and a disk which turns later. Then the claims do not commute.
void TurnOrder::place(const Turn& turn) {
  const auto maneuvers_end =
      std::find_if(turns_.rbegin(), turns_.rend(), is_maneuver).base();  // begin() where none is
  const auto since = std::find_if(turns_.rbegin(), turns_.rend(), [&](const Turn& t) {
                       return involves(t, turn.i) || involves(t, turn.j);
                     }).base();
  auto at = since;
  if (is_maneuver(turn)) {
    if (maneuvers_end == turns_.begin()) {
      at = turns_.end();
    } else if (since <= maneuvers_end) {
      at = maneuvers_end;
    } else {
      refuter_.refute(Fault::wrong_order, "the maneuver of disk " + std::to_string(turn.i) +
                                              " at the same instant comes before the collision of "
                                              "generators " +
                                              text_of((since - 1)->i, (since - 1)->j));
    }
  } else {
    // What a maneuver made due waits for the last of them.
    const bool waits = since != turns_.begin() && is_maneuver(*(since - 1));
    if (waits) at = std::max(since, maneuvers_end);
    at = std::find_if(at, turns_.end(), [&](const Turn& t) {
      return is_maneuver(t) || std::pair(turn.i, turn.j) < std::pair(t.i, t.j);
    });
  }
  require_commutes(turn, {at, turns_.end()});
  turns_.insert(at, turn);
}

// The turn is taken before these, each of which turned before it was claimed.
void TurnOrder::require_commutes(const Turn& turn, std::span<const Turn> passed) const {
  for (std::size_t k = 0; k < passed.size(); ++k) {
    const Turn& later = passed[k];
    for (const auto& [x, state] : {std::pair(later.i, later.state_i), {later.j, later.state_j}}) {
      const auto before = passed.first(k);
      const bool turned = std::any_of(before.begin(), before.end(),
                                      [&, g = x](const Turn& t) { return involves(t, g); });
      if (x == container_id || turned) continue;
      for (const GenId g : {turn.i, turn.j}) {
        const auto [i, j] = std::minmax(g, x);
        if (g == container_id ||
            (!is_maneuver(later) && std::pair(later.i, later.j) <= std::pair(i, j)) ||
            !would_collide(g, {x, state})) {
          continue;
        }
        refuter_.refute(Fault::wrong_order,
                        "generators " + text_of(turn.i, turn.j) +
                            " turn at the same instant and come earlier, and after them " +
                            text_of(i, j));
      }
    }
  }
}

// Whether g, as it moves since it turned at the present instant, touches and approaches another in
// an earlier state. Throws Undecided.
bool TurnOrder::would_collide(GenId g, const DiskState& other) const {
  if (s_.contacts.certainly_apart(std::min(g, other.g), std::max(g, other.g),
                                  s_.chronology.instant(front_.moment))) {
    return false;
  }
  try {
    ExactMotion exact(s_.motion);
    const Tower now = exact.start(s_.motion.state_id(g), g);
    const auto site = [&](GenId of, int id) -> MovingSite<Tower> {
      const ExactMotion::State& s = exact.state(id, of);
      const Tower dt = now - Tower(s.t_ref);
      return {s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, exact.radius(of)};
    };
    const Contact<Tower> k(site(g, s_.motion.state_id(g)), site(other.g, other.id));
    return sign(k.c) == Sign::zero && sign(k.b) == Sign::negative;
  } catch (const BudgetExceeded& e) {
    throw Undecided(
        std::string("the order of the collisions of one instant is not decided: ") + e.what(),
        std::min(g, other.g), std::max(g, other.g));
  }
}

}  // namespace voroproof::internal
