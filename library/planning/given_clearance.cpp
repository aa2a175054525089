#include "library/planning/given_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/patience.h"
#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vec3 place_on(const Waypoint& a, const Waypoint& b, const Rational& t) {
  if (t == a.t) return a.at;
  return a.at + (b.at - a.at) * Rational((t - a.t) / (b.t - a.t));
}

// The curve from one time to another, by s from 0 to 1.
Curve cut(Curve curve, const Rational& from, const Rational& to) {
  const std::size_t n = curve.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (std::size_t k = n - 1; k-- > i;) curve[k] = curve[k] + curve[k + 1] * from;
  }
  Rational scale = 1;
  for (Vec3& c : curve) {
    c = c * scale;
    scale *= to - from;
  }
  return curve;
}

// Points whose convex hull has the curve for s from 0 to 1: its Bernstein coefficients.
std::vector<Vec3> control_points(const Curve& curve) {
  // Those of s^k are C(i, k) / C(n, k).
  std::vector<Vec3> points(curve.size());
  const auto n = static_cast<unsigned long>(curve.size() - 1);
  for (unsigned long i = 0; i <= n; ++i) {
    for (unsigned long k = 0; k <= i; ++k) {
      Integer chosen, all;
      mpz_bin_uiui(chosen.get_mpz_t(), i, k);
      mpz_bin_uiui(all.get_mpz_t(), n, k);
      points[i] = points[i] + curve[k] * Rational(Rational(chosen) / all);
    }
  }
  return points;
}

Vector3<double> each_of(const Vec3& v, double (*rounded)(const Rational&)) {
  return {rounded(v[0]), rounded(v[1]), rounded(v[2])};
}

}  // namespace

Vec3 place_at(const GivenPath& path, const Rational& t) {
  const std::vector<Waypoint>& w = path.waypoints;
  const auto next = std::lower_bound(
      w.begin(), w.end(), t, [](const Waypoint& p, const Rational& at) { return p.t < at; });
  if (next == w.begin()) return next->at;
  const auto leg = static_cast<std::size_t>(next - w.begin()) - 1;
  if (leg < path.curves.size() && !path.curves[leg].empty())
    return place_on(path.curves[leg], t - w[leg].t);
  return place_on(w[leg], *next, t);
}

Curve course_of(const GivenPath& path, std::size_t leg, const Rational& from, const Rational& to) {
  const Waypoint &a = path.waypoints[leg], &b = path.waypoints[leg + 1];
  if (leg < path.curves.size() && !path.curves[leg].empty())
    return cut(path.curves[leg], from - a.t, to - a.t);
  if (a.t == b.t) return {a.at, b.at - a.at};
  const Vec3 start = place_on(a, b, from);
  return {start, place_on(a, b, to) - start};
}

Polynomial<Rational> radius_of(const GivenPath& path, const Rational& from, const Rational& to) {
  return {path.radius_at(from), Rational(path.growth * (to - from))};
}

GivenClearance::GivenClearance(const GivenPaths& given, std::function<bool()> go_on,
                               ClearanceRules rules)
    : given_(given),
      disks_(disks_of(given.paths)),
      go_on_(std::move(go_on)),
      rules_(std::move(rules)),
      sides_below_(each_of(given.sides, round_down)),
      sides_above_(each_of(given.sides, round_up)),
      images_(sides_above_, rules_.height, go_on_) {
  for (std::size_t g = 0; g < given.paths.size(); ++g) {
    const GivenPath& path = given.paths[g];
    const std::size_t count = path.waypoints.size();
    const bool instants = rules_.at_waypoints || count == 1;
    for (std::size_t k = 0; instants && k < count; ++k) add_leg(static_cast<int>(g), k, k);
    for (std::size_t k = 0; k + 1 < count; ++k) {
      const bool stays = (k == 0 && path.stays_before) || (k + 2 == count && path.stays_after);
      if (!instants || stays) add_leg(static_cast<int>(g), k, k + 1);
    }
  }
  std::stable_sort(legs_.begin(), legs_.end(),
                   [](const Leg& a, const Leg& b) { return a.from < b.from; });
  for (const Leg& leg : legs_) motions_.push_back(motion_of(leg));
}

