#include "engine/static_diagram.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "engine/cell_rays.h"
#include "engine/touching_point.h"
#include "exact/directions.h"
#include "filtered/search/instant_predicates.h"

namespace voroproof::internal {

namespace {

using HalfEdge = Diagram::HalfEdge;

// Where the spatial order leads from disk to disk, a walk takes a few steps.
constexpr int kLongestWalk = 100;

class Construction {
 public:
  Construction(const Motion& motion, const Rational& t, Frame frame, TierCounts& counts)
      : framed_(frame, motion.size()),
        predicates_(motion, t, counts),
        rays_(framed_, predicates_),
        diagram_(motion.size()) {}

  InstantPredicates& predicates() { return predicates_; }

  Diagram build(const std::vector<GenId>& order) {
    std::size_t begun = 0;
    if (framed_.has_walls()) {
      diagram_ = diagram_between_walls(framed_, predicates_);
    } else if (order.size() >= 2) {
      diagram_.start(order[0], order[1]);
      begun = 2;
    } else {
      return std::move(diagram_);
    }
    for (std::size_t k = begun; k < order.size(); ++k) {
      insert(order[k], k == 0 ? framed_.wall(0) : order[k - 1]);
    }
    return std::move(diagram_);
  }

 private:
  // A link edge of the growing cell: its triangle on the left has the new generator
  // as apex, in the place of `before` (or of the ray that started the insertion).
  struct LinkEdge {
    HalfEdge h;
    GenId before;
    GenId ray_from;  // the generator the ray starts at, if `before` does not count
  };
  static constexpr GenId no_ray = -2;

  void insert(GenId i, GenId near) {
    const HalfEdge h = around(i, diagram_.anchor(near));
    if (in_conflict(i, h)) {
      start_at_vertex(i, h);
    } else {
      start_on_ray(i, of_nearest(i, h));
    }
    while (!link_.empty()) {
      const LinkEdge edge = link_.back();
      link_.pop_back();
      if (!absorbs(i, edge)) continue;
      const HalfEdge t = Diagram::twin(edge.h);
      const HalfEdge a = diagram_.next(t);  // from org(h) to the outer apex
      const HalfEdge b = diagram_.next(a);
      const GenId l = diagram_.org(edge.h), r = diagram_.dest(edge.h);
      diagram_.flip(edge.h);
      link_.push_back({a, r, no_ray});
      link_.push_back({b, l, no_ray});
    }
  }

  // The vertex on the left of h is in conflict with i.
  void start_at_vertex(GenId i, HalfEdge h) {
    const HalfEdge sides[3] = {h, diagram_.next(h), diagram_.previous(h)};
    for (const HalfEdge side : sides) link_.push_back({side, diagram_.apex(side), no_ray});
    diagram_.insert_in_vertex(h, i);
  }

  // Starts on an edge that i's cell certainly meets. Looks for it from the origin of `from`.
  void start_on_ray(GenId i, HalfEdge from) {
    HalfEdge exit = exit_edge(from, i);
    while (!rays_.meets(i, diagram_.org(exit), diagram_.dest(exit))) {
      exit = exit_edge(Diagram::twin(exit), i);
    }
    const GenId j = diagram_.org(exit);
    const auto halves = diagram_.insert_in_edge(exit, i);
    // halves[0] has i as apex on its own side, halves[1] on its twin's.
    link_ = {{halves[0], no_ray, j}, {Diagram::twin(halves[1]), no_ray, j}};
  }

  // A half-edge, on the left of which is the triangle of centres that contains the centre of i, or
  // one near it: found by a walk from h in plain doubles, proved by nothing.
  HalfEdge around(GenId i, HalfEdge h) const {
    const Site<DoubleBall>& p = predicates_.rough(i);
    const auto is_beyond = [&](HalfEdge side) {
      const GenId g = diagram_.org(side), k = diagram_.dest(side);
      if (!framed_.is_disk(g) || !framed_.is_disk(k)) return false;
      const Site<DoubleBall>&a = predicates_.rough(g), &b = predicates_.rough(k);
      return (b.x.mid - a.x.mid) * (p.y.mid - a.y.mid) < (b.y.mid - a.y.mid) * (p.x.mid - a.x.mid);
    };
    if (is_beyond(h)) h = Diagram::twin(h);
    // Triangles of centres may overlap, and a walk among them need not end.
    for (int steps = 0; steps < kLongestWalk; ++steps) {
      const HalfEdge next = diagram_.next(h), previous = diagram_.previous(h);
      if (is_beyond(next)) {
        h = Diagram::twin(next);
      } else if (is_beyond(previous)) {
        h = Diagram::twin(previous);
      } else {
        break;
      }
    }
    return h;
  }

