#include "engine/certified.h"

#include <limits>

#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

// Relative width below which balls are not asked for a time before it is compared and rounded:
// both nearly always succeed then.
constexpr double fine_width = 1e-20;

bool is_fine(const DdBall& t) { return t.rad <= fine_width * t.hi || rounds_to_leading(t); }

}  // namespace

void Certified::tighten(Moment& m) const {
  if (m.tight) return;
  DdBall t(0, 0, std::numeric_limits<double>::infinity());
  if (motion_.options().filters) {
    t = m.is_flip() ? collapses_.refine_until(m.quad, m.lo, m.hi, rounds_to_leading)
                    : contacts_.refine(m.i, m.j, m.middle());
  }
  if (!is_fine(t)) chronology_.ball(m).to_double_double(t.hi, t.lo, t.rad);
  m.narrow_to(t);
}

double Certified::rounded(const Moment& m) {
  Ladder<double> ladder(stats_.tiers, Predicate::round_time);
  const Rung dd{Tier::dd, [&] {
                  return motion_.options().filters && rounds_to_leading(m.dd)
                             ? std::optional<double>(m.dd.hi)
                             : std::nullopt;
                }};
  const Rung balls{Tier::ball, [&] {
                     double t = 0;
                     return chronology_.ball(m).round_to_double(t) ? std::optional<double>(t)
                                                                   : std::nullopt;
                   }};
  const Rung exactly{Tier::exact, [&]() -> std::optional<double> {
                       ExactMotion exact(motion_);
                       return round_nearest(m.exact(exact));
                     }};
  if (const auto t = ladder.climb(dd, balls, exactly)) return *t;
  if (const auto t = ladder.with_more_bits(motion_, balls)) return *t;
  m.give_up("an event time may lie on a rounding boundary: " + ladder.budget());
}

}  // namespace voroproof::internal
