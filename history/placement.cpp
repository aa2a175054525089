// Overlaps are found by a sweep (Shamos and Hoey 1976). A vertical line moves over the disks; while
// it crosses a disk it does so in a chord whose midpoint has the height of the disk's centre. So
// the chords of disks that do not overlap always stand in the order of the centres' heights, and
// this order is never wrong, for it does not depend on the line's place.
//
// If two disks overlap, then at some place of the line two of the disks it crosses that are
// *neighbours* in this order overlap: let the chords of A and B have common inner points, and let a
// disk C between them in the order be crossed too. Its midpoint lies above A's, below B's, and
// therefore in the interior of A's chord or of B's; so C overlaps A or B, and is closer to it in
// the order than they are to each other. Hence it suffices to test two disks whenever they become
// neighbours: when one is entered, and when the disk between them is left.
//
// Disks are entered before others are left at the same place, so that a point (radius 0) is crossed
// together with everything above its abscissa. Among equal heights points come first, so that
// coinciding points are neighbours.
#include "history/placement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <iterator>
#include <set>
#include <vector>

namespace voroproof::internal {
namespace {

// A number known as hi, the nearest binary64, and lo, the binary64 nearest to the rest. Rounding is
// monotone: two values compare as their (hi, lo) do, unless these are equal. `exact` is the value
// itself, kept elsewhere, or null where hi + lo is the value.
struct Key {
  double hi, lo;
  const Rational* exact;
};

struct Rounded {
  double value;
  bool exact;
};

// The nearest binary64, and whether it is q itself.
Rounded rounded(const CompactRational& q) { return {round_nearest(q), q.is_double()}; }

Key key_of(const CompactRational& q) {
  const Rational* exact = q.exact();
  if (exact == nullptr) return {q.leading(), q.second(), nullptr};
  const double hi = round_nearest(*exact);
  return {hi, round_nearest(Rational(*exact - to_rational(hi))), exact};
}

// a + b (Knuth's TwoSum; the magnitudes of a scene are far from overflow).
Key key_of_sum(double a, double b) {
  const double hi = a + b;
  const double b_part = hi - a;
  const double lo = (a - (hi - b_part)) + (b - b_part);
  return {hi, lo, nullptr};
}

// Compares two with the same hi: -1, 0, 1.
int compare_rests(const Key& a, const Key& b) {
  if (a.lo != b.lo) return a.lo < b.lo ? -1 : 1;
  if (a.exact && b.exact) return cmp(*a.exact, *b.exact);
  if (a.exact) return sgn(Rational(*a.exact - to_rational(b.hi) - to_rational(b.lo)));
  if (b.exact) return -compare_rests(b, a);
  return 0;
}

// -1, 0, 1.
inline int compare(const Key& a, const Key& b) {
  if (a.hi != b.hi) return a.hi < b.hi ? -1 : 1;
  return compare_rests(a, b);
}

// The sign of |a - b|^2 - (ra + sign * rb)^2. In integers over common denominators: lattices of
// touching disks come here with every pair, and cancelling fractions would take most of the time.
int compare_distance_exactly(const DiskInput& a, const DiskInput& b, int sign) {
  struct Fraction {
    Integer numerator, denominator;
  };
  const auto sum = [](const Rational& p, int s, const Rational& q) {
    return Fraction{p.get_num() * q.get_den() + s * (q.get_num() * p.get_den()),
                    p.get_den() * q.get_den()};
  };
  const Fraction x = sum(a.x, -1, b.x), y = sum(a.y, -1, b.y), r = sum(a.radius, sign, b.radius);
  const Integer nx = x.numerator * y.denominator * r.denominator;
  const Integer ny = y.numerator * x.denominator * r.denominator;
  const Integer nr = r.numerator * x.denominator * y.denominator;
  return sgn(Integer(nx * nx + ny * ny - nr * nr));
}

// By how much |a - b| and |ra + sign * rb|, which is not zero, differ: to six digits, at any scale.
std::string difference_text(const DiskInput& a, const DiskInput& b, int sign) {
  const Rational x = a.x.value() - b.x.value(), y = a.y.value() - b.y.value();
  const Rational reach = abs(Rational(a.radius.value() + sign * b.radius.value()));
  // |a - b| is the reach times the root of 1 + part.
  const double part = round_nearest(Rational((x * x + y * y) / (reach * reach) - 1));
  const double difference = round_nearest(reach) * std::fabs(part) / (1 + std::sqrt(1 + part));
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", difference);
  return text;
}

// A circle rounded to binary64; `exact` where rounding changed nothing.
struct Circle {
  double x, y, r;
  bool exact;
};

// A number's magnitude between two bounds.
struct Range {
  double low, high;
};

// |a + sign * b| of two rounded numbers. With u = 2^-53: of exact a, b the rounded result is within
// 2u of itself. Else a and b bring u|a| + u|b| each rounded up a little, and the rounding of the
// result no more than that again: 3u (|a| + |b|) leaves room also for the rounding of the bound.
// The last factor covers the rounding of the additions below.
Range magnitude(double a, double b, int sign, bool exact) {
  constexpr double u = 0x1p-53;
  const double value = std::fabs(a + sign * b);
  const double error = exact ? 2 * u * value : 3 * u * (std::fabs(a) + std::fabs(b));
  return {std::max(0.0, value - error) * (1 - 4 * u), (value + error) * (1 + 4 * u)};
}

class Placement {
 public:
  explicit Placement(const Scene& scene) : scene_(scene) {
    const auto circle = [](const CompactRational& x, const CompactRational& y,
                           const CompactRational& r) {
      const Rounded cx = rounded(x), cy = rounded(y), cr = rounded(r);
      return Circle{cx.value, cy.value, cr.value, cx.exact && cy.exact && cr.exact};
    };
    wall_ = {scene.cx, scene.cy, scene.container_radius, 0, 0, 0};
    container_ = circle(wall_.x, wall_.y, wall_.radius);
    circles_.reserve(scene.disks.size());
    for (const DiskInput& disk : scene.disks) {
      circles_.push_back(circle(disk.x, disk.y, disk.radius));
      const Circle& c = circles_.back();
      heights_.push_back(c.exact ? Key{c.y, 0, nullptr} : key_of(disk.y));
    }
  }

