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
      starts_.push_back({ball_of(v.start.x), ball_of(v.start.y)});
      ways_.push_back({ball_of(v.goal.x - v.start.x), ball_of(v.goal.y - v.start.y)});
      radii_.push_back(ball_of(v.radius));
    }
  }

  // A certain lower bound of the gap.
  double least_gap(int i, int j) const {
    double least = std::numeric_limits<double>::infinity();
    Ball2 a = offset(i, j, 0);
    for_each_piece(plan_.timetables[i], plan_.timetables[j], [&](int, int to) {
      const Ball2 b = offset(i, j, to);
      least = std::min(least, least_distance(a, b));
      a = b;
    });
    return low(DoubleBall(least) - (radii_[i] + radii_[j]));
  }

 private:
  Ball2 offset(int i, int j, int step) const {
    const Ball2 p = place(i, step), q = place(j, step);
    return {q.x - p.x, q.y - p.y};
  }

  Ball2 place(int i, int step) const {
    const DoubleBall part =
        progress_at<DoubleBall>(plan_.timetables[i], step) * DoubleBall(1.0 / whole_way);
    return {starts_[i].x + part * ways_[i].x, starts_[i].y + part * ways_[i].y};
  }

  const Plan& plan_;
  std::vector<Ball2> starts_, ways_;
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
    if (nearest) {
      const auto order = compare_gaps(approach, *nearest);
      if (order > 0) continue;
      if (order == 0 && std::tie(approach.t, approach.i, approach.j) >
                            std::tie(nearest->t, nearest->i, nearest->j))
        continue;
    }
    nearest = approach;
    nearest_above = gap(approach).hi;
  }
  return nearest;
}

bool keeps_clear(const Approach& approach, const Rational& clearance) {
  const Rational apart = approach.reach + clearance;
  return clearance == 0 ? approach.distance2 > apart * apart : approach.distance2 >= apart * apart;
}

// sqrt(d) - r against sqrt(e) - s is sqrt(d) against w = sqrt(e) + c with c = r - s: w's sign
// first, then the squares, d - e - c^2 against 2 c sqrt(e).
std::strong_ordering compare_gaps(const Approach& a, const Approach& b) {
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

Enclosure gap(const Approach& approach) { return root_less(approach.distance2, approach.reach); }

Enclosure root_less(const Rational& square, const Rational& less) {
  if (square == 0) return enclosure(Rational(-less));
  // sqrt(p / q) = sqrt(p q) / q, and the integer root of p q 4^k is right to 1.
  const Integer &p = square.get_num(), &q = square.get_den();
  const Integer scaled = (p * q) << 160;
  const Integer root = sqrt(scaled);
  const auto lessened = [&](const Integer& r) {
    Rational value(r, Integer(q << 80));
    value.canonicalize();
    return Rational(value - less);
  };
  const Integer above = root * root == scaled ? root : Integer(root + 1);
  return {round_down(lessened(root)), round_up(lessened(above))};
}

}  // namespace voroproof::internal
