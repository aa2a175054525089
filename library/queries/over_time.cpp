#include "library/queries/over_time.h"

#include <algorithm>
#include <map>
#include <set>
#include <variant>

#include "exact/tower.h"

namespace voroproof::internal {
namespace {

using Pair = std::pair<GenId, GenId>;
using Spells = std::map<Pair, std::vector<Window>>;

// Follows the pairs of generators that share an edge, from event to event.
class Adjacency {
 public:
  explicit Adjacency(const Window& window) : window_(window) {}

  void begin(Pair pair, const Rational& t) {
    int& edges = edges_[pair];
    if (edges++ == 0) since_[pair] = t;
  }
  void end(Pair pair, const Rational& t) {
    if (--edges_[pair] > 0) return;
    close(pair, t);
  }
  Spells finish() {
    for (const auto& [pair, edges] : edges_) {
      if (edges > 0) close(pair, window_.to);
    }
    return std::move(spells_);
  }

 private:
  void close(Pair pair, const Rational& t) {
    const Rational& since = since_[pair];
    if (since == t && window_.from != window_.to) return;
    std::vector<Window>& all = spells_[pair];
    // Gone and there again within the flips at one time: the spell goes on.
    if (!all.empty() && all.back().to == since) {
      all.back().to = t;
    } else {
      all.push_back({since, t});
    }
  }

  Window window_;
  std::map<Pair, int> edges_;
  std::map<Pair, Rational> since_;
  Spells spells_;
};

// All spells of neighbourhood; `wanted` says of which pairs.
template <class Wanted>
Spells spells(HistoryCursor& history, const Window& window, Wanted&& wanted) {
  Adjacency adjacency(window);
  history.seek(window.from);
  const Diagram& diagram = history.diagram().diagram();
  const auto pair = [](GenId a, GenId b) { return Pair(std::minmax(a, b)); };
  if (diagram.disks() == 1) adjacency.begin({container_id, 0}, window.from);
  for (Diagram::HalfEdge h = 0; h < 2 * diagram.edges(); h += 2) {
    const Pair p = pair(diagram.org(h), diagram.dest(h));
    if (wanted(p)) adjacency.begin(p, window.from);
  }
  const std::size_t end = history.position_at(window.to);
  while (history.position() < end) {
    const Event& event = history.event(history.position());
    if (const auto* flip = std::get_if<FlipEvent>(&event)) {
      const Pair old = pair(flip->quad.l, flip->quad.r), now = pair(flip->quad.s, flip->quad.e);
      const Rational t = std::min(exact_time(event), window.to);
      if (wanted(now)) adjacency.begin(now, t);
      if (wanted(old)) adjacency.end(old, t);
    }
    history.next();
  }
  return adjacency.finish();
}

Rational squared_distance(const ExactVec2& a, const ExactVec2& b) {
  const Rational x = a[0] - b[0], y = a[1] - b[1];
  return x * x + y * y;
}

// The sum of the signed radii. The gap of two disks is sqrt(distance2) minus the sum; that of a
// disk and the container is minus the sum, minus sqrt(distance2).
Rational reach(const Paths& paths, const LeastGap& g) {
  return paths.signed_radius(g.i) + paths.signed_radius(g.j);
}

// The gap along the paths, by so many bits.
Ball gap_ball(const Paths& paths, const LeastGap& g, int bits) {
  const Ball d = sqrt(Ball(g.distance2, bits)), sum(reach(paths, g), bits);
  return g.i == container_id ? -sum - d : d - sum;
}

// The sign of the gap of `a` minus that of `b`, both of disks.
Sign compare_gaps(const Paths& paths, const LeastGap& a, const LeastGap& b) {
  const Enclosure x = gap_of(paths, a), y = gap_of(paths, b);
  if (x.hi < y.lo) return Sign::negative;
  if (x.lo > y.hi) return Sign::positive;
  RadicalField field;
  const auto gap = [&](const LeastGap& g) {
    return g.contact ? Tower(0) : field.sqrt(Tower(g.distance2)) - Tower(reach(paths, g));
  };
  return sign(gap(a) - gap(b));
}

bool earlier(const LeastGap& a, const LeastGap& b) {
  return a.t != b.t ? a.t < b.t : Pair(a.i, a.j) < Pair(b.i, b.j);
}

// The least gap of the two along their paths, without regard to collisions.
LeastGap least_along_paths(const Paths& paths, GenId i, GenId j, const Window& window) {
  const bool wall = i == container_id;
  std::vector<Rational> ends{window.from};
  for (Rational& t : paths.turns({i, j}, window.from, window.to)) ends.push_back(std::move(t));
  ends.push_back(window.to);
  std::optional<LeastGap> least;
  const auto offer = [&](const Rational& t, const RecordedState& a, const RecordedState& b) {
    Rational d2 = squared_distance(position_at(a, t), position_at(b, t));
    if (!least || (wall ? d2 > least->distance2 : d2 < least->distance2)) {
      least = LeastGap{i, j, t, std::move(d2), false};
    }
  };
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const RecordedState &a = paths.piece(i, ends[k]), &b = paths.piece(j, ends[k]);
    offer(ends[k], a, b);
    if (!wall) {
      const ExactVec2 p = position_at(a, ends[k]), q = position_at(b, ends[k]);
      const Rational wx = b.velocity[0] - a.velocity[0], wy = b.velocity[1] - a.velocity[1];
      const Rational w2 = wx * wx + wy * wy;
      if (w2 != 0) {
        const Rational delay = -((q[0] - p[0]) * wx + (q[1] - p[1]) * wy) / w2;
        const Rational t = ends[k] + delay;
        if (delay > 0 && t < ends[k + 1]) offer(t, a, b);
      }
    }
    offer(ends[k + 1], a, b);
  }
  return *least;
}

// The first collision within the window that `wanted` accepts.
template <class Wanted>
std::optional<LeastGap> first_contact(const Paths& paths, const HistoryCursor& history,
                                      const Window& window, Wanted&& wanted) {
  const std::size_t end = history.position_at(window.to);
  for (std::size_t k = 0; k < end; ++k) {
    const auto* collision = std::get_if<CollideEvent>(&history.event(k));
    if (collision == nullptr || !wanted(collision->i, collision->j)) continue;
    const Rational t = exact_time(history.event(k));
    if (t < window.from) continue;
    LeastGap contact{collision->i, collision->j, std::min(t, window.to), 0, true};
    const Rational sum = reach(paths, contact);
    contact.distance2 = sum * sum;
    return contact;
  }
  return std::nullopt;
}

// Whether the least gap along the paths is none, earlier than the contact.
bool touches_before(const Paths& paths, const LeastGap& least, const LeastGap& contact) {
  const Rational sum = reach(paths, least);
  const bool wall = least.i == container_id;
  return least.t < contact.t &&
         (wall ? least.distance2 >= sum * sum : least.distance2 <= sum * sum);
}

}  // namespace

