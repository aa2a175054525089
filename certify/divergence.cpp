// What a refutation says: the first divergence of the history from the truth.
#include <algorithm>

#include "certify/checker.h"
#include "certify/contact_proof.h"
#include "certify/edge_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"
#include "history/error.h"

namespace voroproof::internal {

// The line of the first claim later than t, or the last line read.
std::int64_t Checker::line_at(double t) const {
  const auto it = std::upper_bound(times_.begin(), times_.end(), t);
  return it == times_.end() ? history_.line() : lines_[it - times_.begin()];
}

// The certified prefix ends at t, or with the last event proved.
void Checker::prefix_until(double t) {
  certificate_.prefix_t = std::min(t, frontier_.lo);
  const auto it = std::lower_bound(times_.begin(), times_.end(), certificate_.prefix_t);
  certificate_.prefix_events = std::min<std::int64_t>(it - times_.begin(), processed_);
}

// The claim being checked is false; without one, the history is where it has come to.
Divergence Checker::divergence_at_claim(Fault fault, std::string truth) const {
  Divergence d;
  d.fault = fault;
  d.line = line_;
  d.t = claim_ ? time(*claim_) : frontier_.lo;
  d.claim = claim_;
  d.truth = std::move(truth);
  return d;
}

void Checker::refute(Fault fault, const std::string& truth, Witness witness) {
  Divergence d = divergence_at_claim(fault, truth);
  d.witness = std::move(witness);
  throw Refuted{std::move(d)};
}

Divergence Checker::missing_flip(const Quad& q, const Collapse& root) {
  Divergence d;
  d.fault = Fault::missing_event;
  d.t = root.lo;
  d.line = line_at(root.lo);
  d.truth = "edge " + text_of(canonical(q)) + " flips " + between(root.lo, root.hi);
  d.true_flip = canonical(q);
  d.true_time = {root.lo, root.hi};
  const auto [lo, hi] = interval_of(root);
  d.witness = collapse_witness(motion_, q, lo, hi);
  return d;
}

Divergence Checker::missing_contact(GenId i, GenId j, double lo, double hi) {
  Divergence d;
  d.fault = options_.truth == Truth::recorded ? Fault::overlap : Fault::missing_event;
  d.t = lo;
  d.line = line_at(lo);
  d.truth = "generators " + text_of(i, j) + " touch and approach " + between(lo, hi);
  d.true_contact = {i, j};
  d.true_time = {lo, hi};
  d.witness = contact_witness(motion_, i, j, to_rational(lo), to_rational(hi));
  return d;
}

// The k-th maneuver of the scene.
Divergence Checker::missing_maneuver(std::size_t k) const {
  const Maneuver& m = scene_.maneuvers[k];
  Divergence d;
  d.fault = Fault::missing_event;
  d.line = line_;
  d.t = round_nearest(m.t);
  d.truth =
      "disk " + std::to_string(m.disk) + " is scheduled for a maneuver at t = " + m.t.get_str();
  return d;
}

// Whether one of these turns just now. (The container, which collides, too, does not.)
bool Checker::turns_one_of(std::initializer_list<GenId> generators) const {
  return std::any_of(generators.begin(), generators.end(), [this](GenId g) {
    return g != container_id && std::find(turning_.begin(), turning_.end(), g) != turning_.end();
  });
}

// Disks that move through each other, since a collision is missing, lead the edges into
// degeneracies that may be beyond the budget. Refutes the history where a contact should have been
// claimed before the present claim.
void Checker::refute_missing_contacts() {
  if (!begun_) return;
  // A contact before this time would have been claimed, and its claim checked.
  const double now = (claim_ ? time(*claim_) : frontier_.lo) - 2 * tolerance_up_;
  for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) {
    const auto [i, j] = replay_.pair_of(e);
    if (!(pairs_[e].from < now) || turns_one_of({i, j})) continue;
    try {
      end_pair(e, Moment::at(now), PairEnd::turn);
    } catch (const Undecided&) {
      // Another may tell.
    }
  }
}

