#include "certify/billiards/bounce_law.h"

#include <algorithm>
#include <cmath>

#include "certify/vectors.h"
#include "certify/wording.h"
#include "filtered/motion/options.h"
#include "history/json_text.h"

namespace voroproof::internal {
namespace {

Rational length(const Vec3& v) { return root_bound(dot(v, v)); }

std::string text(const Vec3& v, int dimension) {
  std::string text = "(";
  for (int k = 0; k < dimension; ++k) {
    text += (k ? ", " : "") + number_text(round_nearest(v[static_cast<std::size_t>(k)]));
  }
  return text + ")";
}

}  // namespace

BounceLaw::BounceLaw(const Billiard& billiard, const BilliardGaps<Rational>& exact,
                     const BilliardGaps<DoubleBall>& near, const Rational& tolerance,
                     const Rational& law_tolerance, const Rational& extent, bool filters)
    : billiard_(billiard),
      exact_(exact),
      near_(near),
      tolerance_(tolerance),
      law_tolerance_(law_tolerance),
      extent_(extent),
      near_tolerance_(enclosed(tolerance)),
      near_law_tolerance_(enclosed(law_tolerance)),
      filters_(filters) {}

namespace {

// Centres and velocities just before, of a wall none.
template <class T>
struct Before {
  std::array<Vector3<T>, 2> p, v;
};

template <class T, class Line>
Before<T> before(const BilliardGaps<T>& gaps, const BilliardPair& pair, const Line& a,
                 const Line& b, const T& t) {
  Before<T> state;
  if (pair.a >= 0) {
    state.p[0] = gaps.place(pair.a, a, t);
    state.v[0] = gaps.velocity(pair.a, a, t);
  }
  state.p[1] = gaps.place(pair.b, b, t);
  state.v[1] = gaps.velocity(pair.b, b, t);
  return state;
}

}  // namespace

std::array<Vec3, 2> BounceLaw::after(const Meeting& m) const {
  const Before<Rational> state =
      before(exact_, m.pair, m.a.exact_last(), m.b.exact_last(), m.t.value());
  const auto response = exact_.response(m.pair, state.p, state.v, m.t.value());
  if (response.normal2 == 0)
    throw Undecided("the centres of two that touch coincide: there is no normal", m.pair.a,
                    m.pair.b);
  return {state.v[0] + response.normal * response.factor_a,
          state.v[1] + response.normal * response.factor_b};
}

bool BounceLaw::certainly_obeyed(const Meeting& m, const BilliardCollision& claim) const {
  const Before<DoubleBall> state =
      before(near_, m.pair, m.a.back().near, m.b.back().near, m.t.near);
  const auto response = near_.response(m.pair, state.p, state.v, m.t.near);
  // The root of the sum of squares is at most the sum of the speeds, which is allowed.
  const Vector3<DoubleBall> seen =
      m.pair.a < 0 ? state.v[1] : state.v[1] + near_.drift(m.pair.image);
  DoubleBall speed2 = dot(seen, seen);
  if (m.pair.a >= 0) speed2 = speed2 + dot(state.v[0], state.v[0]);
  const DoubleBall allowed2 = near_law_tolerance_ * near_law_tolerance_ * speed2;
  for (const int side : {0, 1}) {
    if (!claim.v[side]) continue;
    const Vector3<DoubleBall> law =
        state.v[side] + response.normal * (side == 0 ? response.factor_a : response.factor_b);
    const Vector3<DoubleBall> off = enclosed(*claim.v[side]) - law;
    if (sign(dot(off, off) - allowed2) != Sign::negative) return false;
  }
  for (const int side : {0, 1}) {
    if (!claim.p[side]) continue;
    const Vector3<DoubleBall> off = enclosed(*claim.p[side]) - state.p[side];
    const DoubleBall allowed =
        near_tolerance_ * near_tolerance_ * dot(state.v[side], state.v[side]);
    if (sign(dot(off, off) - allowed) != Sign::negative) return false;
  }
  return true;
}

std::string BounceLaw::law_fault(const Meeting& m, const BilliardCollision& claim) const {
  const Before<Rational> state =
      before(exact_, m.pair, m.a.exact_last(), m.b.exact_last(), m.t.value());
  const std::array<Vec3, 2> law = after(m);
  const bool is_wall = m.pair.a < 0;
  Rational speed = length(is_wall ? state.v[1] : Vec3(state.v[1] + exact_.drift(m.pair.image)));
  speed += abs(billiard_.disks[static_cast<std::size_t>(m.pair.b)].growth);
  if (!is_wall) {
    speed += length(state.v[0]) + abs(billiard_.disks[static_cast<std::size_t>(m.pair.a)].growth);
  } else if (!billiard_.round) {
    speed += abs(billiard_.walls[static_cast<std::size_t>(-1 - m.pair.a)].speed);
  }
  Rational rounding = 0;
  if (!is_wall || billiard_.round) {
    const Rational distance = exact_.reach(m.pair, m.t.value()) * (Rational(1) << 53);
    const Rational error = 16 * (extent_ + speed * m.t.value());
    if (error >= distance)
      throw Undecided("the roundings of centres hide the normal of a collision", m.pair.a,
                      m.pair.b);
    rounding = error / distance;
  }
  // A time that is rounded changes velocities under gravity.
  const Rational fall = length(billiard_.gravity) * m.t.value() >> 51;
  const Rational allowed = (law_tolerance_ + rounding) * speed + fall;
  for (const int side : {0, 1}) {
    if (!claim.v[side]) continue;
    const Vec3 off = value_of(*claim.v[side]) - law[static_cast<std::size_t>(side)];
    if (dot(off, off) <= allowed * allowed) continue;
    const GenId disk = side == 0 ? m.pair.a : m.pair.b;
    return "by the law of collision the velocity of " + std::to_string(disk) + " is " +
           text(law[static_cast<std::size_t>(side)], billiard_.dimension) +
           ", and the claimed one is off by " +
           rounded_text(speed == 0 ? length(off) : Rational(length(off) / speed)) +
           " of the speeds that meet, where " + number_text(round_nearest(law_tolerance_)) +
           " is allowed (--law-tolerance)";
  }
  return {};
}

std::string BounceLaw::fault_of_place(GenId disk, const BilliardPath& path, const BilliardTime& t,
                                      const Vec3& place, const Vec3& velocity_after) const {
  const Flight<Rational> flight = path.exact_last();
  const Vec3 true_place = exact_.place(disk, flight, t.value());
  const Rational speeds = length(exact_.velocity(disk, flight, t.value())) + length(velocity_after);
  Rational units = 0;
  for (const Rational& x : place) units = std::max<Rational>(units, abs(x));
  const Rational allowed = tolerance_ * speeds + units / (Rational(1) << 50);
  const Vec3 off = place - true_place;
  if (dot(off, off) <= allowed * allowed) return {};
  return "the centre of " + std::to_string(disk) + " is then " +
         text(true_place, billiard_.dimension) + ", and the claimed one is off by " +
         rounded_text(length(off));
}

std::string BounceLaw::fault(const Meeting& m, const BilliardCollision& claim) const {
  if (filters_ && certainly_obeyed(m, claim)) return {};
  if (std::string fault = law_fault(m, claim); !fault.empty()) return fault;
  const std::array<Vec3, 2> law = after(m);
  for (const int side : {0, 1}) {
    if (!claim.p[side]) continue;
    std::string fault = fault_of_place(
        side == 0 ? m.pair.a : m.pair.b, side == 0 ? m.a : m.b, m.t, value_of(*claim.p[side]),
        claim.v[side] ? value_of(*claim.v[side]) : law[static_cast<std::size_t>(side)]);
    if (!fault.empty()) return fault;
  }
  return {};
}

}  // namespace voroproof::internal
