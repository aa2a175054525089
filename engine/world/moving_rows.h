// The generators of a world as rows of polynomials in time, and the signs of such just after an
// instant.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "exact/algebraic.h"
#include "exact/generators.h"
#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "exact/world_motion.h"
#include "filtered/worlds/rough_rows.h"

namespace voroproof::internal {

// Polynomials in the time of the world, all of them rational: nothing turns by itself.
using TimePolynomial = Polynomial<Rational>;
using WorldTime = AlgebraicNumber<Rational>;

// The generators as they move on: the disks that are there and the frame, which is a circle or
// infinity, and always the generator -1.
class MovingRows {
 public:
  // `filters`: doubles decide where they can.
  MovingRows(const std::optional<WorldCircle>& circle, int disks, bool filters);

  int disks() const { return moving_ ? moving_->disks() : static_cast<int>(sites_.size()); }
  bool has_circle() const { return circle_.has_value(); }
  bool is_there(GenId g) const {
    return moving_ ? rested_.contains(g) || moving_->is_there(g) : sites_[g].has_value();
  }
  const Site<TimePolynomial>& site(GenId g) const;
  const Site<TimePolynomial>& circle() const { return *circle_; }  // its radius is positive

  // The same in doubles.
  const RoughRows& rough() const { return rough_; }

  // From now on the disk moves as one that is in that state at `since`.
  void set(GenId g, const Rational& since, const GrowingDisk& state);
  // Not where others rest.
  void take_out(GenId g) { sites_[g].reset(); }
  // All as they are at one time, and resting there but for those that are set. This outlives it,
  // and does not change meanwhile.
  MovingRows resting_at(const Rational& t) const;
  // Where a disk that is there is at a time.
  GrowingDisk state_at(GenId g, const Rational& t) const;

  // A generator seen from a disk. The signs of rows are such that p is positive for what is
  // visible.
  GeneratorRow<TimePolynomial> row_of(GenId base, GenId g) const;
  // The same at a time that a ball contains.
  Site<Ball> site(GenId g, const Ball& t) const;
  GeneratorRow<Ball> row_of(GenId base, GenId g, const Ball& t) const;
  // How much the radius of j exceeds that of g, which lies in j or touches it from inside where
  // that is not negative and the tangency of the two not positive. For the frame the sum of radii.
  TimePolynomial excess(GenId g, GenId j) const;
  // The tangency p of two generators, one of them a disk; 1 for infinity.
  TimePolynomial tangency_of(GenId a, GenId b) const;

 private:
  MovingRows(const MovingRows* moving, const Rational& t);

  const MovingRows* moving_ = nullptr;                    // these rest
  Rational rest_;                                         // as they are then
  mutable std::map<GenId, Site<TimePolynomial>> rested_;  // those that were asked for or set
  std::vector<std::optional<Site<TimePolynomial>>> sites_;
  std::optional<Site<TimePolynomial>> circle_;
  RoughRows rough_;
};

// A ball that contains the time.
Ball ball_about(const WorldTime& t);
// The value at a time that a ball contains.
Ball value(const TimePolynomial& f, const Ball& t);
// The sign of a polynomial just after an instant: zero only where it vanishes for ever.
Sign sign_after(const TimePolynomial& f, const WorldTime& t);
// The sign of u + sqrt(gamma) v just after an instant, gamma not being negative then.
Sign sign_after(const TimePolynomial& u, const TimePolynomial& gamma, const TimePolynomial& v,
                const WorldTime& t);

}  // namespace voroproof::internal
