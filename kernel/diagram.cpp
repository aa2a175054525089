#include "kernel/diagram.h"

#include <algorithm>

namespace voroproof_kernel {

Diagram::Key Diagram::key(int& i, int& j, int& k) {
  while (i > j || i > k) {
    const int first = i;
    i = j;
    j = k;
    k = first;
  }
  return (Key(i + 1) << 42) | (Key(j + 1) << 21) | Key(k + 1);
}

int Diagram::edge_at(int i, int j, int k, int a, int b) const {
  const auto it = vertices_.find(key(i, j, k));
  if (it == vertices_.end()) return -1;
  const int side = a != k && b != k ? 0 : a != i && b != i ? 1 : 2;
  return it->second[side];
}

void Diagram::join(int i, int j, int k, std::array<int, 3> edges) {
  const int first = i;
  const Key name = key(i, j, k);
  const int turn = i == first ? 0 : j == first ? 2 : 1;
  std::rotate(edges.begin(), edges.begin() + turn, edges.end());
  if (!vertices_.emplace(name, edges).second) refute("a vertex would be there twice");
}

Diagram::Diagram(const std::vector<Quad>& edges, int n) : edges_(edges), spokes_(n + 1) {
  const auto wrong = [](const char* what) {
    refute(std::string("wrong initial diagram: ") + what);
  };
  if (static_cast<int>(edges.size()) != 3 * (n + 1) - 6) wrong("not 3 (n + 1) - 6 edges");
  for (int k = 0; k < static_cast<int>(edges.size()); ++k) {
    const Quad& q = edges[k];
    for (const auto& v : {std::array{q.l, q.s, q.r}, std::array{q.l, q.r, q.e}}) {
      int a = v[0], b = v[1], c = v[2];
      auto& three = vertices_.try_emplace(key(a, b, c), std::array{-1, -1, -1}).first->second;
      const int side = q.l != c && q.r != c ? 0 : q.l != a && q.r != a ? 1 : 2;
      if (three[side] != -1) wrong("a vertex has two edges between the same generators");
      three[side] = k;
    }
    spokes_[q.l + 1].push_back(k);
    spokes_[q.r + 1].push_back(k);
  }
  if (static_cast<int>(vertices_.size()) != 2 * (n + 1) - 4) wrong("not 2 (n + 1) - 4 vertices");
  for (const auto& [name, three] : vertices_) {
    if (std::count(three.begin(), three.end(), -1) != 0) wrong("a vertex without its three edges");
  }
  // One ring around each generator, and all connected: with Euler's count above, a sphere.
  std::vector<int> reached{container};
  std::vector<bool> seen(n + 1, false);
  seen[0] = true;
  for (std::size_t at = 0; at < reached.size(); ++at) {
    const int g = reached[at];
    std::size_t steps = 0;
    const auto& spokes = spokes_[g + 1];
    if (spokes.empty()) wrong("a generator without edges");
    int k = spokes[0];
    do {
      const int other = edges_[k].l == g ? edges_[k].r : edges_[k].l;
      if (!seen[other + 1]) reached.push_back(other);
      seen[other + 1] = true;
      k = next_spoke(k, g);
    } while (++steps <= spokes.size() && k != spokes[0]);
    if (steps != spokes.size()) wrong("the edges around a generator are not one ring");
  }
  if (static_cast<int>(reached.size()) != n + 1) wrong("not connected");
}

int Diagram::find(const Quad& q) const {
  if (q.s == q.l || q.s == q.r || q.e == q.l || q.e == q.r || q.l == q.r) return -1;
  const int k = edge_at(q.l, q.s, q.r, q.l, q.r);
  if (k < 0) return -1;
  return edges_[k] == q || edges_[k] == Quad{q.r, q.l, q.e, q.s} ? k : -1;
}

// With g on the left of the edge it is the other one at its end.
int Diagram::next_spoke(int k, int g) const {
  const Quad& q = edges_[k];
  return q.l == g ? edge_at(q.l, q.r, q.e, q.l, q.e) : edge_at(q.l, q.s, q.r, q.r, q.s);
}

std::array<int, 4> Diagram::around(int k) const {
  const Quad& q = edges_[k];
  return {edge_at(q.l, q.s, q.r, q.l, q.s), edge_at(q.l, q.s, q.r, q.s, q.r),
          edge_at(q.l, q.r, q.e, q.r, q.e), edge_at(q.l, q.r, q.e, q.e, q.l)};
}

std::vector<int> Diagram::about(int disk) const {
  std::vector<int> all(spokes(disk));
  for (const int k : spokes(disk)) {
    const std::array<int, 4> near = around(k);
    all.insert(all.end(), near.begin(), near.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

bool Diagram::adjacent(int i, int j) const {
  return std::any_of(spokes(j).begin(), spokes(j).end(),
                     [&](int k) { return edges_[k].l == i || edges_[k].r == i; });
}

void Diagram::flip(int k) {
  const Quad q = edges_[k];
  const std::array<int, 4> near = around(k);
  if (q.s == q.e) refute("an edge whose two ends have the same generators does not flip");
  int i = q.l, j = q.s, m = q.r;
  vertices_.erase(key(i, j, m));
  i = q.l, j = q.r, m = q.e;
  vertices_.erase(key(i, j, m));
  join(q.l, q.s, q.e, {near[0], k, near[3]});
  join(q.r, q.e, q.s, {near[2], k, near[1]});
  // At the end that was a vertex of the edge, each neighbour has a new third generator.
  const int old[4][3] = {{q.l, q.s, q.r}, {q.l, q.s, q.r}, {q.l, q.r, q.e}, {q.l, q.r, q.e}};
  const int now[4] = {q.e, q.e, q.s, q.s};
  for (int n = 0; n < 4; ++n) {
    Quad& near_quad = edges_[near[n]];
    int a = near_quad.l, b = near_quad.s, c = near_quad.r;
    i = old[n][0], j = old[n][1], m = old[n][2];
    (key(a, b, c) == key(i, j, m) ? near_quad.s : near_quad.e) = now[n];
  }
  edges_[k] = {q.s, q.e, q.r, q.l};
  for (const int g : {q.l, q.r}) std::erase(spokes_[g + 1], k);
  for (const int g : {q.s, q.e}) spokes_[g + 1].push_back(k);
}

}  // namespace voroproof_kernel
