#include "certify/contact_proof.h"

#include <algorithm>
#include <cmath>

#include "exact/rounding.h"
#include "filtered/motion/motion_lanes.h"
#include "filtered/numbers/bound.h"
#include "filtered/numbers/form.h"

namespace voroproof::internal {

namespace {

// A disk's centre at two times.
struct Centres {
  double x0, y0, x1, y1;
  double error;  // of each coordinate, as in quadruplets over an interval (rootless.cpp)

  Centres(const DoubleMotion& m, double a, double b)
      : x0(m.x + m.vx * (a - m.t)),
        y0(m.y + m.vy * (a - m.t)),
        x1(m.x + m.vx * (b - m.t)),
        y1(m.y + m.vy * (b - m.t)),
        error(4 * unit_roundoff *
                  (std::fabs(m.x) + std::fabs(m.y) + std::fabs(x0) + std::fabs(y0) + std::fabs(x1) +
                   std::fabs(y1)) +
              m.ex + m.ev * (std::fabs(a - m.t) + std::fabs(b - m.t))) {}
};

// Whether two disks are apart throughout [a, b] by the Bernstein coefficients of the square of
// their distance less that of their reach: sooner done than what follows, and enough nearly always.
bool have_positive_gap(const DoubleMotion& i, const DoubleMotion& j, double a, double b) {
  const Centres p(i, a, b), q(j, a, b);
  const Form<double, 1> x{{p.x0 - q.x0, p.x1 - q.x1}}, y{{p.y0 - q.y0, p.y1 - q.y1}};
  const double reach = i.r + j.r;
  const Form<double, 2> gap = tangency_of(x, y, Form<double, 0>{{reach}});
  const double far =
      std::max(std::fabs(x.c[0]) + std::fabs(y.c[0]), std::fabs(x.c[1]) + std::fabs(y.c[1]));
  const double limit = tangency_bound(far, reach, p.error + q.error).err * bound_up;
  return gap.c[0] > limit && gap.c[1] > 2 * limit && gap.c[2] > limit;
}

}  // namespace

bool proved_apart(const Motion& motion, GenId i, GenId j, double a, double b) {
  const bool disks = i != container_id && j != container_id;
  if (disks && have_positive_gap(motion.doubles(i), motion.doubles(j), a, b)) return true;
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
    const BallLanes start{{p[0]->a, p[1]->a, p[2]->a, p[3]->a}, {}}, end{splat(b), {}};
    const Contact<BallLanes> before(i.moving_site(start), j.moving_site(start));
    const Contact<BallLanes> after(i.moving_site(end), j.moving_site(end));
    // Two disks: apart at a, and then parting, or never within reach, or still approaching at b. A
    // disk and the container: inside at b, as at a.
    const LaneMask never = negative(before.b * before.b - before.a * before.c);
    const LaneMask not_yet = positive(after.c) & negative(after.b);
    const LaneMask disks = positive(before.c) & (positive(before.b) | never | not_yet);
    const LaneMask wall = i.r < 0;
    const LaneMask apart = (wall & negative(after.c)) | (~wall & disks);
    for (std::size_t k = 0; k < count; ++k) apart_[first + k] = apart[k] != 0;
  }
}

}  // namespace voroproof::internal
