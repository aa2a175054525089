#include "library/bisector_arcs.h"

#include <algorithm>
#include <utility>

#include "filtered/numbers/dd_ball.h"

namespace voroproof::internal {
namespace {

DoubleBall ball(const DdBall& b) {
  return {b.hi, (std::fabs(b.lo) + b.rad) * double_ball_detail::kUp};
}

// A difference of doubles.
DoubleBall between(double from, double to) { return DoubleBall(to) - DoubleBall(from); }
BallPoint between(const Vec2& from, const Vec2& to) {
  return {between(from[0], to[0]), between(from[1], to[1])};
}

// A vertex, which is rounded to nearest.
BallPoint vertex_from(const Vec2& origin, const Vec2& vertex) {
  using namespace double_ball_detail;
  BallPoint v = between(origin, vertex);
  v.x.rad = (v.x.rad + std::fabs(vertex[0]) * u + kTiny) * kUp;
  v.y.rad = (v.y.rad + std::fabs(vertex[1]) * u + kTiny) * kUp;
  return v;
}

DoubleBall length(const BallPoint& a) { return sqrt(dot(a, a)); }
BallPoint operator+(const BallPoint& a, const BallPoint& b) { return {a.x + b.x, a.y + b.y}; }
BallPoint scaled(const DoubleBall& k, const BallPoint& a) { return {k * a.x, k * a.y}; }
BallPoint quarter_turn(const BallPoint& a) { return {-a.y, a.x}; }

// The bisector of `base` and another generator in polar coordinates about the centre of the base.
// With n a unit vector, d and s the differences of centres and signed radii (other minus base), and
// p = d.d - s^2, it is the conic
//
//   kappa(n) = 1 / rho(n) = 2 (d.n + s) / p   where that is positive.
//
// The arc between two directions n0 and n1, an angle delta < pi apart, is the rational quadratic
// curve with the homogeneous control points (n0, kappa0), (nm, kappam), (n1, kappa1): nm is the
// direction in the middle, and for C = cos(delta / 2)
//
//   kappam = 2 (d.nm + s C) / p = ((kappa0 + kappa1) / 2 - (2 s / p) (1 - C^2)) / C,
//
// since n0 + n1 = 2 C nm. (n, kappa) is linear in the homogeneous point (n, 1) of the unit circle,
// of which the control points are (n0, 1), (nm, C), (n1, 1).) Seen from the larger one of two
// disks, s <= 0 < p, nothing cancels in that.
class FocalConic {
 public:
  // A direction, and the reciprocal of the distance in it.
  struct Ray {
    BallPoint n;
    DoubleBall kappa;
  };

  FocalConic(const Circle& base, const Circle& other)
      : center_(base.center), d_(between(base.center, other.center)) {
    const auto difference = [](double from, double to) { return DdBall(to) - DdBall(from); };
    DdBall x = difference(base.center[0], other.center[0]),
           y = difference(base.center[1], other.center[1]);
    const DdBall s = difference(base.radius, other.radius);
    if (std::fabs(x.hi) < std::fabs(y.hi)) std::swap(x, y);
    s_ = ball(s);
    // Disks that nearly touch each other from inside lose few digits so.
    p_ = ball((x - s) * (x + s) + y * y);
  }

  // A wall n.x >= h is the case d = -n, s = 1 and p = 2 (n.c - h + r), c and r of the base.
  FocalConic(const Circle& base, const WallLine& wall)
      : center_(base.center), d_{-wall.inwards[0], -wall.inwards[1]}, s_(1) {
    const auto height = [&](int axis) {
      return DdBall(wall.inwards[axis]) * (DdBall(base.center[axis]) - DdBall(wall.at[axis]));
    };
    p_ = ball(DdBall(2) * (height(0) + height(1) + DdBall(base.radius)));
  }

  const Vec2& center() const { return center_; }
  BallPoint offset(const Vec2& at) const { return between(center_, at); }

