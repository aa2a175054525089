#include "library/box_border.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/predicates.h"
#include "filtered/numbers/dd_ball.h"
#include "library/diagram_geometry.h"

namespace voroproof::internal {
namespace {

// Less is not told apart, relative to the length of a side or to the largest number.
constexpr double least_distance = 0x1p-40;

Vec2 left_of(const Vec2& a) { return {-a[1], a[0]}; }

struct Candidate {
  Vec2 at;
  std::vector<GenId> generators;
  // Whether these are known to be nearest; where there are none the nearest one is to be found.
  bool is_known;
};

class Border {
 public:
  Border(const StaticDiagram& diagram, const Box& box) : diagram_(diagram), box_(box) {}

  std::vector<BorderPlace> places(const std::vector<ClearanceEdge>& edges) {
    add_corners();
    add_vertices();
    add_feet();
    for (const ClearanceEdge& edge : edges) {
      if (may_meet(edge)) add_crossings(edge);
    }
    return judged();
  }

 private:
  double low(int axis) const { return box_.low[axis]; }
  double high(int axis) const { return box_.high[axis]; }

  // Corners come first: a place near one of them is that corner.
  void add_corners() {
    for (const double x : {low(0), high(0)}) {
      for (const double y : {low(1), high(1)}) candidates_.push_back({{x, y}, {}, true});
    }
  }

  void add_vertices() {
    for (const Vertex& v : diagram_.vertices()) {
      const auto& g = v.generators;
      if (is_on_border(v.center)) candidates_.push_back({v.center, {g[0], g[1], g[2]}, true});
    }
  }
  bool is_on_border(const Vec2& p) const {
    bool is_on = false;
    for (const int axis : {0, 1}) {
      if (p[axis] < low(axis) || p[axis] > high(axis)) return false;
      is_on = is_on || p[axis] == low(axis) || p[axis] == high(axis);
    }
    return is_on;
  }

  // Along a side the distance to the frame is greatest where its centre is nearest.
  void add_feet() {
    if (!diagram_.frame()) return;
    const Vec2& c = diagram_.frame()->center;
    for (const int axis : {0, 1}) {
      if (c[1 - axis] < low(1 - axis) || c[1 - axis] > high(1 - axis)) continue;
      for (const double side : {low(axis), high(axis)}) {
        Vec2 foot = c;
        foot[axis] = side;
        candidates_.push_back({foot, {container_id}, false});
      }
    }
  }

  // Whether the edge is not all nearer to a disk's centre than the border is. Beside a disk it is
  // farthest from there at an end, beside the frame at the far point at most.
  bool may_meet(const ClearanceEdge& edge) const {
    const Circle disk = generator_of(diagram_, edge.disk),
                 other = generator_of(diagram_, edge.other);
    const bool at_frame = edge.other == container_id;
    const Circle& base = at_frame || disk.radius <= other.radius ? disk : other;
    double reach = std::numeric_limits<double>::infinity();
    if (at_frame) {
      reach = (disk.radius - other.radius + length(disk.center - other.center)) / 2;
    } else if (edge.start != ClearanceEdge::none && edge.end != ClearanceEdge::none) {
      const auto& vertices = diagram_.vertices();
      reach = std::max(vertices[edge.start].radius, vertices[edge.end].radius) + base.radius;
    }
    const Vec2& c = base.center;
    Vec2 out{};
    double inside = std::numeric_limits<double>::infinity(), size = std::fabs(base.radius);
    for (const int axis : {0, 1}) {
      out[axis] = std::max({0.0, low(axis) - c[axis], c[axis] - high(axis)});
      inside = std::min({inside, c[axis] - low(axis), high(axis) - c[axis]});
      size = std::max({size, std::fabs(c[axis]), std::fabs(low(axis)), std::fabs(high(axis))});
    }
    // The slack is far above what the sums are rounded by.
    return std::max(inside, length(out)) <= reach * (1 + 0x1p-40) + size * 0x1p-40;
  }

  void add_crossings(const ClearanceEdge& edge) {
    for (const int axis : {0, 1}) {
      for (const double side : {low(axis), high(axis)}) add_crossings(edge, axis, side);
    }
  }
  // In direction n from the centre c of its disk the whole bisector is p / (2 (d.n + s)) away
  // (library/edge_curves.cpp). So it meets the line x = X, with h = X - c_x, where A n_x + B n_y =
  // C, A = p - 2 h d_x, B = -2 h d_y and C = 2 h s: in at most two directions. In units of a power
  // of two nothing overflows.
  void add_crossings(const ClearanceEdge& edge, int axis, double side) {
    const Circle disk = generator_of(diagram_, edge.disk),
                 other = generator_of(diagram_, edge.other);
    const Vec2 c = disk.center, d = other.center - c;
    const double size = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(side - c[axis]),
                                  std::fabs(disk.radius), std::fabs(other.radius)});
    const int unit = size > 0 ? std::ilogb(size) : 0;
    const auto in_units = [&](double x) { return DdBall(std::ldexp(x, -unit)); };
    const auto difference = [&](double a, double b) { return in_units(a) - in_units(b); };
    const DdBall dx = difference(other.center[axis], c[axis]),
                 dy = difference(other.center[1 - axis], c[1 - axis]),
                 s = difference(other.radius, disk.radius), h = difference(side, c[axis]),
                 p = dx * dx + dy * dy - s * s, twice(2);
    const DdBall A = p - twice * h * dx, B = -(twice * h * dy), C = twice * h * s;
    const DdBall n2 = A * A + B * B, square = n2 - C * C;
    // Lines that are the bisector itself are met at vertices, or nowhere.
    if (sign(n2) != Sign::positive || sign(square) == Sign::negative) return;
    for (const DdBall& root : {sqrt(square), -sqrt(square)}) {
      const DdBall nx = (C * A - root * B) / n2, ny = (C * B + root * A) / n2;
      const DdBall rho = p / (twice * (dx * nx + dy * ny + s));
      if (!(rho.hi > 0)) continue;  // the other branch, or parallel
      add_crossing(edge, axis, side, std::ldexp((in_units(c[1 - axis]) + rho * ny).hi, unit));
    }
  }
  void add_crossing(const ClearanceEdge& edge, int axis, double side, double along) {
    const double from = low(1 - axis), to = high(1 - axis), slack = (to - from) * least_distance;
    if (!(along >= from - slack && along <= to + slack)) return;
    Vec2 at{};
    at[axis] = side;
    at[1 - axis] = std::clamp(along, from, to);
    candidates_.push_back({at, {edge.disk, edge.other}, false});
  }

