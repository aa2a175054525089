#include "library/planning/common_piece.h"

#include <algorithm>
#include <utility>

namespace voroproof::internal {

namespace {

// To which part of a piece roots are narrowed.
const Rational narrow = Rational(1) / (Integer(1) << 120);

RootInterval point(const Rational& s) { return {s, s}; }

// The roots middle -+ sqrt(square) in [0, 1].
std::vector<RootInterval> roots_around(const Rational& middle, const Rational& square) {
  if (square < 0) return {};
  const auto is_below = [&](const Rational& x) { return x <= 0 || x * x <= square; };
  const auto is_above = [&](const Rational& x) { return x >= 0 && x * x >= square; };
  const auto [low, high] = root_bounds(square);
  std::vector<RootInterval> roots;
  const auto take = [&](const Rational& lo, const Rational& hi) {
    roots.push_back({std::max<Rational>(lo, 0), std::min<Rational>(hi, 1)});
  };
  if (is_above(middle) && is_below(middle - 1)) take(middle - high, middle - low);
  if (square != 0 && is_below(-middle) && is_above(1 - middle)) take(middle + low, middle + high);
  return roots;
}

// The roots in [0, 1], in order: exact, or narrowed. None of a constant.
std::vector<RootInterval> roots_of(const Polynomial<Rational>& f) {
  if (f.degree() < 1) return {};
  const Rational middle =
      f.degree() <= 2 ? Rational(-f[f.degree() - 1] / (f.degree() * f.leading())) : Rational(0);
  if (f.degree() == 1) return roots_around(middle, 0);
  if (f.degree() == 2) return roots_around(middle, middle * middle - f[0] / f[2]);
  std::vector<RootInterval> roots = isolate_roots(f, Rational(0), Rational(1));
  for (RootInterval& root : roots) {
    if (!root.is_point()) refine(f, root, narrow);
  }
  return roots;
}

Polynomial<Rational> coordinate(const Curve& offset, std::size_t axis) {
  std::vector<Rational> coefficients;
  for (const Vec3& c : offset) coefficients.push_back(c[axis]);
  return Polynomial<Rational>(std::move(coefficients));
}

}  // namespace

CommonPiece::CommonPiece(CommonTime time, const Curve& offset,
                         const std::optional<Rational>& height)
    : time_(std::move(time)) {
  const Polynomial<Rational> x = coordinate(offset, 0), y = coordinate(offset, 1),
                             z = coordinate(offset, 2);
  distance2_ = x * x + y * y;
  if (!height) {
    if (!z.is_zero()) distance2_ = distance2_ + z * z;
    spans_.push_back({point(0), point(1)});
    return;
  }
  // Between neighbours of these places z - height and z + height keep their signs.
  std::vector<RootInterval> places{point(0)};
  for (const Rational& limit : {Rational(-*height), *height}) {
    for (RootInterval& root : roots_of(z - Polynomial<Rational>{limit})) places.push_back(root);
  }
  places.push_back(point(1));
  std::sort(places.begin(), places.end(),
            [](const RootInterval& a, const RootInterval& b) { return a.lo < b.lo; });
  const auto is_near = [&](const Rational& s) { return abs(z.evaluate(s)) < *height; };
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    if (places[k].hi < places[k + 1].lo && is_near((places[k].hi + places[k + 1].lo) / 2))
      spans_.push_back({places[k], places[k + 1]});
  }
  is_near_at_begin_ = is_near(0);
  is_near_at_end_ = is_near(1);
}

// A polynomial differs from its value at one end of an interval by no more than its length times
// the greatest derivative, for which the sum of the coefficients' magnitudes stands; and from that
// at a root of its derivative by half of the square of the length times the greatest second one.
Approach CommonPiece::approach_at(const RootInterval& s, bool is_stationary) const {
  const Rational length = time_.to - time_.from;
  Approach approach{time_.i,
                    time_.j,
                    Rational(time_.from + s.lo * length),
                    distance2_.evaluate(s.lo),
                    time_.reach,
                    {},
                    {},
                    time_.image};
  if (s.is_point()) return approach;
  approach.t_width = (s.hi - s.lo) * length;
  const Rational width = s.hi - s.lo;
  Rational steepest, bent;
  for (int k = 1; k <= distance2_.degree(); ++k) {
    steepest += k * abs(distance2_[k]);
    bent += k * (k - 1) * abs(distance2_[k]);
  }
  const Rational error = width * (is_stationary ? Rational(width * bent / 2) : steepest);
  const Rational lowest = std::max<Rational>(approach.distance2 - error, 0);
  approach.distance2_width = approach.distance2 + error - lowest;
  approach.distance2 = lowest;
  return approach;
}

