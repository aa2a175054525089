#include "certify/due_pairs.h"

#include <optional>
#include <string>

#include "filtered/search/ladder.h"

namespace voroproof::internal {

namespace {

// The sign of |offset|^2 - reach^2 of two that are apart.
Sign apart(GenId i) { return i == container_id ? Sign::negative : Sign::positive; }
// The sign of offset times velocity of two that touch and approach.
Sign approach(GenId i) { return i == container_id ? Sign::positive : Sign::negative; }

std::optional<bool> never(bool is_not) { return is_not ? std::optional(false) : std::nullopt; }

}  // namespace

DuePairs::DuePairs(Setting& s, const Front& front, const std::vector<Turn>& turns)
    : s_(s), front_(front), now_(s.chronology.present(front.moment)), exact_(s.motion) {
  for (const Turn& t : turns) {
    ended_.emplace(std::pair(t.i, t.state_i), t.v[0]);
    ended_.emplace(std::pair(t.j, t.state_j), t.v[1]);
    if (t.i != t.j) touching_.emplace(t.i, t.j);
  }
}

// A disk is in one place in all its states of the instant. So whether two touch is asked of their
// last states, of which enclosures are at hand; whether they approach needs the velocities of then.
bool DuePairs::is_due(const States& states) {
  const GenId i = states[0], j = states[1];
  const bool touch = touching_.contains({i, j});
  const Contact<DdBall> k = narrow(states);
  const bool approaching = sign(k.b) == approach(i);
  Ladder<bool> ladder(s_.certificate.tiers, Predicate::contact_search);
  const Rung doubles{Tier::filter,
                     [&] { return never(!touch && s_.contacts.certainly_apart(i, j, now_)); }};
  const Rung double_doubles{Tier::dd, [&] {
                              if (touch && approaching) return std::optional(true);
                              return never(sign(k.c) == apart(i) || sign(k.b) == -approach(i));
                            }};
  const Rung balls{Tier::ball, [&] { return by_balls(i, j); }};
  const Rung symmetry{
      Tier::symmetry, [&]() -> std::optional<bool> {
        const PairStates pair{DiskState{i, states[2]}, DiskState{j, states[3]}};
        if (!approaching || !s_.motion.symmetry()->touch(pair, s_.chronology.known())) {
          return std::nullopt;
        }
        return true;
      }};
  const Rung exact{Tier::exact, [&] { return std::optional(exactly(states)); }};
  if (const auto due = ladder.climb(doubles, double_doubles, balls, symmetry, exact)) return *due;
  if (!touch) {
    if (const auto due = ladder.with_more_bits(s_.motion, balls)) return *due;
  }
  throw Undecided("the order of the collisions of one instant is not decided: " + ladder.budget(),
                  i, j);
}

Contact<DdBall> DuePairs::narrow(const States& states) const {
  const auto site = [&](GenId g, int state) {
    MovingSite<DdBall> at = s_.motion.moving_site(g, now_.dd);
    if (const auto ended = ended_.find({g, state}); ended != ended_.end()) {
      at.vx = ended->second[0];
      at.vy = ended->second[1];
    }
    return at;
  };
  return {site(states[0], states[2]), site(states[1], states[3])};
}

std::optional<bool> DuePairs::by_balls(GenId i, GenId j) const {
  const Ball now = s_.chronology.ball(front_.moment);
  const Contact<Ball> k(s_.motion.moving_site(i, now), s_.motion.moving_site(j, now));
  return never(sign(k.c) == apart(i));
}

bool DuePairs::exactly(const States& states) {
  const GenId i = states[0], j = states[1];
  // States are numbered in their order of time.
  const GenId turned = s_.motion.state_id(i) > s_.motion.state_id(j) ? i : j;
  const Tower now = exact_.start(s_.motion.state_id(turned), turned);
  const auto site = [&](GenId g, int state) -> MovingSite<Tower> {
    const ExactMotion::State& at = exact_.state(state, g);
    const Tower dt = now - Tower(at.t_ref);
    return {at.x + at.vx * dt, at.y + at.vy * dt, at.vx, at.vy, exact_.radius(g)};
  };
  const Contact<Tower> k(site(i, states[2]), site(j, states[3]));
  return sign(k.c) == Sign::zero && sign(k.b) == approach(i);
}

}  // namespace voroproof::internal
