#include "certify/recorded_pairs.h"

#include <algorithm>
#include <cmath>

#include "certify/contact_proof.h"
#include "certify/standing.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

namespace {

// |d|^2 - reach^2 of a pair at a time.
template <class T>
T excess(const Motion& motion, GenId i, GenId j, double t) {
  const T at(t);
  return Contact<T>(motion.moving_site(i, at), motion.moving_site(j, at)).c;
}

// Whether the excess, of a disk inside the container negated, is certainly above both.
template <class T>
bool certainly_above(const Motion& motion, GenId i, GenId j, double t, double a, double b) {
  T over = excess<T>(motion, i, j, t);
  if (i == container_id) over = -over;
  return sign(over - T(a)) == Sign::positive && sign(over - T(b)) == Sign::positive;
}

}  // namespace

// How far roundings of the file may have moved the two towards each other.
Rational RecordedPairs::rounding(GenId i, GenId j) const {
  const Rational extent = abs(s_.scene.cx) + abs(s_.scene.cy) + s_.scene.container_radius;
  return extent / (Rational(1) << 51) * std::max(1, s_.replay.turns(i) + s_.replay.turns(j));
}

// Whether two certainly overlap at t by no more than half of what is a rounding, so that nothing
// has to be carried on; and their tangency certainly has the right sign. Doubles tell so much of
// disks that have turned some times, double-doubles of nearly all.
bool RecordedPairs::certainly_shallow(GenId i, GenId j, double t) const {
  const DoubleMotion &m = s_.motion.doubles(i), &n = s_.motion.doubles(j);
  const double reach = std::fabs(m.r + n.r);
  const double lines = std::max(1, s_.replay.turns(i) + s_.replay.turns(j));
  const double depth = 0x1p-52 * std::fabs(s_.motion.doubles(container_id).r) * lines;
  if (!(8 * depth <= reach)) return false;
  const double least = -depth * reach;
  const double tangent = -4 * std::fabs(m.r) * std::fabs(n.r) * (1 - 0x1p-40);
  return certainly_above<DoubleBall>(s_.motion, i, j, t, least, tangent) ||
         certainly_above<DdBall>(s_.motion, i, j, t, least, tangent);
}

bool RecordedPairs::certainly_part(GenId i, GenId j, double from) const {
  const DoubleBall at(from);
  const Contact<DoubleBall> k(s_.motion.moving_site(i, at), s_.motion.moving_site(j, at));
  const Sign parting = sign(k.b);
  return (parting == Sign::positive || parting == Sign::zero) && certainly_shallow(i, j, from);
}

bool RecordedPairs::certainly_clear(GenId i, GenId j, double from, const Moment& m,
                                    bool apart) const {
  if (s_.motion.same_velocity(i, j)) {
    return sign(excess<DoubleBall>(s_.motion, i, j, from)) ==
           (i == container_id ? Sign::negative : Sign::positive);
  }
  if (!apart && !proved_apart(s_.motion, i, j, from, m.hi)) return false;
  if (i != container_id) return true;
  return sign(excess<DoubleBall>(s_.motion, i, j, from)) == Sign::negative ||
         (s_.replay.hit_container(j) && certainly_shallow(i, j, from));
}

RecordedContacts::Motions RecordedPairs::motions(GenId i, GenId j, const Rational& at) const {
  const auto site = [&](GenId g) -> MovingSite<Rational> {
    if (g == container_id) {
      return {s_.scene.cx, s_.scene.cy, 0, 0, Rational(-s_.scene.container_radius)};
    }
    const ExactVec2 p = s_.replay.path(g).at(at), v = s_.replay.velocity(g).value();
    return {p[0], p[1], v[0], v[1], s_.scene.disks[g].radius};
  };
  return {at, site(i), site(j)};
}

RecordedContacts::Lines RecordedPairs::lines(GenId i, GenId j, double adjacent_since) const {
  const bool wall = i == container_id;
  Rational from = std::max(to_rational(adjacent_since), s_.replay.path(j).since());
  if (!wall) from = std::max(from, s_.replay.path(i).since());
  const Rational r_j = s_.scene.disks[j].radius;
  const Rational r_i =
      wall ? Rational(-s_.scene.container_radius) : Rational(s_.scene.disks[i].radius);
  const Rational reach = s_.law.reach(i, j), hidden_reach2 = square(Rational(r_i - r_j));
  const RecordedContacts::Motions both = motions(i, j, from);
  // |offset + w s|^2 - reach^2, s from the time `from`: all rational.
  const Contact<Rational> contact{both.first, both.second};
  return {{i, j},
          Gap(contact, wall, from, reach, hidden_reach2),
          from,
          reach,
          rounding(i, j),
          (wall ? s_.replay.hit_container(j) : s_.replay.partners(i, j)) &&
              from == s_.replay.path(j).since(),
          both};
}

