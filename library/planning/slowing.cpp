#include "library/planning/slowing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace voroproof::internal {

double top_speed(const Timetable& timetable) {
  double top = 0;
  for (std::size_t k = 1; k < timetable.size(); ++k) {
    const Knot &a = timetable[k - 1], &b = timetable[k];
    top = std::max(top, static_cast<double>(b.progress - a.progress) * time_steps /
                            (static_cast<double>(b.step - a.step) * whole_way));
  }
  return top;
}

Timetable slowed(const Timetable& timetable, int from, int until, int slow) {
  const auto old = [&](int step) {
    return static_cast<int>(std::lround(progress_at<double>(timetable, step)));
  };
  const int start = old(from), end = old(until), left = whole_way - end;
  if (left <= 0 || until >= time_steps) return {};
  const auto during = [&](int progress) { return start + (progress - start) * slow / 4; };
  const int reached = during(end);
  const auto after = [&](int progress) {
    return reached + static_cast<int>(std::int64_t{progress - end} * (whole_way - reached) / left);
  };
  Timetable result;
  for (const Knot& knot : timetable)
    if (knot.step < from) result.push_back(knot);
  result.push_back({from, start});
  for (const Knot& knot : timetable)
    if (knot.step > from && knot.step < until) result.push_back({knot.step, during(knot.progress)});
  result.push_back({until, reached});
  for (const Knot& knot : timetable)
    if (knot.step > until) result.push_back({knot.step, after(knot.progress)});
  drop_idle_knots(result);
  if (top_speed(result) > max_speed_up) return {};
  return result;
}

std::vector<Timetable> slowings(const Timetable& timetable, double conjunction) {
  constexpr int shares = 8;
  std::vector<Timetable> all;
  for (const int slow : {3, 2, 1, 0}) {
    for (int after = 0; after < shares; ++after) {
      for (int before = shares - 1; before >= 0; --before) {
        const int from = static_cast<int>(conjunction * before / shares);
        const double rest = (time_steps - conjunction) * after / shares;
        const int until = static_cast<int>(std::ceil(conjunction + rest));
        if (from >= until) continue;
        Timetable timetable_slowed = slowed(timetable, from, until, slow);
        if (!timetable_slowed.empty()) all.push_back(std::move(timetable_slowed));
      }
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Timetable& a, const Timetable& b) {
    return top_speed(a) < top_speed(b);
  });
  return all;
}

}  // namespace voroproof::internal