void GivenClearance::add_leg(int path, std::size_t first, std::size_t last) {
  const std::vector<Waypoint>& w = given_.paths[static_cast<std::size_t>(path)].waypoints;
  const GivenPath& own = given_.paths[static_cast<std::size_t>(path)];
  Leg leg{path,
          first,
          last,
          round_down(w[first].t),
          round_up(w[last].t),
          {},
          {},
          round_up(std::max(own.radius_at(w[first].t), own.radius_at(w[last].t)))};
  leg.low.fill(infinity);
  leg.high.fill(-infinity);
  const auto take = [&](const Vec3& at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      leg.low[axis] = std::min(leg.low[axis], round_down(at[axis]));
      leg.high[axis] = std::max(leg.high[axis], round_up(at[axis]));
    }
  };
  const Curve* curve = first == last ? nullptr : curve_of(leg);
  if (curve != nullptr) {
    for (const Vec3& p : control_points(cut(*curve, 0, w[last].t - w[first].t))) take(p);
  } else {
    take(w[first].at);
    take(w[last].at);
  }
  legs_.push_back(std::move(leg));
}

GivenClearance::Motion GivenClearance::motion_of(const Leg& leg) const {
  const auto ball3 = [](const Vec3& v) {
    return Ball3{ball_of(v[0]), ball_of(v[1]), ball_of(v[2])};
  };
  const auto [a, b] = ends(leg);
  Motion motion{
      ball_of(a.t), ball3(a.at), {}, curve_of(leg) == nullptr && (b.t > a.t || b.at == a.at)};
  if (motion.is_straight && b.t > a.t) {
    const DoubleBall time = ball_of(b.t - a.t);
    for (std::size_t axis = 0; axis < 3; ++axis)
      motion.velocity[axis] = ball_of(b.at[axis] - a.at[axis]) / time;
  }
  return motion;
}

std::pair<const Waypoint&, const Waypoint&> GivenClearance::ends(const Leg& leg) const {
  const std::vector<Waypoint>& w = given_.paths[static_cast<std::size_t>(leg.path)].waypoints;
  return {w[leg.first], w[leg.last]};
}

// Whether the disk is still there at the last waypoint of the leg.
bool GivenClearance::has_end(const Leg& leg) const {
  const GivenPath& path = given_.paths[static_cast<std::size_t>(leg.path)];
  return !path.ends_open || leg.last + 1 < path.waypoints.size();
}

// Null where the leg is straight.
const Curve* GivenClearance::curve_of(const Leg& leg) const {
  const std::vector<Curve>& curves = given_.paths[static_cast<std::size_t>(leg.path)].curves;
  if (rules_.at_waypoints || leg.first >= curves.size() || curves[leg.first].empty())
    return nullptr;
  return &curves[leg.first];
}

Curve GivenClearance::course(const Leg& leg, const Rational& from, const Rational& to) const {
  const auto [a, b] = ends(leg);
  if (&a == &b) return {a.at};
  return course_of(given_.paths[static_cast<std::size_t>(leg.path)], leg.first, from, to);
}

// Calls visit(a, b, image) for all pairs of legs of two disks that may be there at one time, and
// the images of the second of them that may be within `near`, or be the nearest.
template <class Visit>
void GivenClearance::each_pair(const std::optional<double>& near, Visit&& visit) const {
  std::vector<const Leg*> there;
  for (const Leg& leg : legs_) {
    if (!go_on_()) throw Interrupted();
    std::erase_if(there, [&](const Leg* other) { return other->to < leg.from; });
    for (const Leg* other : there) {
      if (disk(other->path) == disk(leg.path)) continue;
      const bool in_order = other->path < leg.path;
      each_image(in_order ? *other : leg, in_order ? leg : *other, near, visit);
    }
    there.push_back(&leg);
  }
}

template <class Visit>
void GivenClearance::each_image(const Leg& a, const Leg& b, const std::optional<double>& near,
                                Visit&& visit) const {
  if (!given_.is_periodic()) {
    visit(a, b, LatticeImage{});
    return;
  }
  const auto points = [&] {
    std::vector<Ball3> balls;
    const auto [from, to] = common_time(a, b);
    if (from > to) return balls;
    for (const Vec3& p : control_points(offset(a, b, from, to)))
      balls.push_back({ball_of(p[0]), ball_of(p[1]), ball_of(p[2])});
    return balls;
  };
  images_.each({b.low - a.high, b.high - a.low}, near, points,
               [&](const LatticeImage& image) { visit(a, b, image); });
}

