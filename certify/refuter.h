// Refutations: what a divergence from the truth says, and where.
#pragma once

#include <string>

#include "certify/certificate.h"
#include "certify/claims.h"
#include "certify/front.h"
#include "certify/recorded_contacts.h"
#include "certify/setting.h"

namespace voroproof::internal {

// Thrown where the history is false.
struct Refuted {
  Divergence divergence;
};

class Refuter {
 public:
  Refuter(Setting& s, const Claims& claims, const Front& front)
      : s_(s), claims_(claims), front_(front) {}

  // The claim being checked is false; without one, the history is where it has come to.
  Divergence at_claim(Fault fault, std::string truth) const;
  [[noreturn]] void refute(Fault fault, const std::string& truth, Witness witness = {}) const;

  // An event that the history lacks. Throws Undecided where two points meet at a contact, and where
  // the root is provably no flip: then the diagram before it is not proved.
  Divergence missing_flip(const Quad& q, const Collapse& root) const;
  Divergence missing_flip(const Quad& q, const Moment& m) const;  // illegal just after m
  Divergence missing_contact(GenId i, GenId j, double lo, double hi) const;
  // Under the recorded truth, on the lines of then.
  Divergence missing_contact(GenId i, GenId j, const RecordedContacts::Missing& missing) const;
  // The k-th maneuver of the scene.
  Divergence missing_maneuver(std::size_t k) const;

 private:
  Setting& s_;
  const Claims& claims_;
  const Front& front_;
};

}  // namespace voroproof::internal
