// A generator that lies inside another has no cell, and the in-circle functions of edges with both
// tell nothing until it has left the other: what is true of them then is proved anew.
#include <algorithm>

#include "certify/checker.h"
#include "certify/initial_proof.h"

namespace voroproof::internal {

// Recorded truth: of the pairs around the disks that have turned at the present instant, those of
// which one generator has lain inside the other since they last met. At a time at which it does so
// no more, the vertices, edges and cells that depend on the tangency of the two are proved anew;
// the lives of these edges begin then. Gives the other edges of `edges`.
std::vector<int> Checker::prove_hidden_anew(const std::vector<int>& edges) {
  if (!recorded_.carries_any() || diagram_.edges() == 0) return edges;
  std::vector<int> rest = edges;
  for (const int e : edges) {
    const auto pair = replay_.pair_of(e);
    if (!recorded_.hidden(pair)) continue;
    const auto [i, j] = pair;
    const auto lines = recorded_lines(i, j, frontier_.lo);
    const auto revealed = lines.gap.revealed(frontier_.exact(), 2 * options_.tolerance);
    if (!revealed) throw Undecided("a generator lies inside another for long", i, j);
    const double from = round_up(*revealed);
    if (fault_around(diagram_, motion_, i, j, to_rational(from), certificate_.tiers)) {
      throw Undecided("the diagram is not proved after a generator lay inside another", i, j);
    }
    std::erase_if(rest, [&, i = i, j = j](int f) {
      const Quad q = diagram_.quad(2 * f);
      const auto among = [&](GenId g) { return g == q.l || g == q.r || g == q.s || g == q.e; };
      if (!among(i) || !among(j)) return false;
      lives_[f] = {.from = from, .born = instant_};
      return true;
    });
    revealed_ = std::max(revealed_, from);
    ++certificate_.proved_anew;
    recorded_.reveal(pair, *revealed);
  }
  return rest;
}

}  // namespace voroproof::internal
