// The law of collision (docs/formats.md, section 6) as a test of claimed velocities.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "certify/vectors.h"
#include "exact/prefetch.h"
#include "history/scene.h"

namespace voroproof::internal {

class CollisionLaw {
 public:
  // `tolerance`: of velocities, relative to the speeds that meet.
  CollisionLaw(const Scene& scene, const Rational& tolerance);

  // The distance of the centres of i and j at their contact.
  Rational reach(GenId i, GenId j) const;

  // The velocities after a collision of i and j with centres p and velocities v before it. Throws
  // Undecided where they have no normal, or no mass.
  ExactPair after(GenId i, GenId j, const ExactPair& p, const ExactPair& v) const;

  // Whether the velocities claimed are, within the tolerance, those after a collision with centres
  // p and velocities v before it. The centres are written as binary64, or those of paths at a time
  // that is (`t`, else 0), so that the normal is known no better than that, or not at all: then the
  // velocities are those of some normal. Throws Undecided where the two have no mass.
  bool obeyed(const CollideEvent& claim, const ExactPair& p, const ExactPair& v,
              const Rational& t) const;

  // Whether obeyed() certainly holds, by doubles, from enclosures: false says nothing.
  bool certainly_obeyed(const CollideEvent& claim, const BallPair& p, const BallPair& v);

  // Asks for the memory of what it looks at of a disk.
  [[gnu::always_inline]] void prefetch(GenId g) const {
    if (!near_masses_.empty()) internal::prefetch(&near_masses_[g]);
  }

  // Says in words what obeyed() would have accepted in place of the claim.
  std::string expectation(const CollideEvent& claim, const ExactPair& p, const ExactPair& v) const;

 private:
  bool obeyed_in_some_direction(const CollideEvent& claim, const ExactPair& before,
                                const Rational& speed) const;
  ExactVec2 normal(GenId i, const ExactPair& p) const;

  // The constants of the law for two that collide, in rationals or in enclosures.
  template <class T>
  struct Constants {
    T x, y, restitution, container_restitution;
    T mass_i, mass_j;  // masses, for disks
  };
  template <class T>
  std::array<std::array<T, 2>, 2> evaluate(GenId i, const std::array<std::array<T, 2>, 2>& p,
                                           std::array<std::array<T, 2>, 2> v,
                                           const Constants<T>& of) const;

  const Scene& scene_;
  const Rational& tolerance_;
  Constants<DoubleBall> near_;
  DoubleBall near_tolerance_;
  std::vector<DoubleBall> near_masses_;  // once asked for
};

}  // namespace voroproof::internal
