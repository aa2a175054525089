#include "engine/world/moving_edge.h"

#include <array>

#include "filtered/search/collapse.h"

namespace voroproof::internal {
namespace {

Quad from_disk(const Quad& q) { return q.l == container_id ? reversed(q) : q; }

}  // namespace

template <class T>
RootExpression<T> MovingEdge::expression(const EdgeEnds<T>& ends, Which which) {
  switch (which) {
    case Which::conflict_at_start:
      return ends.conflict_at_start();
    case Which::conflict_at_end:
      return ends.conflict_at_end();
    default:
      return ends.same_circle();
  }
}

MovingEdge::MovingEdge(const MovingRows& rows, const Quad& q)
    : rows_(rows),
      quad_(from_disk(q)),
      ends_(rows.site(quad_.l), rows.row_of(quad_.l, quad_.s), rows.row_of(quad_.l, quad_.r),
            rows.row_of(quad_.l, quad_.e)),
      f_(ends_.a * ends_.a + ends_.b * ends_.b - ends_.c * ends_.c),
      is_square_((ends_.a.is_zero() && ends_.b.is_zero()) || f_.is_zero()) {}

Sign MovingEdge::sign_of(Which which, Sign f, const WorldTime& t,
                         const std::optional<EdgeEnds<Ball>>& near) const {
  const bool by_f = which != Which::same_circle && f != Sign::unknown && f != Sign::zero;
  if (near) {
    const RootExpression<Ball> x = expression(*near, which);
    const Sign s =
        by_f ? (f == Sign::positive ? x.u : x.v).sign() : (x.u + sqrt(x.gamma) * x.v).sign();
    if (is_certain(s)) return s;
  }
  const RootExpression<TimePolynomial> x = expression(ends_, which);
  if (by_f) return sign_after(f == Sign::positive ? x.u : x.v, t);
  const Sign u = sign_after(x.u, t), v = sign_after(x.v, t);
  if (which != Which::same_circle) return sign_with_root(u, v, f);
  return u == v ? u : sign_with_root(u, v, sign_after(x.u * x.u - x.gamma * x.v * x.v, t));
}

bool MovingEdge::has_inner_touch(const WorldTime& t, const Ball& about) const {
  const std::array<GenId, 4> all{quad_.l, quad_.r, quad_.s, quad_.e};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < i; ++j) {
      if (all[i] == all[j]) continue;
      const TimePolynomial p = rows_.tangency_of(all[i], all[j]);
      if (is_certain(value(p, about).sign())) continue;
      if (sign_at(p, t) == Sign::zero) return true;
    }
  }
  return false;
}

// The sign of u + sqrt(gamma) v at the instant itself, where gamma may vanish.
Sign MovingEdge::sign_then(Which which, const WorldTime& t) const {
  const RootExpression<TimePolynomial> x = expression(ends_, which);
  const Sign u = sign_at(x.u, t), v = sign_at(x.v, t);
  if (u == v) return u;
  const Sign d = sign_at(x.u * x.u - x.gamma * x.v * x.v, t);
  return d == Sign::zero ? Sign::zero : sign_with_root(u, v, d);
}

// Circles and in-circle functions are continuous, also where Gamma vanishes. So at a point, whose
// two circles are one that touches all four, both functions vanish. Two edges between l and r that
// lead from s to e and from e to s have one polynomial: only this tells which of them has no
// length.
bool MovingEdge::may_be_point_at(const WorldTime& t) const {
  return sign_then(Which::conflict_at_start, t) == Sign::zero &&
         sign_then(Which::conflict_at_end, t) == Sign::zero &&
         sign_then(Which::same_circle, t) != Sign::negative;
}

bool MovingEdge::is_illegal_after(const WorldTime& t) const {
  const Sign f = is_square_ ? (f_.is_zero() ? Sign::zero : Sign::negative) : sign_after(f_, t);
  return sign_of(Which::conflict_at_start, f, t, std::nullopt) == Sign::negative ||
         sign_of(Which::conflict_at_end, f, t, std::nullopt) == Sign::negative;
}

bool MovingEdge::collapses_at(const WorldTime& t, Sign after) const {
  const Ball at = ball_about(t);
  const auto row = [&](GenId g) { return rows_.row_of(quad_.l, g, at); };
  const std::optional<EdgeEnds<Ball>> near(std::in_place, rows_.site(quad_.l, at), row(quad_.s),
                                           row(quad_.r), row(quad_.e));
  const auto certainly_outside = [&](Which which) {
    const RootExpression<Ball> x = expression(*near, which);
    return (x.u + sqrt(x.gamma) * x.v).sign() == Sign::positive;
  };
  if (certainly_outside(Which::conflict_at_start) || certainly_outside(Which::conflict_at_end)) {
    return false;
  }
  const bool known = after != Sign::unknown;
  const Sign f = is_square_ ? (f_.is_zero() ? Sign::zero : Sign::negative)
                 : known    ? after
                            : sign_after(f_, t);
  const auto conflict = [&](Which which) {
    return is_square_ && known && f == Sign::negative ? after : sign_of(which, f, t, near);
  };
  const Sign start = conflict(Which::conflict_at_start), end = conflict(Which::conflict_at_end);
  if (start == Sign::positive || end == Sign::positive) return false;
  const bool tie = start == Sign::zero && end == Sign::zero;
  if (tie ? legal_while_cotangent(quad_) : start == Sign::zero || end == Sign::zero) return false;
  if (!tie && has_inner_touch(t, at)) return sign_then(Which::same_circle, t) != Sign::negative;
  return sign_of(Which::same_circle, f, t, near) == Sign::positive;
}

}  // namespace voroproof::internal
