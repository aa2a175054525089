#include "filtered/search/hidden_disks.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <utility>

#include "filtered/motion/enclosures.h"

namespace voroproof::internal {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Box = bg::model::box<Point>;

// The box of a disk, made larger (out) or smaller by more than what its numbers are rounded by.
Box box_of(const DiskInput& d, bool out) {
  const double x = round_nearest(d.x), y = round_nearest(d.y), r = round_nearest(d.radius);
  const double off = (std::fabs(x) + std::fabs(y) + r) * 0x1p-50;
  const double half = out ? r + off : std::max(0.0, r - off);
  return {{x - half, y - half}, {x + half, y + half}};
}

}  // namespace

bool contains(const DiskInput& h, const DiskInput& g) {
  const Rational dx = h.x.value() - g.x.value(), dy = h.y.value() - g.y.value();
  const Rational dr = h.radius.value() - g.radius.value();
  return sgn(dr) >= 0 && dx * dx + dy * dy <= dr * dr;
}

bool is_outside(const MotionInput& input, const DiskInput& d) {
  const Rational dx = d.x.value() - input.container_x, dy = d.y.value() - input.container_y;
  const Rational most = input.container_radius + d.radius.value();
  return dx * dx + dy * dy >= most * most;
}

bool is_behind(const MotionInput& input, GenId wall, GenId g) {
  const Framed framed(Frame::box, static_cast<GenId>(input.disks.size()));
  const auto near = [&](GenId k) {
    const DiskInput& d = input.disks[k];
    return Site<DdBall>{dd_of(d.x), dd_of(d.y), dd_of(d.radius)};
  };
  const Sign s = sign(framed.tangency(near, g, wall));
  if (is_certain(s)) return s != Sign::positive;
  const auto at = [&](GenId k) {
    const DiskInput& d = input.disks[k];
    return Site<Rational>{d.x.value(), d.y.value(), d.radius.value()};
  };
  return sgn(framed.tangency(at, g, wall)) <= 0;
}

std::vector<GenId> hosts_of(const MotionInput& input, Frame frame) {
  const auto generators = static_cast<GenId>(input.disks.size());
  const GenId n = disk_count(frame, generators);
  std::vector<std::pair<Box, GenId>> boxes;
  boxes.reserve(n);
  for (GenId g = 0; g < n; ++g) boxes.emplace_back(box_of(input.disks[g], true), g);
  const bg::index::rtree<std::pair<Box, GenId>, bg::index::quadratic<16>> tree(boxes);
  std::vector<GenId> host(generators, visible_disk);
  // In the order of the tree: neighbours in the plane are neighbours in memory.
  for (const auto& entry : tree) {
    const GenId g = entry.second;
    const DiskInput& d = input.disks[g];
    if (frame == Frame::circle && is_outside(input, d)) {
      host[g] = container_id;
      continue;
    }
    for (GenId wall = n; wall < generators; ++wall) {
      if (is_behind(input, wall, g)) host[g] = wall;
    }
    if (host[g] != visible_disk) continue;
    const auto hides = [&](const std::pair<Box, GenId>& other) {
      const GenId h = other.second;
      if (h == g || !contains(input.disks[h], d)) return false;
      return h < g || !contains(d, input.disks[h]);
    };
    const auto found =
        tree.qbegin(bg::index::covers(box_of(d, false)) && bg::index::satisfies(hides));
    if (found != tree.qend()) host[g] = found->second;
  }
  // A disk that is hidden itself lies in a visible one, or outside of the frame.
  for (GenId g = 0; g < n; ++g) {
    while (host[g] >= 0 && host[host[g]] != visible_disk) host[g] = host[host[g]];
  }
  return host;
}

}  // namespace voroproof::internal
