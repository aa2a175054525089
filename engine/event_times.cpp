#include "engine/event_times.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "engine/static_diagram.h"
#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

// Relative width below which balls are not asked for a time before it is compared and rounded:
// both nearly always succeed then.
constexpr double fine_width = 1e-20;

bool is_fine(const DdBall& t) { return t.rad <= fine_width * t.hi || rounds_to_leading(t); }

double middle(const IsolatingInterval& at) { return 0.5 * (at.lo + at.hi); }

}  // namespace

TimedEvent EventTimes::rough(const FoundEvent& event) const {
  if (!event.is_contact()) return tight(event);
  const auto [lo, hi] = event.at;
  return {event, lo, hi, DdBall(middle(event.at), 0, (hi - lo) * (1 + 0x1p-50)), false};
}

TimedEvent EventTimes::tight(const FoundEvent& event) const {
  if (event.exactly != nullptr) {
    const Instant t = instant_at(*event.exactly);
    return {event, t.lo, t.hi, t.dd, true};
  }
  const auto [lo, hi] = event.at;
  DdBall dd(0, 0, std::numeric_limits<double>::infinity());
  if (!motion_.options().filters) {
    dd = by_ball(event);
  } else if (event.is_flip()) {
    dd = collapses_.refine_until(event.quad, lo, hi, rounds_to_leading);
  } else {
    dd = contacts_.refine(event.i, event.j, middle(event.at));
  }
  if (!is_fine(dd)) dd = by_ball(event);
  TimedEvent timed{event, 0, 0, dd, true};
  enclose(dd, timed.lo, timed.hi);
  // The isolating interval may be the tighter one.
  timed.lo = std::max(lo, timed.lo);
  timed.hi = std::min(hi, timed.hi);
  return timed;
}

Ball EventTimes::ball(const FoundEvent& event, int bits) const {
  if (event.is_flip()) {
    const RootInterval root = event.root();
    return collapses_.refine(event.quad, root.lo, root.hi, bits);
  }
  if (event.is_contact()) {
    return contacts_.refine(event.i, event.j, to_rational(middle(event.at)), bits);
  }
  return Ball(*event.exactly, bits);
}

DdBall EventTimes::by_ball(const FoundEvent& event) const {
  DdBall dd;
  ball(event, bits()).to_double_double(dd.hi, dd.lo, dd.rad);
  return dd;
}

ExactTime EventTimes::exact(const FoundEvent& event, ExactMotion& exact) {
  if (event.is_flip()) {
    const RootInterval root = event.root();
    return CollapseSearch::exact_root(event.quad, root.lo, root.hi, exact);
  }
  if (event.is_contact()) {
    return ContactSearch::exact_time(event.i, event.j, to_rational(event.at.lo), exact);
  }
  return ExactTime(*event.exactly);
}

void EventTimes::give_up(const std::string& reason, const FoundEvent& event) {
  if (event.is_flip()) throw Undecided(reason, event.quad);
  if (event.is_contact()) throw Undecided(reason, event.i, event.j);
  throw Undecided(reason);
}

bool EventTimes::is_rational(const FoundEvent& event) const {
  if (event.is_flip()) return collapses_.has_rational_motion(event.quad);
  return !event.is_contact() || (motion_.is_rational(event.i) && motion_.is_rational(event.j));
}

// Tried where arithmetic is expensive.
bool EventTimes::same_by_symmetry(const FoundEvent& a, const FoundEvent& b) const {
  if (is_rational(a) && is_rational(b)) return false;
  const auto symmetry = motion_.symmetry();
  if (a.is_contact() && b.is_contact()) {
    return symmetry->same_contact(states_of(motion_, a.i, a.j), states_of(motion_, b.i, b.j));
  }
  if (!a.is_flip() || !b.is_flip()) return false;
  const auto same = [&](const FoundEvent& x, const FoundEvent& y) {
    return symmetry->same_flip(states_of(motion_, x.quad), ball(x, bits()),
                               states_of(motion_, y.quad), y.root());
  };
  return same(a, b) || same(b, a);
}

int EventTimes::order(const TimedEvent& x, const TimedEvent& y) {
  const FoundEvent &a = x.event, &b = y.event;
  if (a.is_contact() && b.is_contact() && std::pair(a.i, a.j) == std::pair(b.i, b.j)) return 0;
  Ladder<int> ladder(stats_.tiers, Predicate::compare);
  const Rung dd{Tier::dd, [&]() -> std::optional<int> {
                  return motion_.options().filters ? told(sign(x.dd - y.dd)) : std::nullopt;
                }};
  const Rung balls{Tier::ball, [&] { return told(sign(ball(a, bits()) - ball(b, bits()))); }};
  const Rung symmetry{Tier::symmetry, [&] {
                        return same_by_symmetry(a, b) ? std::optional<int>(0) : std::nullopt;
                      }};
  const Rung exactly{Tier::exact, [&]() -> std::optional<int> {
                       ExactMotion algebra(motion_);
                       const auto c = compare(exact(a, algebra), exact(b, algebra));
                       return c < 0 ? -1 : c > 0 ? 1 : 0;
                     }};
  if (const auto order = ladder.climb(dd, balls, symmetry, exactly)) {
    if (*order == 0) ++stats_.ties;
    return *order;
  }
  if (const auto order = ladder.with_more_bits(motion_, balls)) return *order;
  give_up("two events may be simultaneous: " + ladder.budget(), a);
}

double EventTimes::rounded(const TimedEvent& timed) {
  const FoundEvent& event = timed.event;
  Ladder<double> ladder(stats_.tiers, Predicate::round_time);
  const Rung dd{Tier::dd, [&] {
                  return motion_.options().filters && rounds_to_leading(timed.dd)
                             ? std::optional<double>(timed.dd.hi)
                             : std::nullopt;
                }};
  const Rung balls{Tier::ball, [&] {
                     double t = 0;
                     return ball(event, bits()).round_to_double(t) ? std::optional<double>(t)
                                                                   : std::nullopt;
                   }};
  const Rung exactly{Tier::exact, [&]() -> std::optional<double> {
                       ExactMotion algebra(motion_);
                       return round_nearest(exact(event, algebra));
                     }};
  if (const auto t = ladder.climb(dd, balls, exactly)) return *t;
  if (const auto t = ladder.with_more_bits(motion_, balls)) return *t;
  give_up("an event time may lie on a rounding boundary: " + ladder.budget(), event);
}

}  // namespace voroproof::internal
