#include "library/illegal_edge.h"

#include <algorithm>
#include <cmath>

#include "filtered/search/collapse.h"

namespace voroproof::internal {
namespace {

// How far a generator is outside of a circle, in doubles: for circles that are not looked at more
// closely.
double distance(const DiagramFile& diagram, const DiagramVertex& circle, GenId g) {
  const auto from = [&](const Vec2& center) {
    return std::hypot(circle.center[0] - center[0], circle.center[1] - center[1]);
  };
  if (g == container_id) {
    return diagram.container_radius - from(diagram.container_center) - circle.radius;
  }
  const auto& disk = diagram.disks[static_cast<std::size_t>(g)];
  return from(disk.center) - disk.radius - circle.radius;
}

// The same, enclosed. The container's radius is negative, as it is looked at from within.
Ball distance(const std::array<Ball, 3>& circle, const Site<Ball>& site, GenId g) {
  const Ball x = circle[0] - site.x, y = circle[1] - site.y;
  const Ball between = sqrt(x * x + y * y);
  return (g == container_id ? -between : between) - site.r - circle[2];
}

bool turned_lately(const PlacedGenerators& generators, const Quad& edge, double t) {
  const GenId four[] = {edge.l, edge.r, edge.s, edge.e};
  return std::any_of(std::begin(four), std::end(four), [&](GenId g) {
    const double since = generators[static_cast<std::size_t>(g + 1)].since;
    return since > 0 && since > t - 2 * snapshot_time_tolerance;
  });
}

// How deep roundings of places may put a generator into a circle. They grow with the coordinates: a
// container far from the origin has coarser places.
double rounding_depth(const DiagramFile& diagram) {
  const auto [x, y] = diagram.container_center;
  return snapshot_depth_tolerance * (diagram.container_radius + std::hypot(x, y));
}

// Whether the generator lies deeper than `depth` inside the circle, so long before and after the
// instant.
bool inside_throughout(const PlacedGenerators& generators, const Triple& circle, GenId inside,
                       double depth) {
  for (const double later : {-snapshot_time_tolerance, 0.0, snapshot_time_tolerance}) {
    const auto site = [&](GenId g) {
      const MovingSite<Ball>& s = generators[static_cast<std::size_t>(g + 1)].site;
      const Ball time(later, s.x.precision());
      return Site<Ball>{s.x + s.vx * time, s.y + s.vy * time, s.r};
    };
    const auto at = circle_of(circle, site);
    if (at[2].sign() != Sign::positive) return false;
    const Ball outside = distance(at, site(inside), inside);
    if ((outside + Ball(depth, outside.precision())).sign() != Sign::negative) return false;
  }
  return true;
}

}  // namespace

std::array<Ball, 3> circle_of(const Triple& generators,
                              const std::function<Site<Ball>(GenId)>& site) {
  const auto [i, j, k] = disk_first(generators[0], generators[1], generators[2]);
  // Recorded positions are rounded: where two circles of three generators are about to become one,
  // their discriminant may come out below zero.
  const auto root = [](const Ball& x) {
    return x.sign() == Sign::negative ? Ball(x.precision()) : sqrt(x);
  };
  const TangentTriple<Ball> triple(site(i), site(j), site(k),
                                   j == container_id || k == container_id);
  return tangent_circle(triple, root);
}

std::optional<IllegalEdge> illegal_edge(const PlacedGenerators& generators,
                                        const DiagramFile& diagram) {
  const double depth = rounding_depth(diagram);
  for (const Quad& edge : diagram.edges) {
    if (edge.s == edge.e) continue;
    const std::pair<Triple, GenId> ends[] = {{start_vertex(edge), edge.e},
                                             {end_vertex(edge), edge.s}};
    for (const auto& [triple, other] : ends) {
      const auto circle = std::lower_bound(
          diagram.vertices.begin(), diagram.vertices.end(), triple,
          [](const DiagramVertex& v, const Triple& name) { return v.generators < name; });
      const double outside = distance(diagram, *circle, other);
      if (outside >= -0.5 * depth || turned_lately(generators, edge, diagram.t)) continue;
      if (inside_throughout(generators, triple, other, depth)) {
        return IllegalEdge{edge, *circle, other, -outside};
      }
    }
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
