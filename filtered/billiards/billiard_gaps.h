// The gaps between the disks of a billiard, their images and the frame, as polynomials of time.
//
// On lines that two disks keep, the sign of their gap |c_j - c_i| - (r_i + r_j) is that of
// |c_j - c_i|^2 - (r_i + r_j)^2, which is a polynomial of degree 2, as gravity moves both alike, or
// of degree 4 where one of them is fixed. So is the sign of the gap in a round frame,
// (R - r)^2 - |c - O|^2, while R >= r. The gap to a wall is a polynomial itself, of degree 2.
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "exact/ball.h"
#include "exact/billiard.h"
#include "exact/generators.h"
#include "filtered/numbers/double_ball.h"

namespace voroproof::internal {

// A disk or wall a and a disk b > a, or that image of b.
struct BilliardPair {
  GenId a, b;
  LatticeImage image{};
  auto operator<=>(const BilliardPair&) const = default;
};

// A disk's motion from the time t0 on: centre and velocity then.
template <class T>
struct Flight {
  T t0;
  Vector3<T> x, v;
};

inline constexpr int max_gap_degree = 4;
template <class T>
using GapForm = std::array<T, max_gap_degree + 1>;  // coefficients from the constant term up

// T is Rational, or DoubleBall or Ball: then enclosures of all values.
template <class T>
class BilliardGaps {
 public:
  // `bits`: the precision, where T has one.
  explicit BilliardGaps(const Billiard& billiard, int bits = 0);

  // The least degree that all forms of the pair have, whatever their lines.
  int degree(const BilliardPair& pair) const;

  // The form whose sign at u is that of gap + depth at the time since + u, on the given lines,
  // where reach() >= depth up to then. For a wall `a` is ignored. |depth| is at most that reach.
  GapForm<T> form(const BilliardPair& pair, const Flight<T>& a, const Flight<T>& b, const T& since,
                  const T& depth) const;

  // The sum of two radii, or in a round frame R - r, at that time. Not for walls.
  T reach(const BilliardPair& pair, const T& t) const;

  const Vector3<T>& gravity() const { return gravity_; }
  // How far a disk falls from rest in the time t.
  Vector3<T> fall(const T& t) const;

  // The radius at a time.
  T radius(GenId i, const T& t) const { return disk(i).radius + disk(i).growth * t; }

  // Centre and velocity at a time.
  Vector3<T> place(GenId disk, const Flight<T>& flight, const T& t) const;
  Vector3<T> velocity(GenId disk, const Flight<T>& flight, const T& t) const;

  // Where the image is from its disk, and how fast it moves beside it.
  Vector3<T> offset(const LatticeImage& image, const T& t) const;
  Vector3<T> drift(const LatticeImage& image) const;

  // The factors by which the velocities change along the normal: v_a += factor_a n,
  // v_b += factor_b n, and the normal (docs/formats.md, section 21). For walls factor_a is unused.
  struct Response {
    T factor_a, factor_b;
    Vector3<T> normal;
    T normal2;  // its squared length; the law has no answer where it is zero
  };
  // From centres and velocities at t just before the collision, those of the disks themselves.
  Response response(const BilliardPair& pair, const std::array<Vector3<T>, 2>& p,
                    const std::array<Vector3<T>, 2>& v, const T& t) const;

 private:
  struct Disk {
    T radius, growth, mass;
    bool fixed;
  };
  struct Wall {
    Vector3<T> normal;
    T offset, speed, restitution;
  };
  const Disk& disk(GenId i) const { return disks_[static_cast<std::size_t>(i)]; }
  const Wall& wall(GenId a) const { return walls_[static_cast<std::size_t>(-1 - a)]; }

  bool falls_;  // whether there is gravity
  bool round_;
  Vector3<T> gravity_, center_, sides_;
  T radius_, round_restitution_, restitution_, shear_;
  std::vector<Disk> disks_;
  std::vector<Wall> walls_;
};

// Whether the form is certainly positive on all of [lo, hi]. False says nothing.
bool certainly_positive(const GapForm<DoubleBall>& form, int degree, double lo, double hi);

// The form's derivative, as one of the same kind.
GapForm<DoubleBall> derivative(const GapForm<DoubleBall>& form);

DoubleBall value_at(const GapForm<DoubleBall>& form, double u);

}  // namespace voroproof::internal
