#include "certify/billiards/true_response.h"

#include <algorithm>
#include <cmath>

#include "certify/billiards/billiard_path.h"
#include "certify/vectors.h"
#include "certify/wording.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

// An upper bound, good to a part in 10^12 where doubles hold the vector.
Rational length(const Vector3<Ball>& v) {
  double sum = 0;
  for (const DoubleBall& x : enclosed(v)) sum = std::hypot(sum, std::fabs(x.mid) + x.rad);
  if (std::isfinite(sum)) return to_rational(sum * (1 + 0x1p-45));
  Rational all;
  for (const Ball& x : v) {
    const auto [lo, hi] = x.rational_interval();
    all += std::max<Rational>(abs(lo), abs(hi));
  }
  return all;
}

std::string text(const Vector3<Ball>& v, int dimension) {
  std::string text = "(";
  for (int k = 0; k < dimension; ++k)
    text += (k ? ", " : "") + number_text(v[static_cast<std::size_t>(k)].midpoint_as_double());
  return text + ")";
}

Vector3<Ball> off_by(const Vec3& claimed, const Vector3<Ball>& truth) {
  return of_kind<Ball>(claimed, static_cast<int>(truth[0].precision())) - truth;
}

bool is_within(const Vector3<Ball>& off, const Rational& allowed) {
  const Rational square = allowed * allowed;
  const Sign beyond = sign(dot(off, off) - Ball(square, off[0].precision()));
  if (beyond == Sign::unknown)
    throw TooCoarse("whether a claimed velocity or centre is within the tolerance is not told");
  return beyond != Sign::positive;
}

}  // namespace

// The speeds with which two meet, growth and walls included.
Rational TrueResponse::speeds_of(const BilliardPair& pair,
                                 const BilliardMotion::Bounce<Ball>& bounce) const {
  const auto disk = [&](GenId i) -> const BilliardDisk& {
    return billiard_.disks[static_cast<std::size_t>(i)];
  };
  Rational speeds = length(bounce.before[1]) + abs(disk(pair.b).growth);
  if (pair.a >= 0) {
    const Vec3 drift = motion_.exact().drift(pair.image);
    speeds += abs(drift[0]) + length(bounce.before[0]) + abs(disk(pair.a).growth);
  } else if (!billiard_.round) {
    speeds += abs(billiard_.walls[static_cast<std::size_t>(-1 - pair.a)].speed);
  }
  return speeds;
}

// A contact that is off by the tolerance in time turns its normal by what the two cover meanwhile,
// over their reach, and the velocities by twice that; where the reach is too short for that to say
// much, by no more than a part in 1024. Under gravity velocities change meanwhile.
Rational TrueResponse::allowed(const BilliardPair& pair, const TrueTime& t,
                               const Rational& speeds) const {
  Rational turned;
  if (pair.a >= 0 || billiard_.round) {
    turned = speeds / 1024;
    const DoubleBall reach = motion_.near().reach(pair, t.near);
    if (reach.mid > reach.rad)
      turned = std::min<Rational>(
          turned, 4 * tolerance_ * speeds * speeds / to_rational(reach.mid - reach.rad));
  }
  const Rational fall = 4 * tolerance_ * root_bound(dot(billiard_.gravity, billiard_.gravity));
  return law_tolerance_ * speeds + turned + fall;
}

std::string TrueResponse::fault_of_velocity(GenId disk, const Vec3& claimed,
                                            const Vector3<Ball>& truth,
                                            const Rational& allowed) const {
  const Vector3<Ball> off = off_by(claimed, truth);
  // Two roundings besides.
  if (is_within(off, allowed + (length(truth) >> 51))) return {};
  return "the velocity of " + std::to_string(disk) + " just after is " +
         text(truth, billiard_.dimension) + ", and the claimed one is off by " +
         rounded_text(length(off)) + ", where " + rounded_text(allowed) +
         " is allowed (--tolerance, --law-tolerance)";
}

std::string TrueResponse::fault_of_place(GenId disk, const Vec3& claimed,
                                         const Vector3<Ball>& truth, const Rational& speeds) const {
  Rational units = 0;
  for (const Rational& x : claimed) units = std::max<Rational>(units, abs(x));
  const Vector3<Ball> off = off_by(claimed, truth);
  if (is_within(off, tolerance_ * speeds + (units >> 50))) return {};
  return "the centre of " + std::to_string(disk) + " is then " + text(truth, billiard_.dimension) +
         ", and the claimed one is off by " + rounded_text(length(off));
}

std::string TrueResponse::fault(const BilliardPair& pair, const TrueTime& t,
                                const BilliardCollision& claim) const {
  const BilliardMotion::Bounce<Ball> bounce = motion_.bounce(pair, t);
  const Rational most = allowed(pair, t, speeds_of(pair, bounce));
  for (const int side : {0, 1}) {
    const GenId disk = side == 0 ? pair.a : pair.b;
    std::string fault;
    if (claim.v[side])
      fault = fault_of_velocity(disk, value_of(*claim.v[side]), bounce.after[side], most);
    if (fault.empty() && claim.p[side])
      fault = fault_of_place(disk, value_of(*claim.p[side]), bounce.p[side],
                             length(bounce.before[side]) + length(bounce.after[side]));
    if (!fault.empty()) return fault;
  }
  return {};
}

std::string TrueResponse::fault(const BilliardManeuver& due, const BilliardTurn& claim) const {
  if (!claim.p) return {};
  const TrueTime t = motion_.time(due.t);
  return fault_of_place(
      claim.disk, value_of(*claim.p), motion_.place(claim.disk, t),
      length(motion_.velocity(claim.disk, t)) + root_bound(dot(due.velocity, due.velocity)));
}

}  // namespace voroproof::internal