  std::optional<PlacementFault> find_fault() {
    const int n = static_cast<int>(circles_.size());
    for (int i = 0; i < n; ++i)
      if (auto fault = outside(i)) return fault;
    return find_overlap();
  }

 private:
  // The sign of |a - b|^2 - (ra + sign * rb)^2, of the exact values.
  static int compare_distance(const Circle& a, const Circle& b, const DiskInput& exact_a,
                              const DiskInput& exact_b, int sign) {
    const bool exact = a.exact && b.exact;
    const Range x = magnitude(a.x, b.x, -1, exact);
    const Range y = magnitude(a.y, b.y, -1, exact);
    const Range r = magnitude(a.r, b.r, sign, exact);
    // Two squares and a sum, each rounded once: 8u covers them and the product with the factor.
    constexpr double slack = 8 * 0x1p-53;
    if ((x.low * x.low + y.low * y.low) * (1 - slack) > r.high * r.high * (1 + slack)) return 1;
    if ((x.high * x.high + y.high * y.high) * (1 + slack) < r.low * r.low * (1 - slack)) return -1;
    return compare_distance_exactly(exact_a, exact_b, sign);
  }

  std::optional<PlacementFault> outside(int i) const {
    const DiskInput& disk = scene_.disks[i];
    // Rounding keeps the order.
    const bool smaller = circles_[i].r != container_.r ? circles_[i].r < container_.r
                                                       : disk.radius.value() < wall_.radius.value();
    if (!smaller) return PlacementFault{i, "not smaller than the container"};
    const int sign = compare_distance(container_, circles_[i], wall_, disk, -1);
    if (sign > 0) {
      return PlacementFault{i, "not inside the container, by " + difference_text(wall_, disk, -1)};
    }
    if (sign == 0 && (sgn(disk.vx) != 0 || sgn(disk.vy) != 0)) {
      const Rational nx = disk.x.value() - wall_.x.value(), ny = disk.y.value() - wall_.y.value();
      if (nx * disk.vx.value() + ny * disk.vy.value() == 0)
        return PlacementFault{i, "touches the container with a tangential velocity"};
    }
    return std::nullopt;
  }

