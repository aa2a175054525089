// The motion of four generators side by side, and intervals of four numbers: several generators,
// edges or pairs in one evaluation.
#pragma once

#include <type_traits>

#include "exact/predicates.h"
#include "filtered/motion/motion.h"
#include "filtered/numbers/double_ball.h"
#include "filtered/numbers/lanes.h"

namespace voroproof::internal {

using LaneMask [[gnu::vector_size(32)]] = long long;

inline Lanes splat(double x) { return Lanes{x, x, x, x}; }
inline bool any(const LaneMask& m) { return (m[0] | m[1] | m[2] | m[3]) != 0; }

// A DoubleBall on each lane.
struct BallLanes {
  Lanes mid, rad;
};

inline BallLanes operator+(const BallLanes& a, const BallLanes& b) {
  using namespace double_ball_detail;
  const Lanes m = a.mid + b.mid;
  return {m, (a.rad + b.rad + abs(m) * u) * kUp};
}
inline BallLanes operator-(const BallLanes& a, const BallLanes& b) {
  using namespace double_ball_detail;
  const Lanes m = a.mid - b.mid;
  return {m, (a.rad + b.rad + abs(m) * u) * kUp};
}
inline BallLanes operator*(const BallLanes& a, const BallLanes& b) {
  using namespace double_ball_detail;
  const Lanes m = a.mid * b.mid;
  return {m, (abs(a.mid) * b.rad + a.rad * (abs(b.mid) + b.rad) + abs(m) * u + kTiny) * kUp};
}
inline Sign sign(const BallLanes& a, int lane) {
  return sign(DoubleBall(a.mid[lane], a.rad[lane]));
}

// Four of DoubleMotion.
struct MotionLanes {
  Lanes t, x, y, vx, vy, r, ex, ev;

  MotionLanes(const DoubleMotion& a, const DoubleMotion& b, const DoubleMotion& c,
              const DoubleMotion& d) {
    transpose(&a.t, &b.t, &c.t, &d.t, t, x, y, vx);
    transpose(&a.vy, &b.vy, &c.vy, &d.vy, vy, r, ex, ev);
  }
  // The same motion on all four lanes.
  explicit MotionLanes(const DoubleMotion& m)
      : t(splat(m.t)),
        x(splat(m.x)),
        y(splat(m.y)),
        vx(splat(m.vx)),
        vy(splat(m.vy)),
        r(splat(m.r)),
        ex(splat(m.ex)),
        ev(splat(m.ev)) {}

  // Motion::site, on each lane.
  Site<BallLanes> site(const BallLanes& time) const {
    const BallLanes dt = time - BallLanes{t, Lanes{}};
    return {BallLanes{x, ex} + BallLanes{vx, ev} * dt,
            BallLanes{y, ex} + BallLanes{vy, ev} * dt,
            {r, ex}};
  }

 private:
  // Takes four doubles that follow each other, of each of four motions, to the lanes: the first
  // double of each motion to `first`, and so on.
  static void transpose(const double* a, const double* b, const double* c, const double* d,
                        Lanes& first, Lanes& second, Lanes& third, Lanes& fourth) {
    const Lanes p = load(a), q = load(b), r = load(c), s = load(d);
    const Lanes ab0 = __builtin_shufflevector(p, q, 0, 4, 2, 6);
    const Lanes ab1 = __builtin_shufflevector(p, q, 1, 5, 3, 7);
    const Lanes cd0 = __builtin_shufflevector(r, s, 0, 4, 2, 6);
    const Lanes cd1 = __builtin_shufflevector(r, s, 1, 5, 3, 7);
    first = __builtin_shufflevector(ab0, cd0, 0, 1, 4, 5);
    second = __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5);
    third = __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7);
    fourth = __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7);
  }
  static_assert(std::is_standard_layout_v<DoubleMotion> && offsetof(DoubleMotion, x) == 8 &&
                offsetof(DoubleMotion, y) == 16 && offsetof(DoubleMotion, vx) == 24 &&
                offsetof(DoubleMotion, vy) == 32 && offsetof(DoubleMotion, r) == 40 &&
                offsetof(DoubleMotion, ex) == 48 && offsetof(DoubleMotion, ev) == 56);
};

}  // namespace voroproof::internal
