#include "certify/first_divergence.h"

#include <algorithm>
#include <limits>

#include "certify/contact_proof.h"
#include "certify/edge_proof.h"
#include "certify/exact_truth.h"
#include "exact/patience.h"

namespace voroproof::internal {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

// Whether one of these turns just now. (The container, which collides, too, does not.)
bool FirstDivergence::turns_one_of(std::initializer_list<GenId> generators) const {
  return std::any_of(generators.begin(), generators.end(), [this](GenId g) {
    const std::vector<GenId>& turning = front_.turning;
    return g != container_id && std::find(turning.begin(), turning.end(), g) != turning.end();
  });
}

// Tells what refutes the history in the open life of the pair, as far as the claims are settled.
std::optional<Divergence> FirstDivergence::refuted_in(const PairLives::Open& life) {
  const double settled = claims_.settled();
  if (!(life.since < settled) || turns_one_of({life.i, life.j})) return std::nullopt;
  try {
    pairs_.end(life, Moment::at(settled), PairEnd::turn);
  } catch (const Refuted& r) {
    return r.divergence;
  } catch (const Undecided&) {
    // Another may tell.
  }
  return std::nullopt;
}

std::optional<Divergence> FirstDivergence::before_undecided() {
  Earliest first{{}, std::min(claims_.settled(), s_.horizon_window_down)};
  if (front_.begun) {
    for (const PairLives::Open& life : pairs_.open(claims_.settled())) {
      const auto refuted = refuted_in(life);
      if (refuted && (!first.divergence || refuted->t < first.limit)) first = {refuted, refuted->t};
    }
    look_for_flips(first);
  }
  const double now = claims_.current() ? time(*claims_.current()) : front_.moment.lo;
  const auto maneuver = maneuver_missing_by(first.divergence ? first.divergence->t : now);
  return maneuver ? maneuver : first.divergence;
}

// The earliest event that every open life should have had, up to the refuted claim. Contacts come
// first everywhere: disks that move through each other lead the edges into degeneracies that are
// costly to decide.
Divergence FirstDivergence::first_event_missing(const Divergence& found) {
  const bool earlier = found.true_time && (*found.true_time)[0] < found.t;
  Earliest first{found, std::min(earlier ? (*found.true_time)[0] : found.t, s_.search_end)};
  look_for_contacts(first);
  look_for_flips(first);
  return *first.divergence;
}

// How much earlier than the first so far an event must be to be missing for certain. Of those that
// are missing the first counts: where it is very near, the later one may be its consequence.
double FirstDivergence::margin(const Earliest& first) const {
  if (!first.divergence) return 0;
  const Fault fault = first.divergence->fault;
  return fault == Fault::missing_event || fault == Fault::overlap ? 0 : s_.tolerance_up;
}

void FirstDivergence::look_for_contacts(Earliest& first) {
  // A spurious event may be the consequence of an event that happens later by no more than times
  // may be off.
  const auto limit = [&] {
    const bool spurious = first.divergence->fault == Fault::spurious_event;
    return std::min(first.limit + (spurious ? s_.tolerance_up : 0), s_.search_end);
  };
  for (const PairLives::Open& life : pairs_.open(limit())) {
    const auto& [i, j, since, edge] = life;
    // An overlap behind a claimed collision lasts too long by no event of its own.
    if (pairs_.recorded().contacts().carries({i, j})) {
      const auto refuted = refuted_in(life);
      if (refuted && refuted->t < first.limit) first = {*refuted, refuted->t};
    }
    if (s_.replay.partners(i, j) || turns_one_of({i, j}) ||
        proved_apart(s_.motion, i, j, since, limit())) {
      continue;
    }
    const NextContact c = contact_in(life, limit());
    if (c.kind == NextContact::Kind::none) continue;
    const bool near = c.hi >= first.limit - margin(first) - s_.tolerance_up;
    if ((near && !is_never_claimed(i, j, c)) || may_be_left_out(life, c)) continue;
    first = {refuter_.missing_contact(i, j, c.lo, c.hi), c.lo};
    if (near) first.divergence->line = std::min(first.divergence->line, claims_.line());
  }
}

// The first contact of the pair in its life, narrowly enclosed. Throws Undecided.
NextContact FirstDivergence::contact_in(const PairLives::Open& life, double until) {
  const GenId i = life.i, j = life.j;
  const Moment begin =
      s_.exact != nullptr ? s_.exact->since(i, j) : s_.chronology.instant(Moment::at(life.since));
  NextContact c = s_.contacts.from(i, j, begin, until);
  if (c.kind == NextContact::Kind::at) {
    const auto [lo, hi] = s_.chronology.enclosure(Moment::of(i, j, c));
    c.lo = lo;
    c.hi = hi;
  }
  return c;
}

// Recorded truth: whether the overlap that the contact begins may be a rounding, or left out at the
// horizon.
bool FirstDivergence::may_be_left_out(const PairLives::Open& life, const NextContact& c) {
  if (s_.exact != nullptr) return false;
  if (c.hi >= s_.horizon_window_down) return true;
  const RecordedContacts::Lines lines = pairs_.recorded().lines(life.i, life.j, life.since);
  const auto overlaps =
      lines.gap.overlaps(to_rational(c.hi) + s_.options.tolerance, lines.rounding);
  return std::all_of(overlaps.begin(), overlaps.end(), [&](const Gap::Overlap& o) {
    return RecordedContacts::is_rounding(lines, o);
  });
}

// Whether the contact is missing although it is so near the refuted claim: no claim is left that
// may be of it, or may turn one of the two before it. Reads on.
bool FirstDivergence::is_never_claimed(GenId i, GenId j, const NextContact& c) {
  const Event* const refuted = claims_.current() ? &*claims_.current() : nullptr;
  return !claims_.has_unchecked(
      to_rational(c.hi) + s_.options.tolerance, [refuted, i, j](const Event& event) {
        const std::array<GenId, 2> pair = turned_by(event);
        if (&event == refuted)
          return std::holds_alternative<CollideEvent>(event) && pair == std::array{i, j};
        const auto turns = [&pair](GenId g) {
          return g != container_id && (g == pair[0] || g == pair[1]);
        };
        return turns(i) || turns(j);
      });
}

void FirstDivergence::look_for_flips(Earliest& first) {
  // Where it is undecided whether an edge collapses so early that its flip should have been claimed
  // by now, the history is false whether it does or not, and the refutation stands.
  bool undecided = false;
  const auto search = [&](const Quad& q, double from) -> std::optional<Collapse> {
    try {
      return edges_.first_collapse(q, from, first.limit);
    } catch (const Undecided&) {
      try {
        const double early = first.limit - margin(first) - 2 * s_.tolerance_up;
        if (const auto c = edges_.first_collapse(q, from, early)) return c;
      } catch (const Undecided&) {
        undecided = true;
        return std::nullopt;
      }
      throw;
    }
  };
  for (int e = 0; e < s_.diagram.edges(); ++e) {
    const Quad q = s_.diagram.quad(2 * e);
    const EdgeLives::Life& life = edges_.life(e);
    if (life.illegal || life.pending || turns_one_of({q.l, q.r, q.s, q.e})) continue;
    std::optional<Collapse> c;
    if (life.due) {
      c = edges_.due(e);
    } else if (!proved_free(s_.motion, q, life.from, first.limit)) {
      c = search(q, life.from);
    }
    if (!c) continue;
    const auto [lo, hi] = s_.chronology.enclosure(Moment::of(q, *c));
    if (!(hi < first.limit - margin(first))) continue;
    try {
      first = {refuter_.missing_flip(q, *c), lo};
    } catch (const Undecided&) {
      undecided = true;
    }
  }
  if (undecided && first.divergence) {
    s_.certificate.remarks.push_back(
        "whether a flip is missing before the claim that is refuted is undecided");
  }
}

double FirstDivergence::complete_until(double t, bool briefly) {
  double until = t;
  // A life that began at `since`, and is not clear as doubles tell; `first` gives the time of the
  // first event in it, or infinity.
  const auto look = [&until, &briefly](double since, const auto& first) {
    try {
      until = std::min(until, briefly ? since : first());
    } catch (const Undecided&) {
      until = since;
    } catch (const GivenUp&) {
      until = since;
      briefly = true;
    }
  };
  for (const PairLives::Open& life : pairs_.open(t)) {
    if (!(life.since < until) || turns_one_of({life.i, life.j})) continue;
    const Moment end = Moment::at(until);
    if (pairs_.certainly_clear(life, end)) continue;
    look(life.since, [&] {
      if (s_.replay.partners(life.i, life.j)) return s_.exact != nullptr ? infinity : life.since;
      pairs_.require_no_meeting(life.i, life.j, end);
      const NextContact c = contact_in(life, until);
      return c.kind == NextContact::Kind::none || may_be_left_out(life, c) ? infinity : c.lo;
    });
  }
  for (int e = 0; e < s_.diagram.edges(); ++e) {
    const Quad q = s_.diagram.quad(2 * e);
    const EdgeLives::Life& life = edges_.life(e);
    if (!(life.from < until) || life.pending || turns_one_of({q.l, q.r, q.s, q.e})) continue;
    if (!life.illegal && !life.due && proved_free(s_.motion, q, life.from, until)) continue;
    look(life.from, [&] {
      if (life.illegal) return life.from;
      if (life.due) return edges_.due(e).lo;
      const auto c = edges_.first_collapse(q, life.from, until);
      return c ? c->lo : infinity;
    });
  }
  return until;
}

// Finds an event or a maneuver that is missing before: what was refuted may be its consequence.
// Claims within the tolerance of a maneuver may be meant on either side of it.
Divergence FirstDivergence::before(const Divergence& refuted) {
  const Divergence found = due_before().value_or(refuted);
  const Divergence first = front_.begun ? first_event_missing(found) : found;
  const bool by_truth = first.fault == Fault::missing_event || first.fault == Fault::overlap;
  return maneuver_missing_by(first.t + (by_truth ? 0 : s_.tolerance_up)).value_or(first);
}

// A collision that should have come before the claim at its instant. Where any order is accepted it
// may still come behind the claim.
std::optional<Divergence> FirstDivergence::due_before() {
  if (s_.exact == nullptr) return std::nullopt;
  auto due = s_.exact->due_before();
  if (!due || !s_.options.accepts_other_orders()) return due;
  const auto is_it = [&](const Event& event) {
    const auto* c = std::get_if<CollideEvent>(&event);
    return c != nullptr && std::pair(c->i, c->j) == *due->true_contact;
  };
  if (claims_.has_unchecked(to_rational(front_.moment.hi) + s_.options.tolerance, is_it)) return {};
  return due;
}

std::optional<Divergence> FirstDivergence::maneuver_missing_by(double t) {
  const HistoryHeader& header = s_.header;
  const Rational last = std::min(to_rational(t), header.certain_horizon());
  for (std::size_t k = s_.replay.next_maneuver(); k < s_.scene.maneuvers.size(); ++k) {
    if (s_.scene.maneuvers[k].t > last) break;
    const Maneuver& due = s_.scene.maneuvers[k];
    const auto is_it = [&](const Event& event) {
      const auto* m = std::get_if<ManeuverEvent>(&event);
      return m != nullptr && m->disk == due.disk &&
             abs(Rational(exact_time(event) - due.t)) <= s_.options.tolerance;
    };
    if (!s_.replay.maneuver_done(k) &&
        !claims_.has_unchecked(due.t + s_.options.tolerance, is_it)) {
      return refuter_.missing_maneuver(k);
    }
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
