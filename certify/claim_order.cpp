#include "certify/claim_order.h"

#include <algorithm>
#include <array>

#include "certify/exact_truth.h"
#include "certify/wording.h"
#include "history/json_text.h"

namespace voroproof::internal {

namespace {

std::array<GenId, 4> generators(const Event& event) {
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    return {f->quad.l, f->quad.r, f->quad.s, f->quad.e};
  }
  const auto [i, j] = turned_by(event);
  return {i, j, container_id, container_id};
}

}  // namespace

// Takes the k-th of the near claims, which in truth comes before those that the file has before it.
// It has to commute with them. Two turns of one disk do not: whoever reads the file in its order
// takes the velocity of the later line for the last one. Flips do where each names an edge that is
// there in the file's order, too.
void ClaimOrder::take_before_others(std::size_t k) {
  const std::vector<Claims::Claim>& near = claims_.near();
  const auto flips = [&near](std::size_t m) { return std::get_if<FlipEvent>(&near[m].event); };
  for (std::size_t passed = 0; passed < k; ++passed) {
    if (!turn_one_disk(near[passed].event, near[k].event)) continue;
    const double later = time(near[k].event);
    claims_.take(passed);
    refuter_.refute(Fault::wrong_order, "a turn of the same disk, claimed at t = " +
                                            number_text(later) + ", comes before it");
  }
  if (flips(k) != nullptr) {
    Diagram in_file_order = s_.diagram;
    for (std::size_t m = 0; m <= k; ++m) {
      if (flips(m) == nullptr) continue;
      const Quad q = flips(m)->quad;
      HalfEdge h = find_edge(in_file_order, q);
      if (h < 0 && s_.options.unoriented) h = find_edge(in_file_order, {q.l, q.r, q.e, q.s});
      if (h >= 0 && q.s != q.e) {
        in_file_order.flip(h);
        continue;
      }
      claims_.take(m);
      refuter_.refute(Fault::edge_not_present, "no edge of the diagram has the quadruplet " +
                                                   text_of(q) + " after the claims before it");
    }
  }
  ++s_.certificate.swaps;
  take(k);
}

void ClaimOrder::take(std::size_t k) {
  ++taken_;
  for (const GenId g : generators(claims_.near()[k].event)) {
    if (g != container_id) concerned_[static_cast<std::size_t>(g)] = taken_;
  }
  claims_.take(k);
}

// Which of the near claims is the first in truth. Only a claim that is certainly earlier than those
// before it, and whose own edge or pair is there already, goes before them. Among simultaneous
// claims the file's order stands; to prove claims simultaneous is expensive, and done once.
std::size_t ClaimOrder::earliest() {
  std::vector<Claims::Claim>& near = claims_.near();
  if (has_to_flip_now(near[0].event)) return 0;
  std::size_t best = 0;
  std::optional<Moment> first = moment_of(near[0]);
  if (!first) {
    if (!s_.options.strict) best = turn_before(near[0].event);
    if (best == 0) return 0;
    first = moment_of(near[best]);
  }
  // Nothing precedes the present instant, at which more may turn.
  const bool may_turn = edges_.any_pending() || !s_.options.judges_flips();
  if (may_turn && first->lo <= front_.moment.hi &&
      s_.chronology.compare(*first, front_.moment) <= 0) {
    return best;
  }
  const auto tie = [this](Claims::Claim& claim, const Moment& m, std::int64_t number) {
    claim.tie = {number, m.lo, m.hi, s_.replay.changes()};
  };
  for (std::size_t k = 1; k < near.size(); ++k) {
    if (k == best) continue;
    // No truth within the tolerance of this claim comes first.
    if (time(near[k].event) - s_.tolerance_up > first->hi) continue;
    Claims::Claim &earlier = near[best], &claim = near[k];
    const bool tied = instants_.is_moment_of(earlier.tie, *first);
    if (claim.placed || (tied && claim.tie.number == earlier.tie.number)) continue;
    const std::optional<Moment>& m = moment_of(claim);
    if (!m || m->lo > first->hi) continue;
    // Do not raise the precision to decide this order. An undecided order is harmless here: the
    // claim then keeps its place in the file.
    const std::optional<int> order = s_.chronology.known_order(*m, *first);
    if (!order) {
      claim.placed = true;
    } else if (*order < 0) {
      first = m;
      best = k;
    } else if (*order == 0) {
      if (!tied) tie(earlier, *first, ++ties_);
      tie(claim, *m, earlier.tie.number);
    }
  }
  if (best > 0 && s_.options.strict) {
    claims_.take(0);
    refuter_.refute(Fault::wrong_order, "an event claimed after it happens before it, " +
                                            between(first->lo, first->hi));
  }
  return best;
}

// The half-edge that a claim names, perhaps without its orientation, or -1.
Diagram::HalfEdge ClaimOrder::meant_by(const FlipEvent& claim) const {
  const HalfEdge h = s_.replay.find(claim.quad);
  return h < 0 && s_.options.unoriented ? s_.replay.find_mirrored(claim.quad) : h;
}

