#include "library/planning/clearance.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/predicates.h"
#include "library/planning/least_distance.h"

namespace voroproof::internal {
namespace {

// Starts and ways of the vehicles for the filter.
class BallPlan {
 public:
  explicit BallPlan(const Plan& plan) : plan_(plan) {
    for (const Vehicle& v : plan.task.vehicles) {
      starts_.push_back({ball_of(v.start.x), ball_of(v.start.y), DoubleBall()});
      ways_.push_back({ball_of(v.goal.x - v.start.x), ball_of(v.goal.y - v.start.y), DoubleBall()});
      radii_.push_back(ball_of(v.radius));
    }
  }

  // A certain lower bound of the gap.
  double least_gap(int i, int j) const {
    double least = std::numeric_limits<double>::infinity();
    Ball3 a = offset(i, j, 0);
    for_each_piece(plan_.timetables[i], plan_.timetables[j], [&](int, int to) {
      const Ball3 b = offset(i, j, to);
      least = std::min(least, least_distance(a, b));
      a = b;
    });
    return low(DoubleBall(least) - (radii_[i] + radii_[j]));
  }

 private:
  Ball3 offset(int i, int j, int step) const { return place(j, step) - place(i, step); }

  Ball3 place(int i, int step) const {
    const DoubleBall part =
        progress_at<DoubleBall>(plan_.timetables[i], step) * DoubleBall(1.0 / whole_way);
    return starts_[i] + ways_[i] * part;
  }

  const Plan& plan_;
  std::vector<Ball3> starts_, ways_;
  std::vector<DoubleBall> radii_;
};

}  // namespace

std::pair<Rational, Rational> nearest_to_origin(const Point2& a, const Point2& b) {
  const Rational u = b.x - a.x, v = b.y - a.y, length2 = u * u + v * v;
  Rational part = 0;
  if (length2 != 0) part = std::clamp<Rational>(-(a.x * u + a.y * v) / length2, 0, 1);
  const Rational x = a.x + part * u, y = a.y + part * v;
  return {part, Rational(x * x + y * y)};
}

Approach nearest_approach(const Plan& plan, int i, int j) {
  return nearest_approach(plan.task, i, plan.timetables[i], j, plan.timetables[j]);
}

Approach nearest_approach(const PlanTask& task, int i, const Timetable& of_i, int j,
                          const Timetable& of_j) {
  const Vehicle &first = task.vehicles[i], &second = task.vehicles[j];
  Approach nearest{std::min(i, j), std::max(i, j), 0, -1, Rational(first.radius + second.radius)};
  const auto offset = [&](int step) -> Point2 {
    const Point2 p = place(first, progress_at<Rational>(of_i, step));
    const Point2 q = place(second, progress_at<Rational>(of_j, step));
    return {q.x - p.x, q.y - p.y};
  };
  Point2 a = offset(0);
  for_each_piece(of_i, of_j, [&](int from, int to) {
    const Point2 b = offset(to);
    const auto [part, distance2] = nearest_to_origin(a, b);
    if (nearest.distance2 < 0 || distance2 < nearest.distance2) {
      nearest.distance2 = distance2;
      nearest.t = time_of(task, from + part * (to - from));
    }
    a = b;
  });
  return nearest;
}

std::optional<Approach> minimum_gap(const Plan& plan) {
  const int n = static_cast<int>(plan.task.vehicles.size());
  const BallPlan balls(plan);
  // The pairs that may be nearest, the likely ones first.
  struct Pair {
    double bound;
    int i, j;
  };
  std::vector<Pair> pairs;
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) pairs.push_back({balls.least_gap(i, j), i, j});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.bound < b.bound; });
  std::optional<Approach> nearest;
  double nearest_above = std::numeric_limits<double>::infinity();
  for (const Pair& pair : pairs) {
    if (pair.bound > nearest_above) break;
    const Approach approach = nearest_approach(plan, pair.i, pair.j);
    nearest = nearest ? nearer_of(*nearest, approach) : approach;
    nearest_above = gap(*nearest).hi;
  }
  return nearest;
}

namespace {

bool is_at_wall(const Approach& approach) { return approach.i < 0; }

// Whether a distance, whose square is given, is what is asked for.
bool is_enough(const Approach& approach, const Rational& distance2, const Rational& clearance,
               Touching touching) {
  const bool may_be_equal =
      clearance != 0 || touching == Touching::is_allowed || !approach.is_reached;
  if (is_at_wall(approach)) {
    const Rational room = approach.reach - clearance;
    if (room < 0) return false;
    return may_be_equal ? distance2 <= room * room : distance2 < room * room;
  }
  const Rational apart = approach.reach + clearance;
  if (apart < 0) return true;
  return may_be_equal ? distance2 >= apart * apart : distance2 > apart * apart;
}

// The squares of the distance for which the gap is least, and greatest.
Rational worst_square(const Approach& a) {
  return is_at_wall(a) ? Rational(a.distance2 + a.distance2_width) : a.distance2;
}
Rational best_square(const Approach& a) {
  return is_at_wall(a) ? a.distance2 : Rational(a.distance2 + a.distance2_width);
}

}  // namespace

