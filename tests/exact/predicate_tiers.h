// The predicates by each number type in its turn, from doubles to exact ones: which is the first to
// decide.
#pragma once

#include <limits>
#include <optional>
#include <ostream>

#include "exact/ball.h"
#include "exact/predicates.h"
#include "exact/rational.h"
#include "exact/tower.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"
#include "tests/exact/powers.h"
#include "tests/exact/predicate_sites.h"

namespace voroproof::internal::testing {

// The number types that a decision is tried in, cheapest first, by their bits: doubles and
// double-doubles with error bounds; balls of 32 bits more than the goal of a run's motion, 112,
// which doubles whenever the run asks for more; exact numbers.
inline constexpr int in_doubles = 53, in_double_doubles = 106,
                     exactly = std::numeric_limits<int>::max();
inline constexpr int tiers[] = {in_doubles, in_double_doubles, 144, 256, 480, 928, 1824, exactly};

inline DoubleBall double_ball(const Rational& q) {
  const double mid = round_nearest(q);
  return {mid, round_up(abs(Rational(q - to_rational(mid))))};
}
inline DdBall dd_ball(const Rational& q) {
  const double hi = round_nearest(q);
  const Rational rest = q - to_rational(hi);
  const double lo = round_nearest(rest);
  return {hi, lo, round_up(abs(Rational(rest - to_rational(lo))))};
}

// The sites in another type; turned by 45 degrees and twice as large where the root of 2 is given,
// so that they have irrational coordinates and all signs are as before.
template <class T, class Make>
Sites<T> sites_in(const Sites<Rational>& at, Make&& make, const std::optional<T>& root2) {
  const auto site = [&](const Site<Rational>& s) -> Site<T> {
    if (!root2) return {make(s.x), make(s.y), make(s.r)};
    return {*root2 * make(s.x - s.y), *root2 * make(s.x + s.y), make(2 * s.r)};
  };
  return {site(at[0]), site(at[1]), site(at[2]), site(at[3])};
}

// visit(tier, sites) until that returns true.
template <class Visit>
void at_each_tier(const Sites<Rational>& at, bool turned, Visit&& visit) {
  const auto go = [&]<class T>(int tier, auto&& make, const T& root2) {
    return visit(tier, sites_in<T>(at, make, turned ? std::optional<T>(root2) : std::nullopt));
  };
  for (const int tier : tiers) {
    if (tier == in_doubles) {
      if (go(tier, double_ball, sqrt(DoubleBall(2)))) return;
    } else if (tier == in_double_doubles) {
      if (go(tier, dd_ball, sqrt(DdBall(2)))) return;
    } else if (tier == exactly) {
      RadicalField field;
      const auto element = [](const Rational& x) { return Tower(x); };
      if (go(tier, element, field.sqrt(Tower(2)))) return;
    } else {
      const auto ball = [tier](const Rational& x) { return Ball(x, tier); };
      if (go(tier, ball, sqrt(ball(2)))) return;
    }
  }
}

enum class Question { cotangency, cocircularity, in_circle, exists };
inline constexpr Question all_questions[] = {Question::cotangency, Question::cocircularity,
                                             Question::in_circle, Question::exists};

// Of the triple 0, 1, 2 and the site 3.
template <class T>
Sign answer(Question question, const Sites<T>& at, int wall) {
  const auto t = [&] { return triple(at, disk_leads({0, 1, 2}, wall), wall); };
  switch (question) {
    case Question::cotangency:
      return sign(f_of(at));
    case Question::cocircularity:
      return sign(c_of(at));
    case Question::in_circle:
      return incircle(t(), at[3], wall == 3, sign(f_of(at)));
    case Question::exists:
      return circle_exists(t());
  }
  return Sign::unknown;
}

struct Decision {
  Sign sign = Sign::unknown;
  int tier = 0;
  bool operator==(const Decision&) const = default;
};
inline std::ostream& operator<<(std::ostream& out, const Decision& d) {
  return out << "sign " << static_cast<int>(d.sign) << " by " << d.tier << " bits";
}

inline Decision first_decision(Question question, const Four& four, bool turned) {
  Decision first;
  at_each_tier(four.at, turned, [&](int tier, const auto& at) {
    first = {answer(question, at, four.wall), tier};
    return first.sign != Sign::unknown;
  });
  return first;
}

inline Rational hair(int bits) { return bits == 0 ? Rational(0) : power_of_two(-bits); }

}  // namespace voroproof::internal::testing
