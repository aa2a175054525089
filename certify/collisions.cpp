// Collisions and maneuvers: the claimed changes of the motion, and what they change.
#include <algorithm>
#include <cmath>
#include <utility>

#include "certify/checker.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

// ---- The lives around disks that turn. ----

// Collects the edges that have one of the two disks among their generators: spokes of the cells,
// and the rims around them. i may be the container, for one disk.
void Checker::collect_around(GenId i, GenId j) {
  spokes_.clear();
  around_.clear();
  if (!begun_) return;
  if (motion_.size() == 1) {
    spokes_.push_back(0);
    return;
  }
  const long spoke = ++collection_, any = ++collection_;
  const auto add = [this](std::vector<int>& to, int edge, long stamp, long known) {
    if (collected_[edge] >= known) return;
    collected_[edge] = stamp;
    to.push_back(edge);
  };
  const auto each = [this, i, j](auto&& visit) {
    for (const GenId g : {i, j}) {
      if (g == container_id) continue;
      const HalfEdge first = diagram_.anchor(g);
      HalfEdge h = first;
      do {
        visit(h);
        h = diagram_.rotate(h);
      } while (h != first);
    }
  };
  // What is needed of them soon is asked for on the way: the lives, the pairs, and the generators
  // on the other sides.
  each([&](HalfEdge h) {
    add(spokes_, h / 2, spoke, spoke);
    const HalfEdge rim = diagram_.next(h);
    diagram_.prefetch(diagram_.previous(rim ^ 1));
    __builtin_prefetch(&lives_[rim / 2]);
    __builtin_prefetch(&pairs_[h / 2]);
    __builtin_prefetch(&motion_.doubles(diagram_.dest(h)));
  });
  around_ = spokes_;
  each([&](HalfEdge h) {
    const HalfEdge rim = diagram_.next(h);
    add(around_, rim / 2, any, spoke);
    __builtin_prefetch(&lives_[h / 2]);
    __builtin_prefetch(&motion_.doubles(diagram_.apex(rim ^ 1)));
  });
}

// All lives around the disks end at m, but that of the pair that collides.
void Checker::end_around(const Moment& m) {
  end_pairs(spokes_, m, PairEnd::turn);
  end_lives(around_, m);
}

// More may turn at the same instant: what an edge would do between two of these does not matter,
// and may be a tie beyond proof where all of them together are none.
void Checker::begin_around(const Moment& m) {
  for (const int e : spokes_) pairs_[e] = {m.lo};
  for (const int e : around_) {
    Life& life = lives_[e];
    if (!life.pending) pending_.push_back(e);
    life = {};
    life.from = m.lo;
    life.born = instant_;
    life.pending = true;
  }
}

void Checker::begin_pending_lives() {
  if (pending_.empty()) return;
  chronology_.note_collisions(frontier_);
  const std::vector<int> edges = std::exchange(pending_, {});
  begin_lives(prove_hidden_anew(edges), frontier_);
}

// ---- Collisions. ----

void Checker::collide(const CollideEvent& claim) {
  require_maneuvers_before(time(*claim_));
  colliding_ = {claim.i, claim.j};
  const int edge = begun_ ? replay_.adjacency(claim.i, claim.j) : 0;
  if (edge < 0) {
    refute(Fault::wrong_pair, "generators " + text_of(claim.i, claim.j) +
                                  " are not adjacent in the diagram, so they do not touch");
  }
  if (options_.truth == Truth::exact) {
    collide_exactly(claim);
  } else {
    collide_as_recorded(claim, edge);
  }
  colliding_.reset();
  ++certificate_.collisions;
}

