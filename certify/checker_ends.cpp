// The start and the end of a history, and of a part of one.
#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "certify/checker.h"
#include "certify/initial_proof.h"
#include "certify/witness.h"
#include "history/json_text.h"

namespace voroproof::internal {

// Whether a claim is of a change of the motion that happens at t = 0, in truth.
bool Checker::turns_at_start(const Event& event) {
  if (std::holds_alternative<FlipEvent>(event)) return false;
  if (options_.truth == Truth::recorded) return sgn(exact_time(event)) == 0;
  if (const auto* m = std::get_if<ManeuverEvent>(&event)) {
    const auto k = replay_.scheduled(*m, exact_time(event));
    return k && scene_.maneuvers[*k].t == 0;
  }
  const auto& claim = std::get<CollideEvent>(event);
  const NextContact c = next_contact(claim.i, claim.j);
  return c.kind != NextContact::Kind::none &&
         chronology_.compare(moment_of(claim.i, claim.j, c), frontier_) <= 0;
}

// The next of these claims, wherever within the tolerance the file has it.
std::optional<std::size_t> Checker::next_turn_at_start() {
  for (std::size_t k = 0; k < near_.size(); ++k) {
    if (exact_time(near_[k].event) > options_.tolerance) break;
    if (turns_at_start(near_[k].event)) return k;
  }
  return std::nullopt;
}

void Checker::start() {
  frontier_ = Moment::at(Rational(0));
  refill();
  // What happens to the motion at t = 0 comes before the diagram at 0+.
  while (const auto k = next_turn_at_start()) {
    if (*k == 0) {
      take(0);
    } else if (options_.strict) {
      take(0);
      refute(Fault::wrong_order, "what is claimed on a later line happens at t = 0, before it");
    } else {
      take_before_others(*k);
    }
    if (const auto* c = std::get_if<CollideEvent>(&*claim_)) {
      collide(*c);
    } else {
      maneuver(std::get<ManeuverEvent>(*claim_));
    }
    done();
    refill();
  }
  claim_.reset();
  line_ = 1;
  take_initial_diagram();
  const int edges = diagram_.edges();
  lives_.assign(edges, {});
  collected_.assign(edges, 0);
  pairs_.assign(motion_.size() == 1 ? 1 : edges, {});
  const Moment now = Moment::at(Rational(0));
  chronology_.note_collisions(now);
  begin_lives(all_edges(), now);
  begun_ = true;
}

// Takes over the diagram at 0+ and proves it.
void Checker::take_initial_diagram() {
  std::vector<Quad> initial;
  if (history_.header().initial) {
    initial = *history_.header().initial;
  } else if (motion_.size() >= 2) {
    if (!options_.propose_initial) {
      throw Undecided("the history gives no initial diagram, and none is at hand");
    }
    initial = options_.propose_initial(motion_);
    certificate_.remarks.push_back(constructed_initial_remark);
  }
  if (motion_.size() < 2) {
    if (!initial.empty()) {
      refute(Fault::wrong_initial_diagram, "a diagram of fewer than two disks has no edge");
    }
    return;
  }
  try {
    if (diagram_.edges() == 0) diagram_ = diagram_of(motion_.size(), initial);
  } catch (const std::invalid_argument& e) {
    refute(Fault::wrong_initial_diagram, e.what());
  }
  if (const auto f = initial_fault(diagram_, motion_, 0, certificate_.tiers)) {
    Witness w;
    if (f->vertex && f->conflict) {
      w = conflict_witness(motion_, *f->vertex, *f->conflict, 0);
    } else if (f->edge) {
      w = motion_witness(motion_, generators(*f->edge), 0);
    } else if (f->vertex) {
      w = motion_witness(motion_, {f->vertex->begin(), f->vertex->end()}, 0);
    }
    refute(Fault::wrong_initial_diagram, f->truth, w);
  }
}

std::vector<int> Checker::all_edges() const {
  std::vector<int> edges(diagram_.edges());
  std::iota(edges.begin(), edges.end(), 0);
  return edges;
}

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

}  // namespace

