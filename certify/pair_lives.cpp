// Lives of pairs of neighbours: contacts under the exact truth, contacts and overlaps under the
// recorded one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/checker.h"
#include "certify/contact_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

// ---- Exact truth. ----

// When the present motion of the pair began: with the later of the last turns of the two. Nothing
// where neither has turned.
const Checker::Birth* Checker::birth(GenId i, GenId j) const {
  const auto of = [this](GenId g) {
    return g == container_id || births_.empty() ? nullptr : births_[g].get();
  };
  const Birth *a = of(i), *b = of(j);
  if (a == nullptr || b == nullptr) return a != nullptr ? a : b;
  // States are numbered in their order of time.
  return motion_.state_id(i) > motion_.state_id(j) ? a : b;
}

Moment Checker::born(GenId i, GenId j) const {
  const Birth* b = birth(i, j);
  return b != nullptr ? b->moment : Moment::at(0.0);
}

bool Checker::born_at_present(GenId i, GenId j) const {
  const Birth* b = birth(i, j);
  return (b != nullptr ? b->instant : 0) == instant_ && frontier_.kind != Moment::Kind::flip;
}

// The same as an instant. Of the present one more is known.
Instant Checker::since(GenId i, GenId j) const {
  return born_at_present(i, j) ? chronology_.present(frontier_) : chronology_.instant(born(i, j));
}

void Checker::note_birth(GenId g, const Moment& m) {
  if (g == container_id) return;
  births_.resize(motion_.size());
  births_[g] = std::make_shared<const Birth>(Birth{m, instant_});
}

// When i and j touch: `c` is not `none`.
Moment Checker::moment_of(GenId i, GenId j, const NextContact& c) const {
  if (c.kind != NextContact::Kind::now) return Moment::of(i, j, c);
  return born_at_present(i, j) ? frontier_ : born(i, j);
}

// When the two touch next, from the birth of their present motion on.
NextContact Checker::next_contact(GenId i, GenId j) {
  if (replay_.partners(i, j)) return {};
  NextContact c = contacts_.from(i, j, since(i, j), search_end_);
  if (c.kind != NextContact::Kind::at) return c;
  const DdBall dd = contacts_.refine(i, j, 0.5 * (c.lo + c.hi));
  if (std::isfinite(dd.rad)) {
    double lo = 0, hi = 0;
    enclose(dd, lo, hi);
    c.lo = std::max(c.lo, lo);
    c.hi = std::min(c.hi, hi);
  }
  return c;
}

// The pair does not touch while it approaches from the birth of its motion to m; at m itself it may
// only where its motion ends there, too.
void Checker::require_no_contact(GenId i, GenId j, const Moment& m, PairEnd why) {
  const NextContact c = contacts_.from(i, j, since(i, j), std::nextafter(m.hi, HUGE_VAL));
  if (c.kind == NextContact::Kind::none) return;
  const int order = chronology_.compare(moment_of(i, j, c), m);
  if (order > 0) return;
  // Collisions come before maneuvers; with the velocities between two maneuvers nothing moves.
  const bool averted = maneuvering_ && (i == *maneuvering_ || j == *maneuvering_) &&
                       !turned_at_present(i == *maneuvering_ ? j : i);
  if (order == 0 && why == PairEnd::turn && !averted) {
    // They touch as something else happens. If they still approach after it, that is for their
    // next life; but of collisions at one instant the smallest pair comes first.
    if (colliding_ && std::pair(i, j) < *colliding_) {
      refute(Fault::wrong_order, "generators " + text_of(i, j) +
                                     " touch and approach at the same instant and come first");
    }
    return;
  }
  throw Refuted{missing_contact(i, j, c.lo, c.hi)};
}

// ---- Lives. ----

// The pair's adjacency, or its motion, ends at m without a collision of the two; `apart`: the two
// are proved to be apart from their birth until m.hi.
void Checker::end_pair(int edge, const Moment& m, PairEnd why, bool apart) {
  const auto [i, j] = replay_.pair_of(edge);
  const bool partners = replay_.partners(i, j);
  if (!partners) ++certificate_.pair_lives;
  const double from = pairs_[edge].from;
  if (options_.truth == Truth::recorded) {
    if (!recorded_.carries({i, j}) &&
        (partners ? certainly_part(i, j, from) : certainly_clear(edge, m, apart))) {
      return;
    }
    if (!partners) ++certificate_.beyond_filter;
    pass_recorded(edge, Moment(m), why);
    return;
  }
  if (partners || apart || proved_apart(motion_, i, j, from, m.hi)) return;
  ++certificate_.beyond_filter;
  require_no_contact(i, j, m, why);
}

void Checker::end_pairs(std::span<const int> edges, const Moment& m, PairEnd why) {
  apart_.clear();
  for (const int e : edges) {
    const auto [i, j] = replay_.pair_of(e);
    apart_.add(i, j, pairs_[e].from);
  }
  apart_.prove(m.hi);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!colliding_ || replay_.pair_of(edges[k]) != *colliding_) {
      end_pair(edges[k], m, why, apart_.apart(k));
    }
  }
}

