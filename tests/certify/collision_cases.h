// Contacts of every kind and claims of what comes after them, for tests of the law of collision.
#pragma once

#include <rapidcheck.h>

#include <memory>
#include <optional>

#include "certify/collision_law.h"
#include "tests/exact/fraction.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

inline ExactVec2 plus(const ExactVec2& a, const ExactVec2& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline ExactVec2 times(const Rational& k, const ExactVec2& a) { return {k * a[0], k * a[1]}; }

// Velocities after a collision as a line gives them that writes exact strings.
inline CollideEvent claim_of(GenId i, GenId j, const std::optional<ExactVec2>& vi,
                             const std::optional<ExactVec2>& vj) {
  const auto near = [](const ExactVec2& v) {
    return Vec2{round_nearest(v[0]), round_nearest(v[1])};
  };
  auto exact = std::make_shared<ExactValues>();
  exact->v = {vi, vj};
  CollideEvent claim{.i = i, .j = j};
  if (vi) claim.v[0] = near(*vi);
  if (vj) claim.v[1] = near(*vj);
  claim.exact = exact;
  return claim;
}

inline CollideEvent claim_of(GenId i, GenId j, const ExactPair& v) {
  return claim_of(i, j, i == container_id ? std::nullopt : std::optional(v[0]), v[1]);
}

// The same as a line gives them that writes JSON numbers.
inline CollideEvent plain_claim(GenId i, GenId j, const Vec2& vi, const Vec2& vj) {
  CollideEvent claim{.i = i, .j = j};
  if (i != container_id) claim.v[0] = vi;
  claim.v[1] = vj;
  return claim;
}

inline const Rational kTolerance(1, 1000000000);

// Two disks, of these radii and masses, in a container of radius 10 around (1, 2).
inline Scene two(const Rational& r0, const Rational& m0, const Rational& r1, const Rational& m1) {
  Scene scene = scene_of(10, 1, {disk(0, 0, r0, 0, 0, m0), disk(0, 0, r1, 0, 0, m1)});
  scene.cx = 1;
  scene.cy = 2;
  return scene;
}

inline rc::Gen<Rational> small() {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-8, 9)),
                      [](int k) { return fraction(k, 2); });
}
inline ExactVec2 any_vector() { return {*small(), *small()}; }

// Radii and masses of 0, equal ones, centres that coincide, no velocity: all are common.
struct Contact {
  Scene scene;
  GenId i;
  ExactPair p, v;

  bool at_container() const { return i == container_id; }
  ExactVec2 normal() const {
    return minus(p[1], at_container() ? ExactVec2{scene.cx, scene.cy} : p[0]);
  }
  bool has_mass() const {
    return at_container() || Rational(scene.disks[0].mass + scene.disks[1].mass) > 0;
  }
  bool has_normal() const { return norm2(normal()) != 0; }
};

inline Contact any_contact() {
  const auto size = [] {
    return *rc::gen::element(Rational(0), Rational(1, 2), Rational(1), Rational(3));
  };
  Contact c{two(size(), size(), size(), size()), *rc::gen::element(container_id, 0), {}, {}};
  c.scene.restitution =
      *rc::gen::element(Rational(0), Rational(1, 4), Rational(1, 3), Rational(1), Rational(1));
  c.scene.container_restitution = *rc::gen::element(Rational(1, 10), Rational(7, 8), Rational(1));
  c.scene.law = *rc::gen::element(ContainerLaw::normal, ContainerLaw::whole);
  c.p = {any_vector(), any_vector()};
  c.v = {any_vector(), any_vector()};
  // Far from the origin the centres' roundings matter.
  const Rational far =
      *rc::gen::element(Rational(0), Rational(1 << 24), Rational("1125899906842624"));
  for (ExactVec2& at : c.p) at[0] += far;
  c.scene.cx += far;
  return c;
}

}  // namespace voroproof::internal::testing