bool keeps_clear(const Approach& approach, const Rational& clearance, Touching touching) {
  return is_enough(approach, worst_square(approach), clearance, touching);
}

bool falls_short(const Approach& approach, const Rational& clearance, Touching touching) {
  return !is_enough(approach, best_square(approach), clearance, touching);
}

// sqrt(d) - r against sqrt(e) - s is sqrt(d) against w = sqrt(e) + c with c = r - s: w's sign
// first, then the squares, d - e - c^2 against 2 c sqrt(e). Gaps to walls are the negatives.
std::strong_ordering compare_gaps(const Approach& of_a, const Approach& of_b) {
  const Approach &a = is_at_wall(of_a) ? of_b : of_a, &b = is_at_wall(of_a) ? of_a : of_b;
  const Rational c = a.reach - b.reach;
  const auto ordering = [](Sign s) { return static_cast<int>(s) <=> 0; };
  const Sign w =
      sign_with_root(sign(c), sign(b.distance2) == Sign::zero ? Sign::zero : Sign::positive,
                     sign(Rational(c * c - b.distance2)));
  if (w == Sign::negative) return std::strong_ordering::greater;
  if (w == Sign::zero) return ordering(sign(a.distance2));
  const Rational u = a.distance2 - b.distance2 - c * c, v = -2 * c;
  return ordering(sign_with_root(sign(u),
                                 sign(v) * (b.distance2 == 0 ? Sign::zero : Sign::positive),
                                 sign(Rational(u * u - b.distance2 * v * v))));
}

std::pair<Rational, Rational> root_bounds(const Rational& square) {
  if (square == 0) return {0, 0};
  // sqrt(p / q) = sqrt(p q) / q, and the integer root of p q 4^k is right to 1.
  const Integer &p = square.get_num(), &q = square.get_den();
  const Integer scaled = (p * q) << 160;
  const Integer root = sqrt(scaled);
  const auto divided = [&](const Integer& r) {
    Rational value(r, Integer(q << 80));
    value.canonicalize();
    return value;
  };
  return {divided(root), divided(root * root == scaled ? root : Integer(root + 1))};
}

namespace {

// Bounds of the gap.
std::pair<Rational, Rational> gap_of(const Approach& a) {
  const Rational low = root_bounds(a.distance2).first,
                 high = root_bounds(a.distance2 + a.distance2_width).second;
  if (is_at_wall(a)) return {a.reach - high, a.reach - low};
  return {low - a.reach, high - a.reach};
}

}  // namespace

Approach nearer_of(const Approach& a, const Approach& b) {
  const auto rank = [](const Approach& c) { return std::tie(c.t, c.i, c.j, c.image); };
  Approach first = rank(b) < rank(a) ? b : a;
  first.is_reached = a.is_reached || b.is_reached;
  if (a.is_exact() && b.is_exact()) {
    const auto order = compare_gaps(a, b);
    return order < 0 ? a : order > 0 ? b : first;
  }
  const auto [a_lo, a_hi] = gap_of(a);
  const auto [b_lo, b_hi] = gap_of(b);
  if (a_hi < b_lo) return a;
  if (b_hi < a_lo) return b;
  if (is_at_wall(first)) {
    const Rational near = std::max<Rational>(first.reach - std::min(a_hi, b_hi), 0),
                   far = first.reach - std::min(a_lo, b_lo);
    first.distance2 = near * near;
    first.distance2_width = far * far - near * near;
    return first;
  }
  const Rational least = std::max<Rational>(std::min(a_lo, b_lo) + first.reach, 0);
  const Rational most = std::min(a_hi, b_hi) + first.reach;
  const auto above = [&](const Approach& c) -> Rational {
    return c.reach == first.reach ? Rational(c.distance2 + c.distance2_width) : most * most;
  };
  const Rational lower = std::min<Rational>(first.distance2, least * least),
                 upper = a.is_reached == b.is_reached ? std::min(above(a), above(b))
                                                      : above(a.is_reached ? a : b);
  first.distance2 = lower;
  first.distance2_width = upper - lower;
  return first;
}

Enclosure gap(const Approach& approach) {
  const auto [lo, hi] = gap_of(approach);
  return {round_down(lo), round_up(hi)};
}

}  // namespace voroproof::internal