  // How far along the border, counterclockwise from the low corner; a side is one long.
  double position(const Vec2& p) const {
    const double x = (p[0] - low(0)) / (high(0) - low(0)), y = (p[1] - low(1)) / (high(1) - low(1));
    if (p[1] == low(1)) return x;
    if (p[0] == high(0)) return 1 + y;
    if (p[1] == high(1)) return 3 - x;
    return y > least_distance ? 4 - y : 0;
  }

  // Those that are near to each other as one, which touches what any of them does.
  std::vector<BorderPlace> judged() {
    std::vector<Vector> points;
    for (const Candidate& c : candidates_) points.push_back(c.at);
    const std::vector<Nearest> nearest = diagram_.nearest(points);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      auto& [at, generators, is_known] = candidates_[k];
      if (generators.empty()) generators = {nearest[k].generator};
      if (!is_known && !touches(at, generators[0], nearest[k].distance)) continue;
      order.emplace_back(position(candidates_[k].at), k);
    }
    std::sort(order.begin(), order.end());
    std::vector<BorderPlace> all;
    for (std::size_t k = 0; k < order.size();) {
      const std::size_t first = k;
      std::size_t chosen = order[k].second;
      std::vector<GenId> touched;
      for (; k < order.size() && order[k].first - order[first].first <= least_distance; ++k) {
        chosen = std::min(chosen, order[k].second);
        const auto& more = candidates_[order[k].second].generators;
        touched.insert(touched.end(), more.begin(), more.end());
      }
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      const Vec2& at = candidates_[chosen].at;
      all.push_back({{at, nearest[chosen].distance, touched}, is_greatest(at, touched)});
    }
    return all;
  }

  // Whether no other generator is nearer, but for what the place is rounded by.
  bool touches(const Vec2& at, GenId g, double clearance) const {
    const auto& [c, r] = generator_of(diagram_, g);
    const double far = length(at - c), distance = (g == container_id ? -far : far) - r;
    return distance - clearance <= (far + std::fabs(r)) * least_distance;
  }

  // A generator whose distance, by its slope, does not rise in a direction ends all rise there.
  // Where the slope is zero that from a disk rises nevertheless, and that to the frame falls.
  struct Slope {
    Vec2 slope;
    bool is_frame;
  };
  static bool rises(const std::vector<Slope>& slopes, const Vec2& u) {
    return std::all_of(slopes.begin(), slopes.end(), [&](const Slope& s) {
      const double rise = dot(s.slope, u);
      return rise > 0 || (rise == 0 && !s.is_frame);
    });
  }

  // The least of several slopes is greatest in the direction of one of them, where two are equal,
  // or along a side.
  bool is_greatest(const Vec2& at, const std::vector<GenId>& touched) const {
    std::vector<Slope> slopes;
    for (const GenId g : touched) {
      const bool is_frame = g == container_id;
      Vec2 away = at - generator_of(diagram_, g).center;
      const double size = std::max(std::fabs(away[0]), std::fabs(away[1]));
      if (size > 0) {
        away = (1 / size) * away;
        away = (1 / std::sqrt(dot(away, away))) * away;
      }
      slopes.push_back({is_frame ? -1 * away : away, is_frame});
    }
    std::vector<Vec2> inwards, directions;
    for (const int axis : {0, 1}) {
      Vec2 n{};
      n[axis] = at[axis] == low(axis) ? 1 : -1;
      if (at[axis] == low(axis) || at[axis] == high(axis)) inwards.push_back(n);
    }
    for (const Vec2& n : inwards)
      directions.insert(directions.end(), {left_of(n), -1 * left_of(n)});
    for (const Slope& a : slopes) {
      directions.push_back(a.slope);
      for (const Slope& b : slopes) directions.push_back(left_of(a.slope - b.slope));
    }
    return std::none_of(directions.begin(), directions.end(), [&](const Vec2& u) {
      const bool is_in_box = std::all_of(inwards.begin(), inwards.end(),
                                         [&](const Vec2& n) { return dot(n, u) >= 0; });
      return is_in_box && dot(u, u) > 0 && rises(slopes, u);
    });
  }

  const StaticDiagram& diagram_;
  Box box_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<BorderPlace> border_places(const StaticDiagram& diagram,
                                       const std::vector<ClearanceEdge>& edges, const Box& box) {
  return Border(diagram, box).places(edges);
}

}  // namespace voroproof::internal
