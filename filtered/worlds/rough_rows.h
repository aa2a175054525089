// The generators of a world in doubles with error bounds: where they are at a time, and their
// tangencies over a window of time.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "exact/generators.h"
#include "exact/polynomial.h"
#include "exact/predicates.h"
#include "filtered/numbers/dd_ball.h"
#include "filtered/numbers/double_ball.h"
#include "filtered/numbers/form.h"

namespace voroproof::internal {

// The round frame seen from a disk.
template <class T>
GeneratorRow<T> row_of_circle(const Site<T>& base, const Site<T>& circle) {
  const T x = base.x - circle.x, y = base.y - circle.y, s = circle.r + base.r;
  return {x, y, s, s * s - x * x - y * y};
}

// A generator over a window of time: its centre and its radius are linear.
template <class T>
struct SiteForm {
  Form<T, 1> x, y, r;
};

class RoughRows {
 public:
  // Without `filters` all bounds are infinite, so that exact numbers tell everything.
  RoughRows(int disks, bool filters) : filters_(filters), sites_(static_cast<std::size_t>(disks)) {}

  // All as they are at one time, and resting there but for those that are set. `moving` outlives
  // it, and does not change meanwhile.
  RoughRows(const RoughRows* moving, const Rational& t);

  // Polynomials of degree 1 at most.
  void set(GenId g, const Site<Polynomial<Rational>>& site);
  bool has_circle() const { return moving_ ? moving_->has_circle() : circle_.has_value(); }

  // At all times that the ball contains. Precondition: the generator is there and not infinity.
  Site<DoubleBall> site(GenId g, const DoubleBall& t) const;
  Site<DdBall> site(GenId g, const DdBall& t) const;
  // A generator seen from a disk that is in `base`, with the signs of row_of_circle():
  // those of another disk are row()'s, infinity is (0, 0, 0, 1).
  GeneratorRow<DoubleBall> row_of(const Site<DoubleBall>& base, GenId g, const DoubleBall& t) const;
  // The tangency of two generators, with these signs.
  DoubleBall tangency_of(GenId a, GenId b, const DoubleBall& t) const;

  // Over [a, b]: of infinity something of no meaning.
  template <class T>
  SiteForm<T> over(GenId g, double a, double b) const;
  template <class T>
  Form<T, 2> tangency_over(GenId g, const SiteForm<T>& of_g, GenId h,
                           const SiteForm<T>& of_h) const;

  // Whether four disks, or three and infinity, have one radius, and grow alike.
  bool have_one_radius(const Quad& q) const;
  // About the time in which some of the disks goes or grows as far as they are apart and large at
  // t. Costs depend on it, and no decision.
  double time_scale(const Quad& q, double t) const;

 private:
  struct Line {
    DdBall at_zero, rate;
  };
  struct Lines {
    Line x, y, r;
  };
  Lines lines(GenId g) const;
  // Exactly; null where it is not known.
  const Polynomial<Rational>* radius(GenId g) const;
  bool is_infinity(GenId g) const { return g == container_id && !has_circle(); }

  struct Known {
    Lines lines;
    Polynomial<Rational> radius;
  };
  const RoughRows* moving_ = nullptr;  // these rest
  DdBall rest_;                        // as they are then
  std::map<GenId, Known> set_;         // but for these
  bool filters_;
  std::vector<Known> sites_;
  std::optional<Lines> circle_;
};

}  // namespace voroproof::internal
