#include "certify/exact_turns.h"

#include <cmath>

#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

std::optional<Moment> ExactTurns::next_contact(GenId i, GenId j) {
  const NextContact c = exact_.next_contact(i, j);
  if (c.kind == NextContact::Kind::none) return std::nullopt;
  return exact_.moment_of(i, j, c);
}

// When the pair of the claim touches, proved to be in time.
Moment ExactTurns::contact_of(const CollideEvent& claim) {
  const GenId i = claim.i, j = claim.j;
  const NextContact c = exact_.next_contact(i, j);
  const auto claimed = [this] { return exact_time(*claims_.current()); };
  if (c.kind == NextContact::Kind::none) {
    const std::string why = s_.replay.partners(i, j)
                                ? "have collided, and neither has turned since: they part"
                                : pairs_.standing(claim);
    refuter_.refute(Fault::spurious_event, "generators " + text_of(i, j) + " " + why,
                    motion_witness(s_.motion, {i, j}, claimed()));
  }
  if (i != container_id && s_.points.is_point(i) && s_.points.is_point(j)) {
    // They meet then, and do not approach there: the gap has a double root.
    exact_.require_no_meeting(i, j, Moment::at(claimed() + s_.options.tolerance));
    refuter_.refute(Fault::spurious_event,
                    "generators " + text_of(i, j) + " are points that do not meet by then",
                    motion_witness(s_.motion, {i, j}, claimed()));
  }
  const Moment m = exact_.moment_of(i, j, c);
  if (m.hi >= s_.horizon_down && s_.chronology.compare(m, Moment::at(s_.last_instant)) > 0) {
    refuter_.refute(Fault::spurious_event, "generators " + text_of(i, j) + " touch " +
                                               between(m.lo, m.hi) + ", after the horizon");
  }
  if (instants_.in_time(m)) return m;
  const bool near = to_rational(c.lo) - claimed() <= mistimed_tolerances * s_.options.tolerance;
  const auto [lo, hi] = s_.chronology.enclosure(m);
  Divergence d = refuter_.at_claim(near ? Fault::wrong_time : Fault::spurious_event,
                                   "generators " + text_of(i, j) + " touch " + between(lo, hi));
  d.true_contact = {i, j};
  d.true_time = {lo, hi};
  d.witness = contact_witness(s_.motion, i, j, to_rational(lo), to_rational(hi));
  throw Refuted{d};
}

void ExactTurns::collide(const CollideEvent& claim) {
  const GenId i = claim.i, j = claim.j;
  const Moment m = contact_of(claim);
  instants_.advance(m);
  instants_.require_no_flip_yet(i, j);
  order_.begin(i, j, claims_.line(), claim);
  if (!front_.begun) order_.note_at_start(i, j);
  around_.end(i, j, m);
  // The law between the claimed values first, while the state before is at hand.
  if (claim.v[1] && claim.p[1]) {
    const BallPair near{claim.p[0] ? Responses::claimed_center(claim, 0) : BallVec2{},
                        Responses::claimed_center(claim, 1)};
    if (!s_.law.certainly_obeyed(claim, near, s_.replay.near_velocities(i, j))) {
      const ExactPair p = Replay::recorded_centers(claim, {});
      if (!s_.law.obeyed(claim, p, s_.replay.velocities(i, j), 0)) responses_.refute(claim, p);
    }
  }
  const TrueTurn& turned = turn(claim, m);
  check_state(claim, 1, turned.led.rounded_second);
  if (i != container_id) check_state(claim, 0, turned.led.rounded_first);
  note(claim, turned);
  order_.end();
  around_.begin(front_.moment);
  front_.turning.clear();
}

const TrueTurn& ExactTurns::turn(const CollideEvent& claim, Moment m) {
  const GenId i = claim.i, j = claim.j;
  front_.turning = {i, j};
  const TrueTurn& turned = turns_.collide(i, j, m);
  m.collided(i, j, s_.motion.state_id(j));
  m.dd = turned.time;
  m.tight = true;
  front_.moment = m;
  exact_.note_birth(i, m);
  exact_.note_birth(j, m);
  return turned;
}

