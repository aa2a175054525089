#include "certify/turns.h"

#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

void Turns::collide(const CollideEvent& claim) {
  front_.colliding = {claim.i, claim.j};
  const bool adjacent = front_.begun && s_.options.judges_flips();
  const int edge = adjacent ? s_.replay.adjacency(claim.i, claim.j) : -1;
  if (adjacent && edge < 0) {
    refuter_.refute(Fault::wrong_pair, "generators " + text_of(claim.i, claim.j) +
                                           " are not adjacent in the diagram: they " +
                                           pairs_.standing(claim));
  }
  if (s_.options.truth == Truth::exact) {
    collide_exactly(claim);
  } else {
    collide_as_recorded(claim, edge);
  }
  front_.colliding.reset();
  ++s_.certificate.collisions;
}

// When the pair of the claim touches, proved to be in time.
Moment Turns::contact_of(const CollideEvent& claim) {
  const GenId i = claim.i, j = claim.j;
  const NextContact c = pairs_.exact().next_contact(i, j);
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
    pairs_.exact().require_no_meeting(i, j, Moment::at(claimed() + s_.options.tolerance));
    refuter_.refute(Fault::spurious_event,
                    "generators " + text_of(i, j) + " are points that do not meet by then",
                    motion_witness(s_.motion, {i, j}, claimed()));
  }
  const Moment m = pairs_.exact().moment_of(i, j, c);
  if (m.hi >= s_.horizon_down && s_.chronology.compare(m, Moment::at(s_.last_instant)) > 0) {
    refuter_.refute(Fault::spurious_event, "generators " + text_of(i, j) + " touch " +
                                               between(m.lo, m.hi) + ", after the horizon");
  }
  if (instants_.in_time(m)) return m;
  const bool near = to_rational(c.lo) - claimed() <= mistimed_tolerances * s_.options.tolerance;
  Divergence d = refuter_.at_claim(near ? Fault::wrong_time : Fault::spurious_event,
                                   "generators " + text_of(i, j) + " touch " + between(c.lo, c.hi));
  d.true_contact = {i, j};
  d.true_time = {c.lo, c.hi};
  d.witness = contact_witness(s_.motion, i, j, to_rational(c.lo), to_rational(c.hi));
  throw Refuted{d};
}

void Turns::collide_exactly(const CollideEvent& claim) {
  const GenId i = claim.i, j = claim.j;
  Moment m = contact_of(claim);
  instants_.advance(m);
  order_.require_no_flip_yet(i, j);
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
  front_.turning = {i, j};
  const Impact impact = s_.motion.collide(i, j, m.middle());
  m.collided(i, j, s_.motion.state_id(j));
  m.dd = impact.time_dd;
  m.tight = true;
  front_.moment = m;
  pairs_.exact().note_birth(i, m);
  pairs_.exact().note_birth(j, m);
  responses_.check_state(claim, 1, impact.second);
  if (i != container_id) responses_.check_state(claim, 0, impact.first);
  std::optional<ExactPair> computed;
  if (!claim.v[1]) {
    computed = {ExactVec2{to_rational(impact.first.vx), to_rational(impact.first.vy)},
                ExactVec2{to_rational(impact.second.vx), to_rational(impact.second.vy)}};
  }
  s_.replay.note_collision(claim, computed);
  order_.end();
  around_.begin(m);
  front_.turning.clear();
}

void Turns::collide_as_recorded(const CollideEvent& claim, int edge) {
  const GenId i = claim.i, j = claim.j;
  const BallPair at = s_.replay.near_positions(claim);
  const Moment m = claim.exact ? Moment::at(exact_time(*claims_.current())) : Moment::at(claim.t);
  // Settle the events of the instant before first.
  instants_.advance(m);
  pairs_.check_contact(claim, edge, at);
  order_.require_no_flip_yet(i, j);
  around_.end(i, j, m);
  s_.replay.note_collision(claim, recorded_response(claim, at));
  front_.turning = {i, j};
  if (i != container_id) turn(i);
  turn(j);
  around_.begin(m);
  front_.turning.clear();
}

