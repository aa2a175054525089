#include "engine/collapse_rule.h"

#include <cstddef>
#include <cstdio>

namespace voroproof::internal {

namespace {

// A disk collides that often within this part of the scale,
constexpr std::size_t kManyCollisions = 48;
constexpr double kShortSpan = 1e-10;
// or for some number m, from 2 to half of that, the last m delays between its collisions are not
// all zero, less than this part of the scale, and at most this part of the m before. (In turns
// with two neighbours the delays shrink every other time only.)
constexpr double kShortDelays = 1e-9;
constexpr double kShrinking = 1.0 / 16;
// or the same twice in a row for m = 1, with this part of the scale: with restitution 0 the
// delays may shrink like squares, and one more is too short for binary64 times.
constexpr double kShortLast = 1e-12;

}  // namespace

std::string time_text(double t) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.17g", t);
  return buffer;
}

std::string seeming_collapse(GenId disk, double t, double scale, std::vector<double>& times) {
  times.push_back(t);
  if (times.size() > kManyCollisions + 1) times.erase(times.begin());
  const std::size_t n = times.size();
  const auto within = [&](std::size_t collisions) {
    char span[40];
    std::snprintf(span, sizeof span, "%.3g", t - times[n - collisions]);
    return "collapse, as it seems: disk " + std::to_string(disk) + " collides " +
           std::to_string(collisions) + " times within " + span + " before t = " + time_text(t);
  };
  if (n > kManyCollisions && t - times.front() < kShortSpan * scale) return within(n);
  const auto shrink = [&](std::size_t end, std::size_t m) {
    const double between = times[end - m];
    return times[end] > between &&
           times[end] - between <= kShrinking * (between - times[end - 2 * m]);
  };
  if (n > 3 && t - times[n - 2] < kShortLast * scale && shrink(n - 1, 1) && shrink(n - 2, 1))
    return within(4);
  for (std::size_t m = 2; 2 * m < n; ++m) {
    if (!(t - times[n - 1 - m] < kShortDelays * scale)) break;
    if (shrink(n - 1, m)) return within(2 * m + 1);
  }
  return {};
}

}  // namespace voroproof::internal
