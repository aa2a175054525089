#include "certify/replay.h"

#include "certify/fingerprint.h"
#include "certify/orientation.h"

namespace voroproof::internal {

Replay::Replay(const Scene& scene, const CertifyOptions& options)
    : scene_(&scene),
      options_(&options),
      diagram_(static_cast<int>(scene.disks.size())),
      turns_(scene.disks.size() + 1) {
  velocities_.reserve(scene.disks.size());
  if (options.truth == Truth::recorded) paths_.reserve(scene.disks.size());
  for (const DiskInput& d : scene.disks) {
    velocities_.emplace_back(d.vx, d.vy);
    if (options.truth == Truth::recorded) paths_.emplace_back(d.x, d.y, velocities_.back());
  }
}

Diagram::HalfEdge Replay::find(const Quad& q) const { return find_edge(diagram_, q); }

Diagram::HalfEdge Replay::find_mirrored(const Quad& q) const {
  return q.s == q.e ? -1 : find({q.l, q.r, q.e, q.s});
}

int Replay::adjacency(GenId i, GenId j) const {
  if (disks() == 1) return 0;
  for (const HalfEdge h : diagram_.ring(j)) {
    if (diagram_.dest(h) == i) return h / 2;
  }
  return -1;
}

ExactPair Replay::velocities(GenId i, GenId j) const {
  ExactPair v;
  if (i != container_id) v[0] = velocities_[i].value();
  v[1] = velocities_[j].value();
  return v;
}

BallPair Replay::near_velocities(GenId i, GenId j) const {
  const auto near = [&](GenId g) {
    const Velocity& v = velocities_[g];
    return v.exact ? ball(*v.exact) : ball(v.near);
  };
  return {i == container_id ? BallVec2{} : near(i), near(j)};
}

BallPair Replay::near_positions(const CollideEvent& claim) const {
  const auto near = [&](GenId g) -> BallVec2 {
    if (!claim.exact) {
      if (const auto p = paths_[g].near(claim.t)) return {ball((*p)[0]), ball((*p)[1])};
    }
    return ball(paths_[g].at(claim.exact ? claim.exact->t : to_rational(claim.t)));
  };
  return {claim.i == container_id ? BallVec2{} : near(claim.i), near(claim.j)};
}

ExactPair Replay::positions(GenId i, GenId j, const Rational& t) const {
  ExactPair p;
  if (i != container_id) p[0] = paths_[i].at(t);
  p[1] = paths_[j].at(t);
  return p;
}

void Replay::note_collision(const CollideEvent& claim, const std::optional<ExactPair>& computed) {
  ++changes_;
  for (const int side : {0, 1}) {
    const GenId g = side == 0 ? claim.i : claim.j;
    if (g == container_id) continue;
    if (claim.v[side] && !claim.exact) {
      velocities_[g] = Velocity(*claim.v[side]);
    } else {
      const auto exact = exact_velocity(claim, side);
      velocities_[g] = Velocity(exact ? *exact : computed.value()[side]);
    }
    note_turn(g, claim.i == container_id);
  }
}

void Replay::turn(GenId g, const Event& claim) {
  const Velocity& v = velocities_[g];
  const bool plain = std::visit([](const auto& c) { return c.exact == nullptr; }, claim);
  if (plain) {
    paths_[g].turn(time(claim), v);
  } else {
    paths_[g].turn(exact_time(claim), v);
  }
}

void Replay::move(GivenMotion& motion, GenId g) const {
  const Path& path = paths_[g];
  const Velocity& v = path.velocity();
  if (const auto s = path.start()) {
    motion.restart(g, s->t, s->x, s->y, v.near[0], v.near[1], *this);
    return;
  }
  const Rational t = path.since();
  const ExactVec2 p = path.at(t), w = v.value();
  motion.restart(g, t, p[0], p[1], w[0], w[1]);
}

void Replay::move(GivenMotion& motion) const {
  for (GenId g = 0; g < disks(); ++g) {
    if (moved(g)) move(motion, g);
  }
}

void Replay::state(GenId g, DiskInput& disk) const {
  const Path& path = paths_[g];
  const ExactVec2 p = path.at(path.since()), v = path.velocity().value();
  disk.x = p[0];
  disk.y = p[1];
  disk.vx = v[0];
  disk.vy = v[1];
}

ExactPair Replay::recorded_centers(const CollideEvent& claim, ExactPair path) {
  for (const int side : {0, 1}) {
    if (const auto p = exact_center(claim, side)) path[side] = *p;
  }
  return path;
}

ExactPair Replay::computed_velocities(const CollideEvent& claim, const ExactPair& path) const {
  ExactPair v =
      CollisionLaw(*scene_, options_->law_tolerance)
          .after(claim.i, claim.j, recorded_centers(claim, path), velocities(claim.i, claim.j));
  for (ExactVec2& w : v) {
    for (Rational& x : w) x = to_rational(round_nearest(x));
  }
  return v;
}

std::optional<std::size_t> Replay::scheduled(const ManeuverEvent& claim, const Rational& t) const {
  const auto& all = scene_->maneuvers;
  for (std::size_t k = next_maneuver_; k < all.size(); ++k) {
    if (all[k].disk == claim.disk && !maneuver_done(k)) return k;
    if (all[k].t > t + options_->tolerance) break;
  }
  return std::nullopt;
}

void Replay::note_maneuver(std::size_t k, const ManeuverEvent& claim) {
  done_maneuvers_.insert(k);
  while (done_maneuvers_.erase(next_maneuver_) > 0) ++next_maneuver_;
  const Maneuver& m = scene_->maneuvers[k];
  velocities_[claim.disk] = Velocity(exact_velocity(claim).value_or(ExactVec2{m.vx, m.vy}));
  ++changes_;
  note_turn(claim.disk, false);
}

void Replay::take_turns(const Replay& other) {
  velocities_ = other.velocities_;
  changes_ = other.changes_;
  turns_ = other.turns_;
  next_maneuver_ = other.next_maneuver_;
  done_maneuvers_ = other.done_maneuvers_;
}

Diagram::HalfEdge Replay::flip(const FlipEvent& claim) {
  const Quad& q = claim.quad;
  if (q.s == q.e) return -1;
  HalfEdge h = -1, mirrored = -1;
  each_between(diagram_, q.l, q.r, [&](HalfEdge g) {
    const Quad found = diagram_.quad(g);
    if (found.s == q.s && found.e == q.e) h = g;
    if (found.s == q.e && found.e == q.s) mirrored = g;
    return h >= 0 && !options_->unoriented;
  });
  if (options_->unoriented &&
      (h < 0 || (mirrored >= 0 && options_->truth == Truth::recorded &&
                 means_mirrored(*this, *scene_, *options_, claim, diagram_.quad(mirrored))))) {
    h = mirrored;
  }
  if (h >= 0) diagram_.flip(h);
  return h;
}

void Replay::add_to(Fingerprint& fingerprint) const {
  fingerprint.add(disks());
  fingerprint.add(diagram_.edges());
  for (HalfEdge h = 0; h < 2 * diagram_.edges(); ++h) {
    fingerprint.add(diagram_.org(h));
    fingerprint.add(diagram_.previous(h));
  }
  for (GenId g = container_id; g < disks(); ++g) {
    fingerprint.add(diagram_.anchor(g));
    fingerprint.add(turns_[g + 1].last);
  }
  for (GenId g = 0; g < disks(); ++g) {
    velocities_[g].add_to(fingerprint);
    paths_[g].add_to(fingerprint);
    fingerprint.add(turns_[g + 1].count);
    fingerprint.add(turns_[g + 1].at_container);
  }
  fingerprint.add(changes_);
  fingerprint.add(static_cast<std::int64_t>(next_maneuver_));
  fingerprint.add(static_cast<std::int64_t>(done_maneuvers_.size()));
  for (const std::size_t k : done_maneuvers_) fingerprint.add(static_cast<std::int64_t>(k));
}

void Replay::prefetch(const Event& event) const {
  if (const auto* c = std::get_if<CollideEvent>(&event)) {
    prefetch(c->i);
    prefetch(c->j);
  }
  const auto* f = std::get_if<FlipEvent>(&event);
  if (f == nullptr || diagram_.edges() == 0) return;
  const GenId g = f->quad.l == container_id ? f->quad.r : f->quad.l;
  if (g >= 0 && g < disks()) diagram_.prefetch(diagram_.anchor(g));
}

Replay::Place Replay::place_of(const Event& event) const {
  if (const auto* f = std::get_if<FlipEvent>(&event)) return {find(f->quad)};
  if (const auto* c = std::get_if<CollideEvent>(&event)) return {diagram_.anchor(c->j), c->i};
  const auto& m = std::get<ManeuverEvent>(event);
  return {diagram_.anchor(m.disk), m.disk};
}

Replay::Place Replay::take(const Event& event) {
  if (const auto* f = std::get_if<FlipEvent>(&event)) return {flip(*f)};
  if (options_->truth == Truth::exact) return place_of(event);
  if (const auto* c = std::get_if<CollideEvent>(&event)) {
    std::optional<ExactPair> computed;
    if (!c->v[1]) {
      try {
        computed = computed_velocities(*c, positions(c->i, c->j, exact_time(event)));
      } catch (const Undecided&) {
        return {};
      }
    }
    note_collision(*c, computed);
    if (c->i != container_id) turn(c->i, event);
    turn(c->j, event);
    return place_of(event);
  }
  const auto& m = std::get<ManeuverEvent>(event);
  const auto k = scheduled(m, exact_time(event));
  if (!k) return {};
  note_maneuver(*k, m);
  turn(m.disk, event);
  return place_of(event);
}

}  // namespace voroproof::internal