// Recorded truth: the claimed centres are where the paths are, enclosed by `at`, and the claimed
// velocities obey the law there. Where the claim gives no velocities: those that the law computes.
std::optional<ExactPair> Turns::recorded_response(const CollideEvent& claim, const BallPair& at) {
  const auto exactly = [&] {
    return s_.replay.positions(claim.i, claim.j, exact_time(*claims_.current()));
  };
  std::optional<ExactPair> computed;
  const auto check_centers = [&] {
    for (const int side : {0, 1}) {
      if (!claim.p[side] || responses_.certainly_near(claim, side, at[side])) continue;
      const auto after = computed ? (*computed)[side] : exact_velocity(claim, side);
      responses_.check_center(side == 0 ? claim.i : claim.j, exact_center(claim, side),
                              after.value_or(ExactVec2{}), exactly()[side]);
    }
  };
  if (claim.v[1]) {
    check_centers();
    // The law with the centres of the paths: those that the file gives are only compared with them.
    if (!s_.law.certainly_obeyed(claim, at, s_.replay.near_velocities(claim.i, claim.j))) {
      const ExactPair p = exactly(), v = s_.replay.velocities(claim.i, claim.j);
      if (!s_.law.obeyed(claim, p, v, exact_time(*claims_.current()))) responses_.refute(claim, p);
    }
    return std::nullopt;
  }
  try {
    computed = s_.replay.computed_velocities(claim, exactly());
  } catch (const Undecided&) {
    // A centre that is too far from the disk's path even if the disk stops is wrong. This check
    // needs no velocities.
    check_centers();
    throw;
  }
  check_centers();
  ++s_.certificate.computed_velocities;
  responses_.remark_velocities(claim.p[1].has_value());
  return computed;
}

// Recorded truth: since the claim the disk goes on with its claimed velocity.
void Turns::turn(GenId g) {
  s_.replay.turn(g, *claims_.current());
  s_.replay.move(s_.motion, g);
}

void Turns::maneuver(const ManeuverEvent& claim) {
  const Rational t = exact_time(*claims_.current());
  const auto k = s_.replay.scheduled(claim, t);
  if (!k) refuter_.refute(Fault::spurious_event, "the scene schedules no such maneuver");
  const Maneuver& due = s_.scene.maneuvers[*k];
  require_as_scheduled(claim, due, t);
  const bool exact = s_.options.truth == Truth::exact;
  const Moment m = Moment::at(exact ? due.t : t);
  instants_.advance(m);
  const GenId g = claim.disk;
  order_.require_no_flip_yet(g, g);
  if (exact) order_.begin(g, g, claims_.line(), claim);
  if (!front_.begun && exact) order_.note_at_start(g, g);
  around_.end(container_id, g, m);
  front_.turning = {g};
  const ExactVec2 v{due.vx, due.vy};
  if (exact) {
    const RoundedState s = s_.motion.maneuver(g, due.t, v[0], v[1]);
    front_.moment = m;
    pairs_.exact().note_birth(g, m);
    order_.end();
    responses_.check_center(g, exact_center(claim), v, {to_rational(s.px), to_rational(s.py)});
    s_.replay.note_maneuver(*k, claim);
  } else {
    responses_.check_center(g, exact_center(claim), v, s_.replay.path(g).at(t));
    s_.replay.note_maneuver(*k, claim);
    turn(g);
  }
  around_.begin(m);
  front_.turning.clear();
  ++s_.certificate.maneuvers;
}

// The claim, of the time t, is of this maneuver of the scene.
void Turns::require_as_scheduled(const ManeuverEvent& claim, const Maneuver& due,
                                 const Rational& t) {
  if (abs(Rational(t - due.t)) > s_.options.tolerance) {
    refuter_.refute(Fault::wrong_time, "the maneuver is scheduled at t = " + due.t.get_str());
  }
  if (due.t > s_.last_instant) {
    refuter_.refute(Fault::spurious_event,
                    "the maneuver is scheduled at t = " + due.t.get_str() + ", after the horizon");
  }
  const ExactVec2 v{due.vx, due.vy};
  const auto claimed = exact_velocity(claim);
  if (claimed && norm2(minus(*claimed, v)) > square(s_.options.law_tolerance * length_bound(v))) {
    refuter_.refute(Fault::wrong_response,
                    "the scheduled velocity is (" + number_text(v[0].get_d()) + ", " +
                        number_text(v[1].get_d()) + "), and the claimed one is " +
                        off(*claimed, v, s_.options.law_tolerance * length_bound(v)) +
                        " (--law-tolerance)");
  }
}

}  // namespace voroproof::internal
