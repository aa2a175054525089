#include "library/planning/common_piece.h"

#include <algorithm>
#include <compare>
#include <utility>

#include "exact/algebraic.h"

namespace voroproof::internal {

namespace {

// To which part of a piece roots are narrowed.
const Rational narrow = Rational(1) / (Integer(1) << 120);

Place point(const Rational& s) { return {{s, s}}; }

AlgebraicNumber<Rational> number(const Place& place) {
  if (place.s.is_point()) return place.s.lo;
  return {*place.root_of, place.s};
}

// A root that is enclosed is at neither end of its enclosure.
std::strong_ordering operator<=>(const Place& a, const Place& b) {
  const bool are_points = a.s.is_point() && b.s.is_point();
  if (are_points ? a.s.lo < b.s.lo : a.s.hi <= b.s.lo) return std::strong_ordering::less;
  if (are_points ? b.s.lo < a.s.lo : b.s.hi <= a.s.lo) return std::strong_ordering::greater;
  if (are_points) return std::strong_ordering::equal;
  return compare(number(a), number(b));
}

// A fraction between two that differ.
Rational between(const Place& a, const Place& b) {
  if (a.s.hi <= b.s.lo) return (a.s.hi + b.s.lo) / 2;
  return rational_between(number(a), number(b));
}

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

std::vector<RootInterval> enclosures_of(const Polynomial<Rational>& f) {
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

// The roots in [0, 1], in order: exact, or narrowed. None of a constant.
std::vector<Place> roots_of(const Polynomial<Rational>& f) {
  std::vector<Place> places;
  std::shared_ptr<const Polynomial<Rational>> shared;
  for (RootInterval& root : enclosures_of(f)) {
    if (!root.is_point() && !shared) shared = std::make_shared<const Polynomial<Rational>>(f);
    places.push_back({root, root.is_point() ? nullptr : shared});
  }
  return places;
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
  if (!height && !z.is_zero()) distance2_ = distance2_ + z * z;
  is_constant_ = distance2_.degree() < 1 && time_.reach.degree() < 1;
  if (!height) {
    spans_.push_back({point(0), point(1)});
    return;
  }
  // Between neighbours of these places z - height and z + height keep their signs.
  std::vector<Place> places{point(0), point(1)};
  for (const Rational& limit : {Rational(-*height), *height}) {
    for (Place& root : roots_of(z - Polynomial<Rational>{limit})) places.push_back(std::move(root));
  }
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return (a <=> b) < 0; });
  const auto is_near = [&](const Rational& s) { return abs(z.evaluate(s)) < *height; };
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const Place &a = places[k], &b = places[k + 1];
    if ((a <=> b) < 0 && is_near(between(a, b))) spans_.push_back({a, b});
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
                    time_.reach.evaluate(s.lo),
                    {},
                    {},
                    time_.image};
  if (s.is_point()) return approach;
  const Rational width = s.hi - s.lo;
  approach.t_width = width * length;
  Rational steepest, bent, growth;
  for (int k = 1; k <= distance2_.degree(); ++k) {
    steepest += k * abs(distance2_[k]);
    bent += k * (k - 1) * abs(distance2_[k]);
  }
  for (int k = 1; k <= time_.reach.degree(); ++k) growth += k * abs(time_.reach[k]);
  const Rational error = width * (is_stationary ? Rational(width * bent / 2) : steepest);
  const Rational lowest = std::max<Rational>(approach.distance2 - error, 0);
  Rational highest = approach.distance2 + error;
  if (growth != 0) {
    // The greatest reach stands for all, and a greater distance for the others.
    approach.reach += width * growth;
    const Rational root = root_bounds(highest).second + 2 * width * growth;
    highest = root * root;
  }
  approach.distance2_width = highest - lowest;
  approach.distance2 = lowest;
  return approach;
}

// The gap's derivative is zero where that of the distance's square, D', is 2 sqrt(D) times the
// reach's, r': at roots of D'^2 - 4 r'^2 D, some of which are others. Where that is zero throughout
// D is a square, and the gap is bent at its root alone.
const std::vector<Place>& CommonPiece::stationary() const {
  if (stationary_) return *stationary_;
  const Polynomial<Rational> slope = distance2_.derivative(), growth = time_.reach.derivative();
  if (growth.is_zero()) return stationary_.emplace(roots_of(slope));
  if (distance2_.is_zero()) return stationary_.emplace(roots_of(growth));
  const Polynomial<Rational> steady = slope * slope - Rational(4) * growth * growth * distance2_;
  stationary_ = roots_of(steady.is_zero() ? slope : steady);
  for (Place& place : *stationary_) {
    if (!place.s.is_point()) refine(*place.root_of, place.s, narrow);
  }
  return *stationary_;
}

Approach CommonPiece::at_contact(Approach approach, const std::set<GivenContact>& contacts) const {
  if (contacts.empty() || !contacts.contains({time_.i, time_.j, approach.t, time_.image}))
    return approach;
  if (is_at_wall() && distance2_.is_zero())
    approach.reach = 0;
  else
    approach.distance2 = approach.reach * approach.reach;
  return approach;
}

