// A scene at t = 0: what the queries see, and distances in 100 digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "library/queries/clearance.h"
#include "library/true_moment.h"
#include "tests/oracle/circle.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {

using oracle::Real;

struct BruteMoment {
  explicit BruteMoment(const Scene& given) : scene(given), moment(true_moment(scene, "", 0, {})) {
    for (const DiskInput& d : scene.disks) {
      disks.push_back(oracle::rounded(oracle::ExactCircle{d.x, d.y, d.radius}));
    }
    container = oracle::rounded(oracle::ExactCircle{scene.cx, scene.cy, scene.container_radius});
  }

  const oracle::Circle& circle(GenId g) const { return g == container_id ? container : disks[g]; }
  // The distance of a point from generator g.
  Real distance(GenId g, const Real& x, const Real& y) const {
    const oracle::Circle& c = circle(g);
    const Real dx = x - c.x, dy = y - c.y;
    const Real d = sqrt(dx * dx + dy * dy);
    return g == container_id ? Real(c.radius - d) : Real(d - c.radius);
  }
  double distance_in_doubles(GenId g, double x, double y) const {
    const oracle::Circle& c = circle(g);
    const double d = std::hypot(x - c.x.convert_to<double>(), y - c.y.convert_to<double>());
    const double r = c.radius.convert_to<double>();
    return g == container_id ? r - d : d - r;
  }
  double clearance(double x, double y) const {
    double least = distance_in_doubles(container_id, x, y);
    for (GenId g = 0; g < size(); ++g) least = std::min(least, distance_in_doubles(g, x, y));
    return least;
  }
  Real gap(GenId i, GenId j) const {
    if (i == container_id) std::swap(i, j);
    const oracle::Circle& c = circle(i);
    return distance(j, c.x, c.y) - c.radius;
  }
  GenId size() const { return static_cast<GenId>(disks.size()); }

  Clearance clearance_for(const Rational& probe) {
    return Clearance(moment.motion, zero, moment.diagram, probe, counts);
  }

  Scene scene;
  Rational zero = 0;
  TrueMoment moment;
  TierCounts counts;
  std::vector<oracle::Circle> disks;
  oracle::Circle container;
};

inline bool contains(const Enclosure& e, const Real& x) {
  return Real(e.lo) <= x && x <= Real(e.hi);
}
inline double middle(const Enclosure& e) { return 0.5 * e.lo + 0.5 * e.hi; }
inline bool is_narrow(const Enclosure& e, double scale) { return e.hi - e.lo <= 1e-14 * scale; }

}  // namespace voroproof::internal::testing