  // The half-edge of the triangle of h that starts at the disk or wall nearest to the centre of i,
  // in doubles.
  HalfEdge of_nearest(GenId i, HalfEdge h) const {
    const Site<DoubleBall>& p = predicates_.rough(i);
    HalfEdge nearest = -1;
    double least = 0;
    for (const HalfEdge side : {h, diagram_.next(h), diagram_.previous(h)}) {
      if (diagram_.org(side) == container_id) continue;
      const GenId g = diagram_.org(side);
      const Site<DoubleBall>& s = predicates_.rough(g);
      const double far = framed_.is_wall(g)
                             ? framed_.seen_from_wall(g, s, p.x, p.y)[1].mid
                             : std::hypot(s.x.mid - p.x.mid, s.y.mid - p.y.mid) - s.r.mid;
      if (nearest >= 0 && !(far < least)) continue;
      nearest = side;
      least = far;
    }
    return nearest;
  }

  // The edge through which the ray of j, the origin of `from`, and i leaves the cell of j: from j's
  // centre through i's, or for the container and walls from the boundary through i's centre
  // inwards. Looks on both sides of `from`, the nearest edges first: a cell may have many.
  HalfEdge exit_edge(HalfEdge from, GenId i) {
    HalfEdge up = from, down = from;
    do {
      if (is_exit(up, i)) return up;
      up = diagram_.rotate(up);
      if (up == down) break;
      down = diagram_.next(Diagram::twin(down));
      if (is_exit(down, i)) return down;
    } while (up != down);
    throw std::logic_error("static diagram: a ray leaves a cell through none of its edges");
  }

  bool is_exit(HalfEdge h, GenId i) {
    const GenId j = diagram_.org(h), k = diagram_.dest(h);
    const GenId s = diagram_.apex(Diagram::twin(h)), e = diagram_.apex(h);
    if (framed_.is_wall(j)) {
      return !framed_.is_infinity(k) && rays_.is_after(i, {j, s, k}) &&
             !rays_.is_after(i, {j, k, e});
    }
    return predicates_.decide([&](auto at, auto root) -> std::optional<bool> {
      const auto base = at(j), target = at(i);
      using T = std::decay_t<decltype(base.x)>;
      const Direction<T> ray{target.x - base.x, target.y - base.y};
      if (j != container_id) {
        return on_arc<T>(framed_.direction(at, root, j, s, k), framed_.direction(at, root, j, k, e),
                         ray, true);
      }
      // The edges run clockwise around the container's centre.
      const auto direction = [&](GenId a, GenId b) {
        const auto z = tangent_circle(framed_.triple(at, j, a, b), root);
        return Direction<T>{z[0] - base.x, z[1] - base.y};
      };
      return on_arc<T>(direction(k, e), direction(s, k), ray, true);
    });
  }

  // Where symmetry proves that every circle that touches three of them touches the fourth, too: no
  // conflict.
  std::optional<bool> certainly_touches(const Quad& q) const {
    const Motion& motion = predicates_.motion();
    const bool rational = motion.is_rational(q.l) && motion.is_rational(q.r) &&
                          motion.is_rational(q.s) && motion.is_rational(q.e);
    if (rational) return std::nullopt;
    const DoubleBall t = DoubleBall::hull(round_down(predicates_.t()), round_up(predicates_.t()));
    if (!motion.symmetry()->always_cotangent(states_of(motion, q), t)) return std::nullopt;
    return false;
  }

  // Whether i is nearer to the vertex on the left of h than the vertex's own generators.
  bool in_conflict(GenId i, HalfEdge h) {
    const GenId l = diagram_.org(h), r = diagram_.dest(h), x = diagram_.apex(h);
    const auto in_circle = [&](auto at, auto) -> std::optional<bool> {
      const auto& site = at(i);
      if (!framed_.has_disk({l, r, x})) {
        const Sign s = framed_.incircle(at, {l, r, x}, i, Sign::unknown);
        if (s == Sign::unknown) return std::nullopt;
        return s == Sign::negative;
      }
      const auto v = framed_.triple(at, l, r, x);
      if constexpr (std::is_same_v<std::decay_t<decltype(site)>, Site<DoubleBall>>) {
        // Cheaper than the cotangency, and nearly always enough.
        const Sign s = sign(incircle_value(v, site, false));
        if (is_certain(s)) return s == Sign::negative;
      }
      const Sign f = sign(framed_.cotangency(at, l, r, x, i));
      const Sign s = incircle(v, site, false, f);
      if (s == Sign::unknown) return std::nullopt;
      return s == Sign::negative;
    };
    return predicates_.decide(in_circle, [&] { return certainly_touches({l, r, x, i}); });
  }

