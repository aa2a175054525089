// The law of collision (docs/formats.md, section 6) as a test of claimed velocities.
#pragma once

#include <array>
#include <string>

#include "certify/vectors.h"
#include "history/scene.h"

namespace voroproof {

// Of the two of a collision, i < j, at [0] and [1]. What [0] holds for the container is unused.
using ExactPair = std::array<ExactVec2, 2>;

class CollisionLaw {
 public:
  // `tolerance`: of velocities, relative to the speeds that meet.
  CollisionLaw(const Scene& scene, const Rational& tolerance)
      : scene_(scene), tolerance_(tolerance) {}

  // The distance of the centres of i and j at their contact.
  Rational reach(GenId i, GenId j) const;

  // The velocities after a collision of i and j with centres p and velocities v before it. Throws
  // Undecided where they have no normal, or no mass.
  ExactPair after(GenId i, GenId j, const ExactPair& p, const ExactPair& v) const;

  // Whether the velocities claimed are, within the tolerance, those after a collision with centres
  // p and velocities v before it. The centres are written as binary64, so that the normal is known
  // no better than that. Throws Undecided where the two have no mass.
  bool obeyed(const CollideEvent& claim, const ExactPair& p, const ExactPair& v) const;

  // What obeyed() would have accepted, in words.
  std::string expectation(GenId i, GenId j, const ExactPair& p, const ExactPair& v) const;

 private:
  ExactVec2 normal(GenId i, const ExactPair& p) const;
  template <class T, class Of>
  std::array<std::array<T, 2>, 2> evaluate(GenId i, GenId j,
                                           const std::array<std::array<T, 2>, 2>& p,
                                           const ExactPair& v, Of&& of) const;
  bool certainly_obeyed(const CollideEvent& claim, const ExactPair& p, const ExactPair& v) const;

  const Scene& scene_;
  const Rational& tolerance_;
};

}  // namespace voroproof