// Whether the two, whose paths are at `at` at the claimed time, certainly come into contact within
// the tolerance of it, on the lines that they have been on for longer, and overlap at that time by
// no more than a rounding. In doubles: false says nothing.
bool RecordedPairs::certainly_in_contact(const CollideEvent& claim, double from,
                                         const BallPair& at) const {
  const GenId i = claim.i, j = claim.j;
  if (!(from < claim.t - 2 * s_.tolerance_up)) return false;
  const BallPair v = s_.replay.near_velocities(i, j);
  const auto site = [&](int side, GenId g) -> MovingSite<DoubleBall> {
    const DoubleMotion& m = s_.motion.doubles(g);
    return {at[side][0], at[side][1], v[side][0], v[side][1], DoubleBall(m.r, m.ex)};
  };
  MovingSite<DoubleBall> first;
  if (i == container_id) {
    const DoubleMotion& m = s_.motion.doubles(i);
    first = {ball(s_.scene.cx), ball(s_.scene.cy), DoubleBall(), DoubleBall(),
             DoubleBall(m.r, m.ex)};
  } else {
    first = site(0, i);
  }
  const Contact<DoubleBall> k{first, site(1, j)};
  const DoubleBall& s = s_.near_tolerance;
  const Sign before = sign((k.a * s - DoubleBall(2) * k.b) * s + k.c);
  const Sign after = sign((k.a * s + DoubleBall(2) * k.b) * s + k.c);
  return (i == container_id ? before == Sign::negative && after == Sign::positive
                            : before == Sign::positive && after == Sign::negative) &&
         certainly_shallow(i, j, claim.t);
}

std::string RecordedPairs::standing(GenId i, GenId j, const Rational& t) const {
  const RecordedContacts::Motions both = motions(i, j, t);
  return text_of(standing_of(Contact<Rational>(both.first, both.second), s_.law.reach(i, j),
                             i == container_id),
                 round_nearest(t));
}

void RecordedPairs::require_no_meeting(GenId i, GenId j, const Moment& m) const {
  const auto nearest = lines(i, j, 0).gap.graze(0);
  if (!nearest || !nearest->near || s_.chronology.compare(Moment::at(nearest->t), m) > 0) return;
  throw Undecided("two points meet: a contact without a normal", i, j);
}

void RecordedPairs::check_contact(const CollideEvent& claim, double from, const BallPair& at) {
  const GenId i = claim.i, j = claim.j;
  if (s_.replay.partners(i, j)) {
    refuter_.refute(
        Fault::spurious_event,
        "generators " + text_of(i, j) + " have collided, and neither has turned since: they part");
  }
  if (front_.begun && !contacts_.carries({i, j}) && certainly_in_contact(claim, from, at)) return;
  const Rational t = exact_time(claim);
  const RecordedContacts::Lines on = lines(i, j, from);
  using Contact = RecordedContacts::Contact;
  RecordedContacts::Answer answer{Contact::elsewhere, contacts_.pass(on, t, true)};
  if (!answer.entry) {
    // Where flips are not judged, the two are watched for as long as they are on their lines.
    answer = contacts_.answer(s_.options.judges_flips() ? on : lines(i, j, 0), t);
  }
  switch (answer.contact) {
    case Contact::right:
      return;
    case Contact::graze:
      ++s_.certificate.grazes;
      return;
    case Contact::elsewhere: {
      const RecordedContacts::Missing& entry = *answer.entry;
      const bool near =
          std::fabs(entry.lo - round_nearest(t)) <= mistimed_tolerances * s_.tolerance_up;
      if (!near && t > to_rational(entry.hi)) throw Refuted{refuter_.missing_contact(i, j, entry)};
      Divergence d = refuter_.at_claim(
          near ? Fault::wrong_time : Fault::spurious_event,
          "generators " + text_of(i, j) + " touch " + between(entry.lo, entry.hi));
      d.true_contact = {i, j};
      d.true_time = {entry.lo, entry.hi};
      d.witness = contact_witness(entry.motions, i, j, entry.lo, entry.hi);
      throw Refuted{d};
    }
    case Contact::parting:
    case Contact::none:
      break;
  }
  refuter_.refute(Fault::spurious_event, "generators " + text_of(i, j) + " " + standing(i, j, t),
                  motion_witness(s_.motion, {i, j}, t));
}

}  // namespace voroproof::internal
