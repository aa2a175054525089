#include "library/planning/given_clearance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "exact/patience.h"
#include "filtered/numbers/next_double.h"

namespace voroproof::internal {

namespace {

Point2 place_on(const Waypoint& a, const Waypoint& b, const Rational& t) {
  if (t == a.t) return a.at;
  const Rational part = (t - a.t) / (b.t - a.t);
  return {a.at.x + part * (b.at.x - a.at.x), a.at.y + part * (b.at.y - a.at.y)};
}

// A part of a spell, within the common piece of two legs.
struct Part {
  Rational begin, end;    // times of the piece
  bool at_begin, at_end;  // whether the gap is less than the distance there
  NearSpell spell;
};

// The parts of one pair in order of time, put together where one goes on in the next.
void join(std::vector<Part>& parts, std::vector<NearSpell>& spells) {
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.begin < b.begin; });
  const Part* last = nullptr;
  for (const Part& p : parts) {
    if (last != nullptr && last->at_end && p.at_begin && last->end == p.begin) {
      NearSpell& open = spells.back();
      open.to = p.spell.to;
      if (compare_gaps(p.spell.nearest, open.nearest) < 0) open.nearest = p.spell.nearest;
    } else {
      spells.push_back(p.spell);
    }
    last = &p;
  }
}

}  // namespace

Point2 place_at(const GivenPath& path, const Rational& t) {
  const std::vector<Waypoint>& w = path.waypoints;
  const auto next = std::lower_bound(
      w.begin(), w.end(), t, [](const Waypoint& p, const Rational& at) { return p.t < at; });
  return next == w.begin() ? next->at : place_on(*(next - 1), *next, t);
}

// The common piece of two legs: the offset of the centres at both ends, and the reach.
struct GivenClearance::Common {
  int i, j;
  Rational from, to;
  Point2 a, b;
  Rational reach;

  Approach nearest(const std::set<GivenContact>& contacts) const {
    const auto [part, distance2] = nearest_to_origin(a, b);
    const Rational t = from + part * (to - from);
    const bool touch = contacts.contains({i, j, t});
    return {i, j, t, touch ? Rational(reach * reach) : distance2, reach};
  }
};

GivenClearance::GivenClearance(const std::vector<GivenPath>& paths, std::function<bool()> go_on,
                               std::set<GivenContact> contacts)
    : paths_(paths), go_on_(std::move(go_on)), contacts_(std::move(contacts)) {
  for (std::size_t g = 0; g < paths.size(); ++g) {
    const std::vector<Waypoint>& w = paths[g].waypoints;
    const std::size_t last = w.size() - 1;
    for (std::size_t k = 0; k < std::max<std::size_t>(last, 1); ++k) {
      const Waypoint &a = w[k], &b = w[std::min(k + 1, last)];
      const auto [x_lo, x_hi] = std::minmax(a.at.x, b.at.x);
      const auto [y_lo, y_hi] = std::minmax(a.at.y, b.at.y);
      legs_.push_back({static_cast<int>(g), k, round_down(a.t), round_up(b.t), round_down(x_lo),
                       round_up(x_hi), round_down(y_lo), round_up(y_hi)});
    }
  }
  std::stable_sort(legs_.begin(), legs_.end(),
                   [](const Leg& a, const Leg& b) { return a.from < b.from; });
  for (const Leg& leg : legs_) {
    const GivenPath& path = paths[static_cast<std::size_t>(leg.path)];
    const auto [a, b] = ends(leg);
    Motion motion{ball_of(a.t), {ball_of(a.at.x), ball_of(a.at.y)}, {}, ball_of(path.radius)};
    if (b.t > a.t) {
      const DoubleBall time = ball_of(b.t - a.t);
      motion.velocity = {ball_of(b.at.x - a.at.x) / time, ball_of(b.at.y - a.at.y) / time};
    }
    motions_.push_back(motion);
  }
}

