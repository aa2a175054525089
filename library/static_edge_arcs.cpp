// The edges of a diagram of disks at rest as arcs in a box.
#include <algorithm>
#include <cmath>
#include <limits>

#include "library/box_parts.h"
#include "library/diagram_arcs.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

// Rational curves of doubles in the box, from arcs relative to the origin of their chain.
class RoundedArcs {
 public:
  RoundedArcs(const Box& box, const Vec2& origin, double unit)
      : box_(box), origin_(origin), unit_(unit) {}

  void append(const ConicArc& arc, double excess, std::vector<Arc>& out, int halvings = 16) const {
    if (halvings == 0 || (arc.is_proper() ? is_moderate(arc) : !arc.has_proper_ends())) {
      out.push_back(rounded(arc, excess));
    } else {
      for (const ConicArc& half : arc.halves()) append(half, excess, out, halvings - 1);
    }
  }

 private:
  // Less than a quarter turn, and of a weight from 1/2 to 1.33.
  static bool is_moderate(const ConicArc& arc) {
    if (arc.is_straight()) return true;
    const std::array<BallPoint, 3> p = arc.points();
    return std::fabs(arc.roundness().mid) <= 0.75 && dot(p[1] - p[0], p[2] - p[1]).mid >= 0;
  }

  // With u and v the true and the rounded control points, a point of the curve is a mean of these,
  // so that it moves as they do at most; with the weight it moves by at most its change times the
  // longer leg, since for weights > 0 the middle one's share changes by less than that.
  Arc rounded(const ConicArc& arc, double excess) const {
    const DoubleBall weight =
        arc.is_straight() ? DoubleBall(1) : sqrt(DoubleBall(1) - arc.roundness());
    const std::array<BallPoint, 3> p = arc.points();
    std::array<Vector, 3> at;
    double error = 0;
    for (int k = 0; k < 3; ++k) {
      const DoubleBall x = p[k].x + DoubleBall(origin_[0]), y = p[k].y + DoubleBall(origin_[1]);
      at[k] = {x.mid, y.mid};
      if (k != 1) at[k] = clamped(at[k]);
      const double moved = std::fabs(at[k][0] - x.mid) + std::fabs(at[k][1] - y.mid);
      error = std::max(error, x.rad + y.rad + moved);
    }
    if (arc.is_straight()) {
      for (const int axis : {0, 1}) {
        at[1][axis] = (at[0][axis] + at[2][axis]) / 2;
        error += std::fabs(at[1][axis]) * 0x1p-52;
      }
    }
    const auto leg = [&](int k) {
      return std::fabs(at[k][0] - at[1][0]) + std::fabs(at[k][1] - at[1][1]) + 2 * error;
    };
    error += weight.rad * std::max(leg(0), leg(2)) + excess;
    for (Vector& v : at) v = {v[0] * unit_, v[1] * unit_};
    error *= unit_ * (1 + 0x1p-40);
    if (std::isfinite(error)) return {at[0], at[1], at[2], weight.mid, error};
    return {at[0], at[1], at[2], 1, std::numeric_limits<double>::infinity()};
  }

  Vector clamped(const Vector& v) const {
    return {std::clamp(v[0], box_.low[0], box_.high[0]),
            std::clamp(v[1], box_.low[1], box_.high[1])};
  }

  const Box& box_;
  const Vec2& origin_;
  double unit_;
};

// The parts of one arc of a chain in the box; neighbours are one.
void append_inside(const ConicArc& arc, const BallBox& box, const RoundedArcs& rounded,
                   std::vector<Arc>& out) {
  const std::vector<BoxPart> parts = box_parts(arc, box);
  for (std::size_t k = 0; k < parts.size();) {
    double excess = 0;
    const std::size_t first = k;
    for (; k < parts.size() && parts[k].kind != BoxPart::Kind::outside; ++k) {
      excess = std::max(excess, parts[k].excess);
    }
    // Two parts that are unclear, side by side, are a touch of the box.
    if (k > first) rounded.append(arc.part(parts[first].from, parts[k - 1].to), excess, out);
    if (k < parts.size()) ++k;
  }
}

std::vector<Arc> arcs_of(const ArcChain& chain, const DiagramArcs& arcs) {
  const BallBox box(arcs.box(), chain.origin);
  const RoundedArcs rounded(arcs.box(), chain.origin, arcs.unit());
  std::vector<Arc> all;
  for (const ConicArc& arc : chain.arcs) append_inside(arc, box, rounded, all);
  return all;
}

// Puts an end that is a vertex but for rounding there, so that the edges of a vertex meet.
void put(Vector& end, double error, const Triple& name, const std::vector<Vertex>& vertices) {
  const auto found =
      std::lower_bound(vertices.begin(), vertices.end(), name,
                       [](const Vertex& v, const Triple& t) { return v.generators < t; });
  if (found == vertices.end() || found->generators != name) return;
  const Vector& at = found->center;
  if (std::fabs(at[0] - end[0]) + std::fabs(at[1] - end[1]) <= error) end = at;
}

}  // namespace
}  // namespace internal

std::vector<std::vector<Arc>> StaticDiagram::arcs(const Box& box) const {
  internal::require_area(box);
  const internal::DiagramArcs edges(*this, box);
  std::vector<std::vector<Arc>> all;
  all.reserve(edges_.size());
  for (const internal::Quad& q : edges.edges()) {
    std::vector<Arc> chain = internal::arcs_of(edges.chain(q), edges);
    if (!chain.empty()) {
      Arc &first = chain.front(), &last = chain.back();
      internal::put(first.start, first.error, internal::start_vertex(q), vertices());
      internal::put(last.end, last.error, internal::end_vertex(q), vertices());
      if (edges_[all.size()].l != q.l) {  // turned, since its left one is the frame
        std::reverse(chain.begin(), chain.end());
        for (Arc& arc : chain) std::swap(arc.start, arc.end);
      }
    }
    all.push_back(std::move(chain));
  }
  return all;
}

}  // namespace voroproof
