#include <CGAL/Interval_nt.h>

#include "bench/incircle_task.h"
#include "bench/statistics.h"

namespace voroproof::internal::bench {

namespace {

// CGAL's interval with rounding protected by the caller, in the terms of the predicates.
struct Interval {
  CGAL::Interval_nt<false> value;

  Interval(double x) : value(x) {}
  Interval(const CGAL::Interval_nt<false>& x) : value(x) {}
};

Interval operator+(const Interval& a, const Interval& b) { return a.value + b.value; }
Interval operator-(const Interval& a, const Interval& b) { return a.value - b.value; }
Interval operator*(const Interval& a, const Interval& b) { return a.value * b.value; }

Sign sign(const Interval& a) {
  if (a.value.inf() > 0) return Sign::positive;
  if (a.value.sup() < 0) return Sign::negative;
  return a.value.inf() == 0 && a.value.sup() == 0 ? Sign::zero : Sign::unknown;
}

}  // namespace

long incircles_in_intervals(const Motion& motion, const std::vector<IncircleTask>& tasks,
                            double& seconds) {
  const CGAL::Protect_FPU_rounding<true> rounding_up;
  long undecided = 0;
  seconds = seconds_of([&] {
    for (const IncircleTask& task : tasks) {
      const Sign s = incircle_at(task.quad, [&](GenId g) {
        const DoubleMotion& m = motion.doubles(g);
        const Interval dt = Interval(task.t) - Interval(m.t);
        return Site<Interval>{Interval(m.x) + Interval(m.vx) * dt,
                              Interval(m.y) + Interval(m.vy) * dt, Interval(m.r)};
      });
      if (s == Sign::unknown) ++undecided;
    }
  });
  return undecided;
}

}  // namespace voroproof::internal::bench