  Ray through(const Vec2& vertex) const {
    const BallPoint v = vertex_from(center_, vertex);
    const DoubleBall kappa = DoubleBall(1) / length(v);
    return {scaled(kappa, v), kappa};
  }
  // In any direction with a point.
  Ray along(const BallPoint& n) const { return {n, DoubleBall(2) * (dot(d_, n) + s_) / p_}; }
  // The place between two disks.
  Ray apex() const {
    const DoubleBall far = length(d_);
    return {scaled(DoubleBall(1) / far, d_), DoubleBall(2) / (far - s_)};
  }
  // At infinity, d.n + s = 0: on the left or on the right of d.
  Ray asymptote(bool on_left) const {
    const DoubleBall root = on_left ? sqrt(p_) : -sqrt(p_);
    const BallPoint n = scaled(-s_, d_) + scaled(root, quarter_turn(d_));
    return {scaled(DoubleBall(1) / dot(d_, d_), n), 0};
  }

  // Precondition: less than half a turn apart.
  ConicArc arc(const Ray& from, const Ray& to) const {
    const BallPoint sum = from.n + to.n, chord = to.n - from.n;
    const DoubleBall far = length(sum), half(0.5);
    const DoubleBall square_of_sine = half * half * dot(chord, chord);
    const DoubleBall sag = DoubleBall(2) * s_ / p_ * square_of_sine;
    const DoubleBall kappa = (half * (from.kappa + to.kappa) - sag) / (half * far);
    const BallPoint n = scaled(DoubleBall(1) / far, sum);
    return ConicArc({ConicArc::Control{from.n.x, from.n.y, from.kappa},
                     ConicArc::Control{n.x, n.y, kappa},
                     ConicArc::Control{to.n.x, to.n.y, to.kappa}});
  }

 private:
  Vec2 center_;
  BallPoint d_;
  DoubleBall s_, p_;
};

using Ray = FocalConic::Ray;

// From a place on the bisector to the end of it that is at infinity: to where it is `far` from the
// base, and straight to the cut.
std::vector<ConicArc> outwards(const FocalConic& conic, const Ray& from, const Ray& infinity,
                               const BallPoint& cut, double far) {
  std::vector<ConicArc> arcs;
  ConicArc rest = conic.arc(from, infinity);
  for (bool is_far = false; !is_far;) {
    const auto [near, further] = rest.halves();
    arcs.push_back(near);
    rest = further;
    // Each time the distance is doubled at least, until it is no number.
    const auto& [x, y, weight] = rest.control(0);
    const double size = std::fabs(x.mid) + std::fabs(y.mid);
    is_far = !(size < 2 * far * weight.mid);
  }
  arcs.push_back(ConicArc::segment(rest.point(0), cut));
  return arcs;
}

void append_reversed(const std::vector<ConicArc>& arcs, std::vector<ConicArc>& out) {
  for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc) out.push_back(arc->reversed());
}

// Between disks of equal radii.
ArcChain straight_edge(const Circle& left, const Circle& right, const ArcEnd& start,
                       const ArcEnd& end, double far) {
  const Vec2& origin = left.center;
  const BallPoint d = between(left.center, right.center), half = scaled(0.5, d);
  // The edge has the left disk on its left.
  const auto far_away = [&](bool at_end) {
    const DoubleBall reach = DoubleBall(at_end ? far : -far) / length(d);
    return half + scaled(reach, quarter_turn(d));
  };
  const BallPoint from = start.is_cut ? far_away(false) : vertex_from(origin, start.at),
                  to = end.is_cut ? far_away(true) : vertex_from(origin, end.at);
  ArcChain chain{origin};
  if (start.is_cut) chain.arcs.push_back(ConicArc::segment(between(origin, start.at), from));
  if (start.is_cut && end.is_cut) {
    chain.arcs.push_back(ConicArc::segment(from, half));
    chain.arcs.push_back(ConicArc::segment(half, to));
  } else {
    chain.arcs.push_back(ConicArc::segment(from, to));
  }
  if (end.is_cut) chain.arcs.push_back(ConicArc::segment(to, between(origin, end.at)));
  return chain;
}

// Whether `to` is at most a quarter turn counterclockwise from n, or is n but for rounding.
bool is_within_quarter(const BallPoint& n, const BallPoint& to) {
  const DoubleBall turned = cross(n, to);
  return turned.mid >= -turned.rad && dot(n, to).mid > 0;
}

}  // namespace

