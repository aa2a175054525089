// The generator of a diagram of disks at rest that is nearest to a point.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "exact/ball.h"
#include "exact/generators.h"
#include "exact/predicates.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"
#include "library/resting_disks.h"
#include "library/values.h"
#include "voroproof/static_diagram.h"

namespace voroproof {
namespace internal {
namespace {

// A double that says whether it is the result that exact arithmetic would have had. Ties of points
// on a grid are decided so, without rationals.
struct WatchedDouble {
  double value = 0;
  bool is_exact = true;
  explicit WatchedDouble(double v, bool exact = true) : value(v), is_exact(exact) {}

  friend WatchedDouble operator+(const WatchedDouble& a, const WatchedDouble& b) {
    double sum = 0, error = 0;
    dd_detail::two_sum(a.value, b.value, sum, error);
    return WatchedDouble(sum, a.is_exact && b.is_exact && error == 0);
  }
  friend WatchedDouble operator-(const WatchedDouble& a, const WatchedDouble& b) {
    return a + WatchedDouble(-b.value, b.is_exact);
  }
  friend WatchedDouble operator*(const WatchedDouble& a, const WatchedDouble& b) {
    double product = 0, error = 0;
    dd_detail::two_prod(a.value, b.value, product, error);
    // Where the error may have underflowed nothing is known.
    const bool is_seen = std::fabs(product) >= DBL_MIN * 0x1p60 || a.value == 0 || b.value == 0;
    return WatchedDouble(product, a.is_exact && b.is_exact && error == 0 && is_seen);
  }
  friend Sign sign(const WatchedDouble& a) {
    return a.is_exact ? internal::sign(a.value) : Sign::unknown;
  }
};

// The sign of e sqrt(a) + f sqrt(b) + s for a, b >= 0 and signs e and f, without a root. Where the
// roots and s are of opposite signs the larger square tells, and the difference of the squares is
// u + 2 e f sqrt(a b).
template <class T>
Sign sign_of_roots(Sign e, const T& a, Sign f, const T& b, const T& s) {
  const Sign product = sign(a) * sign(b);
  Sign roots = e * sign(T(a - b));
  if (e == f) roots = sign(a) == Sign::zero ? e * sign(b) : e * sign(a);
  const Sign rest = sign(s);
  if (roots == Sign::unknown || rest == Sign::unknown || product == Sign::unknown) {
    return Sign::unknown;
  }
  if (roots == Sign::zero || rest == roots) return rest;
  if (rest == Sign::zero) return roots;
  const T u = a + b - s * s;
  return roots * sign_with_root(sign(u), e * f * product, sign(T(u * u - T(4) * a * b)));
}

// A generator as distances are computed from it.
struct DistanceSite : Site<double> {
  std::array<int, 2> inwards{};  // those of a wall, else zeros
  bool is_wall() const { return inwards[0] != 0 || inwards[1] != 0; }
};

Sign sign_before_root(GenId g) { return g == container_id ? Sign::negative : Sign::positive; }

// The distance from a wall.
template <class T, class Number>
T height(const Vector& x, const DistanceSite& wall, const Number& number) {
  const T from =
      wall.inwards[0] != 0 ? T(number(x[0]) - number(wall.x)) : T(number(x[1]) - number(wall.y));
  return wall.inwards[0] + wall.inwards[1] > 0 ? from : T(number(0) - from);
}

// The squared distance of a point from the centre; a wall has none.
template <class T, class Number>
T squared_distance(const Vector& x, const DistanceSite& site, const Number& number) {
  if (site.is_wall()) return T(number(0));
  const T dx = number(x[0]) - number(site.x), dy = number(x[1]) - number(site.y);
  return dx * dx + dy * dy;
}

// The distance of a point from a generator: |x - c| - r of a disk, R - |x - O| of the frame, whose
// signed radius is -R. T has square roots.
template <class T>
T distance(const Vector& x, GenId g, const DistanceSite& site) {
  const auto number = [](double v) { return T(v); };
  if (site.is_wall()) return height<T>(x, site, number);
  const T far = sqrt(squared_distance<T>(x, site, number));
  return (g == container_id ? -far : far) - T(site.r);
}

// That distance rounded to nearest. Where two doubles do not tell, more bits do, unless it is a
// rational number.
double rounded_distance(const Vector& x, GenId g, const DistanceSite& site) {
  if (site.is_wall()) return round_nearest(height<Rational>(x, site, to_rational));
  const DdBall close = distance<DdBall>(x, g, site);
  if (rounds_to_leading(close)) return close.hi;
  const Rational square = squared_distance<Rational>(x, site, to_rational);
  if (const auto root = rational_sqrt(square)) {
    const Rational far = g == container_id ? Rational(-*root) : *root;
    return round_nearest(Rational(far - to_rational(site.r)));
  }
  for (Ball::Precision bits = 256;; bits *= 2) {
    const Ball far = sqrt(Ball(square, bits));
    double nearest = 0;
    if (((g == container_id ? -far : far) - Ball(site.r, bits)).round_to_double(nearest)) {
      return nearest;
    }
  }
}

// Finds the nearest generator by a walk: from a cell to that of a neighbour that is nearer, until
// none is.
//
// Why it does not end elsewhere. Of generators at one distance the largest id counts as infinitely
// little larger, so that the order by distance and then by falling id is the order of distances
// from disks that are truly larger by as little, of which `edges` is the diagram; let x be outside
// of the cell of g in it. The way to x from the centre of g, or, where g is the frame, from far out
// on the ray from the frame's centre through x, begins in the cell of g, which is star-shaped, and
// leaves it at a place y of an edge with some k. Then d_k(x) <= d_k(y) + |y - x| = d_g(y) + |y - x|
// = d_g(x), and the two are equal only where one of both disks contains the other, or lies outside
// of the frame: but no visible one does, so that the neighbour k is nearer. The way from a wall
// begins far out on its normal through x.
class NearestWalk {
 public:
  explicit NearestWalk(const StaticDiagram& diagram) {
    const auto& frame = diagram.frame();
    const Circle rim = frame.value_or(Circle{});
    sites_.push_back({{rim.center[0], rim.center[1], -rim.radius}});
    for (const Circle& d : diagram.disks()) {
      sites_.push_back({{d.center[0], d.center[1], d.radius}});
    }
    const RestingFrame around{frame, diagram.walls()};
    const Framed framed = around.framed(diagram.disks().size());
    for (int quarter = 0; framed.has_walls() && quarter < wall_count; ++quarter) {
      const Vector at = around.place(quarter);
      sites_.push_back({{at[0], at[1], 0}, framed.reflected(framed.wall(quarter), 0, 1)});
    }
    std::vector<std::array<GenId, 2>> pairs;
    for (const Edge& e : diagram.edges()) {
      if (frame || e.l != container_id) pairs.push_back({e.l, e.r});
    }
    const std::vector<int>& hosts = diagram.hosts();
    const auto seen = std::find(hosts.begin(), hosts.end(), StaticDiagram::visible);
    first_ = seen == hosts.end() && !framed.has_walls() ? container_id
                                                        : static_cast<GenId>(seen - hosts.begin());
    // A lone disk has no edge in the diagram, but a neighbour.
    if (frame && pairs.empty() && first_ != container_id) pairs.push_back({container_id, first_});
    index(pairs);
  }

