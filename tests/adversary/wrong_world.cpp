// A wrong world's events: what comes next, what it does, and where the fault strikes.
#include "tests/adversary/wrong_world.h"

#include <algorithm>
#include <utility>

#include "tests/adversary/truth.h"
#include "tests/adversary/world_state.h"

namespace voroproof::adversary {
namespace {

// How much later than its root an edge that stayed is looked at again, relative to the time that
// its generators need to cross the container.
constexpr Real step_over = 1e-9L;
// Events closer than this, relative to 1 + t, are of one instant.
constexpr Real one_instant = 1e-15L;

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

World::World(const SceneData& scene, const Fault& fault, std::size_t most_lines)
    : scene_(scene),
      fault_(fault),
      most_lines_(most_lines),
      n_(scene.size()),
      end_(scene.horizon),
      size_(scene.radius),
      restitution_(scene.restitution),
      wall_restitution_(scene.wall_restitution) {
  bodies_.push_back({.base = {scene.cx, scene.cy}, .r = -scene.radius});
  for (const DiskData& d : scene.disks) {
    bodies_.push_back({.base = {d.x, d.y}, .v = {d.vx, d.vy}, .r = d.radius, .mass = d.mass});
  }
  pairs_.resize(static_cast<std::size_t>((n_ + 1) * n_));
  for (const ManeuverData& m : scene.maneuvers) maneuver_times_.push_back(m.t);
  maneuver_done_.resize(maneuver_times_.size());
  if (n_ == 0) return;
  const int victim = fault.nth % n_;
  if (fault.kind == FaultKind::mass || fault.kind == FaultKind::radius) {
    Body& b = body(victim);
    (fault.kind == FaultKind::mass ? b.mass : b.r) *= 1 + static_cast<Real>(fault.amount);
    struck(0);
  }
  const bool late = fault.kind == FaultKind::late_maneuver;
  if (!maneuver_times_.empty() && (late || fault.kind == FaultKind::early_maneuver)) {
    double& t = maneuver_times_[static_cast<std::size_t>(fault.nth) % maneuver_times_.size()];
    t = late ? t + fault.amount : std::max(0.0, t - fault.amount);
    struck(t);
  }
}

bool World::strikes(FaultKind kind) {
  return fault_.kind == kind && !result_.struck && candidates_++ == fault_.nth;
}

void World::struck(Real t) {
  result_.struck = true;
  result_.hints.push_back(static_cast<double>(t));
}

void World::move_to(Real t) {
  now_ = std::max(now_, std::min<Real>(static_cast<double>(t), scene_.horizon));
}

void World::turn(int id, Vec v) {
  Body& b = body(id);
  b.base = b.at(now_);
  b.since = now_;
  b.v = {static_cast<double>(v.x), static_cast<double>(v.y)};
  if (fault_.kind == FaultKind::float_velocities) {
    const Vec exact = b.v;
    b.v = {static_cast<float>(v.x), static_cast<float>(v.y)};
    if (!result_.struck && (exact.x != b.v.x || exact.y != b.v.y)) struck(now_);
  }
}

// What comes next: collisions before maneuvers before flips at one instant.
World::Next World::next_event(bool without, const Next& excluded) const {
  Next next;
  const auto offer = [&](const Next& event) {
    if (event.t > end_) return;
    if (without && event.kind == excluded.kind && event.i == excluded.i && event.j == excluded.j &&
        event.edge == excluded.edge) {
      return;
    }
    const Real hair = one_instant * (1 + event.t);
    if (event.t < next.t - hair || (event.t <= next.t + hair && event.kind < next.kind)) {
      next = event;
    }
  };
  for (int i = -1; i < n_; ++i) {
    for (int j = std::max(0, i + 1); j < n_; ++j) {
      const PairState& p = pairs_[static_cast<std::size_t>((i + 1) * n_ + j)];
      if (p.next < never) offer({.kind = Next::Kind::collision, .t = p.next, .i = i, .j = j});
    }
  }
  for (std::size_t k = 0; k < maneuver_times_.size(); ++k) {
    if (maneuver_done_[k]) continue;
    offer({.kind = Next::Kind::maneuver, .t = maneuver_times_[k], .edge = k});
  }
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const EdgeState& e = edges_[k];
    if (e.next < never) {
      offer({.kind = e.flips ? Next::Kind::flip : Next::Kind::look, .t = e.next, .edge = k});
    }
  }
  return next;
}

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
      // There and back, and there.
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

// ---- The whole. ----

// Whether the world goes on.
bool World::process(Next event) {
  switch (event.kind) {
    case Next::Kind::none:
      return false;
    case Next::Kind::collision:
      if (event.t > scene_.horizon && fault_.kind == FaultKind::collision_at_end) struck(event.t);
      collide(event);
      break;
    case Next::Kind::maneuver: {
      const std::size_t k = event.edge;
      const double t = maneuver_times_[k];
      if (strikes(FaultKind::forget_maneuver)) {
        struck(t);
        maneuver(k, t, false, false);
      } else if (strikes(FaultKind::silent_maneuver)) {
        struck(t);
        maneuver(k, t, false, true);
      } else {
        maneuver(k, t, true, true);
        if (strikes(FaultKind::twice_maneuver)) {
          struck(t);
          result_.history.lines.push_back(result_.history.lines.back());
        }
      }
      break;
    }
    case Next::Kind::flip:
      if (event.t > scene_.horizon) {
        edges_[event.edge].next = never;
      } else {
        flip(event);
      }
      break;
    case Next::Kind::look:
      predict_edge(edges_[event.edge], event.t);
      break;
  }
  return result_.history.lines.size() < most_lines_;
}

// What happens at 0, and the diagram just after.
void World::start() {
  Real speed = 1e-9L;
  for (const Body& b : bodies_) speed = std::max(speed, length(b.v));
  const Real moment = 1e-10L * size_ / speed;
  const bool before = fault_.kind == FaultKind::late_at_start;
  const bool generic = make_initial(0, false);
  if (!generic && before && !make_initial(moment, true)) return;
  const std::vector<EdgeState> early = edges_;
  edges_.clear();
  for (int i = -1; i < n_; ++i) {
    for (int j = std::max(0, i + 1); j < n_; ++j) predict_pair(i, j);
  }
  for (Next next = next_event(false, {}); next.t == 0 && process(next);) {
    next = next_event(false, {});
  }
  edges_ = early;
  if (!generic && !before && !make_initial(moment, true)) return;
  if (fault_.kind == FaultKind::later_initial) {
    if (!make_initial(fault_.amount, false)) return;
    struck(0);
  }
  if (fault_.kind == FaultKind::wrong_initial && !edges_.empty()) {
    std::vector<std::size_t> changed;
    for (int k = 0; k <= static_cast<int>(fault_.amount); ++k) {
      if (flip_topology(static_cast<std::size_t>(fault_.nth + 5 * k) % edges_.size(), changed)) {
        struck(0);
      }
    }
  }
  for (const EdgeState& e : edges_) result_.history.initial.push_back(e.q);
  for (EdgeState& e : edges_) predict_edge(e, now_);
}

void World::finish() {
  result_.history.horizon = scene_.horizon;
  const bool all = fault_.kind == FaultKind::mirrored;
  if (!all && fault_.kind != FaultKind::mirrored_flip) return;
  const auto mirror = [](Edge& q) { q = canonical({q[0], q[1], q[3], q[2]}); };
  if (all) {
    for (Edge& q : result_.history.initial) mirror(q);
  }
  int flips = 0;
  for (Line& line : result_.history.lines) {
    if (line.kind != Line::Kind::flip) continue;
    // All, or one in two to five.
    if (!all && (flips++ + fault_.nth) % (2 + fault_.nth % 4) != 0) continue;
    mirror(line.edge);
    struck(line.t);
  }
  if (all) struck(0);
}

std::optional<WorldResult> World::run() {
  if (fault_.kind == FaultKind::collision_at_end) end_ = scene_.horizon + 2 * fault_.amount;
  start();
  if (result_.history.initial.empty()) return std::nullopt;
  while (process(next_event(false, {}))) {
  }
  result_.overflow = result_.history.lines.size() >= most_lines_;
  finish();
  return std::move(result_);
}

std::optional<WorldResult> live(SceneData& scene, const Fault& fault, std::size_t most_lines) {
  if (fault.kind == FaultKind::collision_at_end) {
    const auto right = World(scene, {}, most_lines).run();
    if (!right) return std::nullopt;
    int k = 0;
    for (const Line& line : right->history.lines) {
      if (line.kind == Line::Kind::collide && line.t > 2 * fault.amount && k++ == fault.nth) {
        scene.horizon = line.t - fault.amount;
        break;
      }
    }
  }
  auto result = World(scene, fault, most_lines).run();
  if (!result || !result->overflow) return result;
  const auto& lines = result->history.lines;
  const double last = lines[lines.size() / 2].t;
  if (!(last > 0) || fault.kind == FaultKind::collision_at_end) return std::nullopt;
  // Between two lines, not at one.
  const auto after = std::find_if(lines.begin(), lines.end(),
                                  [&](const Line& line) { return line.t > last * (1 + 1e-9); });
  if (after == lines.end()) return std::nullopt;
  scene.horizon = last + (after->t - last) / 2;
  result = World(scene, fault, most_lines).run();
  if (result && result->overflow) return std::nullopt;
  return result;
}

}  // namespace voroproof::adversary