// For what it gives of them, the claim is taken at its word.
void ExactTurns::note(const CollideEvent& claim, const TrueTurn& turned) {
  std::optional<ExactPair> computed;
  if (!claim.v[1]) {
    const auto velocity = [](const RoundedState& s) {
      return ExactVec2{to_rational(s.vx), to_rational(s.vy)};
    };
    computed = {velocity(turned.led.rounded_first), velocity(turned.led.rounded_second)};
  }
  s_.replay.note_collision(claim, computed);
}

void ExactTurns::maneuver(const ManeuverEvent& claim, std::size_t k) {
  const Maneuver& due = s_.scene.maneuvers[k];
  const Moment m = Moment::at(due.t);
  instants_.advance(m);
  const GenId g = claim.disk;
  instants_.require_no_flip_yet(g, g);
  order_.begin(g, g, claims_.line(), claim);
  if (!front_.begun) order_.note_at_start(g, g);
  around_.end(container_id, g, m);
  const RoundedState s = turn(k).led.rounded_first;
  order_.end();
  responses_.check_center(g, exact_center(claim), {due.vx, due.vy},
                          {to_rational(s.px), to_rational(s.py)});
  s_.replay.note_maneuver(k, claim);
  around_.begin(m);
  front_.turning.clear();
}

const TrueTurn& ExactTurns::turn(std::size_t k) {
  const Maneuver& due = s_.scene.maneuvers[k];
  front_.turning = {due.disk};
  const TrueTurn& turned = turns_.maneuver(k);
  front_.moment = Moment::at(due.t);
  exact_.note_birth(due.disk, front_.moment);
  return turned;
}

namespace {

// Whether a claimed velocity is the true one, but for a rounding or two.
bool certainly_equal(const CollideEvent& claim, int side, const RoundedState& truth) {
  if (claim.exact) return false;
  const auto near = [](double x, double y) { return std::fabs(x - y) <= 0x1p-51 * std::fabs(y); };
  const Vec2& v = *claim.v[side];
  return near(v[0], truth.vx) && near(v[1], truth.vy);
}

}  // namespace

// Claimed values against the true ones, which are correctly rounded. A contact that is
// off by the tolerance in time turns its normal by what the two cover meanwhile, over their reach,
// and the velocities by twice that; where the reach is too short for that to say much, by no more
// than a part in 1024.
void ExactTurns::check_state(const CollideEvent& claim, int side, const RoundedState& truth) {
  const GenId g = side == 0 ? claim.i : claim.j;
  const auto true_velocity = [&] {
    return ExactVec2{to_rational(truth.vx), to_rational(truth.vy)};
  };
  if (claim.v[side] && !certainly_equal(claim, side, truth)) {
    const ExactVec2 v = *exact_velocity(claim, side), true_v = true_velocity();
    const ExactPair before = s_.replay.velocities(claim.i, claim.j);
    Rational speed = length_bound(before[1]);
    if (claim.i != container_id) speed += length_bound(before[0]);
    const Rational turned =
        4 * s_.options.tolerance * speed * speed / s_.law.reach(claim.i, claim.j);
    const Rational allowed =
        s_.options.law_tolerance * speed + std::min(turned, Rational(speed / 1024));
    if (norm2(minus(v, true_v)) > square(allowed)) {
      refuter_.refute(Fault::wrong_response,
                      "the velocity of disk " + std::to_string(g) + " is (" +
                          number_text(true_v[0].get_d()) + ", " + number_text(true_v[1].get_d()) +
                          "), and the claimed one is " + off(v, true_v, allowed) +
                          " (--tolerance, --law-tolerance)");
    }
  }
  if (claim.p[side] && !responses_.certainly_near(claim, side, ball(Vec2{truth.px, truth.py}))) {
    responses_.check_center(g, exact_center(claim, side), true_velocity(),
                            {to_rational(truth.px), to_rational(truth.py)});
  }
}

}  // namespace voroproof::internal
