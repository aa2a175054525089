#include "certify/responses.h"

#include "certify/standing.h"
#include "certify/witness.h"
#include "certify/wording.h"

namespace voroproof::internal {

std::string off(const ExactVec2& claimed, const ExactVec2& due, const Rational& allowed) {
  return amount(length_bound(minus(claimed, due)).get_d()) + " off, where " +
         amount(allowed.get_d()) + " is allowed";
}

BallVec2 Responses::claimed_center(const CollideEvent& claim, int side) {
  return claim.exact ? ball(*exact_center(claim, side)) : ball(*claim.p[side]);
}

// The allowed distance of a claimed centre: the way of the disk within the tolerance, with its
// speeds just before and after, plus the rounding to binary64.
Rational Responses::allowed_distance(GenId g, const ExactVec2& after, const ExactVec2& at) const {
  const Rational speeds = length_bound(s_.replay.velocity(g).value()) + length_bound(after);
  return s_.options.tolerance * speeds + 4 * length_bound(at) / (Rational(1) << 53);
}

bool Responses::certainly_near(const CollideEvent& claim, int side, const BallVec2& at) const {
  const BallVec2 p = claimed_center(claim, side);
  const BallVec2 v = s_.replay.near_velocities(claim.i, claim.j)[side];
  return sign(norm2(minus(p, at)) - s_.near_tolerance * s_.near_tolerance * norm2(v)) ==
         Sign::negative;
}

void Responses::check_center(GenId g, const std::optional<ExactVec2>& p, const ExactVec2& after,
                             const ExactVec2& true_p) {
  if (!p) return;
  const Rational allowed = allowed_distance(g, after, true_p);
  if (norm2(minus(*p, true_p)) > square(allowed)) {
    refuter_.refute(Fault::wrong_response,
                    "the centre of disk " + std::to_string(g) + " is (" +
                        number_text(true_p[0].get_d()) + ", " + number_text(true_p[1].get_d()) +
                        "), and the claimed one is " + off(*p, true_p, allowed) + " (--tolerance)");
  }
}

void Responses::refute(const CollideEvent& claim, const ExactPair& p) {
  refuter_.refute(Fault::wrong_response,
                  s_.law.expectation(claim, p, s_.replay.velocities(claim.i, claim.j)),
                  motion_witness(s_.motion, {claim.i, claim.j}, exact_time(*claims_.current())));
}

void Responses::remark_velocities(bool centers) {
  if (centers ? remarked_centers_ : remarked_paths_) return;
  (centers ? remarked_centers_ : remarked_paths_) = true;
  s_.certificate.remarks.push_back(
      centers
          ? "collisions without velocities: computed by the law from the recorded centres"
          : "collisions without velocities and centres: computed by the law from the path; such "
            "a file soon leaves its producer's motion");
}

}  // namespace voroproof::internal
