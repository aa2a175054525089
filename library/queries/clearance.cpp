#include "library/queries/clearance.h"

#include <optional>
#include <utility>

#include "filtered/search/framed.h"

namespace voroproof::internal {
namespace {

const Framed framed(Frame::circle);

// Twice the clearance at a node: of a gate the gap.
template <class Sites, class Root>
auto twice_clearance(Sites& at, Root& root, const ClearanceNode& node) {
  const auto [i, j, k] = node.generators;
  using T = std::decay_t<decltype(at(i).x)>;
  if (node.kind == ClearanceNode::Kind::vertex) {
    const T rho = tangent_circle(framed.triple(at, i, j, k), root)[2];
    return T(rho + rho);
  }
  const auto a = at(i), b = at(j);
  const T dx = b.x - a.x, dy = b.y - a.y;
  const T d = root(T(dx * dx + dy * dy));
  if (node.kind == ClearanceNode::Kind::far) return T(d - b.r - a.r);
  return j == container_id ? T(-b.r - a.r - d) : T(d - a.r - b.r);
}

bool in_the_centre(InstantPredicates& predicates, GenId disk) {
  return predicates.sign_of([&](auto at, auto) {
    const auto a = at(disk), b = at(container_id);
    const auto dx = a.x - b.x, dy = a.y - b.y;
    return decltype(a.x)(dx * dx + dy * dy);
  }) == Sign::zero;
}

}  // namespace

ClearanceNode gate_node(GenId a, GenId b) {
  if (a == container_id || (b != container_id && b < a)) std::swap(a, b);
  return {ClearanceNode::Kind::gate, {a, b, b}};
}

Clearance::Clearance(const Motion& motion, const Rational& t, const Diagram& diagram,
                     const Rational& probe, TierCounts& counts)
    : diagram_(diagram), probe_(probe), predicates_(motion, t, counts, {probe}) {}

std::vector<ClearanceNode> edge_profile(InstantPredicates& predicates, const Quad& q) {
  std::vector<ClearanceNode> nodes{vertex_node(start_vertex(q))};
  // Seen from the base, the edge runs counterclockwise where that lies on its left.
  const bool left = q.l != container_id;
  const GenId base = left ? q.l : q.r, other = left ? q.r : q.l;
  const bool wall = other == container_id;
  // Whether the edge passes x on its way between two other directions, as seen from the base.
  enum { start, end, gate, far };
  const auto between = [&](int from, int to, int x) {
    return predicates.decide([&](auto at, auto root) {
      using T = std::decay_t<decltype(at(base).x)>;
      const auto direction = [&](int which) -> Direction<T> {
        if (which == start) {
          return left ? framed.direction(at, root, base, q.s, q.r)
                      : framed.direction(at, root, base, q.l, q.s);
        }
        if (which == end) {
          return left ? framed.direction(at, root, base, q.r, q.e)
                      : framed.direction(at, root, base, q.e, q.l);
        }
        const auto a = at(base), b = at(other);
        return wall == (which == gate) ? Direction<T>{a.x - b.x, a.y - b.y}
                                       : Direction<T>{b.x - a.x, b.y - a.y};
      };
      return on_arc<T>(direction(left ? from : to), direction(left ? to : from), direction(x),
                       false);
    });
  };
  if (!wall || !in_the_centre(predicates, base)) {
    const bool has_gate = between(start, end, gate);
    const bool has_far = wall && between(start, end, far);
    const bool gate_first = has_gate && has_far && between(start, far, gate);
    if (has_gate && (!has_far || gate_first)) nodes.push_back(gate_node(base, other));
    if (has_far) nodes.push_back(far_node(base));
    if (has_gate && has_far && !gate_first) nodes.push_back(gate_node(base, other));
  }
  nodes.push_back(vertex_node(end_vertex(q)));
  return nodes;
}

Sign clearance_to_probe(InstantPredicates& predicates, const ClearanceNode& node,
                        std::size_t probe) {
  return predicates.sign_of([&](auto at, auto root) {
    const auto value = twice_clearance(at, root, node);
    return decltype(value)(value - at.constant(probe) - at.constant(probe));
  });
}

std::vector<ClearanceNode> Clearance::ring_profile() {
  const ClearanceNode gate = gate_node(0, container_id);
  if (in_the_centre(predicates_, 0)) return {gate};
  return {gate, far_node(0), gate};
}

Sign Clearance::compare(const ClearanceNode& a, const ClearanceNode& b) {
  if (a == b) return Sign::zero;
  return predicates_.sign_of([&](auto at, auto root) {
    const auto first = twice_clearance(at, root, a);
    return decltype(first)(first - twice_clearance(at, root, b));
  });
}

Enclosure Clearance::value(const ClearanceNode& node) const {
  const Ball twice =
      predicates_.ball([&](auto at, auto root) { return twice_clearance(at, root, node); });
  return enclosure(twice * Ball(Rational(1, 2), 2));
}

}  // namespace voroproof::internal
