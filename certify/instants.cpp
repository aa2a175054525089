#include "certify/instants.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "certify/exact_truth.h"
#include "certify/initial_proof.h"
#include "certify/wording.h"

namespace voroproof::internal {

void Instants::advance(const Moment& m) {
  const bool tied = is_moment_of(claims_.tie(), m);
  const int order =
      tied && claims_.tie().number == tie_ ? 0 : s_.chronology.compare(m, front_.moment);
  if (order < 0 && claims_.placed()) {
    throw Undecided("two events are claimed in the other order, nearer than was seen in time");
  }
  if (order < 0 && claims_.overlooked()) {
    throw Undecided(
        "an event is claimed behind more others within the tolerance than are looked at");
  }
  if (order < 0) {
    refuter_.refute(Fault::wrong_order,
                    "the event lies " + between(m.lo, m.hi) +
                        ", before the event claimed before it, and cannot be swapped "
                        "with it");
  }
  if (order > 0 || tied) tie_ = tied ? claims_.tie().number : 0;
  if (order > 0) {
    leave();
    pairs_.reach(m, claims_.settled());
    if (revealed_ && s_.chronology.compare(m, *revealed_) <= 0) {
      throw Undecided("something happens while a generator may lie inside another");
    }
    front_.moment = m;
    if (front_.instant == std::numeric_limits<int>::max())
      throw Undecided("too many instants to number");
    ++front_.instant;
    flipped_.clear();
    if (s_.exact != nullptr) s_.exact->begin_instant();
    s_.chronology.begin_present();
    s_.chronology.note_present(m);
    return;
  }
  pairs_.reach(m, claims_.settled());
  s_.chronology.note_present(m);
  if (claims_.processed() > 0) ++s_.certificate.simultaneous;
  if (!m.is_flip()) front_.moment = m;
}

void Instants::leave() {
  if (s_.exact != nullptr) s_.exact->require_order(true);
  begin_pending_lives();
  edges_.require_none_illegal();
}

void Instants::begin_pending_lives() {
  if (!s_.options.judges_flips() && front_.begun) s_.chronology.note_collisions(front_.moment);
  if (!edges_.any_pending()) return;
  s_.chronology.note_collisions(front_.moment);
  edges_.take_pending(beginning_);
  if (s_.points.any()) require_areas(beginning_);
  prove_hidden_anew(beginning_);
  edges_.begin(beginning_, front_.moment);
}

// The points among the generators of these edges, which are all around the disks that have turned,
// must have a cell.
void Instants::require_areas(const std::vector<int>& edges) const {
  const Moment now = s_.chronology.instant(front_.moment);
  std::vector<GenId> asked;
  for (const int e : edges) {
    const auto [i, j] = s_.replay.pair_of(e);
    for (const GenId g : {i, j}) {
      if (!s_.points.is_point(g) || std::find(asked.begin(), asked.end(), g) != asked.end()) {
        continue;
      }
      asked.push_back(g);
      s_.points.require_area(g, s_.diagram.neighbours(g), now);
    }
  }
}

// Recorded truth: of the pairs around the disks that have turned at the present instant, those of
// which one generator has lain inside the other since they last met. At a time at which none does
// so any more the whole diagram is proved anew: in the hidden moment nothing was. The lives of the
// edges with both of such a pair among their generators begin then. Leaves the other edges.
void Instants::prove_hidden_anew(std::vector<int>& edges) {
  RecordedContacts& recorded = pairs_.recorded().contacts();
  if (!recorded.carries_any() || s_.diagram.edges() == 0) return;
  std::set<std::pair<GenId, GenId>> hidden;
  Rational revealed;
  for (const int e : edges) {
    const auto pair = s_.replay.pair_of(e);
    if (!recorded.hidden(pair) || !hidden.insert(pair).second) continue;
    const auto lines = pairs_.recorded().lines(pair.first, pair.second, front_.moment.lo);
    const auto t = lines.gap.revealed(front_.moment.rational(), 2 * s_.options.tolerance);
    if (!t) throw Undecided("a generator lies inside another for long", pair.first, pair.second);
    revealed = std::max(revealed, *t);
  }
  if (hidden.empty()) return;
  // Further pairs may be seen at the same instant.
  if (revealed_) revealed = std::max(revealed, revealed_->rational());
  revealed_ = Moment::at(revealed);
  if (initial_fault(s_.diagram, s_.motion, revealed, s_.certificate.tiers, s_.options.threads)) {
    throw Undecided("the diagram is not proved after a generator lay inside another",
                    hidden.begin()->first, hidden.begin()->second);
  }
  const auto concerned = [&](int e) {
    const Quad q = s_.diagram.quad(2 * e);
    const auto among = [&](GenId g) { return g == q.l || g == q.r || g == q.s || g == q.e; };
    return std::any_of(hidden.begin(), hidden.end(),
                       [&](const auto& pair) { return among(pair.first) && among(pair.second); });
  };
  const auto begun = std::stable_partition(edges.begin(), edges.end(), std::not_fn(concerned));
  edges_.begin_later({begun, edges.end()}, *revealed_);
  edges.erase(begun, edges.end());
  for (const auto& pair : hidden) {
    ++s_.certificate.proved_anew;
    recorded.reveal(pair, revealed);
  }
}

void Instants::require_no_flip_yet(GenId i, GenId j) const {
  for (const GenId g : {i, j}) {
    if (g == container_id || std::find(flipped_.begin(), flipped_.end(), g) == flipped_.end()) {
      continue;
    }
    refuter_.refute(Fault::wrong_order,
                    "disk " + std::to_string(g) +
                        " turns at the same instant as an edge of it flips, and comes "
                        "before that");
  }
}

bool Instants::in_time(const Moment& m) {
  const bool plain =
      std::visit([](const auto& c) { return c.exact == nullptr; }, *claims_.current());
  if (plain) {
    const DoubleBall t(time(*claims_.current()));
    if (sign(DoubleBall(m.lo) - (t - s_.near_tolerance)) == Sign::positive &&
        sign(t + s_.near_tolerance - DoubleBall(m.hi)) == Sign::positive) {
      return true;
    }
  }
  return s_.chronology.within(s_.options.tolerance, m, exact_time(*claims_.current()));
}

bool Instants::is_moment_of(const Tie& tie, const Moment& m) const {
  const auto same = [&](std::initializer_list<GenId> generators) {
    return std::all_of(generators.begin(), generators.end(),
                       [&](GenId g) { return s_.replay.unchanged_since(g, tie.changes); });
  };
  // With a finer interval of its own, m need not be the only root of its generators in [lo, hi].
  if (tie.number == 0 || m.fine || m.lo != tie.lo || m.hi != tie.hi) return false;
  return (m.is_flip() && same({m.quad.l, m.quad.r, m.quad.s, m.quad.e})) ||
         (m.is_contact() && same({m.i, m.j}));
}

void Instants::require_maneuvers_before(double t) {
  const std::size_t next = s_.replay.next_maneuver();
  if (next == s_.scene.maneuvers.size()) return;
  const Rational& due = s_.scene.maneuvers[next].t;
  if (t <= due.get_d()) return;  // which is rounded towards zero
  if (due > s_.header.horizon || due >= to_rational(t)) return;
  throw Refuted{refuter_.missing_maneuver(next)};
}

}  // namespace voroproof::internal