  bool absorbs(GenId i, const LinkEdge& edge) {
    const HalfEdge t = Diagram::twin(edge.h);
    const GenId l = diagram_.org(edge.h), r = diagram_.dest(edge.h), x = diagram_.apex(t);
    if (x == i || !in_conflict(i, t)) return false;
    // Both ends of the edge are in conflict. All of it is, if it is straight, between walls: the
    // distance to a disk is convex on it, and that to a wall linear. Else it is, unless both
    // circles of (l, r, i) exist and lie on it.
    if (framed_.is_wall(l) && framed_.is_wall(r)) return true;
    const bool line = framed_.is_infinity(l) || framed_.is_infinity(r);
    const bool both = line || predicates_.decide([&](auto at, auto) -> std::optional<bool> {
      const Sign a = circle_exists(framed_.triple(at, l, r, i));
      if (a == Sign::negative || a == Sign::zero) return false;
      const Sign b = circle_exists(framed_.triple(at, l, i, r));
      if (b == Sign::negative || b == Sign::zero) return false;
      if (a == Sign::unknown || b == Sign::unknown) return std::nullopt;
      return true;
    });
    if (!both) return true;
    // Seen from a disk of the pair, the edge runs counterclockwise from its start to
    // its end; the circle (l, r, i) in the orientation of i's triangle is where the
    // conflict would stop.
    const bool from_l =
        framed_.is_disk(l) && (!framed_.is_disk(edge.ray_from) || edge.ray_from == l);
    const GenId base = from_l ? l : r, other = from_l ? r : l;
    const bool stops = predicates_.decide([&](auto at, auto root) -> std::optional<bool> {
      const auto origin = at(base);
      using T = std::decay_t<decltype(origin.x)>;
      Direction<T> inside;
      if (edge.ray_from != no_ray) {
        inside = rays_.to_end<T>(at, root, edge.ray_from, i, base);
      } else {
        inside = from_l ? framed_.direction(at, root, base, other, edge.before)
                        : framed_.direction(at, root, base, edge.before, other);
      }
      const Direction<T> outside = from_l ? framed_.direction(at, root, base, x, other)
                                          : framed_.direction(at, root, base, other, x);
      const Direction<T> stop = from_l ? framed_.direction(at, root, base, other, i)
                                       : framed_.direction(at, root, base, i, other);
      return from_l ? on_arc<T>(outside, inside, stop, false)
                    : on_arc<T>(inside, outside, stop, false);
    });
    return !stops;
  }

  Framed framed_;
  InstantPredicates predicates_;
  const CellRays rays_;
  Diagram diagram_;
  std::vector<LinkEdge> link_;  // link edges of the growing cell that are not examined
};

// The first n disks.
std::vector<GenId> insertion_order(const Motion& motion, GenId n, double t) {
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_2> centers;
  centers.reserve(n);
  for (GenId g = 0; g < n; ++g) {
    const auto site = motion.site(g, DoubleBall(t));
    centers.emplace_back(site.x.mid, site.y.mid);
  }
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  const CGAL::Spatial_sort_traits_adapter_2<Kernel, Map> traits(
      CGAL::make_property_map(centers.data()));
  CGAL::spatial_sort(order.begin(), order.end(), traits);
  return {order.begin(), order.end()};
}

}  // namespace

Diagram static_diagram(const Motion& motion, const Rational& t, TierCounts& counts) {
  Construction construction(motion, t, Frame::circle, counts);
  if (motion.size() >= 2) {
    if (const auto touch = touching_point(construction.predicates())) {
      throw Undecided("a point touches another generator: the diagram is not defined", touch->first,
                      touch->second);
    }
  }
  return construction.build(insertion_order(motion, motion.size(), round_nearest(t)));
}

Diagram overlapping_diagram(const Motion& motion, Frame frame, TierCounts& counts) {
  const GenId disks = disk_count(frame, motion.size());
  return Construction(motion, 0, frame, counts).build(insertion_order(motion, disks, 0));
}

}  // namespace voroproof::internal
