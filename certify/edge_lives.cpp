// Lives of V-edges, and the flips that end them.
#include <algorithm>
#include <array>
#include <cmath>

#include "certify/checker.h"
#include "certify/edge_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Half width of the bracket that is tried around a claimed flip time, relative to max(1, t) and
// within the tolerance: wide beside the errors of doubles, narrow beside the gaps between events.
constexpr double kBracket = 0x1p-20;

// The same where double-doubles look: what is proved free of roots then begins further away.
constexpr double kWideBracket = 0x1p-21;

}  // namespace

// The first collapse of q, which is legal just after `from`, no later than `end`. Throws Undecided.
std::optional<Collapse> Checker::first_collapse(const Quad& q, double from, double end) {
  while (from < end) {
    const Collapse c = collapses_.after(q, from, end);
    if (c.kind == Collapse::Kind::root) return c;
    if (!(c.lo > from)) {
      throw Undecided("the life of edge " + text_of(canonical(q)) + " is not decided", q);
    }
    from = c.lo;
  }
  return std::nullopt;
}

// A life begins at m. `own`: m is a root of the edge's own polynomial, isolated so, and the edge
// is what the flip there left. `rootless`: its generators are proved not to be cotangent at m.
void Checker::begin_life(int edge, const Moment& m, const Isolated* own, bool rootless) {
  Life& life = lives_[edge];
  life = {};
  life.born = instant_;
  life.from = own != nullptr ? own->hi : m.lo;
  const bool isolated = own != nullptr && m.root == nullptr;
  if (isolated || rootless) return;
  const Quad q = diagram_.quad(2 * edge);
  if (q.s == q.e || (own == nullptr && proved_not_cotangent(motion_, q, m.lo, m.hi))) return;
  ++certificate_.beyond_filter;
  const double soon = std::nextafter(m.hi, kInfinity);
  const Collapse c = own != nullptr ? collapses_.after(q, m.hi, soon, m.root.get())
                                    : collapses_.from(q, chronology_.present(m), soon);
  switch (c.kind) {
    case Collapse::Kind::none:
      life.from = std::max(c.lo, m.lo);
      break;
    case Collapse::Kind::root:
      life.due = true;
      due_[edge] = c;
      break;
    case Collapse::Kind::now:
      life.illegal = true;
      illegal_.push_back(edge);
      chronology_.note_flip(q);
      break;
  }
}

// The life ends at m without a flip of the edge; `closed`: a collapse at m itself is missed too.
// Its quadruplet, over the time from its `from` to m.hi, is the k-th of the batch.
void Checker::end_life(int edge, const Moment& m, bool closed, std::size_t k) {
  ++certificate_.edge_lives;
  Life& life = lives_[edge];
  if (life.pending) return;
  if (life.illegal) {
    if ((life.born == instant_ && !closed) || left_out(frontier_)) return;
    Collapse c;
    c.lo = c.hi = m.lo;
    throw Refuted{missing_flip(diagram_.quad(2 * edge), c)};
  }
  if (!life.due && batch_.rootless(k)) return;
  const Quad q = diagram_.quad(2 * edge);
  if (!life.due) {
    if (batch_.one_root(k) && proved_free_of_one(motion_, q, m.hi, batch_.end_sign(k))) return;
    if (proved_free(motion_, q, life.from, m.hi)) return;
    ++certificate_.beyond_filter;
    const auto c = first_collapse(q, life.from, m.hi);
    if (!c) return;
    life.due = true;
    due_[edge] = *c;
  }
  const Collapse& root = due_.at(edge);
  const Moment at = Moment::of(q, root);
  const int order = chronology_.compare(at, m);
  if ((order < 0 || (order == 0 && closed)) && !left_out(at)) throw Refuted{missing_flip(q, root)};
}

void Checker::begin_lives(std::span<const int> edges, const Moment& m) {
  batch_.clear();
  for (const int e : edges) batch_.add(diagram_.quad(2 * e), m.lo, m.hi);
  batch_.prove_instant();
  for (std::size_t k = 0; k < edges.size(); ++k)
    begin_life(edges[k], m, nullptr, batch_.rootless(k));
}

void Checker::end_lives(std::span<const int> edges, const Moment& m, bool closed) {
  batch_.clear();
  for (const int e : edges) batch_.add(diagram_.quad(2 * e), lives_[e].from, m.hi);
  batch_.prove();
  for (std::size_t k = 0; k < edges.size(); ++k) end_life(edges[k], m, closed, k);
}

// A flip of q about the claimed time t.
Checker::Isolated Checker::claimed_root(const Quad& q, double t) const {
  Isolated root;
  root.m.kind = Moment::Kind::flip;
  root.m.quad = q;
  const double pad = std::fmin(kBracket * std::fmax(1, t), 0.99 * tolerance_up_);
  root.lo = root.m.lo = t - pad;
  root.hi = root.m.hi = t + pad;
  return root;
}

