#include "library/static_slopes.h"

#include <algorithm>

#include "exact/predicates.h"
#include "filtered/numbers/dd_ball.h"
#include "library/values.h"

namespace voroproof::internal {
namespace {

template <class T, class Number>
Site<T> site_of(const StaticDiagram& diagram, GenId g, const Number& number) {
  const auto& [c, r] = generator_of(diagram, g);
  return {number(c[0]), number(c[1]), number(r)};
}

// The sign of the cross product d x n, n the direction from the centre of `base` to the vertex, and
// d that from there to the centre of `other`, or if `turned` that a quarter turn clockwise from it,
// so that it is the scalar product. It is u + sqrt(Gamma) v by circle_direction().
template <class T, class Number>
Sign cross_sign(const StaticDiagram& diagram, const Triple& vertex, GenId base, GenId other,
                bool turned, const Number& number) {
  Triple v = vertex;
  while (v[0] != base) v = {v[1], v[2], v[0]};
  const auto site = [&](GenId g) { return site_of<T>(diagram, g, number); };
  const bool with_frame = v[1] == container_id || v[2] == container_id;
  const TangentTriple<T> t(site(base), site(v[1]), site(v[2]), with_frame);
  const Site<T> to = site(other);
  T x = to.x - t.base.x, y = to.y - t.base.y;
  if (turned) {
    std::swap(x, y);
    y = -y;
  }
  const T u = t.sp * (y * t.xp - x * t.yp), along = x * t.xp + y * t.yp;
  const T v_part = with_frame ? T(-along) : along;
  return sign_with_root(sign(u), sign(v_part), sign(T(u * u - gamma(t) * along * along)));
}

}  // namespace

Circle generator_of(const StaticDiagram& diagram, GenId g) {
  if (g != container_id) return diagram.disks()[g];
  return {diagram.frame()->center, -diagram.frame()->radius};
}

std::vector<ClearanceEdge> clearance_edges(const StaticDiagram& diagram) {
  const auto& vertices = diagram.vertices();
  const auto index = [&](const Triple& name) {
    const auto found =
        std::lower_bound(vertices.begin(), vertices.end(), name,
                         [](const Vertex& v, const Triple& t) { return v.generators < t; });
    const bool is_there = found != vertices.end() && found->generators == name;
    return is_there ? static_cast<int>(found - vertices.begin()) : ClearanceEdge::none;
  };
  std::vector<ClearanceEdge> edges;
  for (const Edge& e : diagram.edges()) {
    Quad q = quad(e);
    if (q.l == container_id) q = reversed(q);
    if (q.r == container_id && !diagram.frame()) continue;
    edges.push_back({q.l, q.r, index(start_vertex(q)), index(end_vertex(q))});
  }
  if (diagram.frame() && edges.empty()) {
    const std::vector<int>& hosts = diagram.hosts();
    const auto lone = std::find(hosts.begin(), hosts.end(), StaticDiagram::visible);
    const auto disk = static_cast<GenId>(lone - hosts.begin());
    if (lone != hosts.end()) edges.push_back({disk, container_id});
  }
  return edges;
}

Sign StaticSlopes::side(const ClearanceEdge& edge, bool at_end, bool turned) const {
  const Triple& vertex = diagram_.vertices()[at_end ? edge.end : edge.start].generators;
  const Sign s = cross_sign<DdBall>(diagram_, vertex, edge.disk, edge.other, turned,
                                    [](double x) { return DdBall(x); });
  if (is_certain(s)) return s;
  return cross_sign<Rational>(diagram_, vertex, edge.disk, edge.other, turned, to_rational);
}

bool StaticSlopes::rises(const ClearanceEdge& edge, bool at_end) const {
  const Sign s = at_end ? -side(edge, at_end, false) : side(edge, at_end, false);
  if (edge.other != container_id) return s != Sign::negative;
  return s == Sign::negative || (s == Sign::zero && side(edge, at_end, true) == Sign::negative);
}

bool StaticSlopes::is_level(const ClearanceEdge& edge) const {
  return edge.other == container_id &&
         diagram_.frame()->center == generator_of(diagram_, edge.disk).center;
}

// With the gate on it, too, the edge falls at one end, to the gate, and its other end is the lower
// one as seen from the far point: so the end that rises to the far point is the higher one.
bool StaticSlopes::has_far_point(const ClearanceEdge& edge) const {
  if (edge.other != container_id || is_level(edge)) return false;
  if (edge.start == ClearanceEdge::none) return true;
  const bool from_start = rises_from_start(edge), from_end = rises_from_end(edge);
  const auto& vertices = diagram_.vertices();
  const double start = vertices[edge.start].radius, end = vertices[edge.end].radius;
  return (from_start && (from_end || start > end)) || (from_end && end > start);
}

EmptyCircle StaticSlopes::far_point(const ClearanceEdge& edge) const {
  const Circle disk = generator_of(diagram_, edge.disk), frame = *diagram_.frame();
  const DdBall dx = DdBall(frame.center[0]) - DdBall(disk.center[0]),
               dy = DdBall(frame.center[1]) - DdBall(disk.center[1]);
  const DdBall between = sqrt(dx * dx + dy * dy), half(0.5);
  const DdBall reach = half * (DdBall(frame.radius) + DdBall(disk.radius) + between);
  const auto place = [&](double c, const DdBall& d) {
    return (DdBall(c) + d / between * reach).hi;
  };
  return {{place(disk.center[0], dx), place(disk.center[1], dy)},
          (half * (DdBall(frame.radius) - DdBall(disk.radius) + between)).hi,
          {container_id, edge.disk}};
}

}  // namespace voroproof::internal
