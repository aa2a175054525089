// The tiers of the search for collapses where doubles do not decide: double-doubles, symmetry,
// balls; then exact algebra (collapse_exact.cpp).
#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include "exact/dual.h"
#include "exact/patience.h"
#include "filtered/numbers/subdivision.h"
#include "filtered/search/bernstein.h"
#include "filtered/search/collapse.h"
#include "filtered/search/edge_predicates.h"
#include "filtered/search/flip_polynomial.h"
#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Effort. None of these decides anything: they say when a tier has done enough, and only the cost
// depends on them.
//
// So much of a window makes an answer of double-doubles and balls; the rest waits for its turn,
// since an event may come before it is hard again.
constexpr double kPartWorthAnAnswer = 0.01;
// Halvings of a window: in double-doubles until it is about as short as they can tell times apart;
// in balls by their bits, and no more than the second.
constexpr int kHalvingsInDd = 48, kHalvingsInBalls = 512;
// Windows beyond an instant are looked at from 1/2^4 of the way to the end of the search down to
// 1/2^60, and are never shorter than 2^-40 of the edge's time scale altogether.
constexpr int kFirstShortening = 4, kLastShortening = 60, kBitsOfLeastWindow = 40;
// A root is narrowed to 2^-20 of that scale: its enclosure is short beside what happens near it.
constexpr int kBitsOfRoot = 20;

Rational least_window(const Motion& motion, const Quad& q, const Rational& t) {
  return to_rational(time_scale(motion, q, voroproof::internal::round_down(t))) >>
         kBitsOfLeastWindow;
}

// The answer of a tier that may give up: then it is decided up to `reached` only.
struct Attempt {
  bool decided = false;
  Collapse answer;
  Rational reached;
};

// Searches [start, end]; a root that is not certainly later than `now` is left to the
// exact tier. `max_halvings` bounds the depth.
template <class T, class Make>
Attempt search_in(const Motion& motion, const Quad& q, const Rational& start, const Rational& end,
                  const Moment* now, int max_halvings, const Make& make) {
  const bool cocircular = flip_polynomial_is_cocircularity(motion, q);
  struct Part {
    Rational a, b;
    Coefficients<T> c;
    int depth;
  };
  std::vector<Part> stack;
  stack.push_back({start, end, form_in<T>(motion, q, start, end, cocircular, make), 0});
  const Rational narrow =
      to_rational(time_scale(motion, q, voroproof::internal::round_down(start))) >> kBitsOfRoot;
  const T half = make(Rational(1, 2));
  while (!stack.empty()) {
    Patience::ask();
    Part part = std::move(stack.back());
    stack.pop_back();
    const int roots = count_roots_in(part.c);
    if (roots == 0) continue;
    if (roots == 1) {
      // Narrow until the verdict is known.
      const Sign before = sign(part.c.front());
      for (;;) {
        Patience::ask();
        const T hull = make.hull(part.a, part.b);
        const auto at_hull = sites(motion, q, hull);
        const auto after = [&] { return sites(motion, q, make(part.b)); };
        const Judgement verdict = judge(q, at_hull, after, cotangency_sign(-before, cocircular));
        const bool near_now = now != nullptr && part.a <= to_rational(now->hi);
        if (verdict == Judgement::stays && !near_now) break;
        if (verdict == Judgement::collapses && !near_now && part.b - part.a < narrow) {
          return {true, Collapse::at_root(part.a, part.b), {}};
        }
        if (++part.depth > max_halvings) return {false, {}, part.a};
        Coefficients<T> left, right;
        halve_in(part.c, half, left, right);
        const Sign middle = sign(right.front());
        const Rational m = (part.a + part.b) / 2;
        if (middle == before) {
          part.a = m;
          part.c = std::move(right);
        } else if (middle == -before) {
          part.b = m;
          part.c = std::move(left);
        } else {
          return {false, {}, part.a};
        }
      }
      continue;
    }
    if (++part.depth > max_halvings) return {false, {}, part.a};
    const Rational m = (part.a + part.b) / 2;
    Part right{m, part.b, {}, part.depth};
    Part left{part.a, m, {}, part.depth};
    halve_in(part.c, half, left.c, right.c);
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  return {true, Collapse::none_until(voroproof::internal::round_down(end)), {}};
}

}  // namespace

