#include "certify/contact_proof.h"

#include <algorithm>

#include "exact/rounding.h"
#include "filtered/motion/motion_lanes.h"
#include "filtered/motion/window_places.h"
#include "filtered/numbers/bound.h"
#include "filtered/numbers/form.h"

namespace voroproof::internal {

namespace {

// The Bernstein coefficients over a window, times their binomials, of the square of the distance of
// two generators less that of their reach.
template <class T>
struct Gap {
  Form<T, 2> form;
  T limit;  // error of a coefficient; the middle one errs by twice as much

  // M: as in WindowPlaces.
  template <class M>
  Gap(const M& i, const M& j, const T& a, const T& b) {
    const WindowPlaces<T> p(i, a, b), q(j, a, b);
    const Form<T, 1> x{{p.x0 - q.x0, p.x1 - q.x1}}, y{{p.y0 - q.y0, p.y1 - q.y1}};
    const T reach = i.r + j.r;
    form = tangency_of(x, y, Form<T, 0>{{reach}});
    const T far = larger(abs(x.c[0]) + abs(y.c[0]), abs(x.c[1]) + abs(y.c[1]));
    limit = tangency_bound(far, abs(reach), p.error + q.error).err * bound_up;
  }

  // Two disks are apart throughout.
  auto is_positive() const {
    auto is = form.c[0] > limit;
    is &= form.c[1] > 2 * limit;
    is &= form.c[2] > limit;
    return is;
  }
  // A disk is inside the container at the end.
  auto ends_negative() const { return form.c[2] < -limit; }
};

}  // namespace

bool proved_apart(const Motion& motion, GenId i, GenId j, double a, double b) {
  const bool disks = i != container_id && j != container_id;
  if (disks && Gap<double>(motion.doubles(i), motion.doubles(j), a, b).is_positive()) return true;
  if (motion.same_velocity(i, j)) return true;  // their distance never changes
  const DoubleBall start(a), end(b);
  if (!disks) {
    // |d + w s|^2 - reach^2 is convex in s: negative at both ends, so between.
    const Contact<DoubleBall> k(motion.moving_site(i, end), motion.moving_site(j, end));
    return sign(k.c) == Sign::negative;
  }
  const Contact<DoubleBall> k(motion.moving_site(i, start), motion.moving_site(j, start));
  // Apart and parting; or apart at a, and never within reach; or not yet.
  if (sign(k.c) != Sign::positive) return false;
  const Sign b_sign = sign(k.b);
  if (b_sign == Sign::positive || b_sign == Sign::zero) return true;
  const DoubleBall discriminant = k.b * k.b - k.a * k.c;
  if (sign(discriminant) == Sign::negative) return true;
  const DoubleBall delay = k.c / (sqrt(discriminant) - k.b);
  return sign(delay - (end - start)) == Sign::positive;
}

void ApartBatch::prove(double b) {
  constexpr std::size_t lanes = 4;
  apart_.resize(pairs_.size());
  for (std::size_t first = 0; first < pairs_.size(); first += lanes) {
    const std::size_t count = std::min(lanes, pairs_.size() - first);
    const Pair* p[lanes];
    for (std::size_t k = 0; k < lanes; ++k) p[k] = &pairs_[first + std::min(k, count - 1)];
    const MotionLanes i(motion_.doubles(p[0]->i), motion_.doubles(p[1]->i),
                        motion_.doubles(p[2]->i), motion_.doubles(p[3]->i));
    const MotionLanes j(motion_.doubles(p[0]->j), motion_.doubles(p[1]->j),
                        motion_.doubles(p[2]->j), motion_.doubles(p[3]->j));
    const Gap<Lanes> gap(i, j, Lanes{p[0]->a, p[1]->a, p[2]->a, p[3]->a}, splat(b));
    // A disk is inside the container at a, so that it is throughout if it is at b.
    const LaneMask wall = i.r < 0;
    const LaneMask apart =
        (wall & LaneMask(gap.ends_negative())) | (~wall & LaneMask(gap.is_positive()));
    for (std::size_t k = 0; k < count; ++k) apart_[first + k] = apart[k] != 0;
  }
}

}  // namespace voroproof::internal
