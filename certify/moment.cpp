#include "certify/moment.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Negative or positive where what encloses the two tells, else 0.
int by_enclosures(const Moment& a, const Moment& b) {
  if (a.hi < b.lo) return -1;
  return b.hi < a.lo ? 1 : 0;
}

}  // namespace

Moment Moment::at(double t) {
  Moment m;
  m.lo = m.hi = t;
  return m;
}

Moment Moment::at(const Rational& t) {
  Moment m;
  m.lo = round_down(t);
  m.hi = round_up(t);
  if (m.lo != m.hi) m.t = std::make_shared<const Rational>(t);
  return m;
}

Rational Moment::exact() const { return t ? *t : to_rational(lo); }

Moment Moment::of(const Quad& q, const Collapse& c) {
  Moment m;
  m.kind = Kind::flip;
  m.quad = q;
  m.lo = c.lo;
  m.hi = c.hi;
  m.root = c.fine;
  return m;
}

Moment Moment::of(GenId i, GenId j, const NextContact& c) {
  Moment m;
  m.kind = Kind::contact;
  m.lo = c.lo;
  m.hi = c.hi;
  m.i = i;
  m.j = j;
  return m;
}

std::pair<Rational, Rational> interval_of(const Collapse& c) {
  if (c.fine) return {c.fine->lo, c.fine->hi};
  return {to_rational(c.lo), to_rational(c.hi)};
}

ExactTime Chronology::exact_time(const Moment& m, ExactMotion& exact) {
  switch (m.kind) {
    case Moment::Kind::rational:
      break;
    case Moment::Kind::flip: {
      const RootInterval r = m.root ? *m.root : RootInterval{to_rational(m.lo), to_rational(m.hi)};
      return CollapseSearch::exact_root(m.quad, r.lo, r.hi, exact);
    }
    case Moment::Kind::contact:
      return ContactSearch::exact_time(m.i, m.j, to_rational(m.lo), exact);
    case Moment::Kind::state:
      return time_of(exact.start(m.state, m.j));
  }
  return ExactTime(m.exact());
}

Instant Chronology::instant(const Moment& m) const {
  Instant now;
  now.dd = narrow(m);
  // A flip is isolated in an interval as wide as the tolerance at most, in which other events may
  // happen: between those and this one nothing but a narrow instant tells.
  double lo = 0, hi = 0;
  enclose(now.dd, lo, hi);
  now.lo = std::max(m.lo, lo);
  now.hi = std::min(m.hi, hi);
  now.exact = [m](ExactMotion& exact) { return exact_time(m, exact); };
  return now;
}

void Chronology::begin_present() {
  present_.flips.clear();
  present_.contacts.clear();
  present_.records = motion_.records();
}

void Chronology::note_present(const Moment& m) {
  if (m.kind == Moment::Kind::flip) note_flip(m.quad);
  if (m.kind == Moment::Kind::contact) present_.contacts.push_back(states_of(motion_, m.i, m.j));
}

void Chronology::note_flip(const Quad& q) { present_.flips.push_back(states_of(motion_, q)); }

void Chronology::note_collisions(const Moment& m) {
  motion_.note_relations(present_.records, m.lo, m.hi);
}

Instant Chronology::present(const Moment& m) const {
  Instant now = instant(m);
  now.known = [this] { return present_; };
  return now;
}