const std::vector<RootInterval>& CommonPiece::stationary() const {
  if (!stationary_) stationary_ = roots_of(distance2_.derivative());
  return *stationary_;
}

Approach CommonPiece::nearest_on(const Span& span, const std::set<GivenContact>& contacts) const {
  Approach nearest = approach_at(span.begin, false), last = approach_at(span.end, false);
  // A constant distance is that of all instants between them, too.
  const bool is_constant = distance2_.degree() < 1;
  nearest.is_reached = is_constant || (span.begin.hi == 0 && is_near_at_begin_);
  last.is_reached = is_constant || (span.end.lo == 1 && is_near_at_end_);
  const auto is_same = [](const RootInterval& a, const RootInterval& b) {
    return a.is_point() && b.is_point() && a.lo == b.lo;
  };
  for (const RootInterval& s : stationary()) {
    if (s.hi >= span.begin.lo && s.lo <= span.end.hi && !is_same(s, span.begin) &&
        !is_same(s, span.end))
      nearest = nearer_of(nearest, approach_at(s, true));
  }
  nearest = nearer_of(nearest, last);
  if (!contacts.empty() && contacts.contains({time_.i, time_.j, nearest.t}))
    nearest.distance2 = time_.reach * time_.reach;
  return nearest;
}

std::optional<Approach> CommonPiece::nearest(const std::set<GivenContact>& contacts) const {
  std::optional<Approach> nearest;
  for (const Span& span : spans_) {
    Approach here = nearest_on(span, contacts);
    nearest = nearest ? nearer_of(*nearest, here) : std::move(here);
  }
  return nearest;
}

Enclosure CommonPiece::time_at(const RootInterval& s) const {
  const Rational length = time_.to - time_.from;
  return {round_down(Rational(time_.from + s.lo * length)),
          round_up(Rational(time_.from + s.hi * length))};
}

std::vector<SpellPart> CommonPiece::below(const Rational& distance,
                                          const std::set<GivenContact>& contacts) const {
  const Rational limit = time_.reach + distance, limit2 = limit * limit;
  const Polynomial<Rational> excess = distance2_ - Polynomial<Rational>{limit2};
  const auto is_below = [&](const Rational& s) { return excess.evaluate(s) < 0; };
  const std::vector<RootInterval> roots = roots_of(excess);
  std::vector<SpellPart> parts;
  for (const Span& span : spans_) {
    std::vector<RootInterval> places{span.begin};
    for (const RootInterval& root : roots) {
      const bool is_end = root.is_point() && (root.lo == span.begin.hi || root.lo == span.end.lo);
      if (root.lo >= span.begin.hi && root.hi <= span.end.lo && !is_end) places.push_back(root);
    }
    places.push_back(span.end);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Span here{places[k], places[k + 1]};
      // Two that are enclosed may share an end, which is neither of them.
      if (here.begin.hi > here.end.lo || !is_below((here.begin.hi + here.end.lo) / 2)) continue;
      Approach nearest = nearest_on(here, contacts);
      // At a contact the rounded places may be nearer than the disks.
      if (nearest.distance2 >= limit2) continue;
      parts.push_back({here.begin.hi == 0 && is_near_at_begin_ && is_below(0),
                       here.end.lo == 1 && is_near_at_end_ && is_below(1),
                       {time_at(here.begin), time_at(here.end), std::move(nearest)}});
    }
  }
  return parts;
}

bool CommonPiece::is_plainly_beyond(const Rational& distance2) const {
  // The least of a square is found as fast as that.
  return distance2_.degree() > 2 && distance2_.evaluate(0) > distance2 &&
         is_plainly_rootless(distance2_ - Polynomial<Rational>{distance2}, Rational(0),
                             Rational(1));
}

}  // namespace voroproof::internal
