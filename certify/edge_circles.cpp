#include "certify/edge_circles.h"

#include <array>

namespace voroproof::internal {

EdgeCircles::EdgeCircles(const Motion& motion, const Quad& q, const DoubleBall& t) {
  // A disk as the base, as tangent_triple() takes it.
  const auto triple = [](GenId a, GenId b, GenId c) {
    return a == container_id ? std::array{b, c, a} : std::array{a, b, c};
  };
  const std::array<std::array<GenId, 3>, 2> ids{triple(q.l, q.s, q.r), triple(q.r, q.e, q.l)};
  const std::array<GenId, 2> other{q.e, q.s};
  for (int k = 0; k < 2; ++k) {
    with_container_[k] = ids[k][1] == container_id || ids[k][2] == container_id;
    other_is_container_[k] = other[k] == container_id;
  }
  const BallLanes time{splat(t.mid), splat(t.rad)};
  const auto site = [&](GenId start, GenId end) {
    const DoubleMotion &m = motion.doubles(start), &n = motion.doubles(end);
    return MotionLanes(m, n, m, n).site(time);
  };
  const TangentTriple<BallLanes> circle(site(ids[0][0], ids[1][0]), site(ids[0][1], ids[1][1]),
                                        site(ids[0][2], ids[1][2]), false);
  const InCircleParts<BallLanes> parts(circle, site(other[0], other[1]));
  g_ = parts.g();
  c_ = parts.c();
  along_ = circle.xp * circle.xs + circle.yp * circle.ys;
  across_ = circle.xy;
  difference_ = circle.xs * circle.xs + circle.ys * circle.ys - circle.xy * circle.xy;
}

Sign EdgeCircles::exists(int k) const {
  const Sign u = sign(along_, k), v = sign(across_, k);
  return sign_with_root(u, with_container_[k] ? -v : v, sign(difference_, k));
}

Sign EdgeCircles::in_circle(int k, Sign f) const {
  const Sign c = sign(c_, k);
  const Sign s = sign_with_root(sign(g_, k), with_container_[k] ? -c : c, f);
  return other_is_container_[k] ? -s : s;
}

}  // namespace voroproof::internal
