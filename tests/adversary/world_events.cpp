// What the events of a wrong world do, and where its fault strikes.
#include <algorithm>
#include <utility>

#include "tests/adversary/truth.h"
#include "tests/adversary/world_state.h"

namespace voroproof::internal::adversary {
namespace {

// How much later than its root an edge that stayed is looked at again, relative to the time that
// its generators need to cross the container.
constexpr Real step_over = 1e-9L;

Pair2 rounded(Vec v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

bool same_set(int a, int b, int c, int d) { return (a == c && b == d) || (a == d && b == c); }

// A choice that depends on the fault's number and the event only.
bool coin(int nth, int k) {
  auto x = static_cast<std::uint64_t>(nth) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(k);
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return ((x >> 40) & 1) != 0;
}

}  // namespace

// ---- Collisions. ----

void World::respond(int i, int j) {
  const Body a = body(i), b = body(j);
  Real when = now_;
  if (strikes(FaultKind::old_normal)) {
    struck(now_);
    when -= fault_.amount;
  }
  const Vec n = b.at(when) - a.at(when);
  const Vec towards = (dot(b.v - a.v, n) / dot(n, n)) * n;
  Real sigma = i < 0 ? wall_restitution_ : restitution_;
  if (strikes(FaultKind::restitution)) {
    struck(now_);
    sigma += fault_.amount;
  }
  Vec vi, vj;
  if (i >= 0) {
    Real mi = a.mass, mj = b.mass;
    if (mi != mj && strikes(FaultKind::masses_exchanged)) {
      struck(now_);
      std::swap(mi, mj);
    }
    const Real k = (1 + sigma) / (mi + mj);
    vi = a.v + (k * mj) * towards;
    vj = b.v - (k * mi) * towards;
  } else if (scene_.whole) {
    vj = sigma * (b.v - 2 * towards);
  } else {
    vj = b.v - (1 + sigma) * towards;
  }
  if (strikes(FaultKind::stranger_velocity)) {
    struck(now_);
    vj = vj + static_cast<Real>(fault_.amount) * Vec{0.6L, 0.8L};
  }
  if (i >= 0) turn(i, vi);
  turn(j, vj);
  if (i >= 0) body(i).partner = j;
  body(j).partner = i;
}

void World::write_collision(int i, int j, double t) {
  Line line{.kind = Line::Kind::collide, .t = t, .i = i, .j = j};
  if (i >= 0) {
    line.v[0] = rounded(body(i).v);
    line.p[0] = rounded(body(i).at(now_));
  }
  line.v[1] = rounded(body(j).v);
  line.p[1] = rounded(body(j).at(now_));
  result_.history.lines.push_back(line);
}

void World::collide(const Next& event) {
  PairState& p = pair(event.i, event.j);
  Real t = event.t;
  const auto postpone = [&](Real until) {
    struck(t);
    p.next = until;
    p.forced = true;
    result_.hints.push_back(static_cast<double>(until));
  };
  const bool turned_now = body(event.j).since == t || (event.i >= 0 && body(event.i).since == t);
  const auto is_maneuvered = [&](int id) { return body(id).since == t && body(id).partner == -3; };
  const bool by_maneuver =
      turned_now && (is_maneuvered(event.j) || (event.i >= 0 && is_maneuvered(event.i)));
  if (p.false_one) {
    struck(t);
  } else if (!p.forced) {
    const bool missed = strikes(FaultKind::miss_collision) ||
                        (t == 0 && strikes(FaultKind::miss_at_start)) ||
                        (by_maneuver && strikes(FaultKind::miss_at_maneuver)) ||
                        (fault_.kind == FaultKind::miss_several && coin(fault_.nth, candidates_++));
    if (missed) {
      struck(t);
      move_to(t);
      p.passing = true;
      p.next = never;
      return;
    }
    if (strikes(FaultKind::late_collision) || fault_.kind == FaultKind::all_late) {
      return postpone(t + fault_.amount);
    }
    if (fault_.kind == FaultKind::late_at_start && t == 0) return postpone(fault_.amount);
    if (strikes(FaultKind::wrong_order)) {
      const Next other = next_event(true, event);
      if (other.kind != Next::Kind::none && other.kind != Next::Kind::look) {
        return postpone(other.t + 2 * one_instant * (1 + other.t));
      }
    }
    if (strikes(FaultKind::early_collision)) {
      struck(t);
      t = std::max<Real>(now_, t - fault_.amount);
    }
  }
  move_to(t);
  respond(event.i, event.j);
  write_collision(event.i, event.j, static_cast<double>(now_));
  if (strikes(FaultKind::twice_collision)) {
    struck(now_);
    result_.history.lines.push_back(result_.history.lines.back());
  }
  if (event.i >= 0) predict_around(event.i);
  predict_around(event.j);
}

// ---- Maneuvers. ----

void World::maneuver(std::size_t k, double t, bool turns, bool writes) {
  const ManeuverData& m = scene_.maneuvers[k];
  maneuver_done_[k] = true;
  move_to(t);
  const Vec v{m.vx, m.vy};
  if (turns) {
    turn(m.disk, v);
    body(m.disk).partner = -3;
  }
  if (writes) {
    result_.history.lines.push_back({.kind = Line::Kind::maneuver,
                                     .t = static_cast<double>(now_),
                                     .i = m.disk,
                                     .j = m.disk,
                                     .v = {Pair2{}, rounded(turns ? body(m.disk).v : v)},
                                     .p = {Pair2{}, rounded(body(m.disk).at(now_))}});
  }
  if (turns) predict_around(m.disk);
}

// ---- Flips. ----

void World::apply_flip(std::size_t k) {
  const Edge q = edges_[k].q;
  std::vector<std::size_t> changed;
  if (!flip_topology(k, changed)) {
    Real speed = 0;
    for (const int id : q) speed = std::max(speed, length(body(id).v));
    predict_edge(edges_[k], now_ + step_over * size_ / std::max<Real>(speed, 1e-9L));
    return;
  }
  result_.history.lines.push_back(
      {.kind = Line::Kind::flip, .t = static_cast<double>(now_), .edge = canonical(q)});
  for (const std::size_t m : changed) predict_edge(edges_[m], now_);
}

void World::flip(const Next& event) {
  EdgeState& e = edges_[event.edge];
  Real t = event.t;
  Real speed = 0;
  for (const int id : e.q) speed = std::max(speed, length(body(id).v));
  const Real over = t + step_over * size_ / std::max<Real>(speed, 1e-9L);
  if (e.shadow) struck(t);
  if (!e.forced && !e.shadow) {
    const auto postpone = [&](Real until) {
      struck(t);
      e.next = until;
      e.forced = true;
      result_.hints.push_back(static_cast<double>(until));
    };
    if (strikes(FaultKind::miss_flip)) {
      struck(t);
      return predict_edge(e, over);
    }
    if (strikes(FaultKind::late_flip) || fault_.kind == FaultKind::all_flips_late) {
      return postpone(t + fault_.amount);
    }
    if (strikes(FaultKind::wrong_order)) {
      const Next other = next_event(true, event);
      if (other.kind != Next::Kind::none && other.kind != Next::Kind::look) {
        return postpone(other.t + 2 * one_instant * (1 + other.t));
      }
    }
    if (strikes(FaultKind::early_flip)) {
      struck(t);
      t = std::max<Real>(now_, t - fault_.amount);
    }
    if (fault_.kind == FaultKind::other_edge && !result_.struck) {
      const Edge q = e.q;
      for (std::size_t m = 0; m < edges_.size(); ++m) {
        const Edge& o = edges_[m].q;
        const bool crossing = same_set(o[0], o[1], q[0], q[1]);
        const bool traversing = same_set(o[2], o[3], q[2], q[3]);
        if (m == event.edge || !(crossing || traversing) || !strikes(FaultKind::other_edge))
          continue;
        struck(t);
        move_to(t);
        apply_flip(m);
        return predict_edge(edges_[event.edge], over);
      }
    }
  }
  move_to(t);
  if (strikes(FaultKind::back_and_forth)) {
    struck(t);
    if (fault_.amount < tolerance) {
      // The edge flips there and back, and there.
      apply_flip(event.edge);
      apply_flip(event.edge);
    } else {
      // Another edge, there and back.
      const std::size_t other = static_cast<std::size_t>(1e6 * fault_.amount) % edges_.size();
      apply_flip(other);
      apply_flip(other);
    }
  }
  apply_flip(event.edge);
}

}  // namespace voroproof::internal::adversary
