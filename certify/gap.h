// The gap of two generators on lines, and when it changes its sign: all in rationals.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "exact/rational.h"

namespace voroproof::internal {

// A time: a rational, or a root of the gap. Compared exactly, with no root taken.
class GapTime {
 public:
  explicit GapTime(Rational t) : t_(std::move(t)) {}
  // t + (-b -+ sqrt(b^2 - a c)) / a, for a > 0 and b^2 > a c.
  GapTime(Rational t, const Contact<Rational>& k, bool upper)
      : t_(std::move(t)), root_(Root{k.a, k.b, Rational(k.b * k.b - k.a * k.c), upper}) {}

  // Negative, zero or positive: this time against the time `t`.
  int compare(const Rational& t) const;
  // An enclosure in doubles.
  std::pair<double, double> enclosure() const;

 private:
  struct Root {
    Rational a, b, discriminant;
    bool upper;
  };
  Rational t_;
  std::optional<Root> root_;
};

// Two generators on lines from the time `from` on. Their gap is positive where they are apart
// (two disks), or the disk inside the container; where it is negative they overlap.
class Gap {
 public:
  // `k`: their offset and relative velocity at `from`, |d + w s|^2 - reach^2. `reach` >= 0: r_i +
  // r_j, with the container R - r_j. `hidden_reach2`: the square of |r_i - r_j|, with the container
  // of R + r_j, at which the tangency of the two vanishes.
  Gap(Contact<Rational> k, bool wall, Rational from, Rational reach, Rational hidden_reach2);

  // An overlap of the time from `from` to `end`: the gap is negative just after `begin` and until
  // `end`.
  struct Overlap {
    GapTime begin, end;
    bool at_start;  // they overlap at `from` already, and just after it
    bool to_end;    // they overlap still at the end, or until just before it
    bool shallow;   // they overlap by no more than the depth asked for
    bool hidden;    // the tangency has the wrong sign, or vanishes, at some time of it
  };
  // The overlaps up to `end`, in order of time: none, one, or with the container two. `depth` >= 0.
  std::vector<Overlap> overlaps(const Rational& end, const Rational& depth) const;

  // When the gap goes from zero or more to less than zero, at `from` or later.
  std::optional<GapTime> entry() const;
  // Two disks that move relative to each other and never overlap: when they are nearest, if that is
  // at `from` or later, and whether they are no further apart than `distance` then.
  struct Graze {
    Rational t;
    bool near;
  };
  std::optional<Graze> graze(const Rational& distance) const;

  // Whether the gap changes its sign at a time of [lo, hi].
  bool changes_in(const Rational& lo, const Rational& hi) const;
  // A polynomial in time whose roots are those of the gap.
  Polynomial<Rational> polynomial() const;

  // A disk touches the container at `from` and moves along it, and out of it on its line.
  bool slides() const { return wall_ && sgn(k_.c) == 0 && sgn(k_.b) == 0 && sgn(k_.a) > 0; }
  bool overlap_at(const Rational& t) const { return sgn(value(t)) < 0; }
  // Whether they overlap by no more than the depth at `from`.
  bool shallow_at_start(const Rational& depth) const;
  // Whether the two come nearer at the time t: a disk to the container, outwards.
  bool approach_at(const Rational& t) const;
  // Whether the tangency of the two has the wrong sign at t, or vanishes.
  bool hidden_at(const Rational& t) const;
  // A time at which the tangency has the right sign: t itself or, where it is hidden at t, a
  // rational time less than `margin` after it has the right sign again. Nothing where it is still
  // hidden at t + `margin`.
  std::optional<Rational> revealed(const Rational& t, const Rational& margin) const;

 private:
  Rational value(const Rational& t) const;
  bool changes_sign() const;

  Contact<Rational> k_;
  bool wall_;
  Rational from_, reach_, hidden_reach2_;
};

}  // namespace voroproof::internal
