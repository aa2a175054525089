// The predicates of a world as polynomials in time, and their signs at an algebraic time and just
// after it.
//
// A generator is a row of four numbers x, y, s, p as seen from a disk, the base: of another disk
// its offset, the difference of radii and their tangency; of a round frame the same with all signs
// changed, so that p > 0 is right for all; of infinity, the frame of the plane, (0, 0, 0, 1). With
// such rows the in-circle function of a vertex is G + sqrt(Gamma) C throughout, and that of
// infinity tells whether the circle exists (exact/predicates.h).
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <vector>

#include "certify/world/world_courses.h"
#include "exact/algebraic.h"
#include "exact/predicates.h"
#include "filtered/worlds/lazy_time.h"

namespace voroproof::internal {

using WorldTime = AlgebraicNumber<Rational>;

// Precondition: the base is a disk.
GeneratorRow<WorldPolynomial> world_row(const WorldCourses& motion, GenId base, GenId g);
// p of two generators: positive where both may have a cell.
WorldPolynomial world_tangency(const WorldCourses& motion, GenId g, GenId h);

// The signs of a polynomial at a time and just after it.
struct SignsThen {
  Sign at, after;
};
SignsThen signs_then(const WorldPolynomial& f, const WorldTime& t);

// u + sqrt(gamma) v, where gamma is not negative; d has the sign of u^2 - gamma v^2.
struct RootedForm {
  WorldPolynomial u, v, d;

  Sign at(const WorldTime& t) const;
  Sign after(const WorldTime& t) const;
  Sign at(const Rational& t) const;
  // Polynomials: the sign after a time changes at roots of the first that is not 0 only, while
  // gamma is positive. Null where it never does.
  const WorldPolynomial* changes() const;
};

// The in-circle function of a generator for the circle of a triple; from L5 of predicates.h its
// product with its conjugate is d, times a positive factor.
RootedForm conflict(const TangentTriple<WorldPolynomial>& t,
                    const GeneratorRow<WorldPolynomial>& e);
// That of infinity: positive where the circle exists.
RootedForm existence(const TangentTriple<WorldPolynomial>& t);

// An edge with its generators around it: the base, a disk, is on its left.
class WorldEdge {
 public:
  // Precondition: q names an edge, and s != e.
  WorldEdge(const WorldCourses& motion, const Quad& q);

  // In-circle functions: that of the end's generator for the circle at the start, and the other.
  const RootedForm& from_start() const { return from_start_; }
  const RootedForm& from_end() const { return from_end_; }
  const TangentTriple<WorldPolynomial>& start() const { return start_; }
  const TangentTriple<WorldPolynomial>& end() const { return end_; }

  // Both functions change their signs at roots of this only; null where they never do.
  const WorldPolynomial* changes() const { return from_start_.changes(); }
  // The edge may not be there just after t: a function is negative then, or both vanish for a
  // while, the edge is a point, and the rule of the largest id is against it.
  bool is_illegal_after(const WorldTime& t) const;
  // Both of its circles are one at t. `lenient`: also where this is not known because two of its
  // generators touch each other in the contact.
  bool is_point_at(const WorldTime& t, bool lenient) const;
  // The same for a while from t on, and at a rational time.
  bool is_point_after(const WorldTime& t) const;
  bool is_point_at(const Rational& t) const;

 private:
  RootedForm order() const;

  bool legal_while_cotangent_;
  TangentTriple<WorldPolynomial> start_, end_;
  RootedForm from_start_, from_end_;
};

// The same edge with a disk on its left.
Quad with_disk_on_left(const Quad& q);

// Whether g lies in h, or outside of the frame h, for a while from t on: h is larger, or of the
// same size and g has the larger id.
bool is_inside_after(const WorldCourses& motion, GenId g, GenId h, const LazyTime& t);
// Whether both have one centre and radius at t.
bool coincide_at(const WorldCourses& motion, GenId g, GenId h, const LazyTime& t);

// The roots in (after, until], in order.
std::vector<WorldTime> roots_after(const WorldPolynomial& f, const WorldTime& after,
                                   const Rational& until);

}  // namespace voroproof::internal
