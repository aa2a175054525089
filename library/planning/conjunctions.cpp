#include "library/planning/conjunctions.h"

#include <algorithm>
#include <cmath>

#include "library/planning/clearance.h"

namespace voroproof::internal {
namespace {

struct Offset {
  double x, y;
};

struct Foot {
  double distance2, part;
};

// The nearest to the origin on the segment from a to b.
Foot foot(Offset a, Offset b) {
  const double u = b.x - a.x, v = b.y - a.y, length2 = u * u + v * v;
  const double part = length2 > 0 ? std::clamp(-(a.x * u + a.y * v) / length2, 0.0, 1.0) : 0;
  const double x = a.x + part * u, y = a.y + part * v;
  return {x * x + y * y, part};
}

// The exponent of the largest length of the task, 0 where all are zero.
int exponent_of(const PlanTask& task) {
  double extent = 0;
  for (const Vehicle& v : task.vehicles) {
    for (const Rational& x : {v.start.x, v.start.y, v.goal.x, v.goal.y, v.radius})
      extent = std::max(extent, std::fabs(round_nearest(x)));
  }
  extent = std::max(extent, round_nearest(task.clearance));
  return extent == 0 ? 0 : std::ilogb(extent);
}

}  // namespace

Conjunctions::Conjunctions(const PlanTask& task) : task_(task) {
  // A power of two is the unit of length here, so that no product of lengths leaves the range of
  // doubles, and all are at most 2.
  const int unit = exponent_of(task);
  const auto length = [&](const Rational& x) { return std::ldexp(round_nearest(x), -unit); };
  clearance_ = length(task.clearance);
  for (const Vehicle& v : task.vehicles) {
    const Vec start{length(v.start.x), length(v.start.y)};
    const Vec goal{length(v.goal.x), length(v.goal.y)};
    ways_.push_back({start, {goal.x - start.x, goal.y - start.y}});
    radii_.push_back(length(v.radius));
  }
  // Coordinates are right to some units of 1e-16.
  doubt_ = 1e-11;
  margin_ = 1e-5;
  const int n = static_cast<int>(ways_.size());
  neighbors_.resize(ways_.size());
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!reaches(j, 0, whole_way, i)) continue;
      neighbors_[i].push_back(j);
      neighbors_[j].push_back(i);
    }
  }
}

// The two ways cross, or one of the four ends is nearest to the other way.
bool Conjunctions::reaches(int j, double c, double d, int i) const {
  const Vec a = place(i, 0), b = place(i, whole_way), p = place(j, c), q = place(j, d);
  const auto side = [](Vec from, Vec to, Vec at) {
    return (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
  };
  if (side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0) return true;
  const auto distance2 = [](Vec at, Vec from, Vec to) {
    return foot({from.x - at.x, from.y - at.y}, {to.x - at.x, to.y - at.y}).distance2;
  };
  const double near = reach(i, j) + margin_;
  return std::min({distance2(p, a, b), distance2(q, a, b), distance2(a, p, q),
                   distance2(b, p, q)}) <= near * near;
}

Conjunctions::Vec Conjunctions::place(int i, double progress) const {
  const double part = progress / whole_way;
  return {ways_[i].start.x + part * ways_[i].way.x, ways_[i].start.y + part * ways_[i].way.y};
}

Conjunctions::Nearest Conjunctions::nearest(int i, double a, double b, int j, double c,
                                            double d) const {
  const Vec p = place(i, a), q = place(j, c), r = place(i, b), s = place(j, d);
  const auto [distance2, part] = foot({q.x - p.x, q.y - p.y}, {s.x - r.x, s.y - r.y});
  return {distance2 - reach(i, j) * reach(i, j), part};
}

std::optional<double> Conjunctions::first(int i, const Timetable& of_i, int j,
                                          const Timetable& of_j) const {
  std::optional<double> sure, doubtful;
  double a = 0, c = 0;
  for_each_piece(of_i, of_j, [&](int from, int to) {
    if (sure) return;
    const auto b = progress_at<double>(of_i, to), d = progress_at<double>(of_j, to);
    const auto [excess, part] = nearest(i, a, b, j, c, d);
    const double step = from + part * (to - from);
    if (excess < -doubt_)
      sure = step;
    else if (excess <= doubt_ && !doubtful)
      doubtful = step;
    a = b;
    c = d;
  });
  if (sure || !doubtful) return sure;
  if (keeps_clear(nearest_approach(task_, i, of_i, j, of_j), task_.clearance)) return std::nullopt;
  return doubtful;
}

int Conjunctions::count(int i, const Timetable& timetable, const std::vector<Timetable>& all,
                        int enough) const {
  int found = 0;
  for (const int j : neighbors_[i]) {
    if (found >= enough) break;
    found += first(i, timetable, j, all[j]).has_value();
  }
  return found;
}

}  // namespace voroproof::internal