  bool overlap(int i, int j) const {
    const DiskInput &a = scene_.disks[i], &b = scene_.disks[j];
    const int sign = compare_distance(circles_[i], circles_[j], a, b, 1);
    // Points at distance 0 are no touching pair: they have no normal, and no bisector.
    return sign < 0 || (sign == 0 && sgn(a.radius) == 0 && sgn(b.radius) == 0);
  }

  // Where the sweep meets a disk (its left end) or leaves it.
  struct Stop {
    Key x;
    int disk;
    bool leaving;
  };

  Stop stop(int i, bool leaving) {
    const Circle& c = circles_[i];
    if (c.exact) return {key_of_sum(c.x, leaving ? c.r : -c.r), i, leaving};
    const DiskInput& disk = scene_.disks[i];
    exact_stops_.emplace_back(Rational(disk.x.value() + (leaving ? 1 : -1) * disk.radius.value()));
    return {key_of(exact_stops_.back()), i, leaving};
  }

  static bool before(const Stop& a, const Stop& b) {
    const int order = compare(a.x, b.x);
    if (order != 0) return order < 0;
    if (a.leaving != b.leaving) return b.leaving;
    return a.disk < b.disk;
  }

  bool below(int a, int b) const {
    const int order = compare(heights_[a], heights_[b]);
    if (order != 0) return order < 0;
    const bool a_is_point = circles_[a].r == 0, b_is_point = circles_[b].r == 0;
    if (a_is_point != b_is_point) return a_is_point;
    return a < b;
  }

  std::optional<PlacementFault> find_overlap() {
    const int n = static_cast<int>(circles_.size());
    std::vector<Stop> stops;
    stops.reserve(2 * circles_.size());
    for (int i = 0; i < n; ++i) {
      stops.push_back(stop(i, false));
      stops.push_back(stop(i, true));
    }
    std::sort(stops.begin(), stops.end(), before);

    const auto order = [&](int a, int b) { return below(a, b); };
    std::set<int, decltype(order)> crossed(order);
    std::vector<decltype(crossed)::iterator> place(circles_.size());
    for (const Stop& s : stops) {
      const auto here = s.leaving ? place[s.disk] : crossed.insert(s.disk).first;
      if (!s.leaving) place[s.disk] = here;
      const auto next = std::next(here);
      const bool has_previous = here != crossed.begin(), has_next = next != crossed.end();
      if (s.leaving) {
        if (has_previous && has_next && overlap(*std::prev(here), *next))
          return fault(*std::prev(here), *next);
        crossed.erase(here);
      } else {
        if (has_previous && overlap(*std::prev(here), s.disk))
          return fault(*std::prev(here), s.disk);
        if (has_next && overlap(s.disk, *next)) return fault(s.disk, *next);
      }
    }
    return std::nullopt;
  }

  PlacementFault fault(int i, int j) const {
    const std::string other = "disks[" + std::to_string(std::min(i, j)) + "]";
    const DiskInput &a = scene_.disks[i], &b = scene_.disks[j];
    const bool points = circles_[i].r == 0 && circles_[j].r == 0;
    return {std::max(i, j), points ? "coincides with " + other
                                   : "overlaps " + other + " by " + difference_text(a, b, 1)};
  }

  const Scene& scene_;
  DiskInput wall_;  // the container, as a circle
  Circle container_;
  std::vector<Circle> circles_;
  std::vector<Key> heights_;
  std::deque<CompactRational> exact_stops_;  // to which keys point
};

}  // namespace

std::optional<PlacementFault> find_placement_fault(const Scene& scene) {
  return Placement(scene).find_fault();
}

}  // namespace voroproof::internal
