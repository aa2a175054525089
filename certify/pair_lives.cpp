// Lives of pairs of neighbours: contacts under the exact truth, contacts and overlaps under the
// recorded one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/checker.h"
#include "certify/contact_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof {

namespace {
// Of roots of quadratics with rational coefficients, where doubles do not decide.
constexpr int kBits = 512;
}  // namespace

void Checker::begin_pair(int edge, const Moment& m) { pairs_[edge] = {m.lo, instant_}; }

// As only the motion of the pair changes: an overlap goes on.
void Checker::go_on_with_pair(int edge, const Moment& m) {
  const bool collided = colliding_ && replay_.pair_of(edge) == *colliding_;
  pairs_[edge] = {m.lo, instant_, collided ? 0 : pairs_[edge].overlap};
}

// When the life of a pair began, or a time just before. At the present instant itself two may touch
// and approach that did not before: what is known of the instant tells.
Instant Checker::since(const Adjacency& pair) const {
  if (pair.born == instant_ && frontier_.kind != Moment::Kind::flip) {
    return chronology_.present(frontier_);
  }
  return chronology_.instant(Moment::at(pair.from));
}

// When i and j touch: `c` is not `none`.
Moment Checker::moment_of(GenId i, GenId j, const NextContact& c) const {
  return c.kind == NextContact::Kind::now ? frontier_ : Moment::of(i, j, c);
}

// The pair's adjacency, or its motion, ends at m without a collision of the two; `closed`: a
// contact at m itself is missed too; `apart`: the two are proved to be apart until m.hi.
void Checker::end_pair(int edge, const Moment& m, bool closed, bool apart) {
  const auto [i, j] = replay_.pair_of(edge);
  if (replay_.partners(i, j)) {
    pairs_[edge].overlap = 0;
    if (options_.truth == Truth::recorded) check_parting(i, j, pairs_[edge].from, m);
    return;
  }
  ++certificate_.pair_lives;
  const double from = pairs_[edge].from;
  if (options_.truth == Truth::recorded && motion_.same_velocity(i, j)) {
    check_at_rest(edge, m);
    return;
  }
  if ((apart || proved_apart(motion_, i, j, from, m.hi)) && certainly_inside_soon(edge, m)) {
    pairs_[edge].overlap = 0;
    return;
  }
  ++certificate_.beyond_filter;
  if (options_.truth == Truth::recorded) {
    check_overlap(edge, m);
    return;
  }
  const NextContact c = contacts_.from(i, j, since(pairs_[edge]), std::nextafter(m.hi, HUGE_VAL));
  if (c.kind == NextContact::Kind::none) return;
  const int order = chronology_.compare(moment_of(i, j, c), m);
  if (order > 0) return;
  // Collisions come before maneuvers; with the velocities between two maneuvers nothing moves.
  const bool averted = maneuvering_ && (i == *maneuvering_ || j == *maneuvering_) &&
                       !turned_at_present(i == *maneuvering_ ? j : i);
  if (order == 0 && !closed && !averted) {
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

void Checker::end_pairs(std::span<const int> edges, const Moment& m, bool closed) {
  apart_.clear();
  for (const int e : edges) {
    const auto [i, j] = replay_.pair_of(e);
    apart_.add(i, j, pairs_[e].from);
  }
  apart_.prove(m.hi);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!colliding_ || replay_.pair_of(edges[k]) != *colliding_) {
      end_pair(edges[k], m, closed, apart_.apart(k));
    }
  }
}

