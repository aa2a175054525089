// A wrong world's geometry: its first diagram, flips of its topology, predictions.
#include "tests/adversary/world_state.h"

#include <algorithm>

namespace voroproof::internal::adversary {
namespace {

using Corner = std::array<int, 3>;

Corner smallest_first(const Corner& t) {
  if (t[1] < t[0] && t[1] < t[2]) return {t[1], t[2], t[0]};
  if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
  return t;
}
Corner start_of(const Edge& q) { return smallest_first({q[0], q[2], q[1]}); }
Corner end_of(const Edge& q) { return smallest_first({q[0], q[1], q[3]}); }

// The third generator becomes `third` at the end of the edge where the vertex is `corner`.
void replace_third(Edge& q, const Corner& corner, int third) {
  (start_of(q) == corner ? q[2] : q[3]) = third;
}

bool joins(const Edge& q, int a, int b) {
  return (q[0] == a && q[1] == b) || (q[0] == b && q[1] == a);
}

}  // namespace

Sites World::sites_at(Real t) const {
  Sites sites;
  for (int id = -1; id < n_; ++id) sites.push_back(site_at(id, t));
  return sites;
}

std::array<Real, 2> World::in_circles(const Edge& q, Real t) const {
  const Site l = site_at(q[0], t), r = site_at(q[1], t), s = site_at(q[2], t), e = site_at(q[3], t);
  return {in_circle(l, s, r, e), in_circle(r, e, l, s)};
}

// The diagram at t. With `ties` the disks are larger by a hair's breadth, the last the most.
bool World::make_initial(Real t, bool ties) {
  Sites sites = sites_at(t);
  if (ties) {
    for (int id = 0; id < n_; ++id) {
      sites[static_cast<std::size_t>(id + 1)].r += 1e-13L * (id + 1) * size_;
    }
  }
  Real margin = 0;
  const std::vector<Edge> edges = diagram_of_sites(sites, &margin);
  if (edges.empty() || (!ties && margin < 1e-12L * size_)) return false;
  edges_.clear();
  for (const Edge& q : edges) edges_.push_back({.q = q});
  return true;
}

// Flips edge k of the diagram, unless a vertex of that name exists already; `changed` receives it
// and its four neighbours.
bool World::flip_topology(std::size_t k, std::vector<std::size_t>& changed) {
  const Edge q = edges_[k].q;
  const auto [l, r, s, e] = q;
  if (s == e) return false;
  const Corner from = start_of(q), to = end_of(q);
  const Corner first = smallest_first({l, s, e}), second = smallest_first({r, e, s});
  std::array<std::size_t, 4> around{};
  constexpr std::size_t nobody = static_cast<std::size_t>(-1);
  around.fill(nobody);
  for (std::size_t m = 0; m < edges_.size(); ++m) {
    const Edge& other = edges_[m].q;
    const Corner a = start_of(other), b = end_of(other);
    if (a == first || a == second || b == first || b == second) return false;
    if (m == k) continue;
    if (joins(other, l, s) && (a == from || b == from)) around[0] = m;
    if (joins(other, s, r) && (a == from || b == from)) around[1] = m;
    if (joins(other, l, e) && (a == to || b == to)) around[2] = m;
    if (joins(other, r, e) && (a == to || b == to)) around[3] = m;
  }
  for (const std::size_t m : around) {
    if (m == nobody) return false;
  }
  replace_third(edges_[around[0]].q, from, e);
  replace_third(edges_[around[1]].q, from, e);
  replace_third(edges_[around[2]].q, to, s);
  replace_third(edges_[around[3]].q, to, s);
  edges_[k].q = {s, e, r, l};
  changed.assign(around.begin(), around.end());
  changed.push_back(k);
  return true;
}

// The next flip of the edge after `from`, within a window in which its generators do not go far.
void World::predict_edge(EdgeState& state, Real from) {
  state.flips = state.shadow = state.forced = false;
  state.next = never;
  const Edge& q = state.q;
  if (q[2] == q[3] || !(from < end_)) return;
  std::array<MovingSite, 4> g;
  Real speed = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Body& b = body(q[k]);
    g[k] = {b.at(from), b.v, b.r};
    speed = std::max(speed, length(b.v));
  }
  if (speed == 0) return;
  const Real w = std::min(end_ - from, size_ / (2 * speed));
  std::vector<Real> found;
  roots(cotangency(g, w), found);
  // Signs just beside a root: farther away a disk may have come to lie in another.
  const auto signs_beside = [&](std::size_t k, bool after) {
    const Real other = after ? (k + 1 < found.size() ? found[k + 1] : 1) : k > 0 ? found[k - 1] : 0;
    const Real step = (other - found[k]) / 2, most = 1e-10L;
    return in_circles(q, from + w * (found[k] + std::clamp(step, -most, most)));
  };
  if (!found.empty()) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto before = signs_beside(k, false), after = signs_beside(k, true);
      const bool first = before[0] > 0 && after[0]<0, second = before[1]> 0 && after[1] < 0;
      const bool may_be_shadow = fault_.kind == FaultKind::shadow_flip && !result_.struck;
      if ((first && second) || (may_be_shadow && first != second)) {
        state.next = from + w * found[k];
        state.flips = true;
        state.shadow = first != second;
        return;
      }
    }
  }
  if (from + w < end_) state.next = from + w;
}

