#include "certify/flips.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/edge_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

// The half-edge with the quadruplet of the claim being checked, or -1.
Diagram::HalfEdge Flips::claimed(const Quad& q) const {
  const HalfEdge h = claims_.place();
  if (h >= 0 && h < 2 * s_.diagram.edges() && s_.diagram.quad(h) == q) return h;
  return s_.replay.find(q);
}

// The edge that the claim means, and when it flips for it.
Flips::Meant Flips::meant_by(const FlipEvent& claim) {
  HalfEdge h = claimed(claim.quad);
  if (h < 0) {
    // A quadruplet whose two third generators are exchanged is that of an edge whose producer
    // cannot orient its quadruplets, or a fault.
    h = s_.replay.find_mirrored(claim.quad);
    if (h < 0) {
      refuter_.refute(Fault::edge_not_present,
                      "no edge of the diagram has the quadruplet " + text_of(claim.quad));
    }
    resolve(h);
    return {h, collapse_for(claim, h)};
  }
  try {
    return {h, collapse_for(claim, h)};
  } catch (const Refuted&) {
    // Both edges of Configuration I may be there, and the claim may mean the other one.
    if (!s_.options.unoriented) throw;
    h = s_.replay.find_mirrored(claim.quad);
    if (h < 0 || !edges_.bracket(s_.diagram.quad(h), edges_.life(h / 2).from, claim.t)) throw;
  }
  resolve(h);
  return {h, collapse_for(claim, h)};
}

void Flips::flip(const FlipEvent& claim) {
  instants_.begin_pending_lives();
  const auto [h, found] = meant_by(claim);
  const int edge = h / 2;
  const Moment& m = found.root.m;
  if (edges_.life(edge).illegal) {
    ++s_.certificate.simultaneous;
  } else {
    if (s_.options.truth == Truth::exact && m.hi >= s_.horizon_down &&
        s_.chronology.compare(m, Moment::at(s_.last_instant)) > 0) {
      refuter_.refute(Fault::spurious_event,
                      "the edge flips " + between(m.lo, m.hi) + ", after the horizon");
    }
    instants_.advance(m);
  }
  if (s_.options.truth == Truth::exact && s_.options.measures_times && found.own) {
    count_ulps(m, claim.t);
  }
  ++s_.certificate.flips;
  edges_.note_flip(m);
  const EdgeRing ring(s_.diagram, h);
  instants_.note_flip(ring.q);
  pairs_.end(edge, m, PairEnd::flip);
  edges_.end_beside(ring, m);
  s_.diagram.flip(h);
  pairs_.begin(edge, m.lo);
  edges_.begin_after_flip(edge, ring, m, found.own ? &found.root : nullptr);
}

// When the edge of h flips for this claim, or a refutation.
Flips::Found Flips::collapse_for(const FlipEvent& claim, HalfEdge h) {
  const Quad q = s_.diagram.quad(h);
  const EdgeLives::Life& life = edges_.life(h / 2);
  Found found{edges_.claimed_root(q, claim.t)};
  if (life.illegal || life.due ||
      !proved_first_collapse(s_.motion, q, life.from, found.root.lo, found.root.hi)) {
    found = collapse_by_search(claim, q, h / 2);
  }
  return found;
}

// The same where the first filter does not tell.
Flips::Found Flips::collapse_by_search(const FlipEvent& claim, const Quad& q, int edge) {
  const EdgeLives::Life& life = edges_.life(edge);
  std::optional<IsolatedRoot> easy;
  if (!life.illegal && !life.due) easy = edges_.bracket(q, life.from, claim.t);
  if (easy && proved_free(s_.motion, q, life.from, easy->lo)) return {*easy};
  ++s_.certificate.tiers.beyond_filter;
  const Rational t = exact_time(*claims_.current());
  if (life.illegal) return present_collapse(q, life, t);
  const double end = round_up(Rational(t + s_.options.tolerance));
  std::optional<Collapse> c =
      life.due ? std::optional(edges_.due(edge)) : edges_.first_collapse(q, life.from, end);
  if (c) {
    const Moment m = Moment::of(q, *c);
    if (instants_.in_time(m)) return {{m, m.lo, m.hi}};
  } else {
    c = edges_.first_collapse(q, std::max(life.from, end), s_.search_end);
  }
  // Kept on beyond other events, the motion may lead to roots at which q is no longer an edge. The
  // search's interval may be wide, and disks may leave each other within it.
  if (c) {
    const auto [lo, hi] = s_.chronology.enclosure(Moment::of(q, *c));
    if (c->kind == Collapse::Kind::now ||
        !proved_no_flip(s_.motion, q, to_rational(lo), to_rational(hi))) {
      mistimed(q, *c, t);
    }
  }
  refuter_.refute(Fault::spurious_event, "edge " + text_of(canonical(q)) + " does not flip by then",
                  motion_witness(s_.motion, generators(q), t));
}

