#include "filtered/search/moment.h"

#include <cmath>
#include <limits>

#include "filtered/search/collapse.h"
#include "filtered/search/contact.h"
#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

// Negative or positive where what encloses the two tells, else 0.
int by_enclosures(const Moment& a, const Moment& b) {
  if (a.hi < b.lo) return -1;
  return b.hi < a.lo ? 1 : 0;
}

}  // namespace

ExactTime time_of(const Tower& t) {
  if (t.is_rational()) return ExactTime(t.rational());
  // The root of x - t, between binary64 neighbours made distinct.
  const auto [lo, hi] = double_interval(t);
  constexpr double inf = std::numeric_limits<double>::infinity();
  return ExactTime(
      Polynomial<Tower>{-t, Tower(1)},
      RootInterval{to_rational(std::nextafter(lo, -inf)), to_rational(std::nextafter(hi, inf))});
}

Moment Moment::at(double t) {
  Moment m;
  m.lo = m.hi = t;
  m.dd = DdBall(t);
  m.tight = true;
  return m;
}

Moment Moment::at(const Rational& t) {
  Moment m = at(round_nearest(t));
  const Rational error = t - to_rational(m.dd.hi);
  if (error == 0) return m;
  m.lo = round_down(t);
  m.hi = round_up(t);
  m.dd.rad = std::fabs(round_nearest(error)) * (1 + 0x1p-50);
  m.fine = std::make_shared<const RootInterval>(RootInterval{t, t});
  return m;
}

Moment Moment::of(const Quad& q, const Collapse& c) { return of(q, c.lo, c.hi, c.fine); }

Moment Moment::of(GenId i, GenId j, const NextContact& c) { return of(i, j, c.lo, c.hi); }

RootInterval Moment::root() const {
  return fine ? *fine : RootInterval{to_rational(lo), to_rational(hi)};
}

ExactTime Moment::exact(ExactMotion& exact) const {
  switch (kind) {
    case Kind::rational:
      break;
    case Kind::flip: {
      const RootInterval r = root();
      return CollapseSearch::exact_root(quad, r.lo, r.hi, exact);
    }
    case Kind::contact:
      return ContactSearch::exact_time(i, j, to_rational(lo), exact);
    case Kind::state:
      return time_of(exact.start(state, j));
  }
  return ExactTime(rational());
}

void Moment::give_up(const std::string& reason) const {
  if (is_flip()) throw Undecided(reason, quad);
  if (is_contact()) throw Undecided(reason, i, j);
  throw Undecided(reason);
}

// A flip is isolated in an interval as wide as the tolerance at most, in which other events may
// happen: between those and this one nothing but a narrow instant tells.
Moment Chronology::instant(const Moment& m) const {
  Moment now = m;
  now.narrow_to(narrow(m));
  return now;
}

void Chronology::begin_present() {
  present_.flips.clear();
  present_.contacts.clear();
  present_.records = motion_.records();
}

void Chronology::note_present(const Moment& m) {
  if (m.is_flip()) note_flip(m.quad);
  if (m.is_contact()) present_.contacts.push_back(states_of(motion_, m.i, m.j));
}

void Chronology::note_collisions(const Moment& m) {
  motion_.note_relations(present_.records, m.lo, m.hi);
}

Moment Chronology::present(const Moment& m) const {
  Moment now = instant(m);
  now.present = this;
  return now;
}

// Whether symmetry proves two moments equal: tried where exact arithmetic is expensive.
bool Chronology::same_by_symmetry(const Moment& a, const Moment& b) const {
  const auto symmetry = motion_.symmetry();
  if (symmetry == nullptr) return false;
  if (a.is_flip() && b.is_flip()) {
    if (collapses_.has_rational_motion(a.quad) && collapses_.has_rational_motion(b.quad)) {
      return false;
    }
    const auto same = [&](const Moment& x, const Moment& y) {
      return symmetry->same_flip(states_of(motion_, x.quad), ball(x), states_of(motion_, y.quad),
                                 y.root());
    };
    return same(a, b) || same(b, a);
  }
  // The pair whose contact it is.
  const auto pair = [&](const Moment& m) -> std::optional<PairStates> {
    if (m.is_contact()) return states_of(motion_, m.i, m.j);
    if (m.kind != Moment::Kind::state) return std::nullopt;
    return symmetry->collision_before({m.j, m.state});
  };
  const auto pair_a = pair(a), pair_b = pair(b);
  return pair_a && pair_b && symmetry->same_contact(*pair_a, *pair_b);
}