// ---- Recorded truth. ----

namespace {

// |d|^2 - reach^2 of a pair at a time.
template <class T>
T excess(const Motion& motion, GenId i, GenId j, double t) {
  const T at(t);
  return Contact<T>(motion.moving_site(i, at), motion.moving_site(j, at)).c;
}

}  // namespace

// How far roundings of the file may have moved the two towards each other.
Rational Checker::rounding(GenId i, GenId j) const {
  const Rational extent = abs(scene_.cx) + abs(scene_.cy) + scene_.container_radius;
  return extent / (Rational(1) << 51) * std::max(1, replay_.turns(i) + replay_.turns(j));
}

// Whether two certainly overlap at t by no more than half of what is a rounding, so that nothing
// has to be carried on; and their tangency certainly has the right sign. Doubles do not tell so
// much.
bool Checker::certainly_shallow(GenId i, GenId j, double t) const {
  const DoubleMotion &m = motion_.doubles(i), &n = motion_.doubles(j);
  const double reach = std::fabs(m.r + n.r);
  const double lines = std::max(1, replay_.turns(i) + replay_.turns(j));
  const double depth = 0x1p-52 * std::fabs(motion_.doubles(container_id).r) * lines;
  if (!(8 * depth <= reach)) return false;
  const DdBall over = excess<DdBall>(motion_, i, j, t);
  const DdBall slack(depth * reach), product(4 * std::fabs(m.r) * std::fabs(n.r) * (1 - 0x1p-40));
  if (i == container_id) {
    return sign(over - slack) == Sign::negative && sign(over - product) == Sign::negative;
  }
  return sign(over + slack) == Sign::positive && sign(over + product) == Sign::positive;
}

// After their own collision at `from`: whether the two certainly part, and overlap no more than by
// a rounding.
bool Checker::certainly_part(GenId i, GenId j, double from) const {
  const DoubleBall at(from);
  const Contact<DoubleBall> k(motion_.moving_site(i, at), motion_.moving_site(j, at));
  const Sign parting = sign(k.b);
  return (parting == Sign::positive || parting == Sign::zero) && certainly_shallow(i, j, from);
}

// Whether the two certainly do not overlap in the life that ends at m: in doubles, false says
// nothing. What lies outside the container at the beginning by a rounding may have hit it there.
bool Checker::certainly_clear(int edge, const Moment& m, bool apart) const {
  const auto [i, j] = replay_.pair_of(edge);
  const double from = pairs_[edge].from;
  if (motion_.same_velocity(i, j)) {
    return sign(excess<DoubleBall>(motion_, i, j, from)) ==
           (i == container_id ? Sign::negative : Sign::positive);
  }
  if (!apart && !proved_apart(motion_, i, j, from, m.hi)) return false;
  if (i != container_id) return true;
  return sign(excess<DoubleBall>(motion_, i, j, from)) == Sign::negative ||
         (replay_.hit_container(j) && certainly_shallow(i, j, from));
}

// |offset + w s|^2 - reach^2, s from the time `at`: all rational.
Contact<Rational> Checker::recorded_contact(GenId i, GenId j, const Rational& at) const {
  const auto site = [&](GenId g) -> MovingSite<Rational> {
    if (g == container_id) {
      return {scene_.cx, scene_.cy, 0, 0, Rational(-scene_.container_radius)};
    }
    const ExactVec2 p = replay_.path(g).at(at), v = replay_.velocity(g).value();
    return {p[0], p[1], v[0], v[1], scene_.disks[g].radius};
  };
  return {site(i), site(j)};
}

// The pair on its present lines, watched from the time on at which it is on these and adjacent.
RecordedContacts::Lines Checker::recorded_lines(GenId i, GenId j, double adjacent_since) const {
  const bool wall = i == container_id;
  Rational from = std::max(to_rational(adjacent_since), replay_.path(j).since());
  if (!wall) from = std::max(from, replay_.path(i).since());
  const Rational r_j = scene_.disks[j].radius;
  const Rational r_i = wall ? Rational(-scene_.container_radius) : Rational(scene_.disks[i].radius);
  const Rational reach = law_.reach(i, j), hidden_reach2 = square(Rational(r_i - r_j));
  return {{i, j},
          Gap(recorded_contact(i, j, from), wall, from, reach, hidden_reach2),
          from,
          reach,
          rounding(i, j),
          (wall ? replay_.hit_container(j) : replay_.partners(i, j)) &&
              from == replay_.path(j).since()};
}

