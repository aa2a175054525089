// The predicates of a V-edge [l,r,s,e], at sites l, r, s, e of any number type.
#pragma once

#include <array>

#include "exact/dual.h"
#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// The generators of q at t, in the order l, r, s, e.
template <class T>
std::array<Site<T>, 4> sites(const Motion& m, const Quad& q, const T& t) {
  return {m.site(q.l, t), m.site(q.r, t), m.site(q.s, t), m.site(q.e, t)};
}

// The sites of q's generators, with their velocities as slopes.
template <class T>
std::array<Site<Dual<T>>, 4> moving_sites(const Motion& motion, const Quad& q, const T& t) {
  std::array<Site<Dual<T>>, 4> out;
  const GenId ids[4] = {q.l, q.r, q.s, q.e};
  for (int k = 0; k < 4; ++k) {
    const MovingSite<T> m = motion.moving_site(ids[k], t);
    out[k] = {{m.x, m.vx}, {m.y, m.vy}, {m.r, T()}};
  }
  return out;
}

// The tangent triple of three generators given counterclockwise, a disk taken as its base.
template <class T>
TangentTriple<T> tangent_triple(GenId a, const Site<T>& sa, GenId b, const Site<T>& sb, GenId c,
                                const Site<T>& sc) {
  if (a == container_id) return {sb, sc, sa, true};
  return {sa, sb, sc, b == container_id || c == container_id};
}

// The triples of both ends of an edge.
template <class T>
struct EdgeTriples {
  TangentTriple<T> start, end;  // (l,s,r) and (r,e,l)
  static EdgeTriples of(const Quad& q, const std::array<Site<T>, 4>& at) {
    return {tangent_triple(q.l, at[0], q.s, at[2], q.r, at[1]),
            tangent_triple(q.r, at[1], q.e, at[3], q.l, at[0])};
  }
};

// Whether the contact points of r, e, l follow each other counterclockwise (positive) or not
// (negative), for an edge whose start circle touches e too. Only in that order are both circles of
// the edge one, and the edge a point. Two circles may touch all four and the edge lead from one to
// the other: mirror images in pairs are always such. The sites may be given over an interval.
template <class T>
Sign contact_order(const Quad& q, const std::array<Site<T>, 4>& at) {
  const ContactDirections<T> contacts(EdgeTriples<T>::of(q, at).start);
  std::array<T, 2> direction[3];
  for (int k = 0; k < 3; ++k) direction[k] = contacts.of(at[k == 0 ? 1 : k == 1 ? 3 : 0]);
  const auto& [r, e, l] = direction;
  return sign(T((e[0] - r[0]) * (l[1] - r[1]) - (e[1] - r[1]) * (l[0] - r[0])));
}

// The fate of the edge at an isolated root, seen from a time just after it.
enum class Judgement { collapses, stays, unknown };

// Reads the verdict off the signs just after the root. Circles that certainly do not exist make an
// edge that is no longer there; whether they do need not be known: the circles of an edge of the
// diagram exist for as long as it is one (docs/certificate.md, section 6).
template <class T, class SitesAfter>
Judgement judge(const Quad& q, const std::array<Site<T>, 4>& at_hull, SitesAfter&& sites_after,
                Sign f_after) {
  const EdgeTriples<T> hull = EdgeTriples<T>::of(q, at_hull);
  if (circle_exists(hull.start) == Sign::negative || circle_exists(hull.end) == Sign::negative) {
    return Judgement::stays;
  }
  const auto in_start = [&](const EdgeTriples<T>& t, const std::array<Site<T>, 4>& at) {
    return incircle(t.start, at[3], q.e == container_id, f_after);
  };
  const auto in_end = [&](const EdgeTriples<T>& t, const std::array<Site<T>, 4>& at) {
    return incircle(t.end, at[2], q.s == container_id, f_after);
  };
  // Near the root of a generic quadruplet the factor that decides is far from zero,
  // so the hull will do; equal radii need the time after the root.
  Sign a = in_start(hull, at_hull);
  Sign b = in_end(hull, at_hull);
  if (a == Sign::unknown || b == Sign::unknown) {
    if (!keeps_tangencies(at_hull)) return Judgement::unknown;
    const std::array<Site<T>, 4> at_after = sites_after();
    const EdgeTriples<T> after = EdgeTriples<T>::of(q, at_after);
    a = in_start(after, at_after);
    b = in_end(after, at_after);
  }
  if (a == Sign::positive || b == Sign::positive) return Judgement::stays;
  if (a == Sign::negative && b == Sign::negative) return Judgement::collapses;
  return Judgement::unknown;
}

}  // namespace voroproof::internal
