#include "engine/touching_point.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voroproof::internal {

std::optional<std::pair<GenId, GenId>> touching_point(InstantPredicates& predicates) {
  const Motion& motion = predicates.motion();
  struct Point {
    double x;
    GenId g;
  };
  std::vector<Point> points;
  double error = 0;
  for (GenId g = 0; g < motion.size(); ++g) {
    if (motion.input().disks[g].radius != 0) continue;
    const DoubleBall& x = predicates.rough(g).x;
    points.push_back({x.mid, g});
    error = std::fmax(error, x.rad);
  }
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
  std::optional<std::pair<GenId, GenId>> smallest;
  const auto examine = [&](GenId g, GenId point) {
    const std::pair<GenId, GenId> pair = std::minmax(g, point);
    if (smallest && *smallest <= pair) return;
    const bool touch = predicates.decide([&](auto at, auto) -> std::optional<bool> {
      const Sign s = sign(tangency(at(g), at(point)));
      if (s == Sign::unknown) return std::nullopt;
      return s == Sign::zero;
    });
    if (touch) smallest = pair;
  };
  for (const Point& p : points) examine(container_id, p.g);
  for (GenId g = 0; g < motion.size(); ++g) {
    if (motion.input().disks[g].radius == 0) continue;  // points do not coincide
    const Site<DoubleBall>& disk = predicates.rough(g);
    // The last term is above the roundings of both ends.
    const double reach = (disk.r.mid + disk.r.rad + disk.x.rad + error) * (1 + 0x1p-50) +
                         std::fabs(disk.x.mid) * 0x1p-51;
    const auto first = std::lower_bound(points.begin(), points.end(), disk.x.mid - reach,
                                        [](const Point& p, double x) { return p.x < x; });
    for (auto p = first; p != points.end() && p->x <= disk.x.mid + reach; ++p) examine(g, p->g);
  }
  return smallest;
}

}  // namespace voroproof::internal
