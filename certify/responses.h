// Claimed centres and velocities of a turn, against the true ones or the path.
#pragma once

#include <optional>
#include <string>

#include "certify/refuter.h"
#include "certify/setting.h"

namespace voroproof::internal {

// "0.5 off, where 1e-9 is allowed": what is claimed, of what is due.
std::string off(const ExactVec2& claimed, const ExactVec2& due, const Rational& allowed);

// All judgements throw Refuted.
class Responses {
 public:
  Responses(Setting& s, const Claims& claims, const Refuter& refuter)
      : s_(s), claims_(claims), refuter_(refuter) {}

  // A claimed centre, if any, against the true one, of a disk that has the velocity `after` just
  // after.
  void check_center(GenId g, const std::optional<ExactVec2>& p, const ExactVec2& after,
                    const ExactVec2& true_p);
  // Whether a claimed centre is where the disk is, but for less than what check_center() allows: in
  // doubles, false says nothing.
  bool certainly_near(const CollideEvent& claim, int side, const BallVec2& at) const;
  static BallVec2 claimed_center(const CollideEvent& claim, int side);
  // The claimed velocities do not obey the law at the centres p.
  [[noreturn]] void refute(const CollideEvent& claim, const ExactPair& p);
  // The report says once that velocities were computed, from claimed centres or from the path.
  void remark_velocities(bool centers);

 private:
  Rational allowed_distance(GenId g, const ExactVec2& after, const ExactVec2& at) const;

  Setting& s_;
  const Claims& claims_;
  const Refuter& refuter_;
  bool remarked_centers_ = false, remarked_paths_ = false;
};

}  // namespace voroproof::internal