// When an edge that is illegal since the present instant flips for this claim, or a refutation.
Flips::Found Flips::present_collapse(const Quad& q, const EdgeLives::Life& life,
                                     const Rational& claimed) {
  if (life.born != front_.instant) {
    refuter_.refute(Fault::wrong_order, "the edge flips at an earlier instant");
  }
  const Moment& m = front_.moment;
  if (!instants_.in_time(m)) mistimed(q, {Collapse::Kind::now, m.lo, m.hi, nullptr}, claimed);
  return {{m, m.lo, m.hi}, false};
}

// The edge flips at c, too far from the claimed time.
void Flips::mistimed(const Quad& q, const Collapse& c, const Rational& claimed) {
  const auto [lo, hi] = c.root();
  const std::array<double, 2> narrow = s_.chronology.enclosure(Moment::of(q, c));
  const Rational far = mistimed_tolerances * s_.options.tolerance;
  const Rational from = to_rational(narrow[0]), to = to_rational(narrow[1]);
  const bool near = from - claimed <= far && claimed - to <= far;
  Divergence d = refuter_.at_claim(
      near || to < claimed ? Fault::wrong_time : Fault::spurious_event,
      "edge " + text_of(canonical(q)) + " flips " + between(narrow[0], narrow[1]));
  d.true_flip = canonical(q);
  d.true_time = narrow;
  // Where the edge is illegal from the instant on, another polynomial may isolate the instant.
  d.witness = c.kind == Collapse::Kind::now ? motion_witness(s_.motion, generators(q), lo)
                                            : collapse_witness(s_.motion, q, lo, hi);
  throw Refuted{d};
}

// Takes the claim for one of the edge of h, though it exchanges the third generators: where the
// history cannot say which, and nowhere else.
void Flips::resolve(HalfEdge h) {
  if (s_.options.unoriented) {
    ++s_.certificate.resolved;
    return;
  }
  const Quad q = canonical(s_.diagram.quad(h));
  Divergence d =
      refuter_.at_claim(Fault::wrong_quadruple, "the edge with these generators is " + text_of(q));
  d.true_flip = q;
  d.witness = motion_witness(s_.motion, generators(s_.diagram.quad(h)), to_rational(d.t));
  throw Refuted{d};
}

// The flip as double-doubles tell, most quickly where it is `near` the claimed time: most times are
// written as precisely as can be.
DdBall Flips::true_time(const Moment& m, double claimed, double near) const {
  const double lo = std::fmax(m.lo, claimed - near), hi = std::fmin(m.hi, claimed + near);
  if (m.fine == nullptr && lo < hi) {
    const DdBall root = s_.collapses.newton(m.quad, lo, hi);
    const bool inside =
        sign(root - DdBall(lo)) == Sign::positive && sign(root - DdBall(hi)) == Sign::negative;
    if (inside) return root;
  }
  return s_.chronology.narrow(m);
}

// The distance of the claimed time from the true one, for the report: to a tenth of a unit in the
// last place, and where it may be the greatest to a hundredth.
void Flips::count_ulps(const Moment& m, double claimed) {
  const double ulp = std::nextafter(claimed, infinity) - claimed;
  const DdBall d = true_time(m, claimed, 4 * ulp) - DdBall(claimed);
  double error = std::fabs(d.hi + d.lo) / ulp;
  const double uncertain = d.rad / ulp;
  if (!(uncertain <= 0.01) &&
      (!(uncertain <= 0.1) || error + uncertain > s_.certificate.ulps_max)) {
    double lo = 0, hi = 0;
    (s_.chronology.ball(m) - Ball(exact_time(*claims_.current()), s_.motion.goal_bits() + 32))
        .to_interval(lo, hi);
    error = std::fmax(std::fabs(lo), std::fabs(hi)) / ulp;
  }
  s_.certificate.ulps_sum += error;
  ++s_.certificate.ulps_count;
  if (error > s_.certificate.ulps_max) {
    s_.certificate.ulps_max = error;
    s_.certificate.ulps_max_line = claims_.line();
  }
}

}  // namespace voroproof::internal
