// Edges at rest of which both circles are one: which of them are there is a matter of a rule.
#pragma once

#include "filtered/motion/motion.h"
#include "filtered/search/framed.h"

namespace voroproof::internal {

// At rest, generators that touch one circle do so for ever. Then the one of largest id is thought
// of as infinitely little larger than it is.
class RestingTies {
 public:
  // The disks of `motion`, which must outlive this object, as they are at t = 0.
  RestingTies(const Motion& motion, Frame frame) : motion_(motion), framed_(frame, motion.size()) {}

  // Whether both circles of the edge, which touch three of its generators each, are one.
  bool is_point(const Quad& q) const;
  // Whether they are and the rule wants another edge in the place of this one.
  bool is_illegal(const Quad& q) const { return !legal_while_cotangent(q) && is_point(q); }

 private:
  bool certainly_apart(const Quad& q) const;
  Site<Rational> exact(GenId g) const;
  GeneratorRow<Rational> row_of(GenId base, GenId g) const;

  const Motion& motion_;
  Framed framed_;
};

}  // namespace voroproof::internal
