#include "certify/turns.h"

#include "certify/exact_truth.h"
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
  if (s_.exact != nullptr) {
    s_.exact->collide(claim);
  } else {
    collide_as_recorded(claim, edge);
  }
  front_.colliding.reset();
  ++s_.certificate.collisions;
}

void Turns::collide_as_recorded(const CollideEvent& claim, int edge) {
  const GenId i = claim.i, j = claim.j;
  const BallPair at = s_.replay.near_positions(claim);
  const Moment m = claim.exact ? Moment::at(exact_time(*claims_.current())) : Moment::at(claim.t);
  // Settle the events of the instant before first.
  instants_.advance(m);
  pairs_.check_contact(claim, edge, at);
  instants_.require_no_flip_yet(i, j);
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
  s_.replay.move(*s_.given, g);
}

void Turns::maneuver(const ManeuverEvent& claim) {
  const Rational t = exact_time(*claims_.current());
  const auto k = s_.replay.scheduled(claim, t);
  if (!k) refuter_.refute(Fault::spurious_event, "the scene schedules no such maneuver");
  const Maneuver& due = s_.scene.maneuvers[*k];
  require_as_scheduled(claim, due, t);
  if (s_.exact != nullptr) {
    s_.exact->maneuver(claim, *k);
  } else {
    maneuver_as_recorded(claim, *k, t);
  }
  ++s_.certificate.maneuvers;
}

void Turns::maneuver_as_recorded(const ManeuverEvent& claim, std::size_t k, const Rational& t) {
  const Moment m = Moment::at(t);
  instants_.advance(m);
  const GenId g = claim.disk;
  instants_.require_no_flip_yet(g, g);
  around_.end(container_id, g, m);
  front_.turning = {g};
  const Maneuver& due = s_.scene.maneuvers[k];
  responses_.check_center(g, exact_center(claim), {due.vx, due.vy}, s_.replay.path(g).at(t));
  s_.replay.note_maneuver(k, claim);
  turn(g);
  around_.begin(m);
  front_.turning.clear();
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
