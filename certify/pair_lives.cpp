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
    pass_recorded(edge, Moment(m), why);
    return;
  }
  if (partners || apart || proved_apart(s_.motion, i, j, from, m.hi)) return;
  ++s_.certificate.beyond_filter;
  exact_.require_no_contact(i, j, m, why);
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