std::optional<Collapse> CollapseSearch::while_cotangent(const Quad& q, const std::array<Sign, 2>& s,
                                                        const Ball& t) const {
  const bool cotangent = s[0] == Sign::zero && s[1] == Sign::zero;
  const bool in_conflict = s[0] == Sign::negative && s[1] == Sign::negative;
  if (!in_conflict && (!cotangent || legal_while_cotangent(q)))
    return Collapse::none_until(kInfinity);
  if (cotangent) {
    const Sign order = contact_order(q, sites(motion_, q, t));
    if (order == Sign::negative) return Collapse::none_until(kInfinity);
    if (order != Sign::positive) return std::nullopt;
  }
  Collapse illegal;
  illegal.kind = Collapse::Kind::now;
  return illegal;
}

Collapse CollapseSearch::slow(const Quad& q, const Rational& start, const Moment* now, double end) {
  const Rational finish =
      std::max<Rational>(to_rational(end), start + least_window(motion_, q, start));
  // Generators that look cotangent at the instant mostly are. Nothing but the exact tier can say
  // so, and while their motion is rational it is quick.
  const bool exact_first = motion_.options().filters && now != nullptr && has_rational_motion(q) &&
                           sign(flip_value(motion_, q, now->dd, false)) == Sign::unknown;
  Ladder<Collapse> ladder(counts_, Predicate::flip_search);
  const auto answer_of = [&](const Attempt& attempt) -> std::optional<Collapse> {
    if (attempt.decided) return attempt.answer;
    // A part of the window that is hard and later can wait: an event may come first.
    const double from = now != nullptr ? now->hi : voroproof::internal::round_up(start);
    const double reached = voroproof::internal::round_down(attempt.reached);
    const double worth = kPartWorthAnAnswer * std::max(0.0, end - from);
    if (!(reached - from > worth)) return std::nullopt;
    return Collapse::none_until(reached);
  };
  const Rung dd{Tier::dd, [&]() -> std::optional<Collapse> {
                  if (!motion_.options().filters) return std::nullopt;
                  return answer_of(
                      search_in<DdBall>(motion_, q, start, finish, now, kHalvingsInDd, MakeDd{}));
                }};
  const Rung symmetry{Tier::symmetry, [&] { return by_symmetry(q, start, now, end); }};
  const Rung balls{
      Tier::ball, [&]() -> std::optional<Collapse> {
        const int bits = motion_.goal_bits() + 32;
        return answer_of(search_in<Ball>(motion_, q, start, finish, now,
                                         std::min(bits / 2, kHalvingsInBalls), MakeBall{bits}));
      }};
  std::string blurred;
  const Rung exact{Tier::exact, [&]() -> std::optional<Collapse> {
                     try {
                       return exactly(q, start, now, end);
                     } catch (const RootTooBlurred& e) {
                       blurred = e.what();
                       return std::nullopt;
                     }
                   }};
  if (const auto found =
          exact_first ? ladder.climb(symmetry, exact) : ladder.climb(dd, symmetry, balls, exact)) {
    return *found;
  }
  if (const auto found = ladder.with_more_bits(motion_, balls)) return *found;
  throw Undecided("the next flip of an edge is not decided with " +
                      std::to_string(motion_.options().max_bits) +
                      " bits; exactly: " + (blurred.empty() ? ladder.budget() : blurred),
                  q);
}