// Whether the claim is of an edge that is illegal since the present instant. Nothing precedes it.
bool ClaimOrder::has_to_flip_now(const Event& event) const {
  const auto* f = std::get_if<FlipEvent>(&event);
  const HalfEdge h = f != nullptr ? meant_by(*f) : -1;
  return h >= 0 && edges_.life(h / 2).illegal;
}

// A flip may be claimed of an edge that stays as its generators move now. The edge may collapse
// after one of them turns: the first near claim of such a turn, or 0 where there is none.
std::size_t ClaimOrder::turn_before(const Event& event) {
  const auto* f = std::get_if<FlipEvent>(&event);
  const HalfEdge h = f != nullptr ? meant_by(*f) : -1;
  if (h < 0) return 0;
  const std::vector<GenId> four = generators(s_.diagram.quad(h));
  for (std::size_t k = 1; k < claims_.near().size(); ++k) {
    for (const GenId g : turned_by(claims_.near()[k].event)) {
      const bool its = g != container_id && std::find(four.begin(), four.end(), g) != four.end();
      if (its && moment_of(claims_.near()[k])) return k;
    }
  }
  return 0;
}

// When an edge that is there collapses, for a claim of its flip.
std::optional<Moment> ClaimOrder::probe_flip(const FlipEvent& claim) {
  const HalfEdge h = meant_by(claim);
  if (h < 0) return std::nullopt;
  if (edges_.life(h / 2).pending) instants_.begin_pending_lives();
  const EdgeLives::Life& life = edges_.life(h / 2);
  if (life.illegal) {
    // It has to flip at the present instant, or is too late.
    return life.born == front_.instant ? std::optional(front_.moment) : std::nullopt;
  }
  const Quad q = s_.diagram.quad(h);
  if (life.due) return Moment::of(q, edges_.due(h / 2));
  if (const auto root = edges_.bracket(q, life.from, claim.t)) return root->m;
  const auto c = edges_.first_collapse(q, life.from, claim.t + s_.tolerance_up);
  if (!c) return std::nullopt;
  return Moment::of(q, *c);
}

// The true time of a claim whose edge or pair is there. It stays what it is until a claim is taken
// that shares a disk with it: every event that changes an edge, or what its generators do, has one
// of its disks.
const std::optional<Moment>& ClaimOrder::moment_of(Claims::Claim& claim) {
  bool known = claim.probed >= 0;
  for (const GenId g : generators(claim.event)) {
    known = known && (g == container_id || concerned_[static_cast<std::size_t>(g)] <= claim.probed);
  }
  if (!known) {
    claim.probed = taken_;
    try {
      claim.moment = probe(claim.event);
    } catch (const Undecided&) {
      // Where the motion goes on otherwise before then, it need not be decided. What is refuted
      // meanwhile may depend on it (Claims::may_depend_on_others).
      claim.moment.reset();
      claim.placed = true;
    }
  }
  return claim.moment;
}

std::optional<Moment> ClaimOrder::probe(const Event& event) {
  if (const auto* f = std::get_if<FlipEvent>(&event)) return probe_flip(*f);
  if (s_.options.truth == Truth::recorded) return Moment::at(exact_time(event));
  if (const auto* c = std::get_if<CollideEvent>(&event)) {
    if (s_.options.judges_flips() && s_.replay.adjacency(c->i, c->j) < 0) return std::nullopt;
    return s_.exact->next_contact(c->i, c->j);
  }
  const auto& m = std::get<ManeuverEvent>(event);
  const auto k = s_.replay.scheduled(m, exact_time(event));
  if (!k) return std::nullopt;
  return Moment::at(s_.scene.maneuvers[*k].t);
}

// Whether a claim is of a change of the motion that happens at t = 0, in truth.
bool ClaimOrder::turns_at_start(const Event& event) {
  if (std::holds_alternative<FlipEvent>(event)) return false;
  if (s_.options.truth == Truth::recorded) return sgn(exact_time(event)) == 0;
  if (const auto* m = std::get_if<ManeuverEvent>(&event)) {
    const auto k = s_.replay.scheduled(*m, exact_time(event));
    return k && s_.scene.maneuvers[*k].t == 0;
  }
  const auto& claim = std::get<CollideEvent>(event);
  const auto contact = s_.exact->next_contact(claim.i, claim.j);
  return contact && s_.chronology.compare(*contact, front_.moment) <= 0;
}

void ClaimOrder::take_next() {
  const std::size_t k = claims_.first_is_alone() ? 0 : earliest();
  if (k > 0) {
    take_before_others(k);
  } else {
    take(0);
  }
}

bool ClaimOrder::take_next_at_start() {
  const std::vector<Claims::Claim>& near = claims_.near();
  std::size_t k = 0;
  while (k < near.size() && exact_time(near[k].event) <= s_.options.tolerance &&
         !turns_at_start(near[k].event)) {
    ++k;
  }
  if (k == near.size() || exact_time(near[k].event) > s_.options.tolerance) return false;
  if (k == 0) {
    take(0);
  } else if (s_.options.strict) {
    claims_.take(0);
    refuter_.refute(Fault::wrong_order,
                    "what is claimed on a later line happens at t = 0, before it");
  } else {
    take_before_others(k);
  }
  return true;
}

}  // namespace voroproof::internal