void Checker::collide_exactly(const CollideEvent& claim) {
  const GenId i = claim.i, j = claim.j;
  const NextContact c = next_contact(i, j);
  if (c.kind == NextContact::Kind::none) {
    refute(Fault::spurious_event,
           "generators " + text_of(i, j) + " do not touch under their present motion",
           motion_witness(motion_, {i, j}, exact_time(*claim_)));
  }
  Moment m = moment_of(i, j, c);
  if (m.hi >= horizon_down_ && chronology_.compare(m, Moment::at(last_instant_)) > 0) {
    refute(Fault::spurious_event,
           "generators " + text_of(i, j) + " touch " + between(m.lo, m.hi) + ", after the horizon");
  }
  if (!in_time(m)) {
    const bool near = to_rational(c.lo) - exact_time(*claim_) <= kMistimed * options_.tolerance;
    Divergence d =
        divergence_at_claim(near ? Fault::wrong_time : Fault::spurious_event,
                            "generators " + text_of(i, j) + " touch " + between(c.lo, c.hi));
    d.true_contact = {i, j};
    d.true_time = {c.lo, c.hi};
    d.witness = contact_witness(motion_, i, j, to_rational(c.lo), to_rational(c.hi));
    throw Refuted{d};
  }
  advance(m);
  require_after_start();
  require_no_flip_yet(i, j);
  if (!begun_) require_first_at_start(i, j);
  collect_around(i, j);
  end_around(m);
  // The law between the claimed values first, while the state before is at hand.
  if (claim.v[1] && claim.p[1]) {
    const BallPair near{claim.p[0] ? claimed_center(claim, 0) : BallVec2{},
                        claimed_center(claim, 1)};
    if (!law_.certainly_obeyed(claim, near, replay_.near_velocities(i, j))) {
      const ExactPair p = Replay::recorded_centers(claim, {});
      if (!law_.obeyed(claim, p, replay_.velocities(i, j), 0)) refute_response(claim, p);
    }
  }
  const Turn turn{i, j, motion_.state_id(i), motion_.state_id(j)};
  turning_ = {i, j};
  const Impact impact = motion_.collide(i, j, 0.5 * (m.lo + m.hi));
  m.kind = Moment::Kind::state;
  m.i = i;
  m.j = j;
  m.state = motion_.state_id(j);
  m.dd = impact.time_dd;
  frontier_ = m;
  note_birth(i, m);
  note_birth(j, m);
  check_state(claim, 1, impact.second);
  if (i != container_id) check_state(claim, 0, impact.first);
  std::optional<ExactPair> computed;
  if (!claim.v[1]) {
    computed = {ExactVec2{to_rational(impact.first.vx), to_rational(impact.first.vy)},
                ExactVec2{to_rational(impact.second.vx), to_rational(impact.second.vy)}};
  }
  replay_.note_collision(claim, computed);
  place_turn(turn);
  begin_around(m);
  turning_.clear();
}

void Checker::collide_as_recorded(const CollideEvent& claim, int edge) {
  const GenId i = claim.i, j = claim.j;
  const BallPair at = replay_.near_positions(claim);
  const Moment m = claim.exact ? Moment::at(exact_time(*claim_)) : Moment::at(claim.t);
  // What began at the instant before is settled first.
  advance(m);
  require_after_start();
  check_recorded_contact(claim, edge, at);
  require_no_flip_yet(i, j);
  collect_around(i, j);
  end_around(m);
  const auto exactly = [&] { return replay_.positions(i, j, exact_time(*claim_)); };
  // What is far from its path even if the disk stops is wrong without asking for velocities.
  std::optional<ExactPair> computed;
  const auto check_centers = [&] {
    for (const int side : {0, 1}) {
      if (!claim.p[side] || certainly_near(claim, side, at[side])) continue;
      const auto after = computed ? (*computed)[side] : exact_velocity(claim, side);
      check_center(side == 0 ? i : j, exact_center(claim, side), after.value_or(ExactVec2{}),
                   exactly()[side]);
    }
  };
  if (claim.v[1]) {
    check_centers();
    // The law with the centres of the paths: those that the file gives are only compared with them.
    if (!law_.certainly_obeyed(claim, at, replay_.near_velocities(i, j))) {
      const ExactPair p = exactly(), v = replay_.velocities(i, j);
      if (!law_.obeyed(claim, p, v, exact_time(*claim_))) refute_response(claim, p);
    }
  } else {
    try {
      computed = replay_.computed_velocities(claim, exactly());
    } catch (const Undecided&) {
      check_centers();
      throw;
    }
    check_centers();
    ++certificate_.computed_velocities;
    remark_velocities(claim.p[1].has_value());
  }
  replay_.note_collision(claim, computed);
  turning_ = {i, j};
  if (i != container_id) turn(i);
  turn(j);
  begin_around(m);
  turning_.clear();
}

