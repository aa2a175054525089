#include "certify/collision_law.h"

#include "filtered/motion.h"
#include "history/json_text.h"

namespace voroproof {

Rational CollisionLaw::reach(GenId i, GenId j) const {
  return i == container_id ? Rational(scene_.container_radius - scene_.disks[j].radius)
                           : Rational(scene_.disks[i].radius + scene_.disks[j].radius);
}

ExactVec2 CollisionLaw::normal(GenId i, const ExactPair& p) const {
  return i == container_id ? minus(p[1], ExactVec2{scene_.cx, scene_.cy}) : minus(p[1], p[0]);
}

// In rationals or in enclosures: `of` converts.
template <class T, class Of>
std::array<std::array<T, 2>, 2> CollisionLaw::evaluate(GenId i, GenId j,
                                                       const std::array<std::array<T, 2>, 2>& p,
                                                       const ExactPair& before, Of&& of) const {
  using Vec = std::array<T, 2>;
  const auto both = [&of](const ExactVec2& v) { return Vec{of(v[0]), of(v[1])}; };
  std::array<Vec, 2> v{Vec{T(0), T(0)}, both(before[1])};
  if (i == container_id) {
    const Vec n = minus(p[1], both({scene_.cx, scene_.cy}));
    const T q = T(v[1][0] * n[0] + v[1][1] * n[1]) / norm2(n);
    const T e = of(scene_.container_restitution);
    for (int k = 0; k < 2; ++k) {
      v[1][k] = scene_.law == ContainerLaw::whole ? T(e * (v[1][k] - T(2) * q * n[k]))
                                                  : T(v[1][k] - (T(1) + e) * q * n[k]);
    }
    return v;
  }
  v[0] = both(before[0]);
  const Vec n = minus(p[1], p[0]), w = minus(v[1], v[0]);
  const Rational& mi = scene_.disks[i].mass;
  const Rational& mj = scene_.disks[j].mass;
  if (mi + mj == 0) throw Undecided("two points without mass touch", i, j);
  const T a = of(mi), b = of(mj);
  const T q =
      (T(1) + of(scene_.restitution)) * T(w[0] * n[0] + w[1] * n[1]) / T(norm2(n) * T(a + b));
  for (int k = 0; k < 2; ++k) {
    v[0][k] = v[0][k] + b * q * n[k];
    v[1][k] = v[1][k] - a * q * n[k];
  }
  return v;
}

ExactPair CollisionLaw::after(GenId i, GenId j, const ExactPair& p, const ExactPair& v) const {
  if (norm2(normal(i, p)) == 0) {
    throw Undecided("the centres of two that touch coincide: there is no normal", i, j);
  }
  return evaluate<Rational>(i, j, p, v, [](const Rational& q) { return q; });
}

// In doubles; false says nothing.
bool CollisionLaw::certainly_obeyed(const CollideEvent& claim, const ExactPair& p,
                                    const ExactPair& before) const {
  const GenId i = claim.i, j = claim.j;
  const std::array<BallVec2, 2> at{ball(p[0]), ball(p[1])};
  const auto v = evaluate<DoubleBall>(i, j, at, before, [](const Rational& q) { return ball(q); });
  DoubleBall speed = sqrt(norm2(ball(before[1])));
  if (i != container_id) speed = speed + sqrt(norm2(ball(before[0])));
  const DoubleBall allowed = ball(tolerance_) * speed;
  for (const int side : {0, 1}) {
    if (side == 0 && i == container_id) continue;
    const auto claimed = exact_velocity(claim, side);
    if (claimed &&
        sign(norm2(minus(ball(*claimed), v[side])) - allowed * allowed) != Sign::negative) {
      return false;
    }
  }
  return true;
}

bool CollisionLaw::obeyed(const CollideEvent& claim, const ExactPair& p,
                          const ExactPair& before) const {
  if (certainly_obeyed(claim, p, before)) return true;
  const GenId i = claim.i, j = claim.j;
  if (norm2(normal(i, p)) == 0) return false;
  const ExactPair v = after(i, j, p, before);
  Rational speed = length_bound(before[1]);
  if (i != container_id) speed += length_bound(before[0]);
  const Rational rounding = 16 * length_bound(p[1]) / (reach(i, j) * (Rational(1) << 53));
  const Rational allowed2 = square((tolerance_ + rounding) * speed);
  for (const int side : {0, 1}) {
    if (side == 0 && i == container_id) continue;
    const auto claimed = exact_velocity(claim, side);
    if (claimed && norm2(minus(*claimed, v[side])) > allowed2) return false;
  }
  return true;
}

std::string CollisionLaw::expectation(GenId i, GenId j, const ExactPair& p,
                                      const ExactPair& before) const {
  if (norm2(normal(i, p)) == 0) return "the centres coincide and give no normal";
  const ExactPair v = after(i, j, p, before);
  std::string words = "by the law of collision the velocities are ";
  for (const int side : {0, 1}) {
    if (side == 0 && i == container_id) continue;
    words += "(" + number_text(v[side][0].get_d()) + ", " + number_text(v[side][1].get_d()) + ")";
    if (side == 0) words += " and ";
  }
  return words;
}

}  // namespace voroproof
