#include "certify/checker.h"

#include <stdexcept>

#include "certify/fetch_ahead.h"
#include "certify/initial_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"
#include "exact/patience.h"
#include "filtered/numbers/next_double.h"
#include "history/json_text.h"

namespace voroproof::internal {

namespace {

// Edges have the same numbers in both as a rule, though not where claims were swapped.
bool same_edges(const Diagram& a, const Diagram& b) {
  if (a == b) return true;
  if (a.edges() != b.edges()) return false;
  for (int e = 0; e < a.edges(); ++e) {
    if (canonical(a.quad(2 * e)) != canonical(b.quad(2 * e))) return a.quads() == b.quads();
  }
  return true;
}

// Whether an event before t is not claimed.
bool missed_before(const Divergence& d, double t) {
  const bool missing = d.fault == Fault::missing_event || d.fault == Fault::overlap;
  return missing && (d.true_time ? (*d.true_time)[1] : d.t) < t;
}

}  // namespace

MotionInput checked_input(MotionInput input, const HistoryHeader& header) {
  input.horizon = to_rational(round_up(Rational(header.horizon + header.horizon_error)));
  return input;
}

Checker::Checker(const Scene& scene, Motion& motion, GivenMotion* given, HistorySource& history,
                 const CertifyOptions& options, Replay replay, std::optional<double> begin,
                 std::vector<Replay::Place> places)
    : s_(scene, motion, given, history.header(), options, std::move(replay)),
      begin_(begin),
      claims_(history, s_.tolerance_up, options.most_near, options.events, std::move(places)),
      refuter_(s_, claims_, front_),
      edges_(s_, front_, refuter_),
      pairs_(s_, front_, refuter_),
      instants_(s_, claims_, front_, refuter_, edges_, pairs_),
      around_(s_, front_, edges_, pairs_),
      flips_(s_, claims_, front_, refuter_, edges_, pairs_, instants_),
      turns_(s_, claims_, front_, refuter_, pairs_, around_, instants_),
      claim_order_(s_, claims_, front_, refuter_, edges_, instants_),
      first_divergence_(s_, claims_, front_, refuter_, edges_, pairs_) {}

Checker::Checker(const Scene& scene, GivenMotion& motion, HistorySource& history,
                 const CertifyOptions& options, Replay replay, std::optional<double> begin,
                 std::vector<Replay::Place> places)
    : Checker(scene, motion, &motion, history, options, std::move(replay), begin,
              std::move(places)) {}

Checker::Checker(const Scene& scene, Motion& motion, HistorySource& history,
                 const CertifyOptions& options, Replay replay, std::optional<double> begin,
                 std::vector<Replay::Place> places, const ExactTruth::Make& exact)
    : Checker(scene, motion, nullptr, history, options, std::move(replay), begin,
              std::move(places)) {
  exact_ = exact({s_, claims_, front_, refuter_, pairs_, around_, instants_});
  s_.exact = exact_.get();
}

Certificate Checker::run(const PartEnd* end) {
  Certificate& c = s_.certificate;
  std::optional<Patience> patience;
  if (s_.options.monitor) {
    patience.emplace([this] { return s_.options.monitor(front_.moment.lo, claims_.processed()); });
  }
  try {
    prove(end);
    conclude(end == nullptr);
  } catch (const GivenUp&) {
    prefix_until(front_.moment.lo, true);
    throw CertificationInterrupted{c.prefix_events, c.prefix_t};
  } catch (const Refuted& r) {
    c.verdict = Verdict::refuted;
    c.divergence = r.divergence;
    prefix_until(c.divergence->t);
  } catch (const Undecided& u) {
    c.verdict = Verdict::undecided;
    c.reason = u.what();
    if (u.flip) c.reason += "; edge " + text_of(canonical(*u.flip));
    if (u.contact) c.reason += "; generators " + text_of(u.contact->first, u.contact->second);
    c.reason_line = claims_.line();
    prefix_until(front_.moment.lo);
  }
  c.highest_bits = s_.motion.highest_bits();
  c.flips_not_judged = claims_.passed_over();
  c.rounding_overlaps = pairs_.recorded().contacts().rounded();
  c.left_out += pairs_.recorded().contacts().left_out();
  return std::move(c);
}

// Proves all claims, and that nothing is missing, or throws Refuted with the first divergence or
// Undecided.
void Checker::prove(const PartEnd* end) {
  try {
    if (begin_) {
      resume(*begin_);
    } else {
      start();
    }
    while (!claims_.near().empty() || refill()) {
      refill();
      claim_order_.take_next();
      process();
    }
    if (end != nullptr) {
      finish_part(*end);
    } else {
      finish();
    }
  } catch (const Refuted& r) {
    const bool dependent = claims_.may_depend_on_others();
    const Divergence first = first_divergence_.before(r.divergence);
    if (dependent && !missed_before(first, claims_.settled())) {
      throw Undecided(
          "the claim is false in its place, and may depend on another within the tolerance that is "
          "not looked at, or undecided");
    }
    throw Refuted{first};
  } catch (const Undecided&) {
    if (const auto first = first_divergence_.before_undecided()) throw Refuted{*first};
    throw;
  }
}

bool Checker::refill() {
  return claims_.refill([this] {
    if (front_.begun && s_.options.judges_flips()) fetch_ahead(s_, claims_, edges_, pairs_);
  });
}

// The claim that was taken.
void Checker::process() {
  const Event& claim = *claims_.current();
  instants_.require_maneuvers_before(claims_.settled());
  if (const auto* f = std::get_if<FlipEvent>(&claim)) {
    flips_.flip(*f);
  } else if (const auto* c = std::get_if<CollideEvent>(&claim)) {
    turns_.collide(*c);
  } else {
    turns_.maneuver(std::get<ManeuverEvent>(claim));
  }
  claims_.done();
  if (s_.options.truth == Truth::recorded && time(claim) > s_.horizon_window_down) {
    ++s_.certificate.at_horizon;
  }
  if (s_.options.monitor && (claims_.processed() & 0xff) == 0 &&
      !s_.options.monitor(front_.moment.lo, claims_.processed())) {
    throw GivenUp{};
  }
}

// ---- The start. ----

void Checker::start() {
  front_.moment = Moment::at(Rational(0));
  refill();
  // Events of the motion at t = 0 come before the diagram at 0+.
  while (claim_order_.take_next_at_start()) {
    process();
    refill();
  }
  // A turn that is missing is told of as such: without it the diagram at 0+ is another.
  const auto* stop =
      claims_.near().empty() ? std::get_if<HistoryStop>(&claims_.history().ending()) : nullptr;
  if (s_.exact != nullptr) s_.exact->require_order(stop == nullptr);
  if (stop != nullptr && stop->t == 0) {
    throw Undecided("the history stops at t = 0, perhaps before it has told of all turns then");
  }
  claims_.stand_at(1);
  if (s_.options.judges_flips()) take_initial_diagram();
  edges_.assign();
  around_.assign();
  pairs_.assign(0);
  const Moment now = Moment::at(Rational(0));
  s_.chronology.note_collisions(now);
  edges_.begin_all(now);
  front_.begun = true;
}

// Takes over the diagram at 0+ and proves it.
void Checker::take_initial_diagram() {
  Motion& motion = s_.motion;
  std::vector<Quad> initial;
  if (s_.header.initial) {
    initial = *s_.header.initial;
  } else if (motion.size() >= 2) {
    if (!s_.options.propose_initial) {
      throw Undecided("the history gives no initial diagram, and none is at hand");
    }
    initial = s_.options.propose_initial(motion);
    s_.certificate.remarks.push_back(constructed_initial_remark);
  }
  if (motion.size() < 2) {
    if (!initial.empty()) {
      refuter_.refute(Fault::wrong_initial_diagram,
                      "a diagram of fewer than two disks has no edge");
    }
    return;
  }
  try {
    if (s_.diagram.edges() == 0) s_.diagram = diagram_of(motion.size(), initial);
  } catch (const std::invalid_argument& e) {
    refuter_.refute(Fault::wrong_initial_diagram, e.what());
  }
  if (const auto f =
          initial_fault(s_.diagram, motion, 0, s_.certificate.tiers, s_.options.threads)) {
    Witness w;
    if (f->vertex && f->conflict) {
      w = conflict_witness(motion, *f->vertex, *f->conflict, 0);
    } else if (f->edge) {
      w = motion_witness(motion, generators(*f->edge), 0);
    } else if (f->vertex) {
      w = motion_witness(motion, {f->vertex->begin(), f->vertex->end()}, 0);
    }
    refuter_.refute(Fault::wrong_initial_diagram, f->truth, w);
  }
}

// Goes on from what the part before has proved to be right up to t.
void Checker::resume(double t) {
  if (s_.given != nullptr) s_.replay.move(*s_.given);
  front_.moment = Moment::at(t);
  s_.chronology.begin_present();
  ++front_.instant;
  edges_.assign_legal_from(t);
  around_.assign();
  pairs_.assign(t);
  front_.begun = true;
}

// ---- The end. ----

// `closed`: nothing may be left that has to happen at m itself either.
void Checker::end_all_lives(const Moment& m, bool closed) {
  pairs_.end_all(m, closed ? PairEnd::end : PairEnd::turn);
  edges_.end_all(m, closed);
}

// The end of a part: nothing may be left that has to happen up to that time.
void Checker::finish_part(const PartEnd& end) {
  claims_.end_at(end.t);
  instants_.require_maneuvers_before(claims_.settled());
  instants_.leave();
  const Moment m = Moment::at(end.t);
  if (s_.chronology.compare(m, front_.moment) <= 0) {
    throw Undecided("a part of the history ends before the last event that it claims");
  }
  end_all_lives(m, true);
  if (!same_edges(s_.diagram, end.diagram)) {
    throw Undecided(
        "a quadruplet without orientation names one edge and means another: what it means was "
        "not settled before the history was cut into parts");
  }
  right_until(end.t);
}

void Checker::finish() {
  const HistorySource& history = claims_.history();
  const auto* stop = std::get_if<HistoryStop>(&history.ending());
  // The end is the earliest that the file allows: its roundings are not held against the history.
  Rational end = s_.header.certain_horizon();
  if (stop != nullptr) end = stop->exact_t ? *stop->exact_t : to_rational(stop->t);
  claims_.end_at(round_down(end));
  if (stop == nullptr || end > to_rational(front_.moment.lo)) {
    const std::vector<Maneuver>& maneuvers = s_.scene.maneuvers;
    for (std::size_t k = s_.replay.next_maneuver(); k < maneuvers.size(); ++k) {
      const Rational& t = maneuvers[k].t;
      if (t > end || s_.replay.maneuver_done(k) || (stop != nullptr && t == end)) continue;
      throw Refuted{refuter_.missing_maneuver(k)};
    }
  }
  // The horizon of some files is rounded, and events may lie beyond it.
  Moment m = Moment::at(end);
  if (s_.chronology.compare(m, front_.moment) < 0) m = front_.moment;
  // A file that stops with its last event is right up to that: the time of it is rounded.
  if (stop != nullptr && claims_.last_is_at(stop->t)) m = front_.moment;
  if (stop == nullptr) {
    instants_.leave();
  } else {
    if (s_.exact != nullptr) s_.exact->require_order(false);
    if (s_.chronology.compare(m, front_.moment) > 0) instants_.begin_pending_lives();
  }
  end_all_lives(m, stop == nullptr);
  if (stop == nullptr && !history.counts_match()) {
    refuter_.refute(Fault::bad_count,
                    "the file has " + std::to_string(history.counts().flips) + " flips, " +
                        std::to_string(history.counts().collisions) + " collisions and " +
                        std::to_string(history.counts().maneuvers) + " maneuvers");
  }
  edges_.require_none_after_left_out();
  const bool left_out = s_.certificate.left_out + pairs_.recorded().contacts().left_out() > 0;
  const double last = left_out ? std::max(0.0, s_.horizon_window_down) : round_down(end);
  // An event before the stop may be claimed after it, within the tolerance.
  right_until(stop == nullptr ? last
                              : first_divergence_.complete_until(std::min(last, m.lo), false));
}

// All claims are proved, and nothing is missing up to t.
void Checker::right_until(double t) {
  s_.certificate.prefix_events = claims_.processed();
  s_.certificate.prefix_t = t;
}

// All that the history claims is proved, to its end if it is the whole.
void Checker::conclude(bool whole) {
  Certificate& c = s_.certificate;
  const auto* stop = whole ? std::get_if<HistoryStop>(&claims_.history().ending()) : nullptr;
  if (stop == nullptr) {
    c.verdict = Verdict::certified;
    return;
  }
  c.verdict = Verdict::undecided;
  const bool whole_way = !(c.prefix_t < next_below(next_below(stop->t)));
  c.reason = "the history stops at t = " + number_text(stop->t) + " and is right up to " +
             (whole_way ? "there" : "t = " + number_text(c.prefix_t)) + ": " + stop->reason;
  c.reason_line = claims_.line();
}

// The certified prefix ends at t, with the last event proved, or where something may be missing.
// `briefly`: as doubles tell.
void Checker::prefix_until(double t, bool briefly) {
  t = std::min(t, front_.moment.lo);
  s_.certificate.prefix_t = front_.begun ? first_divergence_.complete_until(t, briefly) : 0;
  s_.certificate.prefix_events = claims_.proved_before(s_.certificate.prefix_t);
}

}  // namespace voroproof::internal