// Recorded truth: since the claim the disk goes on with its claimed velocity.
void Checker::turn(GenId g) {
  replay_.turn(g, *claim_);
  replay_.move(motion_, g);
}

BallVec2 Checker::claimed_center(const CollideEvent& claim, int side) {
  return claim.exact ? ball(*exact_center(claim, side)) : ball(*claim.p[side]);
}

// What is allowed of a claimed centre: what the disk covers in the tolerance, with its speeds just
// before and after, and what writing it as binary64 changes.
Rational Checker::allowed_distance(GenId g, const ExactVec2& after, const ExactVec2& at) const {
  const Rational speeds = length_bound(replay_.velocity(g).value()) + length_bound(after);
  return options_.tolerance * speeds + 4 * length_bound(at) / (Rational(1) << 53);
}

// Whether a claimed centre is where the disk is, within less than that: in doubles, false says
// nothing.
bool Checker::certainly_near(const CollideEvent& claim, int side, const BallVec2& at) const {
  const BallVec2 p = claimed_center(claim, side);
  const BallVec2 v = replay_.near_velocities(claim.i, claim.j)[side];
  return sign(norm2(minus(p, at)) - near_tolerance_ * near_tolerance_ * norm2(v)) == Sign::negative;
}

// Exact truth: claimed values against the true ones, which are correctly rounded. A contact that is
// off by the tolerance in time turns its normal by what the two cover meanwhile, over their reach,
// and the velocities by twice that; where the reach is too short for that to say much, by no more
// than a part in 1024.
void Checker::check_state(const CollideEvent& claim, int side, const RoundedState& truth) {
  const GenId g = side == 0 ? claim.i : claim.j;
  const ExactVec2 true_v{to_rational(truth.vx), to_rational(truth.vy)};
  const auto v = exact_velocity(claim, side);
  if (v && !certainly_equal(claim, side, truth)) {
    const ExactPair before = replay_.velocities(claim.i, claim.j);
    Rational speed = length_bound(before[1]);
    if (claim.i != container_id) speed += length_bound(before[0]);
    const Rational turned = 4 * options_.tolerance * speed * speed / law_.reach(claim.i, claim.j);
    const Rational allowed =
        options_.law_tolerance * speed + std::min(turned, Rational(speed / 1024));
    if (norm2(minus(*v, true_v)) > square(allowed)) {
      refute(Fault::wrong_response, "the velocity is (" + number_text(true_v[0].get_d()) + ", " +
                                        number_text(true_v[1].get_d()) +
                                        "); --tolerance and --law-tolerance set the bound");
    }
  }
  if (claim.p[side] && !certainly_near(claim, side, ball(Vec2{truth.px, truth.py}))) {
    check_center(g, exact_center(claim, side), true_v,
                 {to_rational(truth.px), to_rational(truth.py)});
  }
}

// Whether a claimed velocity is the true one, but for a rounding or two.
bool Checker::certainly_equal(const CollideEvent& claim, int side, const RoundedState& truth) {
  if (claim.exact) return false;
  const auto near = [](double x, double y) { return std::fabs(x - y) <= 0x1p-51 * std::fabs(y); };
  const Vec2& v = *claim.v[side];
  return near(v[0], truth.vx) && near(v[1], truth.vy);
}

// A claimed centre against the true one, of a disk that has the velocity `after` just after.
void Checker::check_center(GenId g, const std::optional<ExactVec2>& p, const ExactVec2& after,
                           const ExactVec2& true_p) {
  if (!p) return;
  if (norm2(minus(*p, true_p)) > square(allowed_distance(g, after, true_p))) {
    refute(Fault::wrong_response, "the centre is (" + number_text(true_p[0].get_d()) + ", " +
                                      number_text(true_p[1].get_d()) + ")");
  }
}

void Checker::refute_response(const CollideEvent& claim, const ExactPair& p) {
  refute(Fault::wrong_response,
         law_.expectation(claim.i, claim.j, p, replay_.velocities(claim.i, claim.j)) +
             "; --law-tolerance sets the bound",
         motion_witness(motion_, {claim.i, claim.j}, exact_time(*claim_)));
}

