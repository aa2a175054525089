#include "certify/collision_law.h"

#include <algorithm>

#include "certify/standing.h"
#include "filtered/motion/motion.h"
#include "history/json_text.h"

namespace voroproof::internal {

Rational CollisionLaw::reach(GenId i, GenId j) const {
  const Rational radius = scene_.disks[j].radius;
  return i == container_id ? Rational(scene_.container_radius - radius)
                           : Rational(scene_.disks[i].radius.value() + radius);
}

ExactVec2 CollisionLaw::normal(GenId i, const ExactPair& p) const {
  return i == container_id ? minus(p[1], ExactVec2{scene_.cx, scene_.cy}) : minus(p[1], p[0]);
}

template <class T>
std::array<std::array<T, 2>, 2> CollisionLaw::evaluate(GenId i,
                                                       const std::array<std::array<T, 2>, 2>& p,
                                                       std::array<std::array<T, 2>, 2> v,
                                                       const Constants<T>& of) const {
  using Vec = std::array<T, 2>;
  if (i == container_id) {
    const Vec n = minus(p[1], Vec{of.x, of.y});
    const T q = T(v[1][0] * n[0] + v[1][1] * n[1]) / norm2(n);
    const T& e = of.container_restitution;
    for (int k = 0; k < 2; ++k) {
      v[1][k] = scene_.law == ContainerLaw::whole ? T(e * (v[1][k] - T(2) * q * n[k]))
                                                  : T(v[1][k] - (T(1) + e) * q * n[k]);
    }
    return v;
  }
  const Vec n = minus(p[1], p[0]), w = minus(v[1], v[0]);
  const T q = (T(1) + of.restitution) * T(w[0] * n[0] + w[1] * n[1]) /
              T(norm2(n) * T(of.mass_i + of.mass_j));
  for (int k = 0; k < 2; ++k) {
    v[0][k] = v[0][k] + of.mass_j * q * n[k];
    v[1][k] = v[1][k] - of.mass_i * q * n[k];
  }
  return v;
}

CollisionLaw::CollisionLaw(const Scene& scene, const Rational& tolerance)
    : scene_(scene),
      tolerance_(tolerance),
      near_{ball(scene.cx),
            ball(scene.cy),
            ball(scene.restitution),
            ball(scene.container_restitution),
            {},
            {}},
      near_tolerance_(ball(tolerance)) {}

ExactPair CollisionLaw::after(GenId i, GenId j, const ExactPair& p, const ExactPair& v) const {
  if (norm2(normal(i, p)) == 0) {
    throw Undecided("the centres of two that touch coincide: there is no normal", i, j);
  }
  Constants<Rational> of{scene_.cx,
                         scene_.cy,
                         scene_.restitution,
                         scene_.container_restitution,
                         0,
                         scene_.disks[j].mass.value()};
  if (i != container_id) {
    of.mass_i = scene_.disks[i].mass;
    if (of.mass_i + of.mass_j == 0) throw Undecided("two points without mass touch", i, j);
  }
  return evaluate<Rational>(i, p, v, of);
}

bool CollisionLaw::certainly_obeyed(const CollideEvent& claim, const BallPair& p,
                                    const BallPair& before) {
  if (near_masses_.empty()) {
    for (const DiskInput& d : scene_.disks) near_masses_.push_back(ball(d.mass));
  }
  const GenId i = claim.i, j = claim.j;
  Constants<DoubleBall> of = near_;
  of.mass_j = near_masses_[j];
  DoubleBall speed = sqrt(norm2(before[1]));
  if (i != container_id) {
    of.mass_i = near_masses_[i];
    speed = speed + sqrt(norm2(before[0]));
  }
  const BallPair v = evaluate<DoubleBall>(i, p, before, of);
  const DoubleBall allowed = near_tolerance_ * speed;
  for (const int side : {0, 1}) {
    if (!claim.v[side]) continue;
    const BallVec2 claimed =
        claim.exact ? ball(*exact_velocity(claim, side)) : ball(*claim.v[side]);
    if (sign(norm2(minus(claimed, v[side])) - allowed * allowed) != Sign::negative) return false;
  }
  return true;
}

// A change d of velocity is -(k w.n) n for a unit vector n, w the velocity of approach and k by
// restitution and masses, just where |d|^2 = -k d.w: then |d| <= k |w|, and an error of d up to
// `error` makes for up to error (3 k |w| + error). Whatever changes it by no more than that is
// within 7 errors of some such d. Both disks have the same n where the momentum is kept.
bool CollisionLaw::obeyed_in_some_direction(const CollideEvent& claim, const ExactPair& before,
                                            const Rational& speed) const {
  const auto dot = [](const ExactVec2& a, const ExactVec2& b) {
    return Rational(a[0] * b[0] + a[1] * b[1]);
  };
  const auto is_reflection = [&](const ExactVec2& d, const ExactVec2& w, const Rational& k,
                                 const Rational& error) {
    return abs(Rational(norm2(d) + k * dot(d, w))) <= error * (3 * k * length_bound(w) + error);
  };
  const Rational error = tolerance_ * speed;
  const auto v1 = exact_velocity(claim, 1);
  if (claim.i == container_id) {
    if (!v1) return true;
    ExactVec2 after = *v1;
    const Rational& e = scene_.container_restitution;
    if (scene_.law == ContainerLaw::normal) {
      return is_reflection(minus(after, before[1]), before[1], 1 + e, error);
    }
    // Undoes the scaling: the vector before it must be a reflection, with the tolerance it had
    // then.
    for (Rational& x : after) x /= e;
    return is_reflection(minus(after, before[1]), before[1], 2, error / e);
  }
  const auto v0 = exact_velocity(claim, 0);
  const Rational m0 = scene_.disks[claim.i].mass, m1 = scene_.disks[claim.j].mass, m = m0 + m1;
  if (m == 0) throw Undecided("two points without mass touch", claim.i, claim.j);
  const ExactVec2 w = minus(before[1], before[0]), back = minus(before[0], before[1]);
  const Rational k = (1 + scene_.restitution) / m;
  if (v0 && !is_reflection(minus(*v0, before[0]), back, k * m1, error)) return false;
  if (v1 && !is_reflection(minus(*v1, before[1]), w, k * m0, error)) return false;
  if (!v0 || !v1) return true;
  const ExactVec2 d0 = minus(*v0, before[0]), d1 = minus(*v1, before[1]);
  return norm2(ExactVec2{m0 * d0[0] + m1 * d1[0], m0 * d0[1] + m1 * d1[1]}) <=
         square(2 * tolerance_ * m * speed);
}

bool CollisionLaw::obeyed(const CollideEvent& claim, const ExactPair& p, const ExactPair& before,
                          const Rational& t) const {
  const GenId i = claim.i, j = claim.j;
  Rational speed = length_bound(before[1]);
  if (i != container_id) speed += length_bound(before[0]);
  // The centres' roundings turn the normal, or hide it: then any will do.
  const Rational error = 16 * (length_bound(p[1]) + speed * t);
  const Rational distance = reach(i, j) * (Rational(1) << 53);
  const bool hidden = error >= distance;
  if (hidden || error > tolerance_ * distance) {
    if (!obeyed_in_some_direction(claim, before, speed)) return false;
    if (hidden) return true;
  }
  if (norm2(normal(i, p)) == 0) return false;
  const Rational rounding = error / distance;
  const ExactPair v = after(i, j, p, before);
  const Rational allowed2 = square((tolerance_ + rounding) * speed);
  for (const int side : {0, 1}) {
    if (side == 0 && i == container_id) continue;
    const auto claimed = exact_velocity(claim, side);
    if (claimed && norm2(minus(*claimed, v[side])) > allowed2) return false;
  }
  return true;
}

std::string CollisionLaw::expectation(const CollideEvent& claim, const ExactPair& p,
                                      const ExactPair& before) const {
  const GenId i = claim.i, j = claim.j;
  if (norm2(normal(i, p)) == 0) return "the centres coincide and give no normal";
  const ExactPair v = after(i, j, p, before);
  Rational off = 0;
  std::string words = "by the law of collision the velocities are ";
  for (const int side : {0, 1}) {
    if (side == 0 && i == container_id) continue;
    words += "(" + number_text(v[side][0].get_d()) + ", " + number_text(v[side][1].get_d()) + ")";
    if (side == 0) words += " and ";
    if (const auto claimed = exact_velocity(claim, side)) {
      off = std::max(off, length_bound(minus(*claimed, v[side])));
    }
  }
  Rational speed = length_bound(before[1]);
  if (i != container_id) speed += length_bound(before[0]);
  if (speed == 0) return words;
  return words + ", and the claimed ones are off by " + amount(Rational(off / speed).get_d()) +
         " of the speeds that meet, where " + amount(tolerance_.get_d()) +
         " and what roundings do are allowed (--law-tolerance)";
}

}  // namespace voroproof::internal