// The flip of q near the claimed time t, if that is easily proved. q is legal just after `from`.
std::optional<Checker::Isolated> Checker::bracket(const Quad& q, double from, double t) const {
  Isolated root = claimed_root(q, t);
  if (from <= root.lo && proved_collapse(motion_, q, root.lo, root.hi)) return root;
  // The polynomial is flat there, or an event is near.
  const double wide = kWideBracket * std::fmax(1, t);
  root.lo = std::fmax(from, t - wide);
  root.hi = t + wide;
  const auto dd = newton_collapse(motion_, collapses_, q, root.lo, root.hi);
  if (!dd) return std::nullopt;
  root.m.dd = *dd;
  enclose(*dd, root.m.lo, root.m.hi);
  if (!(root.m.lo >= t - 0.99 * tolerance_up_ && root.m.hi <= t + 0.99 * tolerance_up_)) {
    return std::nullopt;
  }
  return root;
}

// When the edge of h flips for this claim, or a refutation.
Checker::Found Checker::collapse_for(const FlipEvent& claim, HalfEdge h) {
  const Quad q = diagram_.quad(h);
  const Life& life = lives_[h / 2];
  std::optional<Isolated> easy;
  if (!life.illegal && !life.due) {
    const Isolated root = claimed_root(q, claim.t);
    if (proved_first_collapse(motion_, q, life.from, root.lo, root.hi)) return {root};
    easy = bracket(q, life.from, claim.t);
  }
  if (easy && proved_free(motion_, q, life.from, easy->lo)) return {*easy};
  ++certificate_.beyond_filter;
  const Rational t = exact_time(*claim_);
  if (life.illegal) {
    if (life.born != instant_) {
      refute(Fault::wrong_order, "the edge flips at an earlier instant");
    }
    const Moment& m = frontier_;
    if (!in_time(m)) {
      mistimed(q, {Collapse::Kind::now, m.lo, m.hi, nullptr}, t);
    }
    return {{m, m.lo, m.hi}, false};
  }
  const double end = round_up(Rational(t + options_.tolerance));
  std::optional<Collapse> c =
      life.due ? std::optional(due_.at(h / 2)) : first_collapse(q, life.from, end);
  if (!c) {
    c = first_collapse(q, std::max(life.from, end), search_end_);
    // Kept on beyond other events, the motion may lead to roots at which q is no longer an edge.
    if (c) {
      const auto [lo, hi] = interval_of(*c);
      if (!proved_no_flip(motion_, q, lo, hi)) mistimed(q, *c, t);
    }
    refute(Fault::spurious_event,
           "edge " + text_of(canonical(q)) + " does not collapse under its present motion",
           motion_witness(motion_, generators(q), t));
  }
  const Moment m = Moment::of(q, *c);
  if (!in_time(m)) mistimed(q, *c, t);
  return {{m, m.lo, m.hi}};
}

// The half-edge with the quadruplet of the claim being checked, or -1.
Diagram::HalfEdge Checker::claimed(const Quad& q) const {
  if (place_ >= 0 && place_ < 2 * diagram_.edges() && diagram_.quad(place_) == q) return place_;
  return replay_.find(q);
}

