// A wrong world from its start to its end: what comes next.
#include "tests/adversary/wrong_world.h"

#include <algorithm>
#include <utility>

#include "tests/adversary/world_state.h"

namespace voroproof::internal::adversary {
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

}  // namespace voroproof::internal::adversary