bool CommonPiece::is_inside(const Place& place, const Span& span) {
  return (place <=> span.begin) > 0 && (place <=> span.end) < 0;
}

// A contact hides no other place: each is held against the contacts before they are compared.
Approach CommonPiece::nearest_on(const Span& span, const std::set<GivenContact>& contacts) const {
  const auto approach = [&](const RootInterval& s, bool is_stationary) {
    return at_contact(approach_at(s, is_stationary), contacts);
  };
  Approach nearest = approach(span.begin.s, false), last = approach(span.end.s, false);
  // On a straight way a disk sticks out of its frame by a convex function, which is greatest at an
  // end.
  if (is_at_wall() && distance2_.degree() <= 2 && time_.reach.degree() <= 1)
    return nearer_of(nearest, last);
  // A constant gap is that of all instants between them, too.
  nearest.is_reached = is_constant_ || (span.begin.s.hi == 0 && is_near_at_begin_);
  last.is_reached = is_constant_ || (span.end.s.lo == 1 && is_near_at_end_ && time_.has_end);
  for (const Place& place : stationary()) {
    if (is_inside(place, span))
      nearest = nearer_of(nearest, approach(place.s, time_.reach.degree() < 1));
  }
  return nearer_of(nearest, last);
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

Polynomial<Rational> CommonPiece::limit(const Rational& distance) const {
  return time_.reach + Polynomial<Rational>{is_at_wall() ? Rational(-distance) : distance};
}

// Where the limit is negative a disk is as near to a wall as that whatever its place, so that roots
// there end nothing. Nor do those of the limit itself: on both sides of one the disk is as near,
// unless it is in the container's centre then, and that is a root of the excess.
std::vector<Place> CommonPiece::ends_below(const Rational& distance) const {
  const Polynomial<Rational> limit = this->limit(distance), excess = distance2_ - limit * limit;
  if (!is_at_wall()) return roots_of(excess);
  if (distance2_.is_zero() || excess.is_zero()) return roots_of(limit);
  std::vector<Place> roots = roots_of(excess);
  std::erase_if(roots, [&](const Place& place) {
    return limit.evaluate(place.s.lo) < 0 && limit.evaluate(place.s.hi) < 0;
  });
  return roots;
}

std::vector<SpellPart> CommonPiece::below(const Rational& distance,
                                          const std::set<GivenContact>& contacts) const {
  const Polynomial<Rational> limit = this->limit(distance), excess = distance2_ - limit * limit;
  const auto is_below = [&](const Rational& s) {
    return is_at_wall() ? limit.evaluate(s) < 0 || excess.evaluate(s) > 0 : excess.evaluate(s) < 0;
  };
  const std::vector<Place> roots = ends_below(distance);
  std::vector<SpellPart> parts;
  for (const Span& span : spans_) {
    std::vector<Place> places{span.begin};
    for (const Place& root : roots) {
      if (is_inside(root, span)) places.push_back(root);
    }
    places.push_back(span.end);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Span here{places[k], places[k + 1]};
      if (!is_below(between(here.begin, here.end))) continue;
      Approach nearest = nearest_on(here, contacts);
      // At a contact the rounded places may be nearer than the disks.
      if (keeps_clear(nearest, distance, Touching::is_allowed)) continue;
      parts.push_back({here.begin.s.hi == 0 && is_near_at_begin_ && is_below(0),
                       here.end.s.lo == 1 && is_near_at_end_ && (!time_.has_end || is_below(1)),
                       {time_at(here.begin.s), time_at(here.end.s), std::move(nearest)}});
    }
  }
  return parts;
}

// The least of a square of degree 2 is found as fast as that where radii are constant.
bool CommonPiece::is_plainly_beyond(const Rational& gap) const {
  const Polynomial<Rational> limit = this->limit(gap), excess = distance2_ - limit * limit;
  return (excess.degree() > 2 || time_.reach.degree() > 0) && excess.evaluate(0) > 0 &&
         is_plainly_rootless(excess, Rational(0), Rational(1));
}

void SpellsBelow::add(const CommonPiece& piece, int i, int j) {
  const CommonTime& time = piece.time();
  for (SpellPart& part : piece.below(distance_, contacts_))
    parts_[{i, j, time.image}].push_back({time.from, time.to, std::move(part)});
}

std::vector<NearSpell> SpellsBelow::spells() {
  std::vector<NearSpell> spells;
  for (auto& [pair, parts] : parts_) join(parts, spells);
  return spells;
}

// The parts of one pair, in order of time.
void SpellsBelow::join(std::vector<PiecePart>& parts, std::vector<NearSpell>& spells) {
  std::stable_sort(parts.begin(), parts.end(), [](const PiecePart& a, const PiecePart& b) {
    return std::tie(a.begin, a.end) < std::tie(b.begin, b.end);
  });
  const PiecePart* last = nullptr;
  for (const PiecePart& p : parts) {
    if (last != nullptr && last->part.at_end && p.part.at_begin && last->end == p.begin) {
      NearSpell& open = spells.back();
      open.to = p.part.spell.to;
      open.nearest = nearer_of(open.nearest, p.part.spell.nearest);
    } else {
      spells.push_back(p.part.spell);
    }
    last = &p;
  }
}

}  // namespace voroproof::internal
