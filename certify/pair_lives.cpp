#include "certify/pair_lives.h"

#include <algorithm>
#include <utility>

namespace voroproof::internal {

void PairLives::end(int edge, const Moment& m, PairEnd why, bool apart) {
  const auto [i, j] = s_.replay.pair_of(edge);
  const bool partners = s_.replay.partners(i, j);
  if (!partners) ++s_.certificate.pair_lives;
  const double from = since_[edge];
  if (s_.options.truth == Truth::recorded) {
    if (!recorded_.contacts().carries({i, j}) &&
        (partners ? recorded_.certainly_part(i, j, from)
                  : recorded_.certainly_clear(i, j, from, m, apart))) {
      return;
    }
    if (!partners) ++s_.certificate.beyond_filter;
    require_no_meeting(i, j, m);
    pass_recorded(edge, Moment(m), why);
    return;
  }
  if (partners || apart || proved_apart(s_.motion, i, j, from, m.hi)) return;
  ++s_.certificate.beyond_filter;
  require_no_meeting(i, j, m);
  exact_.require_no_contact(i, j, m, why);
}

// In the life of i and j, which doubles do not prove to be apart, no point of the two meets another
// point: neither the other of the two, nor a neighbour of the other. (Points that graze one disk
// from two sides meet there without ever being neighbours.)
void PairLives::require_no_meeting(GenId i, GenId j, const Moment& m) {
  if (!s_.points.any() || i == container_id) return;
  const auto require = [&](GenId a, GenId b) {
    if (a == b || !s_.points.is_point(a) || !s_.points.is_point(b)) return;
    const auto [first, second] = std::minmax(a, b);
    if (s_.options.truth == Truth::exact) {
      exact_.require_no_meeting(first, second, m);
    } else {
      recorded_.require_no_meeting(first, second, m);
    }
  };
  require(i, j);
  for (const GenId g : s_.diagram.neighbours(j)) require(i, g);
  for (const GenId g : s_.diagram.neighbours(i)) require(j, g);
}

void PairLives::end(std::span<const int> edges, const Moment& m, PairEnd why) {
  apart_.clear();
  for (const int e : edges) {
    const auto [i, j] = s_.replay.pair_of(e);
    apart_.add(i, j, since_[e]);
  }
  apart_.prove(m.hi);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (!front_.colliding || s_.replay.pair_of(edges[k]) != *front_.colliding) {
      end(edges[k], m, why, apart_.apart(k));
    }
  }
}

// Two generators may be neighbours along several V-edges: the one that has been there for longest
// stands for the pair. `besides`: one that counts no more. -1 where there is none.
int PairLives::watching(int edge, int besides) const {
  if (s_.diagram.edges() == 0) return edge;
  const auto pair = s_.replay.pair_of(edge);
  int oldest = -1;
  const Diagram::HalfEdge first = s_.diagram.anchor(pair.second);
  Diagram::HalfEdge h = first;
  do {
    const int e = h / 2;
    if (e != besides && s_.replay.pair_of(e) == pair &&
        (oldest < 0 || std::pair(since_[e], e) < std::pair(since_[oldest], oldest))) {
      oldest = e;
    }
    h = s_.diagram.rotate(h);
  } while (h != first);
  return oldest;
}

void PairLives::pass_recorded(int edge, const Moment& m, PairEnd why) {
  if (watching(edge) != edge) return;
  const auto [i, j] = s_.replay.pair_of(edge);
  const auto lines = recorded_.lines(i, j, since_[edge]);
  const Rational end = m.kind == Moment::Kind::rational ? m.exact() : to_rational(m.hi);
  const int next = why == PairEnd::flip ? watching(edge, edge) : -1;
  if (const auto missing =
          recorded_.contacts().pass(lines, end, why == PairEnd::turn || next >= 0)) {
    throw Refuted{refuter_.missing_contact(i, j, missing->lo, missing->hi)};
  }
  if (next >= 0) since_[next] = std::max(since_[next], m.hi);
}

}  // namespace voroproof::internal
