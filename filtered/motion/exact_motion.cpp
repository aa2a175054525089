#include "filtered/motion/exact_motion.h"

#include <algorithm>
#include <vector>

#include "exact/collision_response.h"

namespace voroproof::internal {

namespace {

// The limit of exact arithmetic, which is slow far sooner than balls are.
constexpr std::size_t kMaxCoefficientBits = 1 << 16;

}  // namespace

ExactMotion::ExactMotion(const Motion& motion)
    : motion_(motion),
      field_(RadicalField::Budget{
          motion.options().max_radicals,
          std::min(kMaxCoefficientBits, static_cast<std::size_t>(motion.options().max_bits) * 4)}) {
}

const ExactMotion::State& ExactMotion::state(GenId g) {
  return entry(motion_.state_id(g), g).state;
}
const ExactMotion::State& ExactMotion::state(int id, GenId g) { return entry(id, g).state; }
const Tower& ExactMotion::start(int id, GenId g) { return entry(id, g).start; }

Tower ExactMotion::radius(GenId g) const {
  const MotionInput& in = motion_.input();
  return g == container_id ? Tower(Rational(-in.container_radius))
                           : Tower(Rational(in.disks[g].radius));
}

const ExactMotion::Entry& ExactMotion::entry(int id, GenId g) {
  const long key = static_cast<long>(id) * (motion_.size() + 1) + (g + 1);
  if (const auto it = memo_.find(key); it != memo_.end()) return it->second;
  if (id <= 0) {
    Entry e;
    if (g == container_id) {
      e.state = {0, 0, 0, 0, 0};
    } else {
      const DiskInput& d = motion_.initial_state(g);
      const Rational start = to_rational(motion_.initial_time(g));
      e.state = {start, Tower(d.x.value()), Tower(d.y.value()), Tower(d.vx.value()),
                 Tower(d.vy.value())};
      e.start = Tower(start);
    }
    return memo_[key] = e;
  }
  // The records of the causal past that are not known yet, oldest first, found
  // without recursion: a past can be long.
  std::vector<int> pending{id - 1};
  std::vector<int> order;
  std::unordered_map<int, bool> seen{{id - 1, true}};
  while (!pending.empty()) {
    const int record = pending.back();
    pending.pop_back();
    order.push_back(record);
    const MotionStates::Record& r = motion_.record(record);
    for (const int before : {r.before_i, r.before_j}) {
      if (before > 0 && seen.emplace(before - 1, true).second) pending.push_back(before - 1);
    }
  }
  std::sort(order.begin(), order.end());
  for (const int record : order) {
    const MotionStates::Record& r = motion_.record(record);
    const long done = static_cast<long>(record + 1) * (motion_.size() + 1) + (r.j + 1);
    if (!memo_.contains(done)) compute(record);
  }
  return memo_.at(key);
}

void ExactMotion::compute(int record) {
  const MotionStates::Record& r = motion_.record(record);
  const MotionInput& in = motion_.input();
  const long slots = motion_.size() + 1;
  const long base = static_cast<long>(record + 1) * slots;
  const Rational t_ref = to_rational(r.t_ref);
  if (r.maneuver >= 0) {
    const MotionStates::Maneuver& m = motion_.maneuver(r.maneuver);
    const State before = entry(r.before_i, r.i).state;
    const Tower back = Tower(Rational(m.t - before.t_ref));
    const Tower ahead = Tower(Rational(m.t - t_ref));
    const Tower vx(m.vx), vy(m.vy);
    memo_[base + r.i + 1] = {{t_ref, before.x + before.vx * back - vx * ahead,
                              before.y + before.vy * back - vy * ahead, vx, vy},
                             Tower(m.t)};
    return;
  }
  const bool wall = r.i == container_id;
  const State bi = entry(r.before_i, r.i).state;
  const State bj = entry(r.before_j, r.j).state;
  const auto at = [&](const State& s, GenId g) {
    const Tower dt(Rational(t_ref - s.t_ref));
    return MovingSite<Tower>{s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, radius(g)};
  };
  const MovingSite<Tower> mi = at(bi, r.i);
  const MovingSite<Tower> mj = at(bj, r.j);
  const Contact<Tower> contact(mi, mj);
  const Tower s = contact_delay(contact, wall, field_);
  const CollisionResponse<Tower> response(mi, mj, contact, s);
  const auto note = [&](GenId g, const MovingSite<Tower>& m) {
    memo_[base + g + 1] = {{t_ref, m.x, m.y, m.vx, m.vy}, Tower(t_ref) + s};
  };
  if (wall) {
    const Rational& e = in.container_restitution;
    note(r.j, in.whole_container_law ? response.reflected(mj, Tower(e))
                                     : response.pushed(mj, Tower(Rational(-1 - e))));
    return;
  }
  const Rational m1 = in.disks[r.i].mass;
  const Rational m2 = in.disks[r.j].mass;
  const Rational share = (1 + in.restitution) / (m1 + m2);
  note(r.i, response.pushed(mi, Tower(Rational(share * m2))));
  note(r.j, response.pushed(mj, Tower(Rational(-share * m1))));
}

MovingSite<Tower> ExactMotion::moving_site(GenId g, const Rational& t) {
  const State& s = state(g);
  const Tower dt(Rational(t - s.t_ref));
  return {s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, radius(g)};
}

Site<Tower> ExactMotion::site(GenId g, const Tower& t) {
  const State& s = state(g);
  const Tower dt = t - Tower(s.t_ref);
  return {s.x + s.vx * dt, s.y + s.vy * dt, radius(g)};
}

Tower contact_delay(const Contact<Tower>& contact, bool with_container, RadicalField& field) {
  const Tower root = field.sqrt(contact.b * contact.b - contact.a * contact.c);
  if (with_container) return (root - contact.b) / contact.a;
  return contact.c / (root - contact.b);
}

}  // namespace voroproof::internal