std::pair<const Waypoint&, const Waypoint&> GivenClearance::ends(const Leg& leg) const {
  const std::vector<Waypoint>& w = paths_[static_cast<std::size_t>(leg.path)].waypoints;
  return {w[leg.first], w[std::min(leg.first + 1, w.size() - 1)]};
}

// All pairs of legs of two disks that may be there at one time.
template <class Visit>
void GivenClearance::each_pair(Visit&& visit) const {
  std::vector<const Leg*> there;
  for (const Leg& leg : legs_) {
    if (!go_on_()) throw Interrupted();
    std::erase_if(there, [&](const Leg* other) { return other->to < leg.from; });
    for (const Leg* other : there) {
      if (other->path != leg.path) visit(*other, leg);
    }
    there.push_back(&leg);
  }
}

// Nothing where they are not there at one time, or for an instant only that a leg before one of
// them has, too.
std::optional<GivenClearance::Common> GivenClearance::common(const Leg& a, const Leg& b) const {
  const Leg &p = a.path < b.path ? a : b, &q = a.path < b.path ? b : a;
  const auto [p_first, p_last] = ends(p);
  const auto [q_first, q_last] = ends(q);
  const Rational from = std::max(p_first.t, q_first.t), to = std::min(p_last.t, q_last.t);
  if (from > to) return std::nullopt;
  const auto goes_on = [&](const Leg& leg, const Waypoint& first) {
    return leg.first > 0 && first.t == to;
  };
  if (goes_on(p, p_first) || goes_on(q, q_first)) return std::nullopt;
  const auto offset = [&, &p0 = p_first, &p1 = p_last, &q0 = q_first,
                       &q1 = q_last](const Rational& t) -> Point2 {
    const Point2 u = place_on(p0, p1, t), v = place_on(q0, q1, t);
    return {v.x - u.x, v.y - u.y};
  };
  return Common{p.path,
                q.path,
                from,
                to,
                offset(from),
                offset(to),
                Rational(paths_[static_cast<std::size_t>(p.path)].radius +
                         paths_[static_cast<std::size_t>(q.path)].radius)};
}

// A certain lower bound of the gap on the common piece of two legs, if they have one.
double GivenClearance::gap_above(const Leg& a, const Leg& b) const {
  const Motion &p = motions_[static_cast<std::size_t>(&a - legs_.data())],
               &q = motions_[static_cast<std::size_t>(&b - legs_.data())];
  const double from = std::max(a.from, b.from), to = std::min(a.to, b.to);
  const auto offset = [&](const DoubleBall& t) -> Ball2 {
    const DoubleBall of_p = t - p.t, of_q = t - q.t;
    return {(q.at.x + of_q * q.velocity.x) - (p.at.x + of_p * p.velocity.x),
            (q.at.y + of_q * q.velocity.y) - (p.at.y + of_p * p.velocity.y)};
  };
  const double apart = least_distance(offset(DoubleBall::hull(from, next_above(from))),
                                      offset(DoubleBall::hull(next_below(to), to)));
  return low(DoubleBall(apart) - (p.radius + q.radius));
}

// By how much two may be apart on their paths where the gap counts as zero: rounded up.
double GivenClearance::largest_gap_at_contacts() const {
  double largest = 0;
  for (const GivenContact& contact : contacts_) {
    if (contact.i == container_id) continue;
    const GivenPath &p = paths_[static_cast<std::size_t>(contact.i)],
                    &q = paths_[static_cast<std::size_t>(contact.j)];
    if (contact.t < p.waypoints.front().t || contact.t > p.waypoints.back().t) continue;
    const Point2 a = place_at(p, contact.t), b = place_at(q, contact.t);
    const DoubleBall x = ball_of(a.x - b.x), y = ball_of(a.y - b.y);
    largest = std::max(largest, -low(ball_of(p.radius + q.radius) - sqrt(x * x + y * y)));
  }
  return largest;
}