std::vector<Neighbourhood> neighbours_over(HistoryCursor& history, GenId disk,
                                           const Window& window) {
  std::vector<Neighbourhood> all;
  for (const auto& [pair, windows] : spells(
           history, window, [&](const Pair& p) { return p.first == disk || p.second == disk; })) {
    for (const Window& w : windows) {
      all.push_back({pair.first == disk ? pair.second : pair.first, w.from, w.to});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Neighbourhood& a, const Neighbourhood& b) {
    return a.generator < b.generator;
  });
  return all;
}

LeastGap least_gap(const Paths& paths, const HistoryCursor& history, GenId i, GenId j,
                   const Window& window) {
  if (j < i) std::swap(i, j);
  const auto contact =
      first_contact(paths, history, window, [&](GenId a, GenId b) { return a == i && b == j; });
  if (!contact) return least_along_paths(paths, i, j, window);
  // Before they collide they may have touched already, without approaching.
  const LeastGap before = least_along_paths(paths, i, j, {window.from, contact->t});
  return touches_before(paths, before, *contact) ? before : *contact;
}

std::optional<LeastGap> least_gap_of_all(const Paths& paths, HistoryCursor& history,
                                         const Window& window) {
  const int disks = history.diagram().diagram().disks();
  if (disks < 2) return std::nullopt;
  const auto of_disks = [](GenId a, GenId) { return a != container_id; };
  const auto spells_of_disks = [&](const Window& w) {
    return spells(history, w, [](const Pair& p) { return p.first != container_id; });
  };
  if (auto first = first_contact(paths, history, window, of_disks)) {
    // Others may have touched before, without approaching; they are neighbours then.
    const LeastGap contact = *first;
    for (const auto& [pair, windows] : spells_of_disks({window.from, contact.t})) {
      for (const Window& w : windows) {
        const LeastGap gap = least_along_paths(paths, pair.first, pair.second, w);
        if (touches_before(paths, gap, contact) && earlier(gap, *first)) first = gap;
      }
    }
    return first;
  }
  std::optional<LeastGap> least;
  const auto offer = [&](const LeastGap& gap) {
    const Sign s = least ? compare_gaps(paths, gap, *least) : Sign::negative;
    if (s == Sign::negative || (s == Sign::zero && earlier(gap, *least))) least = gap;
  };
  for (const auto& [pair, windows] : spells_of_disks(window)) {
    for (const Window& w : windows) offer(least_along_paths(paths, pair.first, pair.second, w));
  }
  const double bound = gap_of(paths, *least).hi;
  std::vector<GenId> near_wall;
  for (GenId g = 0; g < disks; ++g) {
    const LeastGap to_wall = least_along_paths(paths, container_id, g, window);
    if (gap_of(paths, to_wall).lo <= bound) near_wall.push_back(g);
  }
  for (std::size_t a = 0; a < near_wall.size(); ++a) {
    for (std::size_t b = a + 1; b < near_wall.size(); ++b) {
      offer(least_along_paths(paths, near_wall[a], near_wall[b], window));
    }
  }
  return least;
}

Enclosure gap_of(const Paths& paths, const LeastGap& least) {
  if (least.contact) return {0, 0};
  return enclosure(gap_ball(paths, least, 192));
}

double gap_at(const Paths& paths, GenId i, GenId j, const Rational& t) {
  if (j < i) std::swap(i, j);
  const LeastGap gap{
      i, j, t,
      squared_distance(position_at(paths.piece(i, t), t), position_at(paths.piece(j, t), t)),
      false};
  double x = 0;
  for (const int bits : {192, 1024}) {
    const Ball ball = gap_ball(paths, gap, bits);
    if (ball.round_to_double(x)) return x;
    x = ball.midpoint_as_double();
  }
  const Rational sum = reach(paths, gap);
  return gap.distance2 == sum * sum ? 0 : x;
}

}  // namespace voroproof::internal
