#include "library/queries/nearest.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace voroproof::internal {
namespace {

using Pair = std::pair<GenId, GenId>;

Pair sorted(GenId a, GenId b) { return std::minmax(a, b); }

// The pairs of the least gap among candidates.
ClosestPairs closest_of(Clearance& clearance, const std::set<Pair>& candidates) {
  ClosestPairs closest;
  for (const Pair& pair : candidates) {
    Sign s = Sign::negative;
    if (!closest.pairs.empty()) {
      const Pair& best = closest.pairs.front();
      s = clearance.compare(gate_node(pair.first, pair.second), gate_node(best.first, best.second));
    }
    if (s == Sign::negative) closest.pairs.clear();
    if (s != Sign::positive) closest.pairs.push_back(pair);
  }
  if (!closest.pairs.empty()) {
    const auto [i, j] = closest.pairs.front();
    closest.gap = gap(clearance, i, j);
  }
  return closest;
}

std::set<Pair> adjacent_pairs(const Diagram& diagram) {
  std::set<Pair> pairs;
  if (diagram.disks() == 1) pairs.insert({container_id, 0});
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    pairs.insert(sorted(diagram.org(h), diagram.dest(h)));
  }
  return pairs;
}

}  // namespace

Enclosure gap(const Clearance& clearance, GenId i, GenId j) {
  const Enclosure half = clearance.value(gate_node(i, j));
  return {2 * half.lo, 2 * half.hi};
}

std::vector<NearDisk> nearest_disks(const Motion& motion, const Rational& t, const Point2& point,
                                    std::size_t count, TierCounts& counts) {
  const auto& origin = motion.input().origin;
  InstantPredicates predicates(motion, t, counts,
                               {Rational(point.x - origin[0]), Rational(point.y - origin[1])});
  const auto distance = [](auto& at, auto& root, GenId g) {
    const auto site = at(g);
    using T = std::decay_t<decltype(site.x)>;
    const T dx = site.x - at.constant(0), dy = site.y - at.constant(1);
    return T(root(T(dx * dx + dy * dy)) - site.r);
  };
  const auto compare = [&](GenId a, GenId b) {
    return predicates.sign_of([&](auto at, auto root) {
      const auto first = distance(at, root, a);
      return decltype(first)(first - distance(at, root, b));
    });
  };
  std::vector<GenId> ids(motion.size());
  std::iota(ids.begin(), ids.end(), 0);
  count = std::min(count, ids.size());
  std::partial_sort(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(count), ids.end(),
                    [&](GenId a, GenId b) {
                      if (a == b) return false;
                      const Sign s = compare(a, b);
                      return s == Sign::negative || (s == Sign::zero && a < b);
                    });
  std::vector<NearDisk> nearest;
  for (std::size_t k = 0; k < count; ++k) {
    const Enclosure d =
        enclosure(predicates.ball([&](auto at, auto root) { return distance(at, root, ids[k]); }));
    const bool tied = k > 0 && compare(ids[k - 1], ids[k]) == Sign::zero;
    nearest.push_back({ids[k], d, tied});
  }
  return nearest;
}

std::vector<Neighbour> neighbours(Clearance& clearance, GenId disk) {
  const Diagram& diagram = clearance.diagram();
  std::map<GenId, int> edges;
  if (diagram.disks() == 1) {
    edges[container_id] = 1;
  } else {
    for (const Diagram::HalfEdge h : diagram.ring(disk)) ++edges[diagram.dest(h)];
  }
  std::vector<Neighbour> all;
  for (const auto& [generator, count] : edges) {
    all.push_back({generator, count, gap(clearance, disk, generator)});
  }
  return all;
}

ClosestPairs closest_generators(Clearance& clearance) {
  return closest_of(clearance, adjacent_pairs(clearance.diagram()));
}

ClosestPairs closest_disks(Clearance& clearance) {
  const Diagram& diagram = clearance.diagram();
  if (diagram.disks() < 2) return {};
  std::set<Pair> candidates = adjacent_pairs(diagram);
  std::erase_if(candidates, [](const Pair& pair) { return pair.first == container_id; });
  const double bound = closest_of(clearance, candidates).gap.hi;

  // Disks nearer to the wall than that, in the order of their leftmost points.
  struct Disk {
    GenId id;
    double left, right;
  };
  std::vector<Disk> near_wall;
  for (GenId g = 0; g < diagram.disks(); ++g) {
    if (gap(clearance, g, container_id).lo > bound) continue;
    const Site<DoubleBall>& site = clearance.predicates().rough(g);
    const double reach = site.x.rad + site.r.mid + site.r.rad;
    // Above the roundings of this sum.
    const double slack = 0x1p-50 * (std::fabs(site.x.mid) + reach);
    near_wall.push_back({g, site.x.mid - reach - slack, site.x.mid + reach + slack});
  }
  std::sort(near_wall.begin(), near_wall.end(),
            [](const Disk& a, const Disk& b) { return a.left < b.left; });
  for (std::size_t a = 0; a < near_wall.size(); ++a) {
    const double end = (near_wall[a].right + bound) + 0x1p-50 * std::fabs(near_wall[a].right);
    for (std::size_t b = a + 1; b < near_wall.size() && near_wall[b].left <= end; ++b) {
      candidates.insert(sorted(near_wall[a].id, near_wall[b].id));
    }
  }
  return closest_of(clearance, candidates);
}

}  // namespace voroproof::internal
