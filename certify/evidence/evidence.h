// The witness of a refutation, checked by code that is not this project's: CGAL's polynomials, its
// univariate algebraic kernel, its circles over exact numbers with square roots, and the predicate
// of its Apollonius graph. docs/certificate.md, section 9.
#pragma once

#include <string>

#include "certify/certificate.h"

namespace voroproof::internal {

enum class Evidence {
  confirmed,      // the witness shows what the refutation says of it
  not_checkable,  // motion given by decimal bounds: after collisions, where it is irrational
  none,           // the refutation rests on the file and the scene, and names motions at most
  contradicted    // the witness is false: an error in the certifier or in CGAL
};

struct EvidenceCheck {
  Evidence evidence = Evidence::none;
  std::string sentence;  // for the report: how it was confirmed, or why not
};

// Checks the numbers that a report prints, and nothing else: the polynomial is built anew from the
// motions, by formulas that the certifier does not use; it has one root in the isolating interval,
// and next to that root, at rational times, the edge is legal before and illegal after, or the two
// generators come nearer. Or: at the time given the two overlap, or the circle of the vertex
// contains a point of the generator named. That the generators move so, and that the edge is in the
// diagram, is not looked at.
EvidenceCheck check_evidence(const Divergence& divergence);

}  // namespace voroproof::internal