// The earliest event that every open life should have had, up to the refuted claim. Contacts come
// first everywhere: disks that move through each other lead the edges into degeneracies that are
// costly to decide.
Divergence Checker::first_event_missing(const Divergence& found) {
  Divergence first = found;
  double limit =
      found.true_time && (*found.true_time)[0] < found.t ? (*found.true_time)[0] : found.t;
  const double margin =
      found.fault == Fault::missing_event || found.fault == Fault::overlap ? 0 : tolerance_up_;
  limit = std::min(limit, search_end_);
  for (int e = 0; e < static_cast<int>(pairs_.size()); ++e) {
    const auto [i, j] = replay_.pair_of(e);
    if (replay_.partners(i, j) || turns_one_of({i, j}) ||
        proved_apart(motion_, i, j, pairs_[e].from, limit)) {
      continue;
    }
    const Instant begin = options_.truth == Truth::exact
                              ? since(i, j)
                              : chronology_.instant(Moment::at(pairs_[e].from));
    const NextContact c = contacts_.from(i, j, begin, limit);
    if (c.kind == NextContact::Kind::none || c.hi >= limit - margin - tolerance_up_) continue;
    limit = c.lo;
    first = missing_contact(i, j, c.lo, c.hi);
  }
  // Where it is undecided whether an edge collapses so early that its flip should have been claimed
  // by now, the history is false whether it does or not, and the refutation stands.
  bool undecided = false;
  const auto search = [&](const Quad& q, double from) -> std::optional<Collapse> {
    try {
      return first_collapse(q, from, limit);
    } catch (const Undecided&) {
      try {
        if (const auto c = first_collapse(q, from, limit - margin - 2 * tolerance_up_)) return c;
      } catch (const Undecided&) {
        undecided = true;
        return std::nullopt;
      }
      throw;
    }
  };
  for (int e = 0; e < diagram_.edges(); ++e) {
    const Quad q = diagram_.quad(2 * e);
    const Life& life = lives_[e];
    if (life.illegal || life.pending || turns_one_of({q.l, q.r, q.s, q.e})) continue;
    std::optional<Collapse> c;
    if (life.due) {
      c = due_.at(e);
    } else if (!proved_free(motion_, q, life.from, limit)) {
      c = search(q, life.from);
    }
    if (!c || c->hi >= limit - margin) continue;
    limit = c->lo;
    first = missing_flip(q, *c);
  }
  if (undecided) {
    certificate_.remarks.push_back(
        "whether a flip is missing before the claim that is refuted is undecided");
  }
  return first;
}

// What was refuted may be the consequence of something missed before, an event or a maneuver. Of
// claims within the tolerance of a maneuver it is not known on which side of it they are meant.
Divergence Checker::first_divergence(const Divergence& found) {
  const Divergence first = begun_ ? first_event_missing(found) : found;
  const bool by_truth = first.fault == Fault::missing_event || first.fault == Fault::overlap;
  return maneuver_missing_by(first.t + (by_truth ? 0 : tolerance_up_)).value_or(first);
}

// The first maneuver scheduled by t that the history lacks.
std::optional<Divergence> Checker::maneuver_missing_by(double t) {
  const HistoryHeader& header = history_.header();
  const Rational last = std::min(to_rational(t), Rational(header.horizon - header.horizon_error));
  for (std::size_t k = replay_.next_maneuver(); k < scene_.maneuvers.size(); ++k) {
    if (scene_.maneuvers[k].t > last) break;
    if (!replay_.maneuver_done(k) && !is_claimed(scene_.maneuvers[k])) return missing_maneuver(k);
  }
  return std::nullopt;
}

// Whether a claim that is not proved yet is of this maneuver, or may be for what the file says.
// Reads on: no claim is checked after this.
bool Checker::is_claimed(const Maneuver& due) {
  const auto is_it = [&](const Event& event) {
    const auto* m = std::get_if<ManeuverEvent>(&event);
    return m != nullptr && m->disk == due.disk &&
           abs(Rational(exact_time(event) - due.t)) <= options_.tolerance;
  };
  if (claim_ && is_it(*claim_)) return true;
  for (const Claim& c : near_) {
    if (is_it(c.event)) return true;
  }
  const double latest = round_up(Rational(due.t + options_.tolerance));
  try {
    while (near_.empty() || time(near_.back().event) <= latest) {
      std::optional<Event> event = history_.next();
      if (!event) {
        // A file that stops early may stop before it.
        const auto* stop = std::get_if<HistoryStop>(&history_.ending());
        return stop != nullptr && stop->t <= latest;
      }
      near_.emplace_back(std::move(*event), history_.line());
      if (is_it(near_.back().event)) return true;
    }
    return false;
  } catch (const InputError&) {
    return true;
  }
}

}  // namespace voroproof::internal
