// The law of collision of billiards (docs/formats.md, section 21) as a test of claimed velocities
// and centres.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "certify/billiards/billiard_path.h"
#include "history/billiard_history.h"

namespace voroproof::internal {

class BounceLaw {
 public:
  // Tolerances as CertifyOptions has them. All must outlive it.
  BounceLaw(const Billiard& billiard, const BilliardGaps<Rational>& exact,
            const BilliardGaps<DoubleBall>& near, const Rational& tolerance,
            const Rational& law_tolerance, const Rational& extent, bool filters);

  // Two that collide at t, at the ends of their paths so far; for a wall `a` is unused.
  struct Meeting {
    BilliardPair pair;
    const BilliardPath &a, &b;
    const BilliardTime& t;
  };

  // The velocities just after, unrounded. Throws Undecided where there is no normal.
  std::array<Vec3, 2> after(const Meeting& meeting) const;

  // Why the claim's velocities are not those of the law within the tolerance (and the rounding of
  // centres), or its centres not those of the paths; empty where they are. Throws Undecided where
  // the roundings hide the normal.
  std::string fault(const Meeting& meeting, const BilliardCollision& claim) const;

  // Why the centre claimed at a maneuver is not that of the path; empty where it is.
  std::string fault_of_place(GenId disk, const BilliardPath& path, const BilliardTime& t,
                             const Vec3& place, const Vec3& velocity_after) const;

 private:
  bool certainly_obeyed(const Meeting& meeting, const BilliardCollision& claim) const;
  std::string law_fault(const Meeting& meeting, const BilliardCollision& claim) const;

  const Billiard& billiard_;
  const BilliardGaps<Rational>& exact_;
  const BilliardGaps<DoubleBall>& near_;
  const Rational &tolerance_, &law_tolerance_, &extent_;
  DoubleBall near_tolerance_, near_law_tolerance_;
  bool filters_;
};

}  // namespace voroproof::internal