std::optional<int> Chronology::known_order(const Moment& a, const Moment& b, std::string* why_not) {
  if (const int order = by_enclosures(a, b)) return order;
  return known_order_of_near(a, b, why_not);
}

std::optional<int> Chronology::known_order_of_near(const Moment& a, const Moment& b,
                                                   std::string* why_not) {
  if (a.kind == Moment::Kind::rational && b.kind == Moment::Kind::rational) {
    if (!a.fine && !b.fine) return 0;
    return sgn(Rational(a.rational() - b.rational()));
  }
  const bool states = a.kind == Moment::Kind::state && b.kind == Moment::Kind::state;
  if (states && a.state == b.state) return 0;
  Ladder<int> ladder(counts_, Predicate::compare);
  const Rung dd{Tier::dd, [&]() -> std::optional<int> {
                  return motion_.options().filters ? told(sign(narrow(a) - narrow(b)))
                                                   : std::nullopt;
                }};
  if (const auto order = ladder.climb(dd)) return order;
  ++counts_.beyond_filter;
  const Rung symmetry{Tier::symmetry, [&] {
                        return same_by_symmetry(a, b) ? std::optional<int>(0) : std::nullopt;
                      }};
  const Rung exactly{Tier::exact, [&]() -> std::optional<int> {
                       ExactMotion exact(motion_);
                       const auto c = voroproof::internal::compare(a.exact(exact), b.exact(exact));
                       return c < 0 ? -1 : c > 0 ? 1 : 0;
                     }};
  const auto order =
      ladder.climb(Rung{Tier::ball, [&] { return by_balls(a, b); }}, symmetry, exactly);
  if (!order && why_not != nullptr) *why_not = ladder.budget();
  return order;
}

std::optional<int> Chronology::order(const Moment& a, const Moment& b, std::string& why_not) {
  if (const auto known = known_order(a, b, &why_not)) return known;
  Ladder<int> ladder(counts_, Predicate::compare);
  return ladder.with_more_bits(motion_, Rung{Tier::ball, [&] { return by_balls(a, b); }});
}

int Chronology::compare(const Moment& a, const Moment& b) {
  std::string budget;
  if (const auto known = order(a, b, budget)) return *known;
  throw Undecided("two events may be simultaneous: " + budget);
}

std::optional<int> Chronology::by_balls(const Moment& a, const Moment& b) const {
  return told(sign(ball(a) - ball(b)));
}

bool Chronology::within(const Rational& tolerance, const Moment& m, const Rational& t) {
  return compare(m, Moment::at(Rational(t - tolerance))) >= 0 &&
         compare(m, Moment::at(Rational(t + tolerance))) <= 0;
}

DdBall Chronology::narrow(const Moment& m) const {
  if (m.tight) return m.dd;
  const DdBall dd = m.is_contact()
                        ? contacts_.refine(m.i, m.j, m.middle())
                        : collapses_.refine_until(m.quad, m.lo, m.hi, [](const DdBall& t) {
                            return t.rad < 0x1p-60 * t.hi;
                          });
  return dd.rad < m.dd.rad ? dd : m.dd;
}

Ball Chronology::ball(const Moment& m) const {
  const int bits = motion_.goal_bits() + 32;
  switch (m.kind) {
    case Moment::Kind::rational:
      break;
    case Moment::Kind::flip: {
      const RootInterval root = m.root();
      return collapses_.refine(m.quad, root.lo, root.hi, bits);
    }
    case Moment::Kind::contact:
      return contacts_.refine(m.i, m.j, to_rational(m.middle()), bits);
    case Moment::Kind::state: {
      Ball b(to_rational(m.dd.hi) + to_rational(m.dd.lo), bits);
      b.widen(Magnitude::of(m.dd.rad));
      return b;
    }
  }
  return Ball(m.rational(), bits);
}

std::array<double, 2> Chronology::enclosure(const Moment& m) const {
  double lo = 0, hi = 0;
  ball(m).to_interval(lo, hi);
  return {std::max(m.lo, lo), std::min(m.hi, hi)};
}

}  // namespace voroproof::internal