// Goes on from what the part before has proved to be right up to t.
void Checker::resume(double t) {
  replay_.move(motion_);
  frontier_ = Moment::at(t);
  chronology_.begin_present();
  ++instant_;
  Life life;
  life.from = t;
  lives_.assign(diagram_.edges(), life);
  collected_.assign(diagram_.edges(), 0);
  pairs_.resize(motion_.size() == 1 ? 1 : diagram_.edges());
  begun_ = true;
  for (Adjacency& pair : pairs_) pair.from = t;
}

// `closed`: nothing may be left that has to happen at m itself either.
void Checker::end_all_lives(const Moment& m, bool closed) {
  std::vector<int> edges(pairs_.size());
  std::iota(edges.begin(), edges.end(), 0);
  end_pairs(edges, m, closed ? PairEnd::end : PairEnd::turn);
  end_lives(all_edges(), m, closed);
}

// The end of a part: nothing may be left that has to happen up to that time.
void Checker::finish_part(const PartEnd& end) {
  claim_.reset();
  line_ = history_.line();
  require_maneuvers_before(end.t);
  leave_instant();
  end_all_lives(Moment::at(end.t), true);
  if (!same_edges(diagram_, end.diagram)) {
    throw Undecided(
        "a quadruplet without orientation names one edge and means another: what it means was "
        "not settled before the history was cut into parts");
  }
  certificate_.prefix_events = processed_;
  certificate_.prefix_t = end.t;
  certificate_.verdict = Verdict::certified;
}

void Checker::finish() {
  claim_.reset();
  line_ = history_.line();
  const auto* stop = std::get_if<HistoryStop>(&history_.ending());
  // What the file cannot say for certain is not held against it.
  Rational end = history_.header().horizon - history_.header().horizon_error;
  if (stop != nullptr) end = stop->exact_t ? *stop->exact_t : to_rational(stop->t);
  if (stop == nullptr || end > to_rational(frontier_.lo)) {
    for (std::size_t k = replay_.next_maneuver(); k < scene_.maneuvers.size(); ++k) {
      const Rational& t = scene_.maneuvers[k].t;
      if (t > end || replay_.maneuver_done(k) || (stop != nullptr && t == end)) continue;
      throw Refuted{missing_maneuver(k)};
    }
  }
  // The horizon of some files is rounded, and events may lie beyond it.
  Moment m = Moment::at(end);
  if (chronology_.compare(m, frontier_) < 0) m = frontier_;
  // A file that stops with its last event is right up to that: the time of it is rounded.
  if (stop != nullptr && !times_.empty() && times_.back() == stop->t) m = frontier_;
  if (stop == nullptr) {
    leave_instant();
  } else if (chronology_.compare(m, frontier_) > 0) {
    begin_pending_lives();
  }
  end_all_lives(m, stop == nullptr);
  if (stop == nullptr && !history_.counts_match()) {
    refute(Fault::bad_count, "the file has " + std::to_string(history_.counts().flips) +
                                 " flips, " + std::to_string(history_.counts().collisions) +
                                 " collisions and " + std::to_string(history_.counts().maneuvers) +
                                 " maneuvers");
  }
  certificate_.prefix_events = processed_;
  certificate_.prefix_t = certificate_.left_out + recorded_.left_out() > 0
                              ? std::max(0.0, horizon_window_down_)
                              : round_down(end);
  if (stop != nullptr) {
    certificate_.verdict = Verdict::undecided;
    certificate_.reason = "the history stops at t = " + number_text(stop->t) +
                          " and is right up to there: " + stop->reason;
    certificate_.reason_line = line_;
  } else {
    certificate_.verdict = Verdict::certified;
  }
}

}  // namespace voroproof::internal
