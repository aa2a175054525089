#include "certify/refuter.h"

#include "certify/edge_proof.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

namespace {

// An event at the time of a claim is on neither side of it, by either end.
double middle(double lo, double hi) { return lo + 0.5 * (hi - lo); }

}  // namespace

Divergence Refuter::at_claim(Fault fault, std::string truth) const {
  Divergence d;
  d.fault = fault;
  d.line = claims_.line();
  d.t = claims_.current() ? time(*claims_.current()) : front_.moment.lo;
  d.claim = claims_.current();
  d.truth = std::move(truth);
  return d;
}

void Refuter::refute(Fault fault, const std::string& truth, Witness witness) const {
  Divergence d = at_claim(fault, truth);
  d.witness = std::move(witness);
  throw Refuted{std::move(d)};
}

Divergence Refuter::missing_flip(const Quad& q, const Collapse& root) const {
  const Moment m = Moment::of(q, root);
  const auto [before, after] = s_.chronology.enclosure(m);
  if (proved_no_flip(s_.motion, q, to_rational(before), to_rational(after))) {
    throw Undecided("an edge does not flip where it should, since generators overlapped", q);
  }
  Divergence d = missing_flip(q, m);
  const auto [lo, hi] = root.root();
  d.witness = collapse_witness(s_.motion, q, lo, hi);
  return d;
}

Divergence Refuter::missing_flip(const Quad& q, const Moment& m) const {
  Divergence d;
  d.fault = Fault::missing_event;
  const auto [lo, hi] = s_.chronology.enclosure(m);
  d.t = lo;
  d.line = claims_.line_at(middle(lo, hi));
  d.truth = "edge " + text_of(canonical(q)) + " flips " + between(lo, hi);
  d.true_flip = canonical(q);
  d.true_time = {lo, hi};
  d.witness = motion_witness(s_.motion, generators(q), to_rational(m.lo));
  return d;
}

Divergence Refuter::missing_contact(GenId i, GenId j, double lo, double hi) const {
  if (s_.law.reach(i, j) == 0) {
    throw Undecided("two points meet: a contact without a normal", i, j);
  }
  Divergence d;
  d.fault = s_.options.truth == Truth::recorded ? Fault::overlap : Fault::missing_event;
  d.t = lo;
  d.line = claims_.line_at(middle(lo, hi));
  d.truth = "generators " + text_of(i, j) + " touch and approach " + between(lo, hi);
  d.true_contact = {i, j};
  d.true_time = {lo, hi};
  d.witness = contact_witness(s_.motion, i, j, to_rational(lo), to_rational(hi));
  return d;
}

Divergence Refuter::missing_contact(GenId i, GenId j,
                                    const RecordedContacts::Missing& missing) const {
  Divergence d = missing_contact(i, j, missing.lo, missing.hi);
  d.witness = contact_witness(missing.motions, i, j, missing.lo, missing.hi);
  return d;
}

Divergence Refuter::missing_maneuver(std::size_t k) const {
  const Maneuver& m = s_.scene.maneuvers[k];
  Divergence d;
  d.fault = Fault::missing_event;
  d.line = claims_.line();
  d.t = round_nearest(m.t);
  d.truth =
      "disk " + std::to_string(m.disk) + " is scheduled for a maneuver at t = " + m.t.get_str();
  return d;
}

}  // namespace voroproof::internal
