// The velocities and centres that are claimed of the disks of a billiard, against the true ones.
#pragma once

#include <string>

#include "certify/billiards/billiard_motion.h"
#include "exact/billiard_events.h"

namespace voroproof::internal {

class TrueResponse {
 public:
  // Both must outlive it. Tolerances as CertifyOptions has them.
  TrueResponse(const Billiard& billiard, const BilliardMotion& motion, const Rational& tolerance,
               const Rational& law_tolerance)
      : billiard_(billiard),
        motion_(motion),
        tolerance_(tolerance),
        law_tolerance_(law_tolerance) {}

  // Why the claim's velocities are not those just after the contact at t, within the tolerances, or
  // its centres not the true ones; empty where they are. Throws TooCoarse.
  std::string fault(const BilliardPair& pair, const TrueTime& t,
                    const BilliardCollision& claim) const;
  // The same of the centre at a maneuver.
  std::string fault(const BilliardManeuver& due, const BilliardTurn& claim) const;

 private:
  std::string fault_of_velocity(GenId disk, const Vec3& claimed, const Vector3<Ball>& truth,
                                const Rational& allowed) const;
  std::string fault_of_place(GenId disk, const Vec3& claimed, const Vector3<Ball>& truth,
                             const Rational& speeds) const;
  Rational speeds_of(const BilliardPair& pair, const BilliardMotion::Bounce<Ball>& bounce) const;
  Rational allowed(const BilliardPair& pair, const TrueTime& t, const Rational& speeds) const;

  const Billiard& billiard_;
  const BilliardMotion& motion_;
  Rational tolerance_, law_tolerance_;
};

}  // namespace voroproof::internal