  GenId first() const { return first_; }
  // The generator nearest to x; the walk begins at `start`, a visible one.
  GenId from(GenId start, const Vector& x) const {
    Best best = best_of(start, x);
    for (;;) {
      const GenId cell = best.id;
      for (auto k = begin_[index(cell)]; k < begin_[index(cell) + 1]; ++k) {
        const GenId g = neighbours_[k];
        if (!is_farther(g, x, best.most) && is_nearer(g, best.id, x)) best = best_of(g, x);
      }
      if (best.id == cell) return cell;
    }
  }
  double distance_to(GenId g, const Vector& x) const {
    return rounded_distance(x, g, sites_[index(g)]);
  }

 private:
  // Its distance is at most `most`.
  struct Best {
    GenId id;
    double most;
  };

  static std::size_t index(GenId g) { return static_cast<std::size_t>(g + 1); }

  // The neighbours of each generator, one after the other.
  void index(const std::vector<std::array<GenId, 2>>& pairs) {
    begin_.assign(sites_.size() + 1, 0);
    for (const auto& pair : pairs) {
      for (const GenId g : pair) ++begin_[index(g)];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    neighbours_.resize(2 * pairs.size());
    for (const auto& [l, r] : pairs) {
      neighbours_[--begin_[index(l)]] = r;
      neighbours_[--begin_[index(r)]] = l;
    }
  }

  Best best_of(GenId g, const Vector& x) const {
    const DoubleBall far = distance<DoubleBall>(x, g, sites_[index(g)]);
    const double most = far.mid + far.rad;
    return {g, most + 2 * unit_roundoff * std::fabs(most)};
  }

  // Whether doubles prove without a root that g is farther than `most`: a disk is if |x - c|^2 >
  // (most + r)^2. The square on the left errs by less than 5 u of itself, that on the right by less
  // than 4 u, u = 2^-53, and both by what underflows.
  bool is_farther(GenId g, const Vector& x, double most) const {
    const DistanceSite& site = sites_[index(g)];
    if (g == container_id || site.is_wall()) return false;
    const double reach = most + site.r, dx = x[0] - site.x, dy = x[1] - site.y;
    return (dx * dx + dy * dy) * (1 - 0x1p-48) > reach * reach + 4 * DBL_MIN;
  }

  // Whether g comes before h in the order of the walk.
  bool is_nearer(GenId g, GenId h, const Vector& x) const {
    const DistanceSite &a = sites_[index(g)], &b = sites_[index(h)];
    Sign s = sign(distance<DoubleBall>(x, g, a) - distance<DoubleBall>(x, h, b));
    if (!is_certain(s)) s = exactly<WatchedDouble>(g, h, x, [](double v) { return v; });
    if (s == Sign::unknown) s = sign(distance<DdBall>(x, g, a) - distance<DdBall>(x, h, b));
    if (s == Sign::unknown) s = exactly<Rational>(g, h, x, to_rational);
    return s == Sign::negative || (s == Sign::zero && g > h);
  }
  template <class T, class Number>
  Sign exactly(GenId g, GenId h, const Vector& x, const Number& number) const {
    const DistanceSite &a = sites_[index(g)], &b = sites_[index(h)];
    const auto exact = [&](double v) { return T(number(v)); };
    // A wall is a point with a radius that is the distance without its sign.
    const auto radius = [&](const DistanceSite& s) {
      return s.is_wall() ? T(exact(0) - height<T>(x, s, exact)) : exact(s.r);
    };
    return sign_of_roots<T>(sign_before_root(g), squared_distance<T>(x, a, exact),
                            -sign_before_root(h), squared_distance<T>(x, b, exact),
                            T(radius(b) - radius(a)));
  }

  std::vector<DistanceSite> sites_;  // that of the frame first, those of walls last
  GenId first_ = container_id;
  std::vector<std::size_t> begin_;
  std::vector<GenId> neighbours_;
};

// Indices of the points, those near to each other one after the other.
std::vector<std::size_t> along_a_curve(const std::vector<Vector>& points) {
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_2> places;
  places.reserve(points.size());
  for (const Vector& p : points) places.emplace_back(p[0], p[1]);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  const CGAL::Spatial_sort_traits_adapter_2<Kernel, Map> traits(
      CGAL::make_property_map(places.data()));
  CGAL::hilbert_sort(order.begin(), order.end(), traits);
  return order;
}

void require_points(const std::vector<Vector>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (const double x : points[k]) {
      if (std::fabs(x) <= 1e100) continue;
      throw std::invalid_argument("point " + std::to_string(k) +
                                  ": not finite, or beyond 1e100 in magnitude");
    }
  }
}

}  // namespace
}  // namespace internal

std::vector<Nearest> StaticDiagram::nearest(const std::vector<Vector>& points) const {
  return internal::with_public_errors([&] {
    internal::require_points(points);
    if (disks_.empty() && !frame_ && !walls_ && !points.empty())
      throw std::invalid_argument("no disk");
    const internal::NearestWalk walk(*this);
    std::vector<Nearest> all(points.size());
    int last = walk.first();
    for (const std::size_t k : internal::along_a_curve(points)) {
      last = walk.from(last, points[k]);
      all[k] = {last, walk.distance_to(last, points[k])};
    }
    return all;
  });
}

}  // namespace voroproof