std::pair<Rational, Rational> GivenClearance::common_time(const Leg& a, const Leg& b) const {
  const auto [a_first, a_last] = ends(a);
  const auto [b_first, b_last] = ends(b);
  return {std::max(a_first.t, b_first.t), std::min(a_last.t, b_last.t)};
}

// Where the second is from the first, by s from 0 to 1.
Curve GivenClearance::offset(const Leg& a, const Leg& b, const Rational& from,
                             const Rational& to) const {
  Curve offset = course(b, from, to);
  const Curve of_a = course(a, from, to);
  offset.resize(std::max(offset.size(), of_a.size()));
  for (std::size_t k = 0; k < of_a.size(); ++k) offset[k] = offset[k] - of_a[k];
  return offset;
}

// Each disk with the next images of itself along the axes, from which it is always as far.
std::vector<CommonPiece> GivenClearance::own_images() const {
  std::vector<CommonPiece> pieces;
  for (std::size_t g = 0; g < given_.paths.size(); ++g) {
    const GivenPath& path = given_.paths[g];
    const int disk = static_cast<int>(g);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (given_.sides[axis] == 0) continue;
      CommonTime time{disk, disk, {}, path.waypoints.front().t, path.waypoints.back().t, {}};
      time.reach = Rational(2) * radius_of(path, time.from, time.to);
      time.image[axis] = 1;
      Vec3 offset{};
      offset[axis] = given_.sides[axis];
      pieces.emplace_back(std::move(time), Curve{offset}, rules_.height);
    }
  }
  return pieces;
}

// Nothing where they are not there at one time, or for an instant only that a leg before one of
// them has, too.
std::optional<CommonPiece> GivenClearance::common(const Leg& a, const Leg& b,
                                                  const LatticeImage& image) const {
  const auto [a_first, a_last] = ends(a);
  const auto [b_first, b_last] = ends(b);
  const std::pair<Rational, Rational> time = common_time(a, b);
  const Rational &from = time.first, &to = time.second;
  if (from > to) return std::nullopt;
  const bool both_at_end = (to < a_last.t || has_end(a)) && (to < b_last.t || has_end(b));
  if (from == to && !both_at_end) return std::nullopt;
  const auto goes_on = [&](const Leg& leg, const Waypoint& first, const Waypoint& last) {
    return leg.first > 0 && first.t == to && first.t < last.t;
  };
  if (goes_on(a, a_first, a_last) || goes_on(b, b_first, b_last)) return std::nullopt;
  // Where one jumps the other jumps, too, if it does so at that time.
  const auto jumps_next = [&](const Leg& leg, const Waypoint& first, const Waypoint& last) {
    const std::vector<Waypoint>& w = given_.paths[static_cast<std::size_t>(leg.path)].waypoints;
    return first.t < last.t && leg.first + 2 < w.size() && w[leg.first + 2].t == to;
  };
  if ((a_first.t == a_last.t && jumps_next(b, b_first, b_last)) ||
      (b_first.t == b_last.t && jumps_next(a, a_first, a_last)))
    return std::nullopt;
  Curve way = offset(a, b, from, to);
  for (std::size_t axis = 0; axis < 3; ++axis) way[0][axis] += image[axis] * given_.sides[axis];
  const auto radius = [&](const Leg& leg) {
    return radius_of(given_.paths[static_cast<std::size_t>(leg.path)], from, to);
  };
  return CommonPiece({a.path, b.path, image, from, to, radius(a) + radius(b), both_at_end}, way,
                     rules_.height);
}

// No distance is less than that of the boxes along an axis: a certain lower bound of it.
double GivenClearance::apart_above(const Leg& a, const Leg& b, const LatticeImage& image) const {
  double apart = 0;
  for (std::size_t axis = 0; axis < (rules_.height ? 2 : 3); ++axis) {
    double low_b = b.low[axis], high_b = b.high[axis];
    if (const int k = image[axis]; k != 0) {
      const double near = k * sides_below_[axis], far = k * sides_above_[axis];
      low_b = next_below(low_b + next_below(std::min(near, far)));
      high_b = next_above(high_b + next_above(std::max(near, far)));
    }
    apart = std::max({apart, low_b - a.high[axis], a.low[axis] - high_b});
  }
  return next_below(apart);
}

