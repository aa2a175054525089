#include "library/queries/lines.h"

#include "filtered/search/instant_predicates.h"

namespace voroproof::internal {
namespace {

using P = Polynomial<Rational>;

}  // namespace

Lines::Lines(const Paths& paths, const std::set<GenId>& generators, const Rational& start)
    : start_(start) {
  local_[container_id] = container_id;
  const RecordedState& container = paths.piece(container_id, start);
  input_.container_x = container.center[0];
  input_.container_y = container.center[1];
  input_.container_radius = -paths.signed_radius(container_id);
  for (const GenId g : generators) {
    const RecordedState& piece = paths.piece(g, start);
    const auto coordinate = [&](int axis) {
      const Rational& v = piece.velocity[axis];
      return P{Rational(piece.center[axis] - v * piece.since), v};
    };
    lines_[g] = {coordinate(0), coordinate(1), paths.signed_radius(g)};
    if (g == container_id) continue;
    local_[g] = static_cast<GenId>(global_.size());
    global_.push_back(g);
    const ExactVec2 p = position_at(piece, start);
    input_.disks.push_back(
        {p[0], p[1], paths.signed_radius(g), piece.velocity[0], piece.velocity[1], 1});
  }
}

P Lines::gate(GenId i, GenId j, const Rational& probe) const {
  const Line &a = lines_.at(i), &b = lines_.at(j);
  const P x = a.x - b.x, y = a.y - b.y;
  const Rational reach = a.radius + b.radius + 2 * probe;
  return x * x + y * y - P{reach * reach};
}

P Lines::vertex(const Triple& v, const Rational& probe) const {
  const Line &a = lines_.at(v[0]), &b = lines_.at(v[1]), &c = lines_.at(v[2]);
  const P bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const Rational ra = a.radius + probe, rb = b.radius + probe, rc = c.radius + probe;
  // The centre y, from that of a: 2 y.b = eb and 2 y.c = ec, and y.y = ra^2.
  const P eb = bx * bx + by * by + P{ra * ra - rb * rb};
  const P ec = cx * cx + cy * cy + P{ra * ra - rc * rc};
  const P u = eb * cy - ec * by, w = bx * ec - cx * eb;
  const P det = bx * cy - by * cx;
  return u * u + w * w - det * det * Rational(4 * ra * ra);
}

std::vector<Lines::Fit> Lines::along(const Quad& q, const Rational& t,
                                     const Rational& probe) const {
  const ComputedMotion motion(input_, {});
  TierCounts counts;
  InstantPredicates predicates(motion, Rational(t - start_), counts, {probe});
  const Quad own{local_.at(q.l), local_.at(q.r), local_.at(q.s), local_.at(q.e)};
  const bool ring = q.s == q.l;
  const std::vector<ClearanceNode> nodes =
      ring ? std::vector<ClearanceNode>{gate_node(own.l, own.r), far_node(own.l)}
           : edge_profile(predicates, own);
  std::vector<Fit> all;
  for (ClearanceNode node : nodes) {
    const bool fits = clearance_to_probe(predicates, node, 0) != Sign::negative;
    for (GenId& g : node.generators) {
      if (g != container_id) g = global_[g];
    }
    all.push_back({node, fits});
  }
  return all;
}

bool Lines::fits(const Triple& v, const Rational& t, const Rational& probe) const {
  const ComputedMotion motion(input_, {});
  TierCounts counts;
  InstantPredicates predicates(motion, Rational(t - start_), counts, {probe});
  const Triple own{local_.at(v[0]), local_.at(v[1]), local_.at(v[2])};
  return clearance_to_probe(predicates, vertex_node(own), 0) != Sign::negative;
}

}  // namespace voroproof::internal