void Checker::remark_velocities(bool centers) {
  if (centers ? remarked_centers_ : remarked_paths_) return;
  (centers ? remarked_centers_ : remarked_paths_) = true;
  certificate_.remarks.push_back(
      centers
          ? "collisions without velocities: computed by the law from the recorded centres"
          : "collisions without velocities and centres: computed by the law from the path; such "
            "a file soon leaves its producer's motion");
}

// ---- Maneuvers. ----

void Checker::maneuver(const ManeuverEvent& claim) {
  const Rational t = exact_time(*claim_);
  const auto k = replay_.scheduled(claim, t);
  if (!k) refute(Fault::spurious_event, "the scene schedules no such maneuver");
  const Maneuver& due = scene_.maneuvers[*k];
  if (abs(Rational(t - due.t)) > options_.tolerance) {
    refute(Fault::wrong_time, "the maneuver is scheduled at t = " + due.t.get_str());
  }
  if (due.t > last_instant_) {
    refute(Fault::spurious_event,
           "the maneuver is scheduled at t = " + due.t.get_str() + ", after the horizon");
  }
  require_maneuvers_before(round_down(due.t));
  const ExactVec2 v{due.vx, due.vy};
  const auto claimed = exact_velocity(claim);
  if (claimed && norm2(minus(*claimed, v)) > square(options_.law_tolerance * length_bound(v))) {
    refute(Fault::wrong_response, "the scheduled velocity is (" + number_text(v[0].get_d()) + ", " +
                                      number_text(v[1].get_d()) + ")");
  }
  const bool exact = options_.truth == Truth::exact;
  const Moment m = Moment::at(exact ? due.t : t);
  advance(m);
  require_after_start();
  const GenId g = claim.disk;
  require_no_flip_yet(g, g);
  maneuvering_ = g;
  if (!begun_) require_no_contact_at_start(g);
  collect_around(container_id, g);
  end_around(m);
  maneuvering_.reset();
  turned_[g] = instant_;
  turning_ = {g};
  if (exact) {
    const Turn turn{g, g, motion_.state_id(g), motion_.state_id(g)};
    const RoundedState s = motion_.maneuver(g, due.t, v[0], v[1]);
    frontier_ = m;
    note_birth(g, m);
    place_turn(turn);
    check_center(g, exact_center(claim), v, {to_rational(s.px), to_rational(s.py)});
    replay_.note_maneuver(*k, claim);
  } else {
    check_center(g, exact_center(claim), v, replay_.path(g).at(t));
    replay_.note_maneuver(*k, claim);
    turn(g);
  }
  begin_around(m);
  turning_.clear();
  ++certificate_.maneuvers;
}

// At t = 0 no pair has a life yet that the maneuver would end.
void Checker::require_no_contact_at_start(GenId g) {
  if (options_.truth == Truth::recorded) return;
  const Instant now = chronology_.present(Moment::at(Rational(0)));
  for (GenId other = container_id; other < motion_.size(); ++other) {
    const auto [i, j] = std::minmax(g, other);
    if (i == j || replay_.partners(i, j) || turned_at_present(other) ||
        contacts_.certainly_apart(i, j, now)) {
      continue;
    }
    if (contacts_.from(i, j, now, 0).kind == NextContact::Kind::now) {
      throw Refuted{missing_contact(i, j, 0, 0)};
    }
  }
}

// The initial diagram has been judged with the velocities just after t = 0. A change of them that
// comes to light later, behind more claims than are looked at together, cannot be judged any more.
void Checker::require_after_start() const {
  if (begun_ && instant_ == 0) {
    throw Undecided("a disk turns at t = 0, and too many claims within the tolerance come before");
  }
}

bool Checker::turned_at_present(GenId g) const {
  const auto it = turned_.find(g);
  return it != turned_.end() && it->second == instant_;
}

// Every maneuver scheduled before t must have been claimed.
void Checker::require_maneuvers_before(double t) {
  const std::size_t next = replay_.next_maneuver();
  if (next == scene_.maneuvers.size()) return;
  const Rational& due = scene_.maneuvers[next].t;
  if (t <= due.get_d()) return;  // which is rounded towards zero
  if (due > history_.header().horizon || due + options_.tolerance >= to_rational(t)) return;
  throw Refuted{missing_maneuver(next)};
}

}  // namespace voroproof::internal