std::optional<Approach> GivenClearance::least() const {
  std::optional<Approach> least;
  double least_above = std::numeric_limits<double>::infinity();
  std::vector<double> radii;
  for (const GivenPath& p : paths_) radii.push_back(round_up(p.radius));
  const double at_contacts = largest_gap_at_contacts();
  // Whether gaps of so much and more are not the least, nor one that a contact makes zero.
  const auto is_more = [&](double gap) {
    return gap > least_above && (least_above < 0 || gap > at_contacts);
  };
  each_pair([&](const Leg& a, const Leg& b) {
    // No gap is less than the distance of the boxes along an axis, less the radii.
    const double apart =
        std::max({a.x_lo - b.x_hi, b.x_lo - a.x_hi, a.y_lo - b.y_hi, b.y_lo - a.y_hi, 0.0});
    const double reach = next_above(radii[static_cast<std::size_t>(a.path)] +
                                    radii[static_cast<std::size_t>(b.path)]);
    if (is_more(next_below(next_below(apart) - reach)) || is_more(gap_above(a, b))) return;
    const auto piece = common(a, b);
    if (!piece) return;
    const Approach approach = piece->nearest(contacts_);
    if (least) {
      const auto order = compare_gaps(approach, *least);
      if (order > 0) return;
      if (order == 0 &&
          std::tie(approach.t, approach.i, approach.j) >= std::tie(least->t, least->i, least->j)) {
        return;
      }
    }
    least = approach;
    least_above = gap(approach).hi;
  });
  return least;
}

std::vector<NearSpell> GivenClearance::spells_below(const Rational& distance) const {
  std::map<std::pair<int, int>, std::vector<Part>> parts;
  std::vector<double> widths;  // a radius and half of the distance
  for (const GivenPath& p : paths_) widths.push_back(round_up(Rational(p.radius + distance / 2)));
  each_pair([&](const Leg& a, const Leg& b) {
    const double near = next_above(widths[static_cast<std::size_t>(a.path)] +
                                   widths[static_cast<std::size_t>(b.path)]);
    if (a.x_lo > next_above(b.x_hi + near) || b.x_lo > next_above(a.x_hi + near) ||
        a.y_lo > next_above(b.y_hi + near) || b.y_lo > next_above(a.y_hi + near)) {
      return;
    }
    const auto piece = common(a, b);
    if (!piece) return;
    const Approach nearest = piece->nearest(contacts_);
    const Rational limit = piece->reach + distance, limit2 = limit * limit;
    // At a contact the rounded places tell, too: the ends of the spell are theirs.
    if (nearest.distance2 >= limit2 || piece->nearest({}).distance2 >= limit2) return;
    const auto below = [&](const Point2& o) { return o.x * o.x + o.y * o.y < limit2; };
    Part part{piece->from,
              piece->to,
              below(piece->a),
              below(piece->b),
              {enclosure(piece->from), enclosure(piece->to), nearest}};
    // |a + s u|^2 = limit^2, s from 0 to 1: s = -h -+ sqrt(h^2 - c).
    const Rational ux = piece->b.x - piece->a.x, uy = piece->b.y - piece->a.y;
    const Rational u2 = ux * ux + uy * uy, length = piece->to - piece->from;
    if (!part.at_begin || !part.at_end) {
      const Rational h = (piece->a.x * ux + piece->a.y * uy) / u2;
      const Rational c = (piece->a.x * piece->a.x + piece->a.y * piece->a.y - limit2) / u2;
      const Rational root2 = (h * h - c) * length * length, middle = piece->from - h * length;
      if (!part.at_begin) {
        const Enclosure before = root_less(root2, middle);
        part.spell.from = {-before.hi + 0.0, -before.lo + 0.0};
      }
      if (!part.at_end) part.spell.to = root_less(root2, -middle);
    }
    parts[{piece->i, piece->j}].push_back(std::move(part));
  });
  std::vector<NearSpell> spells;
  for (auto& [pair, all] : parts) join(all, spells);
  return spells;
}

}  // namespace voroproof::internal
