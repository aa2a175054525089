#include "certify/kernel/diagram.h"

#include <algorithm>

namespace voroproof_kernel {

std::uint64_t Diagram::key(int a, int b, int c) {
  return (std::uint64_t(a + 1) << 42) | (std::uint64_t(b + 1) << 21) | std::uint64_t(c + 1);
}

int Diagram::side(int a, int b, int c) const {
  const auto it = sides_.find(key(a, b, c));
  return it == sides_.end() ? -1 : it->second;
}

void Diagram::put(int a, int b, int c, int edge) {
  if (!sides_.emplace(key(a, b, c), edge).second) refute("vertices would be there twice");
  (edges_[edge].l == a ? edges_[edge].e : edges_[edge].s) = c;
}

Diagram::Diagram(const std::vector<Quad>& edges, int n) : edges_(edges), spokes_(n + 1) {
  const std::string wrong = "wrong initial diagram: ";
  const int count = static_cast<int>(edges.size());
  if (count != 3 * (n + 1) - 6) refute(wrong + "not 3 (n + 1) - 6 edges");
  for (int k = 0; k < count; ++k) {
    const Quad& q = edges[k];
    put(q.l, q.r, q.e, k);
    put(q.r, q.l, q.s, k);
    for (const int g : {q.l, q.r}) spokes_[g + 1].push_back(k);
  }
  for (int k = 0; k < count; ++k) {
    const std::array<int, 4> near = around(k);
    if (std::count(near.begin(), near.end(), -1) != 0) refute(wrong + "a vertex without an edge");
  }
  // One ring around each generator, and all connected: by Euler's count a sphere.
  std::vector<int> reached{container};
  std::vector<bool> seen(n + 1, false);
  seen[0] = true;
  for (std::size_t at = 0; at < reached.size(); ++at) {
    const int g = reached[at];
    if (spokes(g).empty()) refute(wrong + "a generator without edges");
    std::size_t steps = 0;
    int k = spokes(g)[0];
    do {
      const int other = edges_[k].l == g ? edges_[k].r : edges_[k].l;
      if (!seen[other + 1]) reached.push_back(other);
      seen[other + 1] = true;
      k = next_spoke(k, g);
    } while (++steps <= spokes(g).size() && k != spokes(g)[0]);
    if (steps != spokes(g).size()) refute(wrong + "the edges of a generator are not one ring");
  }
  if (static_cast<int>(reached.size()) != n + 1) refute(wrong + "not connected");
}

int Diagram::find(const Quad& q) const {
  const int k = side(q.l, q.r, q.e);
  return k >= 0 && (edges_[k] == q || edges_[k] == q.reversed()) ? k : -1;
}

std::array<int, 4> Diagram::around(int k) const {
  const auto [l, r, s, e] = edges_[k];
  return {side(l, s, r), side(s, r, l), side(r, e, l), side(e, l, r)};
}

// With g on the left of the edge it is the other one at its end.
int Diagram::next_spoke(int k, int g) const {
  const auto [l, r, s, e] = edges_[k].l == g ? edges_[k] : edges_[k].reversed();
  return side(e, l, r);
}

bool Diagram::adjacent(int i, int j) const {
  return std::any_of(spokes(j).begin(), spokes(j).end(),
                     [&](int k) { return edges_[k].l == i || edges_[k].r == i; });
}

void Diagram::flip(int k) {
  const auto [l, r, s, e] = edges_[k];
  if (s == e) refute("an edge whose two ends have the same generators does not flip");
  const std::array<int, 4> near = around(k);
  for (const auto& [a, b, c] : {std::array{l, s, r}, std::array{l, r, e}}) {
    for (const auto gone : {key(a, b, c), key(b, c, a), key(c, a, b)}) sides_.erase(gone);
  }
  edges_[k] = {s, e, r, l};
  put(l, s, e, near[0]);
  put(s, r, e, near[1]);
  put(r, e, s, near[2]);
  put(e, l, s, near[3]);
  put(s, e, l, k);
  put(e, s, r, k);
  for (const int g : {l, r}) std::erase(spokes_[g + 1], k);
  for (const int g : {s, e}) spokes_[g + 1].push_back(k);
}

}  // namespace voroproof_kernel