ArcChain plane_arcs(const Circle& left, const Circle& right, const ArcEnd& start, const ArcEnd& end,
                    double far) {
  if (left.radius == right.radius) return straight_edge(left, right, start, end, far);
  const bool from_left = left.radius > right.radius;
  const FocalConic conic = from_left ? FocalConic(left, right) : FocalConic(right, left);
  // The edge runs counterclockwise around its left disk, so it ends on the left as seen from there.
  const auto ray = [&](const ArcEnd& e, bool at_end) {
    return e.is_cut ? conic.asymptote(at_end == from_left) : conic.through(e.at);
  };
  ArcChain chain{conic.center()};
  const auto append = [&](const Ray& from, bool from_infinity, const Ray& to, bool to_infinity) {
    if (from_infinity) {
      append_reversed(outwards(conic, to, from, conic.offset(start.at), far), chain.arcs);
    } else if (to_infinity) {
      const auto arcs = outwards(conic, from, to, conic.offset(end.at), far);
      chain.arcs.insert(chain.arcs.end(), arcs.begin(), arcs.end());
    } else {
      chain.arcs.push_back(conic.arc(from, to));
    }
  };
  const Ray from = ray(start, false), to = ray(end, true);
  // All directions are within a quarter turn of the apex.
  if (dot(from.n, to.n).mid < 0 || (start.is_cut && end.is_cut)) {
    append(from, start.is_cut, conic.apex(), false);
    append(conic.apex(), false, to, end.is_cut);
  } else {
    append(from, start.is_cut, to, end.is_cut);
  }
  return chain;
}

namespace {

ArcChain arcs_around(const FocalConic& conic, const Vec2& start, const Vec2& end) {
  ArcChain chain{conic.center()};
  Ray at = conic.through(start);
  const Ray to = conic.through(end);
  const DoubleBall turned = cross(at.n, to.n);
  chain.is_certain = std::fabs(turned.mid) > turned.rad || dot(at.n, to.n).mid < 0;
  for (int quarters = 0; quarters < 4 && !is_within_quarter(at.n, to.n); ++quarters) {
    const Ray next = conic.along(quarter_turn(at.n));
    chain.arcs.push_back(conic.arc(at, next));
    at = next;
  }
  chain.arcs.push_back(conic.arc(at, to));
  return chain;
}

}  // namespace

ArcChain frame_arcs(const Circle& disk, const Circle& frame, const Vec2& start, const Vec2& end) {
  return arcs_around(FocalConic(disk, Circle{frame.center, -frame.radius}), start, end);
}

// No edge leads all around its disk.
ArcChain wall_arcs(const Circle& disk, const WallLine& wall, const Vec2& start, const Vec2& end) {
  ArcChain chain = arcs_around(FocalConic(disk, wall), start, end);
  chain.is_certain = true;
  return chain;
}

ArcChain straight_arc(const Vec2& start, const Vec2& end) {
  return {start, {ConicArc::segment(vertex_from(start, start), vertex_from(start, end))}};
}

ArcChain frame_ellipse(const Circle& disk, const Circle& frame) {
  const FocalConic conic(disk, Circle{frame.center, -frame.radius});
  ArcChain chain{conic.center()};
  BallPoint n{1, 0};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const BallPoint next = quarter_turn(n);
    chain.arcs.push_back(conic.arc(conic.along(n), conic.along(next)));
    n = next;
  }
  return chain;
}

}  // namespace voroproof::internal
