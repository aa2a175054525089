#include "certify/first_divergence.h"

#include <algorithm>

#include "certify/contact_proof.h"
#include "certify/edge_proof.h"

namespace voroproof::internal {

// Whether one of these turns just now. (The container, which collides, too, does not.)
bool FirstDivergence::turns_one_of(std::initializer_list<GenId> generators) const {
  return std::any_of(generators.begin(), generators.end(), [this](GenId g) {
    const std::vector<GenId>& turning = front_.turning;
    return g != container_id && std::find(turning.begin(), turning.end(), g) != turning.end();
  });
}

void FirstDivergence::refute_missing_contacts() {
  if (!front_.begun) return;
  const double now = claims_.settled();
  for (const PairLives::Open& life : pairs_.open(now)) {
    if (!(life.since < now) || turns_one_of({life.i, life.j})) continue;
    try {
      pairs_.end(life, Moment::at(now), PairEnd::turn);
    } catch (const Undecided&) {
      // Another may tell.
    }
  }
}

// The earliest event that every open life should have had, up to the refuted claim. Contacts come
// first everywhere: disks that move through each other lead the edges into degeneracies that are
// costly to decide.
Divergence FirstDivergence::first_event_missing(const Divergence& found) {
  const bool earlier = found.true_time && (*found.true_time)[0] < found.t;
  Earliest first{found, std::min(earlier ? (*found.true_time)[0] : found.t, s_.search_end)};
  look_for_contacts(first);
  look_for_flips(first);
  return first.divergence;
}

// How much earlier than the first so far an event must be to be missing for certain. Of those that
// are missing the first counts: where it is very near, the later one may be its consequence.
double FirstDivergence::margin(const Earliest& first) const {
  const Fault fault = first.divergence.fault;
  return fault == Fault::missing_event || fault == Fault::overlap ? 0 : s_.tolerance_up;
}

void FirstDivergence::look_for_contacts(Earliest& first) {
  for (const auto& [i, j, since, edge] : pairs_.open(first.limit)) {
    if (s_.replay.partners(i, j) || turns_one_of({i, j}) ||
        proved_apart(s_.motion, i, j, since, first.limit)) {
      continue;
    }
    const Instant begin = s_.options.truth == Truth::exact
                              ? pairs_.exact().since(i, j)
                              : s_.chronology.instant(Moment::at(since));
    const NextContact c = s_.contacts.from(i, j, begin, first.limit);
    if (c.kind == NextContact::Kind::none ||
        c.hi >= first.limit - margin(first) - s_.tolerance_up) {
      continue;
    }
    first = {refuter_.missing_contact(i, j, c.lo, c.hi), c.lo};
  }
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
    if (!c || c->hi >= first.limit - margin(first)) continue;
    first = {refuter_.missing_flip(q, *c), c->lo};
  }
  if (undecided) {
    s_.certificate.remarks.push_back(
        "whether a flip is missing before the claim that is refuted is undecided");
  }
}

// What was refuted may be the consequence of something missed before, an event or a maneuver.
// Claims within the tolerance of a maneuver may be meant on either side of it.
Divergence FirstDivergence::before(const Divergence& found) {
  const Divergence first = front_.begun ? first_event_missing(found) : found;
  const bool by_truth = first.fault == Fault::missing_event || first.fault == Fault::overlap;
  return maneuver_missing_by(first.t + (by_truth ? 0 : s_.tolerance_up)).value_or(first);
}

std::optional<Divergence> FirstDivergence::maneuver_missing_by(double t) {
  const HistoryHeader& header = s_.header;
  const Rational last = std::min(to_rational(t), Rational(header.horizon - header.horizon_error));
  for (std::size_t k = s_.replay.next_maneuver(); k < s_.scene.maneuvers.size(); ++k) {
    if (s_.scene.maneuvers[k].t > last) break;
    if (!s_.replay.maneuver_done(k) &&
        !claims_.has_unchecked(s_.scene.maneuvers[k], s_.options.tolerance))
      return refuter_.missing_maneuver(k);
  }
  return std::nullopt;
}

}  // namespace voroproof::internal
