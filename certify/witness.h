// Evidence: what a person can check by hand.
#pragma once

#include "certify/certificate.h"
#include "certify/recorded_contacts.h"
#include "filtered/motion/motion.h"

namespace voroproof::internal {

// The collapse of q at the one root of its flip polynomial in [lo, hi], under the present motion.
Witness collapse_witness(const Motion& motion, const Quad& q, const Rational& lo,
                         const Rational& hi);

// The contact of i and j in [lo, hi], likewise; or, where their motion is rational and they do not
// come into contact then, a time of [lo, hi] at which they overlap.
Witness contact_witness(const Motion& motion, GenId i, GenId j, const Rational& lo,
                        const Rational& hi);

// The same for two on lines that they may have left since.
Witness contact_witness(const RecordedContacts::Motions& motions, GenId i, GenId j, double lo,
                        double hi);

// The generators of a claim alone, near time t.
Witness motion_witness(const Motion& motion, const std::vector<GenId>& generators,
                       const Rational& t);

// The witness that at time t the circle of the vertex contains a point of the generator.
Witness conflict_witness(const Motion& motion, const Triple& vertex, GenId conflict,
                         const Rational& t);

}  // namespace voroproof::internal