void Checker::flip(const FlipEvent& claim) {
  require_maneuvers_before(time(*claim_));
  begin_pending_lives();
  HalfEdge h = claimed(claim.quad);
  // A quadruplet whose two third generators are exchanged is that of an edge whose producer cannot
  // orient its quadruplets, or a fault.
  const HalfEdge mirrored = h < 0 ? replay_.find_mirrored(claim.quad) : -1;
  if (h < 0 && mirrored < 0) {
    refute(Fault::edge_not_present,
           "no edge of the diagram has the quadruplet " + text_of(claim.quad));
  }
  Found found;
  if (h >= 0) {
    try {
      found = collapse_for(claim, h);
    } catch (const Refuted&) {
      // Both edges of Configuration I may be there, and the other one be meant.
      if (!options_.unoriented) throw;
      h = replay_.find_mirrored(claim.quad);
      if (h < 0 || !bracket(diagram_.quad(h), lives_[h / 2].from, claim.t)) throw;
      resolve(h);
      found = collapse_for(claim, h);
    }
  } else {
    h = mirrored;
    resolve(h);
    found = collapse_for(claim, h);
  }
  const int edge = h / 2;
  const Quad q = diagram_.quad(h);
  const bool illegal = lives_[edge].illegal;
  const Moment& m = found.root.m;
  const bool own = found.own;
  if (illegal) {
    ++certificate_.simultaneous;
  } else {
    if (options_.truth == Truth::exact && m.hi >= horizon_down_ &&
        chronology_.compare(m, Moment::at(last_instant_)) > 0) {
      refute(Fault::spurious_event,
             "the edge flips " + between(m.lo, m.hi) + ", after the horizon");
    }
    advance(m);
  }
  if (options_.truth == Truth::exact && own) count_ulps(m, claim.t);
  ++certificate_.flips;
  flipped_.insert(flipped_.end(), {q.l, q.r, q.s, q.e});

  const std::array<HalfEdge, 4> ring{diagram_.next(h), diagram_.previous(h), diagram_.next(h ^ 1),
                                     diagram_.previous(h ^ 1)};
  std::array<int, 4> others{};
  std::array<GenId, 4> outer{};
  int count = 0;
  for (const HalfEdge g : ring) {
    if (g / 2 == edge ||
        std::find(others.begin(), others.begin() + count, g / 2) != others.begin() + count) {
      continue;
    }
    outer[count] = diagram_.apex(g ^ 1);
    others[count++] = g / 2;
  }
  const std::span<const int> near(others.data(), count);
  end_pair(edge, m, PairEnd::flip);
  if (count == 4) {
    batch_.prove_around(q, outer,
                        {lives_[others[0]].from, lives_[others[1]].from, lives_[others[2]].from,
                         lives_[others[3]].from},
                        m.hi);
    for (int k = 0; k < 4; ++k) end_life(near[k], m, false, k);
  } else {
    end_lives(near, m);
  }
  diagram_.flip(h);
  const Isolated* const root = own ? &found.root : nullptr;
  begin_life(edge, m, root, false);
  if (count == 4) {
    batch_.prove_around_flipped(q, outer, m.lo, m.hi);
  } else {
    batch_.clear();
    for (const int e : near) batch_.add(diagram_.quad(2 * e), m.lo, m.hi);
    batch_.prove_instant();
  }
  for (int k = 0; k < count; ++k) {
    // An edge of the same four generators has the same root, and is legal beyond it.
    const GenId g = outer[k];
    const bool same = own && (g == q.l || g == q.r || g == q.s || g == q.e) &&
                      same_generators(diagram_.quad(2 * near[k]), q);
    begin_life(near[k], m, same ? root : nullptr, batch_.rootless(k));
  }
  pairs_[edge] = {m.lo};
}

// The edge flips at c, too far from the claimed time.
void Checker::mistimed(const Quad& q, const Collapse& c, const Rational& claimed) {
  const auto [lo, hi] = interval_of(c);
  const Rational far = kMistimed * options_.tolerance;
  const bool near = lo - claimed <= far && claimed - hi <= far;
  Divergence d =
      divergence_at_claim(near || hi < claimed ? Fault::wrong_time : Fault::spurious_event,
                          "edge " + text_of(canonical(q)) + " flips " + between(c.lo, c.hi));
  d.true_flip = canonical(q);
  d.true_time = {c.lo, c.hi};
  // Of an edge that is illegal from the instant on, other polynomials may isolate that.
  d.witness = c.kind == Collapse::Kind::now ? motion_witness(motion_, generators(q), lo)
                                            : collapse_witness(motion_, q, lo, hi);
  throw Refuted{d};
}

// Takes the claim for one of the edge of h, though it exchanges the third generators: where the
// history cannot say which, and nowhere else.
void Checker::resolve(HalfEdge h) {
  if (options_.unoriented) {
    ++certificate_.resolved;
    return;
  }
  const Quad q = canonical(diagram_.quad(h));
  Divergence d = divergence_at_claim(Fault::wrong_quadruple,
                                     "the edge with these generators is " + text_of(q));
  d.true_flip = q;
  d.witness = motion_witness(motion_, generators(diagram_.quad(h)), to_rational(d.t));
  throw Refuted{d};
}

// Whether an event at m may be left out: under the recorded truth roundings move what happens
// within the tolerance of the horizon to either side of it.
bool Checker::left_out(const Moment& m) {
  if (options_.truth == Truth::exact || m.hi < horizon_window_down_ ||
      chronology_.compare(m, Moment::at(horizon_window_)) < 0) {
    return false;
  }
  ++certificate_.left_out;
  return true;
}

// The distance of the claimed time from the true one, for the report: to a tenth of a unit in the
// last place, and where it may be the greatest to a hundredth.
void Checker::count_ulps(const Moment& m, double claimed) {
  const DdBall d = chronology_.narrow(m) - DdBall(claimed);
  const double ulp = std::nextafter(claimed, kInfinity) - claimed;
  double error = std::fabs(d.hi + d.lo) / ulp;
  const double uncertain = d.rad / ulp;
  if (!(uncertain <= 0.01) && (!(uncertain <= 0.1) || error + uncertain > certificate_.ulps_max)) {
    double lo = 0, hi = 0;
    (chronology_.ball(m) - Ball(exact_time(*claim_), motion_.goal_bits() + 32)).to_interval(lo, hi);
    error = std::fmax(std::fabs(lo), std::fabs(hi)) / ulp;
  }
  ulps_sum_ += error;
  ++ulps_count_;
  if (error > certificate_.ulps_max) {
    certificate_.ulps_max = error;
    certificate_.ulps_max_line = line_;
  }
}

}  // namespace voroproof::internal