// Exact truth: when the two touch next; `edge` is one between them. Before the lives begin: from
// t = 0 on.
NextContact Checker::next_contact(int edge, GenId i, GenId j) {
  if (replay_.partners(i, j)) return {};
  const Instant from = begun_ ? since(pairs_[edge]) : chronology_.instant(Moment::at(0.0));
  NextContact c = contacts_.from(i, j, from, search_end_);
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

// ---- Recorded truth. ----

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

// After its own collision a pair parts. The law holds within a tolerance, so that one that should
// stay in contact may come nearer again, but not far.
void Checker::check_parting(GenId i, GenId j, double from, const Moment& m) {
  const DoubleBall start(from);
  const Contact<DoubleBall> near(motion_.moving_site(i, start), motion_.moving_site(j, start));
  const Sign parting = sign(near.b);
  if (parting == Sign::positive || parting == Sign::zero) return;
  const Contact<Rational> k = recorded_contact(i, j, to_rational(from));
  if (sgn(k.b) >= 0) return;
  // At the nearest point of the life.
  const Rational end = to_rational(m.hi) - to_rational(from);
  Rational s = -k.b / k.a;
  if (s > end) s = end;
  const Rational lost = -s * (k.a * s + 2 * k.b);  // of the squared distance
  const Rational depth = options_.tolerance * to_rational(replay_.top_speed());
  if (lost <= 2 * law_.reach(i, j) * depth) return;
  throw Refuted{missing_contact(i, j, from, m.hi)};
}

// Two with the same velocity, or a disk at rest and the container, may overlap no longer than
// others, but for a rounding error.
void Checker::check_at_rest(int edge, const Moment& m) {
  const auto [i, j] = replay_.pair_of(edge);
  const bool wall = i == container_id;
  Adjacency& pair = pairs_[edge];
  const double before = std::exchange(pair.overlap, 0);
  const DoubleBall start(pair.from);
  const Contact<DoubleBall> near(motion_.moving_site(i, start), motion_.moving_site(j, start));
  if (sign(near.c) == (wall ? Sign::negative : Sign::positive)) return;
  const Rational from = to_rational(pair.from), reach = law_.reach(i, j);
  const Rational over = recorded_contact(i, j, from).c * (wall ? 1 : -1);
  if (over <= 2 * options_.law_tolerance * reach * reach) return;
  pair.overlap = before + (m.hi - pair.from);
  if (pair.overlap <= tolerance_up_) return;
  throw Refuted{missing_contact(i, j, pair.from, m.hi)};
}

// Recorded truth: whether a disk that is inside the container at the end of the life, but perhaps
// not at its beginning, certainly comes back before it has been outside for the tolerance. Of other
// pairs and under the exact truth there is nothing to ask. The squared distance less the squared
// reach is convex in time, so that it lies below its chord.
bool Checker::certainly_inside_soon(int edge, const Moment& m) const {
  const auto [i, j] = replay_.pair_of(edge);
  if (options_.truth == Truth::exact || i != container_id) return true;
  const Adjacency& pair = pairs_[edge];
  const auto outside = [&, i = i, j = j](double t) {
    const DoubleBall at(t);
    return Contact<DoubleBall>(motion_.moving_site(i, at), motion_.moving_site(j, at)).c;
  };
  const DoubleBall first = outside(pair.from), last = outside(m.hi);
  if (sign(first) == Sign::negative) return true;
  const double over = first.mid + first.rad, under = -(last.mid + last.rad);
  const double until = (m.hi - pair.from) * (over / (over + under));
  return under > 0 && 2 * (pair.overlap + until) < tolerance_up_;
}

// Whether two overlap no deeper than the roundings of their centres let them: such are disks that
// stay in contact or leave it sideways. Where their velocities are the same but for roundings, no
// deeper than two at rest may.
bool Checker::hardly_overlap(int edge, const Contact<Rational>& k, const Moment& m) const {
  const auto [i, j] = replay_.pair_of(edge);
  const bool wall = i == container_id;
  const ExactPair v = replay_.velocities(i, j);
  const Rational speeds = (wall ? Rational(0) : norm2(v[0])) + norm2(v[1]);
  const bool at_rest = k.a * (Rational(1) << 92) <= speeds;
  const Rational end = to_rational(m.hi) - to_rational(pairs_[edge].from);
  const auto value = [&](const Rational& s) { return Rational((k.a * s + 2 * k.b) * s + k.c); };
  const Rational nearest = std::max(Rational(0), std::min(end, Rational(-k.b / k.a)));
  const Rational over = wall ? std::max(value(0), value(end)) : Rational(-value(nearest));
  const Rational reach = law_.reach(i, j);
  const Rational extent = abs(scene_.cx) + abs(scene_.cy) + scene_.container_radius;
  const Rational rounding = extent / (Rational(1) << 49);
  return over <=
         2 * reach *
             (at_rest ? std::max(rounding, Rational(options_.law_tolerance * reach)) : rounding);
}

// Two disks may overlap, or a disk leave the container, for no longer than the tolerance.
void Checker::check_overlap(int edge, const Moment& m) {
  const auto [i, j] = replay_.pair_of(edge);
  const bool wall = i == container_id;
  Adjacency& pair = pairs_[edge];
  const double from = pair.from, before = std::exchange(pair.overlap, 0);
  const Contact<Rational> k = recorded_contact(i, j, to_rational(from));
  const Rational discriminant = k.b * k.b - k.a * k.c;
  if (sgn(k.a) == 0) {
    pair.overlap = before;
    check_at_rest(edge, m);
    return;
  }
  if (hardly_overlap(edge, k, m)) return;
  if (sgn(discriminant) <= 0) {
    // Their distance is nowhere less than the reach: disks stay apart, and a disk outside the
    // container does not come back.
    if (!wall) return;
    pair.overlap = before + (m.hi - from);
    if (pair.overlap <= tolerance_up_) return;
    throw Refuted{missing_contact(i, j, from, m.hi)};
  }
  const Ball a(k.a, kBits), b(k.b, kBits), root = sqrt(Ball(discriminant, kBits));
  const Ball enter = (-b - root) / a, leave = (root - b) / a;
  const Ball end(Rational(to_rational(m.hi) - to_rational(from)), kBits), zero(kBits);
  const Ball tolerance(options_.tolerance, kBits);
  const auto first = [&](const Ball& x, const Ball& y) {
    return sign(x - y) == Sign::negative ? x : y;
  };
  const auto last = [&](const Ball& x, const Ball& y) {
    return sign(x - y) == Sign::positive ? x : y;
  };
  // An overlap from lo to hi of this life. Ends that cannot be told apart differ by nothing that
  // counts.
  const auto allowed = [&](const Ball& lo, const Ball& hi) {
    Ball length = hi - lo;
    if (sign(length) != Sign::positive) return true;
    if (sign(lo) != Sign::positive) length = length + Ball(to_rational(before), kBits);
    if (sign(end - hi) != Sign::positive) {
      double low = 0;
      length.to_interval(low, pair.overlap);
    }
    return sign(length - tolerance) == Sign::negative;
  };
  const bool fine = wall ? allowed(zero, first(enter, end)) && allowed(last(leave, zero), end)
                         : allowed(last(enter, zero), first(leave, end));
  if (fine) return;
  double lo = 0, hi = 0;
  (Ball(to_rational(from), kBits) + (wall ? leave : last(enter, zero))).to_interval(lo, hi);
  throw Refuted{missing_contact(i, j, lo, hi)};
}

// In doubles, whether the two, whose paths are at `at` at the claimed time, come into contact
// within the tolerance of it. False says nothing.
bool Checker::certainly_in_contact(GenId i, GenId j, const BallPair& at) const {
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
  return i == container_id ? before == Sign::negative && after == Sign::positive
                           : before == Sign::positive && after == Sign::negative;
}

// The pair, enclosed by `at` at the claimed time, touches within the tolerance of it, or the claim
// is refuted.
void Checker::check_recorded_contact(const CollideEvent& claim, const BallPair& at) {
  const GenId i = claim.i, j = claim.j;
  if (certainly_in_contact(i, j, at)) return;
  const Rational t = exact_time(*claim_);
  const Contact<Rational> k = recorded_contact(i, j, t);
  const Rational& tol = options_.tolerance;
  const auto value = [&](const Rational& s) { return Rational((k.a * s + 2 * k.b) * s + k.c); };
  const bool wall = i == container_id;
  const Rational before = value(-tol), after = value(tol);
  // A change from apart to overlapping within the tolerance; not two that are at rest in contact.
  if (before != after &&
      (wall ? sgn(before) <= 0 && sgn(after) >= 0 : sgn(before) >= 0 && sgn(after) <= 0)) {
    return;
  }
  const Rational discriminant = k.b * k.b - k.a * k.c;
  if (sgn(k.a) > 0 && sgn(discriminant) >= 0) {
    const Ball root = sqrt(Ball(discriminant, kBits)), b(k.b, kBits), a(k.a, kBits);
    const Ball contact = wall ? (root - b) / a : (-b - root) / a;
    const Ball limit(tol, kBits);
    if (sign(contact - limit) != Sign::positive && sign(contact + limit) != Sign::negative) return;
    double lo = 0, hi = 0;
    (Ball(t, kBits) + contact).to_interval(lo, hi);
    const bool near = std::fabs(lo - round_nearest(t)) <= kMistimed * tolerance_up_;
    Divergence d = divergence_at_claim(near ? Fault::wrong_time : Fault::spurious_event,
                                       "generators " + text_of(i, j) + " touch " + between(lo, hi));
    d.true_contact = {i, j};
    d.true_time = {lo, hi};
    d.witness = contact_witness(motion_, i, j, to_rational(lo), to_rational(hi));
    throw Refuted{d};
  }
  if (!wall && sgn(k.a) > 0) {
    // They only come near: a graze. Near enough for a contact within the tolerance of time?
    Rational s = -k.b / k.a;
    s = std::max(Rational(-tol), std::min(tol, s));
    const Rational distance2 = value(s) + square(law_.reach(i, j));
    const Rational reach = law_.reach(i, j) + tol * to_rational(std::sqrt(round_up(k.a)));
    if (distance2 <= square(reach)) return;
  }
  refute(Fault::spurious_event,
         "generators " + text_of(i, j) +
             (sgn(k.a) == 0 && sgn(k.c) == 0 ? " do not approach" : " do not touch"),
         motion_witness(motion_, {i, j}, t));
}

}  // namespace voroproof
