#include "engine/world/next_root.h"

#include <algorithm>

namespace voroproof::internal {
namespace {

bool overlap(const WorldTime& x, const WorldTime& y) {
  return x.interval().lo <= y.interval().hi && y.interval().lo <= x.interval().hi;
}

// The number of the root that is t. Precondition: one is.
std::size_t which_is(const WorldTime& t, const std::vector<WorldTime>& roots) {
  std::vector<WorldTime> all = roots;
  WorldTime at = t;
  for (;;) {
    std::vector<std::size_t> near;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (overlap(all[k], at)) near.push_back(k);
    }
    if (near.size() == 1) return near.front();
    const auto narrow = [](WorldTime& x) {
      if (!x.is_point()) x.refine((x.interval().hi - x.interval().lo) >> 8);
    };
    narrow(at);
    for (const std::size_t k : near) narrow(all[k]);
  }
}

}  // namespace

std::vector<WorldTime> roots_after(const TimePolynomial& f, const WorldTime& now, bool vanishes,
                                   const Rational& end) {
  const Rational& begin = now.interval().lo;
  if (begin > end) return {};
  std::vector<WorldTime> roots = real_roots(f, begin, end);
  const auto first = vanishes && !roots.empty()
                         ? roots.begin() + static_cast<std::ptrdiff_t>(which_is(now, roots)) + 1
                         : std::find_if(roots.begin(), roots.end(), [&](const WorldTime& root) {
                             return compare(root, now) > 0;
                           });
  return {first, roots.end()};
}

}  // namespace voroproof::internal
