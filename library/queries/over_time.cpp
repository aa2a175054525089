#include "library/queries/over_time.h"

#include <algorithm>
#include <map>
#include <set>
#include <variant>

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

LeastGap least_gap(const Paths& paths, GenId i, GenId j, const Window& window) {
  if (j < i) std::swap(i, j);
  const bool wall = i == container_id;
  std::vector<Rational> ends{window.from};
  for (Rational& t : paths.turns({i, j}, window.from, window.to)) ends.push_back(std::move(t));
  ends.push_back(window.to);
  std::optional<LeastGap> least;
  const auto offer = [&](std::optional<LeastGap>& nearest, LeastGap gap) {
    if (!nearest ||
        (wall ? gap.distance2 > nearest->distance2 : gap.distance2 < nearest->distance2)) {
      nearest = std::move(gap);
    }
  };
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const RecordedState &a = paths.piece(i, ends[k]), &b = paths.piece(j, ends[k]);
    const auto at = [&](const Rational& t) -> LeastGap {
      return {i, j, t, squared_distance(position_at(a, t), position_at(b, t)), false};
    };
    std::optional<LeastGap> nearest = at(ends[k]);
    if (!wall) {
      const ExactVec2 p = position_at(a, ends[k]), q = position_at(b, ends[k]);
      const Rational wx = b.velocity[0] - a.velocity[0], wy = b.velocity[1] - a.velocity[1];
      const Rational w2 = wx * wx + wy * wy;
      if (w2 != 0) {
        const Rational delay = -((q[0] - p[0]) * wx + (q[1] - p[1]) * wy) / w2;
        const Rational t = ends[k] + delay;
        if (delay > 0 && t < ends[k + 1]) offer(nearest, at(t));
      }
    }
    offer(nearest, at(ends[k + 1]));
    if (paths.contacts().contains({i, j, nearest->t})) {
      const Rational sum = reach(paths, *nearest);
      nearest->distance2 = sum * sum;
      nearest->contact = true;
    }
    offer(least, *std::move(nearest));
  }
  return *least;
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
