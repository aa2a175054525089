#include "engine/resting_diagram.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <utility>

#include "engine/legalize.h"
#include "filtered/motion/given_motion.h"
#include "filtered/search/edge_predicates.h"

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

// By disk: visible, or one that hides it.
std::vector<GenId> hosts(const MotionInput& input, Frame frame) {
  const auto n = static_cast<GenId>(input.disks.size());
  std::vector<std::pair<Box, GenId>> boxes;
  boxes.reserve(n);
  for (GenId g = 0; g < n; ++g) boxes.emplace_back(box_of(input.disks[g], true), g);
  const bg::index::rtree<std::pair<Box, GenId>, bg::index::quadratic<16>> tree(boxes);
  std::vector<GenId> host(n, RestingDiagram::visible);
  for (GenId g = 0; g < n; ++g) {
    const DiskInput& d = input.disks[g];
    if (frame == Frame::circle && is_outside(input, d)) {
      host[g] = container_id;
      continue;
    }
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
    while (host[g] >= 0 && host[host[g]] != RestingDiagram::visible) host[g] = host[host[g]];
  }
  return host;
}

// At rest, generators that touch one circle do so for ever. Then the one of largest id is thought
// of as infinitely little larger than it is.
class RestingEdges {
 public:
  RestingEdges(const Motion& motion, Frame frame) : motion_(motion), frame_(frame) {}

  // Whether the rule wants another edge in the place of this one, both circles of which are one.
  bool is_illegal(const Quad& q) const {
    const bool has_largest = std::max(q.s, q.e) < std::max(q.l, q.r);
    return !has_largest && !certainly_apart(q) && is_point(q);
  }

 private:
  bool is_infinity(GenId g) const { return frame_ == Frame::plane && g == container_id; }

  // Whether doubles prove that no circle touches all four.
  bool certainly_apart(const Quad& q) const {
    const DoubleBall now(0.0);
    std::array<GenId, 4> g{q.l, q.r, q.s, q.e};
    const auto infinite = std::find_if(g.begin(), g.end(), [&](GenId k) { return is_infinity(k); });
    if (infinite != g.end()) std::swap(*infinite, g[3]);
    std::array<Site<DoubleBall>, 4> at;
    for (int k = 0; k < 4; ++k) at[k] = motion_.site(g[k], now);
    if (infinite == g.end()) return is_certain(sign(cotangency(at[0], at[1], at[2], at[3])));
    return is_certain(sign(
        cotangency_of(tangency(at[0], at[1]), tangency(at[0], at[2]), tangency(at[1], at[2]))));
  }

  // A generator seen from a disk, exactly; the sign of the row is such that p is positive.
  GeneratorRow<Rational> row_of(GenId base, GenId g) const {
    if (is_infinity(g)) return {0, 0, 0, 1};
    const GeneratorRow<Rational> r = row(exact(base), exact(g));
    return g == container_id ? GeneratorRow<Rational>{-r.x, -r.y, -r.s, -r.p} : r;
  }
  Site<Rational> exact(GenId g) const {
    const MotionInput& input = motion_.input();
    if (g == container_id) {
      return {input.container_x, input.container_y, Rational(-input.container_radius)};
    }
    const DiskInput& d = input.disks[g];
    return {d.x.value(), d.y.value(), d.radius.value()};
  }

  // Whether both circles of the edge are one. Seen from a disk, l or r, they touch this disk and
  // the first two or the last two of three others. With the rows of all kinds of generators of one
  // sign the in-circle function is G + sqrt(Gamma) C; it vanishes where both touch the same four.
  // They are one where from the first the contacts with the disk and with the last two are
  // counterclockwise.
  bool is_point(const Quad& q) const {
    const bool turned = q.l == container_id;
    const GenId base = turned ? q.r : q.l;
    const GeneratorRow<Rational> a = row_of(base, turned ? q.e : q.s),
                                 b = row_of(base, turned ? q.l : q.r),
                                 c = row_of(base, turned ? q.s : q.e);
    const Site<Rational> origin = exact(base);
    const TangentTriple<Rational> m(origin, a, b, false), n(origin, b, c, false);
    const InCircleParts<Rational> parts(m, c);
    const Rational A = c.x * m.sp - c.s * m.xp + c.p * m.xs,
                   B = c.y * m.sp - c.s * m.yp + c.p * m.ys, C = parts.c();
    const Sign f = sign(Rational(A * A + B * B - C * C));
    if (sign_with_root(sign(parts.g()), sign(C), f) != Sign::zero) return false;
    const Rational x = -m.sp * (n.xp * m.yp - n.yp * m.xp), y = n.xp * m.xp + n.yp * m.yp;
    return sign_with_root(sign(x), sign(y), sign(Rational(x * x - gamma(m) * y * y))) ==
           Sign::positive;
  }

  const Motion& motion_;
  Frame frame_;
};

}  // namespace

RestingDiagram resting_diagram(const MotionInput& input, Frame frame, const MotionOptions& options,
                               TierCounts& counts) {
  RestingDiagram out{hosts(input, frame), {}};
  std::vector<GenId> names;  // the visible disks
  MotionInput seen = input;
  seen.disks.clear();
  for (GenId g = 0; g < static_cast<GenId>(out.host.size()); ++g) {
    if (out.host[g] != RestingDiagram::visible) continue;
    names.push_back(g);
    seen.disks.push_back(input.disks[g]);
  }
  if (names.size() < 2) return out;
  const GivenMotion motion(std::move(seen), options);
  Diagram diagram = overlapping_diagram(motion, frame, counts);
  const RestingEdges edges(motion, frame);
  legalize(diagram, [&](const Quad& q) { return edges.is_illegal(q); });
  const auto name = [&](GenId g) { return g == container_id ? g : names[g]; };
  for (const Quad& q : diagram.quads()) {
    out.edges.push_back({name(q.l), name(q.r), name(q.s), name(q.e)});
  }
  return out;
}

}  // namespace voroproof::internal
