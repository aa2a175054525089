#include "certify/checker.h"

#include <algorithm>
#include <array>
#include <limits>

#include "certify/witness.h"
#include "certify/wording.h"
#include "exact/patience.h"
#include "history/json_text.h"

namespace voroproof::internal {

namespace {

// How many of the claims that are near each other in time are looked at together.
constexpr std::size_t kMaxNear = 64;

// The disks that a claim turns, the container for none.
std::array<GenId, 2> turned_by(const Event& event) {
  if (const auto* c = std::get_if<CollideEvent>(&event)) return {c->i, c->j};
  if (const auto* m = std::get_if<ManeuverEvent>(&event)) return {m->disk, container_id};
  return {container_id, container_id};
}

bool turn_one_disk(const Event& a, const Event& b) {
  for (const GenId g : turned_by(a)) {
    for (const GenId h : turned_by(b)) {
      if (g != container_id && g == h) return true;
    }
  }
  return false;
}

}  // namespace

MotionInput checked_input(MotionInput input, const HistoryHeader& header) {
  input.horizon = to_rational(round_up(Rational(header.horizon + header.horizon_error)));
  return input;
}

Checker::Checker(const Scene& scene, Motion& motion, HistorySource& history,
                 const CertifyOptions& options, Replay replay, std::optional<double> begin,
                 std::vector<Replay::Place> places)
    : scene_(scene),
      history_(history),
      options_(options),
      last_instant_(history.header().horizon + history.header().horizon_error),
      search_end_(round_up(last_instant_)),
      horizon_down_(round_down(last_instant_)),
      horizon_window_(history.header().horizon - history.header().horizon_error -
                      options.tolerance),
      horizon_window_down_(round_down(horizon_window_)),
      motion_(motion),
      begin_(begin),
      replay_(std::move(replay)),
      diagram_(replay_.diagram()),
      collapses_(motion_, certificate_.tiers),
      contacts_(motion_, certificate_.tiers),
      chronology_(motion_, collapses_, contacts_, certificate_.beyond_filter),
      law_(scene, options.law_tolerance),
      tolerance_up_(round_up(options.tolerance)),
      near_tolerance_(ball(options.tolerance)),
      places_(std::move(places)),
      recorded_(options.tolerance, horizon_window_),
      batch_(motion_),
      apart_(motion_) {}

Certificate Checker::run(const PartEnd* end) {
  std::optional<Patience> patience;
  if (options_.monitor)
    patience.emplace([this] { return options_.monitor(frontier_.lo, processed_); });
  try {
    try {
      if (begin_) {
        resume(*begin_);
      } else {
        start();
      }
      while (!near_.empty() || refill()) process_next();
      if (end != nullptr) {
        finish_part(*end);
      } else {
        finish();
      }
    } catch (const Refuted& r) {
      throw Refuted{first_divergence(r.divergence)};
    } catch (const Undecided&) {
      refute_missing_contacts();
      if (auto d = maneuver_missing_by(claim_ ? time(*claim_) : frontier_.lo)) throw Refuted{*d};
      throw;
    }
  } catch (const GivenUp&) {
    prefix_until(frontier_.lo);
    throw CertificationInterrupted{certificate_.prefix_events, certificate_.prefix_t};
  } catch (const Refuted& r) {
    certificate_.verdict = Verdict::refuted;
    certificate_.divergence = r.divergence;
    prefix_until(certificate_.divergence->t);
  } catch (const Undecided& u) {
    certificate_.verdict = Verdict::undecided;
    certificate_.reason = u.what();
    if (u.flip) certificate_.reason += "; edge " + text_of(canonical(*u.flip));
    if (u.contact) {
      certificate_.reason += "; generators " + text_of(u.contact->first, u.contact->second);
    }
    certificate_.reason_line = line_;
    prefix_until(frontier_.lo);
  }
  certificate_.highest_bits = motion_.highest_bits();
  certificate_.rounding_overlaps = recorded_.rounded();
  certificate_.left_out += recorded_.left_out();
  if (ulps_count_ > 0) certificate_.ulps_mean = ulps_sum_ / static_cast<double>(ulps_count_);
  return std::move(certificate_);
}

// ---- Claims. ----

// Reads the claims that follow within twice the tolerance of the next one: their true order may
// differ from that of the file. False at the end.
bool Checker::refill() {
  while (!ended_ && (near_.empty() ||
                     (near_.size() < kMaxNear &&
                      time(near_.back().event) <= time(near_.front().event) + 2 * tolerance_up_))) {
    std::optional<Event> event = history_.next();
    if (!event) {
      ended_ = true;
      break;
    }
    const std::size_t k = times_.size();
    near_.emplace_back(std::move(*event), history_.line(),
                       k < places_.size() ? places_[k].half : -1);
    times_.push_back(time(near_.back().event));
    lines_.push_back(history_.line());
    if (begun_) fetch_ahead();
  }
  return !near_.empty();
}

// Asks for the memory of claims that are soon to be checked: large diagrams do not fit into the
// nearest caches. What a claim is about is found step by step, each from what the one before has
// asked for: the half-edge h, those of its two triangles, their twins' triangles, and the
// generators on the way. Always inline: g++ leaves out calls of functions that do nothing else.
inline void Checker::fetch_ahead() const {
  const auto place = [this](std::size_t far) {
    const std::size_t k = times_.size() + far;
    return k < places_.size() ? places_[k] : Replay::Place{};
  };
  if (const HalfEdge h = place(8).half; h >= 0) {
    diagram_.prefetch(h);
    __builtin_prefetch(&lives_[h / 2]);
    __builtin_prefetch(&pairs_[h / 2]);
  }
  if (const auto [h, turns] = place(6); h >= 0) {
    if (turns != Replay::Place::kNone) {
      replay_.prefetch(turns);
      replay_.prefetch(diagram_.org(h));
    }
    for (const HalfEdge g : {h, h ^ 1}) {
      const HalfEdge side = diagram_.previous(g);
      diagram_.prefetch(side);
      __builtin_prefetch(&lives_[side / 2]);
      __builtin_prefetch(&motion_.doubles(diagram_.org(g)));
    }
  }
  if (const HalfEdge h = place(4).half; h >= 0) {
    for (const HalfEdge g : {h, h ^ 1}) {
      const HalfEdge side = diagram_.previous(g), other = diagram_.previous(side);
      diagram_.prefetch(other);
      __builtin_prefetch(&lives_[other / 2]);
      diagram_.prefetch(diagram_.previous(side ^ 1));
      __builtin_prefetch(&motion_.doubles(diagram_.org(side)));
    }
  }
  if (const HalfEdge h = place(2).half; h >= 0) {
    for (const HalfEdge g : {h, h ^ 1}) {
      const HalfEdge side = diagram_.previous(g), other = diagram_.previous(side);
      diagram_.prefetch(diagram_.previous(other ^ 1));
      __builtin_prefetch(&motion_.doubles(diagram_.org(diagram_.previous(side ^ 1))));
    }
  }
}

// Makes the k-th of the near claims the one being checked.
void Checker::take(std::size_t k) {
  claim_ = std::move(near_[k].event);
  line_ = near_[k].line;
  place_ = near_[k].place;
  tie_ = near_[k].tie;
  placed_ = near_[k].placed;
  near_.erase(near_.begin() + static_cast<std::ptrdiff_t>(k));
}

void Checker::done() {
  ++processed_;
  if (options_.truth == Truth::recorded && time(*claim_) > horizon_window_down_) {
    ++certificate_.at_horizon;
  }
  if (options_.monitor && (processed_ & 0xff) == 0 && !options_.monitor(frontier_.lo, processed_)) {
    throw GivenUp{};
  }
}

void Checker::process_next() {
  refill();
  const bool alone =
      near_.size() == 1 || time(near_[1].event) > time(near_[0].event) + 2 * tolerance_up_;
  const std::size_t k = alone ? 0 : earliest();
  if (k > 0) {
    take_before_others(k);
  } else {
    take(0);
  }
  if (const auto* f = std::get_if<FlipEvent>(&*claim_)) {
    flip(*f);
  } else if (const auto* c = std::get_if<CollideEvent>(&*claim_)) {
    collide(*c);
  } else {
    maneuver(std::get<ManeuverEvent>(*claim_));
  }
  done();
}

// Takes the k-th of the near claims, which in truth comes before those that the file has before it.
// It has to commute with them. Two turns of one disk do not: whoever reads the file in its order
// takes the velocity of the later line for the last one. Flips do where each names an edge that is
// there in the file's order, too.
void Checker::take_before_others(std::size_t k) {
  const auto flips = [this](std::size_t m) { return std::get_if<FlipEvent>(&near_[m].event); };
  for (std::size_t passed = 0; passed < k; ++passed) {
    if (!turn_one_disk(near_[passed].event, near_[k].event)) continue;
    const double later = time(near_[k].event);
    take(passed);
    refute(Fault::wrong_order,
           "a turn of the same disk, claimed at t = " + number_text(later) + ", comes before it");
  }
  if (flips(k) != nullptr) {
    Diagram in_file_order = diagram_;
    for (std::size_t m = 0; m <= k; ++m) {
      if (flips(m) == nullptr) continue;
      const Quad q = flips(m)->quad;
      HalfEdge h = find_edge(in_file_order, q);
      if (h < 0 && options_.unoriented) h = find_edge(in_file_order, {q.l, q.r, q.e, q.s});
      if (h >= 0 && q.s != q.e) {
        in_file_order.flip(h);
        continue;
      }
      take(m);
      refute(Fault::edge_not_present, "no edge of the diagram has the quadruplet " + text_of(q) +
                                          " after the claims before it");
    }
  }
  ++certificate_.swaps;
  take(k);
}

// Which of the near claims is the first in truth. Only a claim that is certainly earlier than
// those before it, and whose own edge or pair is there already, goes before them. Of simultaneous
// ones the file's order stands; it is expensive to prove that they are, and done once.
std::size_t Checker::earliest() {
  std::size_t best = 0;
  std::optional<Moment> first = probe(near_[0].event);
  if (!first) return options_.strict ? 0 : turn_before(near_[0].event);
  // Nothing precedes the present instant, at which more may turn.
  if (!pending_.empty() && first->lo <= frontier_.hi &&
      chronology_.compare(*first, frontier_) <= 0) {
    return 0;
  }
  const auto tie = [this](Claim& claim, const Moment& m, std::int64_t number) {
    claim.tie = {number, m.lo, m.hi, replay_.changes()};
  };
  for (std::size_t k = 1; k < near_.size(); ++k) {
    // No truth within the tolerance of this claim comes first.
    if (time(near_[k].event) - tolerance_up_ > first->hi) continue;
    Claim &earlier = near_[best], &claim = near_[k];
    const bool tied = is_moment_of(earlier.tie, *first);
    if (claim.placed || (tied && claim.tie.number == earlier.tie.number)) continue;
    const std::optional<Moment> m = probe(claim.event);
    if (!m || m->lo > first->hi) continue;
    // No more bits for it: it need not be known, as that of an edge that is to flip in any case.
    const std::optional<int> order = chronology_.known_order(*m, *first);
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
  if (best > 0 && options_.strict) {
    take(0);
    refute(Fault::wrong_order,
           "an event claimed after it happens before it, " + between(first->lo, first->hi));
  }
  return best;
}

// Of a flip of an edge that stays as its generators move now: the first near claim that turns one
// of them, for the edge may collapse after that. 0 where there is none.
std::size_t Checker::turn_before(const Event& event) {
  const auto* f = std::get_if<FlipEvent>(&event);
  const HalfEdge h = f != nullptr ? replay_.find(f->quad) : -1;
  if (h < 0 || lives_[h / 2].illegal) return 0;
  const std::vector<GenId> four = generators(diagram_.quad(h));
  for (std::size_t k = 1; k < near_.size(); ++k) {
    for (const GenId g : turned_by(near_[k].event)) {
      const bool its = g != container_id && std::find(four.begin(), four.end(), g) != four.end();
      if (its && probe(near_[k].event)) return k;
    }
  }
  return 0;
}

// The true time of a claim whose edge or pair is there.
std::optional<Moment> Checker::probe(const Event& event) {
  if (const auto* f = std::get_if<FlipEvent>(&event)) {
    HalfEdge h = replay_.find(f->quad);
    if (h < 0 && options_.unoriented) h = replay_.find_mirrored(f->quad);
    if (h >= 0 && lives_[h / 2].pending) begin_pending_lives();
    if (h < 0 || lives_[h / 2].illegal) return std::nullopt;
    const Quad q = diagram_.quad(h);
    if (lives_[h / 2].due) return Moment::of(q, due_.at(h / 2));
    const double from = lives_[h / 2].from;
    if (const auto root = bracket(q, from, f->t)) return root->m;
    const auto c = first_collapse(q, from, f->t + tolerance_up_);
    if (!c) return std::nullopt;
    return Moment::of(q, *c);
  }
  if (options_.truth == Truth::recorded) return Moment::at(exact_time(event));
  if (const auto* c = std::get_if<CollideEvent>(&event)) {
    if (replay_.adjacency(c->i, c->j) < 0) return std::nullopt;
    const NextContact next = next_contact(c->i, c->j);
    if (next.kind == NextContact::Kind::none) return std::nullopt;
    return moment_of(c->i, c->j, next);
  }
  const auto& m = std::get<ManeuverEvent>(event);
  const auto k = replay_.scheduled(m, exact_time(event));
  if (!k) return std::nullopt;
  return Moment::at(scene_.maneuvers[*k].t);
}

// ---- Time. ----

// Whether m is the moment for which the tie was proved: then no generator of it has turned since.
bool Checker::is_moment_of(const Tie& tie, const Moment& m) const {
  const auto same = [&](std::initializer_list<GenId> generators) {
    return std::all_of(generators.begin(), generators.end(),
                       [&](GenId g) { return replay_.unchanged_since(g, tie.changes); });
  };
  // With a finer interval of its own, m need not be the only root of its generators in [lo, hi].
  if (tie.number == 0 || m.root || m.lo != tie.lo || m.hi != tie.hi) return false;
  return (m.kind == Moment::Kind::flip && same({m.quad.l, m.quad.r, m.quad.s, m.quad.e})) ||
         (m.kind == Moment::Kind::contact && same({m.i, m.j}));
}

// Where the truth has come to. A later moment makes it move on, and then nothing may be left
// that had to happen before.
void Checker::advance(const Moment& m) {
  const bool tied = is_moment_of(tie_, m);
  const int order = tied && tie_.number == frontier_tie_ ? 0 : chronology_.compare(m, frontier_);
  if (order < 0 && placed_) {
    throw Undecided("two events are claimed in the other order, nearer than was seen in time");
  }
  if (order < 0) {
    refute(Fault::wrong_order, "the event lies " + between(m.lo, m.hi) +
                                   ", before the event claimed before it, and cannot be swapped "
                                   "with it");
  }
  if (order > 0 || tied) frontier_tie_ = tied ? tie_.number : 0;
  if (order > 0) {
    leave_instant();
    if (m.lo <= revealed_) {
      throw Undecided("something happens while a generator may lie inside another");
    }
    frontier_ = m;
    if (instant_ == std::numeric_limits<int>::max()) throw Undecided("too many instants to number");
    ++instant_;
    turns_.clear();
    flipped_.clear();
    chronology_.begin_present();
    chronology_.note_present(m);
    return;
  }
  chronology_.note_present(m);
  if (processed_ > 0) ++certificate_.simultaneous;
  if (m.kind != Moment::Kind::flip) frontier_ = m;
}

// Whether the event of the claim being checked, which happens at m, is claimed in time.
bool Checker::in_time(const Moment& m) {
  const bool plain = std::visit([](const auto& c) { return c.exact == nullptr; }, *claim_);
  if (plain) {
    const DoubleBall t(time(*claim_));
    if (sign(DoubleBall(m.lo) - (t - near_tolerance_)) == Sign::positive &&
        sign(t + near_tolerance_ - DoubleBall(m.hi)) == Sign::positive) {
      return true;
    }
  }
  return chronology_.within(options_.tolerance, m, exact_time(*claim_));
}

// Every edge illegal at the present instant must have flipped.
void Checker::leave_instant() {
  begin_pending_lives();
  for (const int e : illegal_) {
    const Life& life = lives_[e];
    if (life.illegal && life.born == instant_ && !left_out(frontier_)) {
      Collapse c;
      c.lo = frontier_.lo;
      c.hi = frontier_.hi;
      Divergence d = missing_flip(diagram_.quad(2 * e), c);
      d.witness = motion_witness(motion_, generators(diagram_.quad(2 * e)), to_rational(c.lo));
      throw Refuted{d};
    }
  }
  illegal_.clear();
}

}  // namespace voroproof::internal