namespace {

// Judges an edge whose four generators touch one circle at an instant of the hull, for the rest of
// the hull: the slopes of its in-circle functions tell, if both circles exist and are the one that
// is touched. (The flip polynomial itself may have a double root, where two circles that touch
// three of them touch the fourth.)
Judgement departs(const Motion& motion, const Quad& q, const Ball& hull, bool every_circle) {
  const std::array<Site<Ball>, 4> at = sites(motion, q, hull);
  const EdgeTriples<Ball> circles = EdgeTriples<Ball>::of(q, at);
  const Sign start_exists = circle_exists(circles.start), end_exists = circle_exists(circles.end);
  if (start_exists == Sign::negative || end_exists == Sign::negative) return Judgement::stays;
  if (start_exists != Sign::positive || end_exists != Sign::positive || !keeps_tangencies(at)) {
    return Judgement::unknown;
  }
  if (!every_circle) {
    const Sign a = incircle(circles.start, at[3], q.e == container_id, Sign::zero);
    const Sign b = incircle(circles.end, at[2], q.s == container_id, Sign::zero);
    if (a == Sign::positive || b == Sign::positive) return Judgement::stays;
    if (a != Sign::zero || b != Sign::zero) return Judgement::unknown;
  }
  const std::array<Site<Dual<Ball>>, 4> moving = moving_sites(motion, q, hull);
  const EdgeTriples<Dual<Ball>> triples = EdgeTriples<Dual<Ball>>::of(q, moving);
  const Sign a = sign(incircle_value(triples.start, moving[3], q.e == container_id).slope);
  const Sign b = sign(incircle_value(triples.end, moving[2], q.s == container_id).slope);
  if (a == Sign::positive || b == Sign::positive) return Judgement::stays;
  if (a != Sign::negative || b != Sign::negative) return Judgement::unknown;
  const Sign order = contact_order(q, at);
  return order == Sign::negative   ? Judgement::stays
         : order == Sign::positive ? Judgement::collapses
                                   : Judgement::unknown;
}

}  // namespace

// The answer where symmetry proves that the four are cotangent for good, or at the present instant.
std::optional<Collapse> CollapseSearch::by_symmetry(const Quad& q, const Rational& start,
                                                    const Moment* now, double end) {
  if (has_rational_motion(q)) return std::nullopt;
  const auto symmetry = motion_.symmetry();
  const QuadStates states = states_of(motion_, q);
  const Rational t = now != nullptr ? to_rational(now->hi) : start;
  const DoubleBall about =
      DoubleBall::hull(voroproof::internal::round_down(t), voroproof::internal::round_up(t));
  if (symmetry->always_cotangent(states, about)) {
    const MakeBall make{motion_.goal_bits() + 32};
    const Ball at = now != nullptr ? make.hull(to_rational(now->lo), t) : make(t);
    return while_cotangent(q, {Sign::zero, Sign::zero}, at);
  }
  if (now == nullptr || now->present == nullptr) return std::nullopt;
  const auto proved = symmetry->cotangency(states, now->present->known(), now->lo, now->hi);
  if (proved == Symmetry::Cotangency::unknown) return std::nullopt;
  const bool every_circle =
      proved == Symmetry::Cotangency::every_circle || flip_polynomial_is_cocircularity(motion_, q);
  const MakeBall make{motion_.goal_bits() + 32};
  // The answer goes as far beyond the instant as the signs are certain: a search is expensive next
  // to a root.
  const Rational last =
      std::max<Rational>(to_rational(end) - to_rational(now->hi), least_window(motion_, q, t));
  for (int k = kFirstShortening; k <= kLastShortening; k += 4) {
    const Rational beyond = to_rational(now->hi) + last / (Integer(1) << k);
    const Judgement verdict =
        departs(motion_, q, make.hull(to_rational(now->lo), beyond), every_circle);
    if (verdict == Judgement::unknown) continue;
    if (verdict == Judgement::stays) return slow(q, beyond, nullptr, end);
    Collapse answer;
    answer.kind = Collapse::Kind::now;
    return answer;
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
