// The exact states of computed motion: a disk's causal past, followed through the log.
#include "filtered/computed/computed_motion.h"

#include <algorithm>
#include <unordered_set>
#include <utility>
#include <vector>

#include "exact/collision_response.h"
#include "filtered/motion/exact_motion.h"

namespace voroproof::internal {

struct RationalState {
  int id;
  ExactMotion::State state;
  Tower start;
};

void ComputedMotion::compute_exactly(int id, GenId g, ExactMotion& exact) const {
  if (is_known(id, g, exact)) return;
  // The records of the causal past that are not known yet, oldest first, found
  // without recursion: a past can be long.
  std::vector<int> pending{id - 1};
  std::vector<int> order;
  std::unordered_set<int> seen{id - 1};
  while (!pending.empty()) {
    const int record = pending.back();
    pending.pop_back();
    order.push_back(record);
    const Record& r = states_->record(record);
    for (const auto& [before, of] : {std::pair(r.before_i, r.i), std::pair(r.before_j, r.j)}) {
      if (before > 0 && !is_known(before, of, exact) && seen.insert(before - 1).second) {
        pending.push_back(before - 1);
      }
    }
  }
  std::sort(order.begin(), order.end());
  for (const int record : order) {
    compute_exactly(record, exact);
    const Record& r = states_->record(record);
    for (const GenId of : {r.i, r.j}) {
      if (of != container_id) remember(record + 1, of, exact);
    }
  }
}

// Whether the state is noted, or can be since it is remembered.
bool ComputedMotion::is_known(int id, GenId g, ExactMotion& exact) const {
  if (exact.knows(id, g)) return true;
  const RationalState* known = rational_[g + 1].get();
  if (known == nullptr || known->id != id) return false;
  exact.note(id, g, known->state, known->start);
  return true;
}

// Rational states grow with every collision, and each is asked for when the next one is rounded.
// Others are not remembered: their radicals are of one field, which ends.
void ComputedMotion::remember(int id, GenId g, ExactMotion& exact) const {
  if (exact.field().size() > 0) return;
  std::shared_ptr<const RationalState>& known = rational_[g + 1];
  if (known && known->id >= id) return;
  known =
      std::make_shared<RationalState>(RationalState{id, exact.state(id, g), exact.start(id, g)});
}

namespace {

// The exact time, within the tower, of the next contact of two moving sites given
// at time t (see Contact): the root at which they begin to overlap, or the exit of
// a disk from the container. Precondition: that root exists.
Tower contact_delay(const Contact<Tower>& contact, bool with_container, RadicalField& field) {
  const Tower root = field.sqrt(contact.b * contact.b - contact.a * contact.c);
  if (with_container) return (root - contact.b) / contact.a;
  return contact.c / (root - contact.b);
}

}  // namespace

void ComputedMotion::compute_exactly(int record, ExactMotion& exact) const {
  const Record& r = states_->record(record);
  const MotionInput& in = input();
  const Rational t_ref = to_rational(r.t_ref);
  if (r.maneuver >= 0) {
    const MotionStates::Maneuver& m = states_->maneuver(r.maneuver);
    const ExactMotion::State before = exact.state(r.before_i, r.i);
    const Tower back = Tower(Rational(m.t - before.t_ref));
    const Tower ahead = Tower(Rational(m.t - t_ref));
    const Tower vx(m.vx), vy(m.vy);
    exact.note(record + 1, r.i,
               {t_ref, before.x + before.vx * back - vx * ahead,
                before.y + before.vy * back - vy * ahead, vx, vy},
               Tower(m.t));
    return;
  }
  const bool wall = r.i == container_id;
  const ExactMotion::State bi = exact.state(r.before_i, r.i);
  const ExactMotion::State bj = exact.state(r.before_j, r.j);
  const auto at = [&](const ExactMotion::State& s, GenId g) {
    const Tower dt(Rational(t_ref - s.t_ref));
    return MovingSite<Tower>{s.x + s.vx * dt, s.y + s.vy * dt, s.vx, s.vy, exact.radius(g)};
  };
  const MovingSite<Tower> mi = at(bi, r.i);
  const MovingSite<Tower> mj = at(bj, r.j);
  const Contact<Tower> contact(mi, mj);
  const Tower s = contact_delay(contact, wall, exact.field());
  const CollisionResponse<Tower> response(mi, mj, contact, s);
  const auto note = [&](GenId g, const MovingSite<Tower>& m) {
    exact.note(record + 1, g, {t_ref, m.x, m.y, m.vx, m.vy}, Tower(t_ref) + s);
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

}  // namespace voroproof::internal
