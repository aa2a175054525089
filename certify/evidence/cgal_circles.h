// Generators at one rational time: the circle that touches three of them, and where a fourth lies
// to it. The circle is constructed by CGAL over numbers a + b sqrt(c), exactly; where the fourth
// lies is asked of that circle and of the vertex conflict predicate of CGAL's Apollonius graph. For
// evidence.cpp alone.
#pragma once

#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Root_of_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <stdexcept>

#include "certify/evidence/cgal_motion.h"

namespace voroproof::internal::cgal {

using Kernel = CGAL::Simple_cartesian<Gmpq>;
using Root = CGAL::Root_of_traits<Gmpq>::Root_of_2;
using RootKernel = CGAL::Simple_cartesian<Root>;
// Ring operations and signs only: no square roots, no divisions.
using ApolloniusTraits =
    CGAL::Apollonius_graph_traits_2<Kernel, CGAL::Integral_domain_without_division_tag>;

// It touches disks from outside and the container from inside.
struct TangentCircle {
  Root x, y, radius;

  // From its centre to the centre of a generator that it touches.
  Root reach(const Circle& g) const { return radius + g.r; }
};

// Whether the contacts with the three run counterclockwise in this order, and each is of the right
// kind.
inline bool is_of_vertex(const TangentCircle& z, const std::array<Circle, 3>& g) {
  std::array<Root, 3> x, y, reach;
  int turn = 1;
  for (int i = 0; i < 3; ++i) {
    x[i] = g[i].x - z.x;
    y[i] = g[i].y - z.y;
    reach[i] = z.reach(g[i]);
    if (CGAL::sign(reach[i]) != (g[i].container ? CGAL::NEGATIVE : CGAL::POSITIVE)) return false;
    turn *= CGAL::sign(reach[i]);
  }
  // (x, y) / reach is the direction to the contact.
  return turn * CGAL::sign(CGAL::determinant(x[0], y[0], reach[0], x[1], y[1], reach[1], x[2], y[2],
                                             reach[2])) >
         0;
}

// The circle of the vertex [g0, g1, g2]. With the first generator as origin, z the centre and w the
// distance from it, the other two give two planes in (z, w) and the first the cone |z| = |w|: their
// common line meets the cone in two points.
inline std::optional<TangentCircle> vertex_circle(const std::array<Circle, 3>& g) {
  const auto plane = [&](const Circle& c) {
    const Gmpq x = c.x - g[0].x, y = c.y - g[0].y, r = c.r - g[0].r;
    return Kernel::Plane_3(2 * x, 2 * y, 2 * r, r * r - x * x - y * y);
  };
  const auto planes = CGAL::intersection(plane(g[1]), plane(g[2]));
  if (!planes) return std::nullopt;
  const auto* line = boost::get<Kernel::Line_3>(&*planes);
  if (line == nullptr) return std::nullopt;
  const Kernel::Point_3 p = line->point();
  const Kernel::Vector_3 u = line->to_vector();
  const auto cone = [](const auto& a, const auto& b) {
    return Gmpq(a.x() * b.x() + a.y() * b.y() - a.z() * b.z());
  };
  const Gmpq a = cone(u, u), b = 2 * cone(p, u), c = cone(p, p);
  if (a == 0 && b == 0) return std::nullopt;
  std::vector<Root> places;
  CGAL::compute_roots_of_2(a, b, c, std::back_inserter(places));
  for (const Root& s : places) {
    const TangentCircle z{g[0].x + p.x() + s * u.x(), g[0].y + p.y() + s * u.y(),
                          p.z() + s * u.z() - g[0].r};
    if (is_of_vertex(z, g)) return z;
  }
  return std::nullopt;
}

// The side of circle z on which a generator lies: ON_BOUNDED_SIDE if z contains a point of it.
inline CGAL::Bounded_side side_of(const TangentCircle& z, const Circle& e) {
  const Root reach = z.reach(e);
  const RootKernel::Point_2 center(z.x, z.y), other(Root(e.x), Root(e.y));
  if (e.container) {
    if (CGAL::sign(reach) != CGAL::NEGATIVE) return CGAL::ON_BOUNDED_SIDE;
    return CGAL::opposite(RootKernel::Circle_2(center, reach * reach).bounded_side(other));
  }
  if (CGAL::sign(reach) != CGAL::POSITIVE) return CGAL::ON_UNBOUNDED_SIDE;
  return RootKernel::Circle_2(center, reach * reach).bounded_side(other);
}

// A point in no disk, in the container and outside of z: near the container, or nothing.
inline std::optional<Kernel::Point_2> free_point(const TangentCircle& z,
                                                 const std::array<Circle, 4>& g,
                                                 const Circle& container) {
  const auto is_free = [&](const Kernel::Point_2& o) {
    for (const Circle& c : g) {
      const auto side = Kernel::Circle_2({c.x, c.y}, c.r * c.r).bounded_side(o);
      if (side != (c.container ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE)) return false;
    }
    const RootKernel::Circle_2 circle({z.x, z.y}, z.radius * z.radius);
    return circle.bounded_side({Root(o.x()), Root(o.y())}) == CGAL::ON_UNBOUNDED_SIDE;
  };
  for (int part = 2; part <= 1 << 20; part *= 4) {
    const Gmpq far = container.r * (Gmpq(1) - Gmpq(1, part));
    for (int k = -8; k <= 8; ++k) {
      // Half the angle has the tangent m.
      const Gmpq m(k, 4), n = Gmpq(1) + m * m;
      const Kernel::Vector_2 d(far * (Gmpq(1) - m * m) / n, far * 2 * m / n);
      for (const Kernel::Vector_2& v : {d, -d}) {
        const Kernel::Point_2 o = Kernel::Point_2(container.x, container.y) + v;
        if (is_free(o)) return o;
      }
    }
  }
  return std::nullopt;
}

// side_of() by the predicate of the Apollonius graph, which knows disks only. An inversion turns
// the outside of the container into one; it reverses orientations. Returns nothing where no centre
// for the inversion is at hand. Precondition: z is the circle of the vertex of the first three.
inline std::optional<CGAL::Bounded_side> apollonius_side(const TangentCircle& z,
                                                         const std::array<Circle, 4>& g) {
  using Site = ApolloniusTraits::Site_2;
  std::array<Site, 4> sites;
  const Circle* container = nullptr;
  for (const Circle& c : g) {
    if (c.container) container = &c;
  }
  std::optional<Kernel::Point_2> o;
  if (container != nullptr && !(o = free_point(z, g, *container))) return std::nullopt;
  for (int i = 0; i < 4; ++i) {
    const Circle& c = g[i];
    if (!o) {
      sites[i] = Site({c.x, c.y}, c.r);
      continue;
    }
    const Gmpq x = c.x - o->x(), y = c.y - o->y(), power = x * x + y * y - c.r * c.r;
    sites[i] = Site({x / power, y / power}, c.r / power);
  }
  if (o) std::swap(sites[1], sites[2]);
  switch (ApolloniusTraits().vertex_conflict_2_object()(sites[0], sites[1], sites[2], sites[3])) {
    case CGAL::NEGATIVE:
      return CGAL::ON_BOUNDED_SIDE;
    case CGAL::ZERO:
      return CGAL::ON_BOUNDARY;
    default:
      return CGAL::ON_UNBOUNDED_SIDE;
  }
}

// Two ways of CGAL's, with two answers.
struct Disagreement : std::logic_error {
  Disagreement() : std::logic_error("CGAL's circle and its Apollonius predicate disagree") {}
};

// The side of the circle of the vertex [g0, g1, g2] on which the last generator lies; nothing where
// there is no such circle.
inline std::optional<CGAL::Bounded_side> side_of_vertex(const std::array<Circle, 4>& g) {
  const auto z = vertex_circle({g[0], g[1], g[2]});
  if (!z) return std::nullopt;
  const CGAL::Bounded_side side = side_of(*z, g[3]);
  if (const auto other = apollonius_side(*z, g); other && *other != side) {
    throw Disagreement();
  }
  return side;
}

}  // namespace voroproof::internal::cgal
