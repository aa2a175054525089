#include "certify/contact_proof.h"

namespace voroproof {

bool proved_apart(const Motion& motion, GenId i, GenId j, double a, double b) {
  if (motion.same_velocity(i, j)) return true;  // their distance never changes
  const DoubleBall start(a), end(b);
  if (i == container_id || j == container_id) {
    // |d + w s|^2 - reach^2 is convex in s: negative at both ends, so between.
    const Contact<DoubleBall> k(motion.moving_site(i, end), motion.moving_site(j, end));
    return sign(k.c) == Sign::negative;
  }
  const Contact<DoubleBall> k(motion.moving_site(i, start), motion.moving_site(j, start));
  // Apart and parting; or apart at a, and never within reach; or not yet.
  if (sign(k.c) != Sign::positive) return false;
  const Sign b_sign = sign(k.b);
  if (b_sign == Sign::positive || b_sign == Sign::zero) return true;
  const DoubleBall discriminant = k.b * k.b - k.a * k.c;
  if (sign(discriminant) == Sign::negative) return true;
  const DoubleBall delay = k.c / (sqrt(discriminant) - k.b);
  return sign(delay - (end - start)) == Sign::positive;
}

}  // namespace voroproof