// A certain lower bound of the gap on the common piece of two legs, if they have one.
double GivenClearance::gap_above(const Leg& a, const Leg& b, const LatticeImage& image) const {
  const Motion &p = motions_[static_cast<std::size_t>(&a - legs_.data())],
               &q = motions_[static_cast<std::size_t>(&b - legs_.data())];
  if (!p.is_straight || !q.is_straight || rules_.height) return -infinity;
  const double from = std::max(a.from, b.from), to = std::min(a.to, b.to);
  const auto offset = [&](const DoubleBall& t) {
    Ball3 of = (q.at + q.velocity * (t - q.t)) - (p.at + p.velocity * (t - p.t));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (image[axis] == 0) continue;
      of[axis] = of[axis] +
                 DoubleBall(image[axis]) * DoubleBall::hull(sides_below_[axis], sides_above_[axis]);
    }
    return of;
  };
  const double apart = least_distance(offset(DoubleBall::hull(from, next_above(from))),
                                      offset(DoubleBall::hull(next_below(to), to)));
  return low(DoubleBall(apart) - (DoubleBall(a.radius) + DoubleBall(b.radius)));
}

// By how much two may be apart on their paths where the gap counts as zero: rounded up.
double GivenClearance::largest_gap_at_contacts() const {
  double largest = 0;
  for (const GivenContact& contact : given_.contacts) {
    if (contact.i < 0) continue;
    const GivenPath &p = given_.paths[static_cast<std::size_t>(contact.i)],
                    &q = given_.paths[static_cast<std::size_t>(contact.j)];
    if (contact.t < p.waypoints.front().t || contact.t > p.waypoints.back().t) continue;
    Vec3 offset = place_at(q, contact.t) - place_at(p, contact.t);
    for (std::size_t axis = 0; axis < 3; ++axis)
      offset[axis] += contact.image[axis] * given_.sides[axis];
    const DoubleBall apart = sqrt(ball_of(dot(offset, offset)));
    const Rational reach = p.radius_at(contact.t) + q.radius_at(contact.t);
    largest = std::max(largest, -low(ball_of(reach) - apart));
  }
  return largest;
}

std::optional<Approach> GivenClearance::least() const {
  std::optional<Approach> least;
  double least_above = infinity;
  const double at_contacts = largest_gap_at_contacts();
  // Whether gaps of so much and more are not the least, nor one that a contact makes zero.
  const auto is_more = [&](double gap) {
    return gap > least_above && (least_above < 0 || gap > at_contacts);
  };
  const auto take = [&](const CommonPiece& piece) {
    const std::optional<Approach> approach = piece.nearest(given_.contacts);
    if (!approach) return;
    least = least ? nearer_of(*least, *approach) : *approach;
    least_above = gap(*least).hi;
  };
  for (const CommonPiece& piece : own_images()) take(piece);
  each_pair(std::nullopt, [&](const Leg& a, const Leg& b, const LatticeImage& image) {
    const double reach = next_above(a.radius + b.radius);
    if (is_more(next_below(apart_above(a, b, image) - reach)) || is_more(gap_above(a, b, image)))
      return;
    const std::optional<CommonPiece> piece = common(a, b, image);
    if (!piece) return;
    // Further than the least gap that is known, and no contact.
    const double beyond = least_above < 0 ? least_above : std::max(least_above, at_contacts);
    if (least && piece->is_plainly_beyond(to_rational(beyond))) return;
    take(*piece);
  });
  return least;
}

std::vector<NearSpell> GivenClearance::spells_below(const Rational& distance) const {
  SpellsBelow spells(distance, given_.contacts);
  double widest = 0;
  for (const Leg& leg : legs_) widest = std::max(widest, leg.radius);
  const double beyond = round_up(distance);
  const auto add = [&](const CommonPiece& piece) {
    spells.add(piece, disk(piece.time().i), disk(piece.time().j));
  };
  for (const CommonPiece& piece : own_images()) add(piece);
  const double nearest = next_above(next_above(2 * widest) + beyond);
  each_pair(nearest, [&](const Leg& a, const Leg& b, const LatticeImage& image) {
    const double near = next_above(next_above(a.radius + b.radius) + beyond);
    if (apart_above(a, b, image) > near) return;
    if (const std::optional<CommonPiece> piece = common(a, b, image)) add(*piece);
  });
  return spells.spells();
}

}  // namespace voroproof::internal