// Two generators may be neighbours along several V-edges: the one that has been there for longest
// stands for the pair. `besides`: one that counts no more. -1 where there is none.
int Checker::watching(int edge, int besides) const {
  if (diagram_.edges() == 0) return edge;
  const auto pair = replay_.pair_of(edge);
  int oldest = -1;
  const HalfEdge first = diagram_.anchor(pair.second);
  HalfEdge h = first;
  do {
    const int e = h / 2;
    if (e != besides && replay_.pair_of(e) == pair &&
        (oldest < 0 || std::pair(pairs_[e].from, e) < std::pair(pairs_[oldest].from, oldest))) {
      oldest = e;
    }
    h = diagram_.rotate(h);
  } while (h != first);
  return oldest;
}

void Checker::pass_recorded(int edge, const Moment& m, PairEnd why) {
  if (watching(edge) != edge) return;
  const auto [i, j] = replay_.pair_of(edge);
  const auto lines = recorded_lines(i, j, pairs_[edge].from);
  const Rational end = m.kind == Moment::Kind::rational ? m.exact() : to_rational(m.hi);
  const int next = why == PairEnd::flip ? watching(edge, edge) : -1;
  if (const auto missing = recorded_.pass(lines, end, why == PairEnd::turn || next >= 0)) {
    throw Refuted{missing_contact(i, j, missing->lo, missing->hi)};
  }
  if (next >= 0) pairs_[next].from = std::max(pairs_[next].from, m.hi);
}

// In doubles, whether the two, whose paths are at `at` at the claimed time, come into contact
// within the tolerance of it, on the lines that they have been on for longer, and overlap at that
// time by no more than a rounding. False says nothing.
bool Checker::certainly_in_contact(const CollideEvent& claim, double from,
                                   const BallPair& at) const {
  const GenId i = claim.i, j = claim.j;
  if (!(from < claim.t - 2 * tolerance_up_)) return false;
  const BallPair v = replay_.near_velocities(i, j);
  const auto site = [&](int side, GenId g) -> MovingSite<DoubleBall> {
    const DoubleMotion& m = motion_.doubles(g);
    return {at[side][0], at[side][1], v[side][0], v[side][1], DoubleBall(m.r, m.ex)};
  };
  MovingSite<DoubleBall> first;
  if (i == container_id) {
    first = motion_.moving_site(i, DoubleBall(0));
  } else {
    first = site(0, i);
  }
  const Contact<DoubleBall> k{first, site(1, j)};
  const DoubleBall& s = near_tolerance_;
  const Sign before = sign((k.a * s - DoubleBall(2) * k.b) * s + k.c);
  const Sign after = sign((k.a * s + DoubleBall(2) * k.b) * s + k.c);
  return (i == container_id ? before == Sign::negative && after == Sign::positive
                            : before == Sign::positive && after == Sign::negative) &&
         certainly_shallow(i, j, claim.t);
}

// The pair of the edge, enclosed by `at` at the claimed time, is in contact then, or the claim is
// refuted.
void Checker::check_recorded_contact(const CollideEvent& claim, int edge, const BallPair& at) {
  const GenId i = claim.i, j = claim.j;
  if (replay_.partners(i, j)) {
    refute(Fault::spurious_event, "generators " + text_of(i, j) +
                                      " have collided, and neither has turned since: they part");
  }
  const double from = begun_ ? pairs_[watching(edge)].from : 0;
  if (begun_ && !recorded_.carries({i, j}) && certainly_in_contact(claim, from, at)) return;
  const Rational t = exact_time(*claim_);
  const auto lines = recorded_lines(i, j, from);
  using Contact = RecordedContacts::Contact;
  RecordedContacts::Answer answer{Contact::elsewhere};
  if (const auto missing = recorded_.pass(lines, t, true)) {
    answer.lo = missing->lo;
    answer.hi = missing->hi;
  } else {
    answer = recorded_.answer(lines, t);
  }
  switch (answer.contact) {
    case Contact::right:
      return;
    case Contact::graze:
      ++certificate_.grazes;
      return;
    case Contact::elsewhere: {
      const bool near = std::fabs(answer.lo - round_nearest(t)) <= kMistimed * tolerance_up_;
      if (!near && t > to_rational(answer.hi)) {
        throw Refuted{missing_contact(i, j, answer.lo, answer.hi)};
      }
      Divergence d = divergence_at_claim(
          near ? Fault::wrong_time : Fault::spurious_event,
          "generators " + text_of(i, j) + " touch " + between(answer.lo, answer.hi));
      d.true_contact = {i, j};
      d.true_time = {answer.lo, answer.hi};
      d.witness = contact_witness(motion_, i, j, to_rational(answer.lo), to_rational(answer.hi));
      throw Refuted{d};
    }
    case Contact::parting:
      refute(Fault::spurious_event, "generators " + text_of(i, j) + " do not approach",
             motion_witness(motion_, {i, j}, t));
    case Contact::none:
      break;
  }
  refute(Fault::spurious_event, "generators " + text_of(i, j) + " do not touch",
         motion_witness(motion_, {i, j}, t));
}

}  // namespace voroproof::internal