// Whether symmetry proves two moments equal: tried where exact arithmetic is expensive.
bool Chronology::same_by_symmetry(const Moment& a, const Moment& b) const {
  const auto symmetry = motion_.symmetry();
  if (symmetry == nullptr) return false;
  if (a.kind == Moment::Kind::flip && b.kind == Moment::Kind::flip) {
    if (collapses_.has_rational_motion(a.quad) && collapses_.has_rational_motion(b.quad)) {
      return false;
    }
    const auto same = [&](const Moment& x, const Moment& y) {
      return symmetry->same_flip(
          states_of(motion_, x.quad), ball(x), states_of(motion_, y.quad),
          y.root ? *y.root : RootInterval{to_rational(y.lo), to_rational(y.hi)});
    };
    return same(a, b) || same(b, a);
  }
  // The pair whose contact it is.
  const auto pair = [&](const Moment& m) -> std::optional<PairStates> {
    if (m.kind == Moment::Kind::contact) return states_of(motion_, m.i, m.j);
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
    if (!a.t && !b.t) return 0;
    const Rational s = a.exact(), t = b.exact();
    return s < t ? -1 : s > t ? 1 : 0;
  }
  const bool states = a.kind == Moment::Kind::state && b.kind == Moment::Kind::state;
  if (states && a.state == b.state) return 0;
  if (const auto s = told(sign(narrow(a) - narrow(b)))) return s;
  ++beyond_filter_;
  Ladder<int> ladder(counts_, Predicate::compare);
  const Rung symmetry{Tier::symmetry, [&] {
                        return same_by_symmetry(a, b) ? std::optional<int>(0) : std::nullopt;
                      }};
  const Rung exactly{Tier::exact, [&]() -> std::optional<int> {
                       ExactMotion exact(motion_);
                       const auto c =
                           voroproof::internal::compare(exact_time(a, exact), exact_time(b, exact));
                       return c < 0 ? -1 : c > 0 ? 1 : 0;
                     }};
  const auto order =
      ladder.climb(Rung{Tier::ball, [&] { return by_balls(a, b); }}, symmetry, exactly);
  if (!order && why_not != nullptr) *why_not = ladder.budget();
  return order;
}

int Chronology::compare(const Moment& a, const Moment& b) {
  if (const int order = by_enclosures(a, b)) return order;
  std::string budget;
  if (const auto order = known_order_of_near(a, b, &budget)) return *order;
  Ladder<int> ladder(counts_, Predicate::compare);
  const Rung balls{Tier::ball, [&] { return by_balls(a, b); }};
  if (const auto order = ladder.with_more_bits(motion_, balls)) return *order;
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
  if (m.dd.rad < kInfinity) return m.dd;
  if (m.kind == Moment::Kind::rational) {
    if (!m.t) return DdBall(m.lo);
    const double near = round_nearest(*m.t);
    const double error = std::fabs(round_nearest(Rational(*m.t - to_rational(near))));
    return DdBall(near, 0, error * (1 + 0x1p-50));
  }
  const double middle = 0.5 * (m.lo + m.hi);
  DdBall best(middle, 0, (m.hi - m.lo) * (1 + 0x1p-50));
  if (m.kind == Moment::Kind::state) return best;
  if (m.kind == Moment::Kind::contact) {
    const DdBall dd = contacts_.refine(m.i, m.j, middle);
    return dd.rad < best.rad ? dd : best;
  }
  const DdBall dd = collapses_.refine_until(m.quad, m.lo, m.hi,
                                            [](const DdBall& t) { return t.rad < 0x1p-60 * t.hi; });
  return dd.rad < best.rad ? dd : best;
}

Ball Chronology::ball(const Moment& m) const {
  const int bits = motion_.goal_bits() + 32;
  switch (m.kind) {
    case Moment::Kind::rational:
      break;
    case Moment::Kind::flip:
      return m.root ? collapses_.refine(m.quad, m.root->lo, m.root->hi, bits)
                    : collapses_.refine(m.quad, to_rational(m.lo), to_rational(m.hi), bits);
    case Moment::Kind::contact:
      return contacts_.refine(m.i, m.j, to_rational(0.5 * (m.lo + m.hi)), bits);
    case Moment::Kind::state: {
      Ball b(to_rational(m.dd.hi) + to_rational(m.dd.lo), bits);
      b.widen(Magnitude::of(m.dd.rad));
      return b;
    }
  }
  return Ball(m.exact(), bits);
}

std::array<double, 2> Chronology::enclosure(const Moment& m) const {
  double lo = 0, hi = 0;
  ball(m).to_interval(lo, hi);
  return {std::max(m.lo, lo), std::min(m.hi, hi)};
}

}  // namespace voroproof::internal