// The next contact of the pair from now on.
void World::predict_pair(int i, int j) {
  PairState& p = pair(i, j);
  p.next = never;
  p.forced = p.false_one = false;
  const Body &a = body(i), &b = body(j);
  const bool wall = i < 0;
  const Vec d = b.at(now_) - a.at(now_), v = b.v - a.v;
  const Real reach = wall ? -a.r - b.r : a.r + b.r;
  const Real aa = dot(v, v), bb = dot(d, v), distance = length(d);
  const Real gap = wall ? reach - distance : distance - reach;
  const Real hair = std::min(1e-15L * size_, 1e-6L * reach);
  if (gap > hair) p.passing = false;
  if (p.passing || aa == 0 || (a.partner == j && b.partner == i)) return;
  const Real c = (distance - reach) * (distance + reach);
  if (wall) {
    if (gap < -hair) return;  // outside for good
    const Real root = std::sqrt(std::max<Real>(0, bb * bb - aa * c));
    const Real t = bb > 0 ? -c / (bb + root) : (root - bb) / aa;
    p.next = now_ + std::max<Real>(0, t);
    return;
  }
  if (bb >= 0) return;
  if (gap < -hair) {
    p.passing = true;
    return;
  }
  const Real discriminant = bb * bb - aa * c;
  if (discriminant > 0) {
    p.next = now_ + std::max<Real>(0, c / (std::sqrt(discriminant) - bb));
  } else if (fault_.kind == FaultKind::false_collision && !result_.struck) {
    const Real least = std::sqrt(std::max<Real>(0, dot(d, d) - bb * bb / aa)) - reach;
    if (least < fault_.amount) {
      // The collision is put where they still approach.
      p.next = now_ - bb / aa * (1 - 1e-9L);
      p.false_one = true;
    }
  }
}

void World::predict_around(int id) {
  for (EdgeState& e : edges_) {
    if (std::find(e.q.begin(), e.q.end(), id) != e.q.end()) predict_edge(e, now_);
  }
  for (int other = -1; other < n_; ++other) {
    if (other != id) predict_pair(std::min(other, id), std::max(other, id));
  }
}

void World::predict_all() {
  for (EdgeState& e : edges_) predict_edge(e, now_);
  for (int i = -1; i < n_; ++i) {
    for (int j = std::max(0, i + 1); j < n_; ++j) predict_pair(i, j);
  }
}

}  // namespace voroproof::internal::adversary
