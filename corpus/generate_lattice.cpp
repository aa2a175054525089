// The families that start on a square lattice: grid and swarm.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "corpus/generate.h"
#include "corpus/generate_shared.h"

namespace voroproof::internal {
namespace {

std::string name_of(GridOptions::Motion motion) {
  switch (motion) {
    case GridOptions::Motion::rest:
      return "rest";
    case GridOptions::Motion::common:
      return "common";
    case GridOptions::Motion::random:
      return "random";
    case GridOptions::Motion::shear:
      return "shear";
  }
  throw std::invalid_argument("generate: unknown motion");
}

}  // namespace

Scene generate_grid(const GridOptions& options) {
  require(options.n >= 0, "generate: n must not be negative");
  require(finite_and_positive(options.radius), "generate: radius must be positive");
  require(std::isfinite(options.spacing) && options.spacing >= 2 * options.radius,
          "generate: spacing must be at least twice the radius");
  require(finite_and_not_negative(options.speed), "generate: speed must not be negative");
  require(finite_and_not_negative(options.horizon), "generate: horizon must not be negative");

  const Lattice lattice(options.n, options.spacing);
  // The power of two that brings the fastest row of a shear to at most `speed`.
  double shear = 1;
  while (shear * static_cast<double>(lattice.rows - 1) > 1) shear /= 2;
  Uniform random(options.seed);
  const auto velocity = [&](int i) -> Vec {
    switch (options.motion) {
      case GridOptions::Motion::rest:
        return {0, 0};
      case GridOptions::Motion::common:
        return {options.speed, 0};
      case GridOptions::Motion::random:
        return polar(two_pi * random(), options.speed);
      case GridOptions::Motion::shear:
        break;
    }
    return {options.speed * (shear * static_cast<double>(lattice.up(i))), 0};
  };

  const std::string motion = name_of(options.motion);
  Scene scene = empty_scene("grid-" + motion, options.n, options.seed,
                            lattice.round_up(lattice.extent() + options.radius + options.spacing),
                            options.horizon);
  scene.comment = "square lattice: n " + std::to_string(options.n) + ", seed " +
                  std::to_string(options.seed) + ", spacing " + text(options.spacing) +
                  ", radius " + text(options.radius) + ", motion " + motion + ", speed " +
                  text(options.speed) + ", horizon " + text(options.horizon);
  for (int i = 0; i < options.n; ++i) {
    add_disk(scene, lattice.centre(i), options.radius, velocity(i));
  }
  return scene;
}

Scene generate_swarm(const SwarmOptions& options) {
  require(options.n >= 0, "generate: n must not be negative");
  require(finite_and_positive(options.radius), "generate: radius must be positive");
  require(std::isfinite(options.spacing) && options.spacing > 2 * options.radius,
          "generate: spacing must be more than twice the radius");
  require(finite_and_positive(options.horizon), "generate: horizon must be positive");

  const Lattice lattice(options.n, options.spacing);
  const double n = options.n;
  double circle = lattice.extent() + options.spacing;
  if (options.n >= 3) circle = std::max(circle, options.spacing / (2 * sine(two_pi / 2 / n)));
  circle = lattice.round_up(circle);

  // Disks by direction from the centre, counterclockwise from the positive x
  // axis, compared exactly; the inner of two in one direction first.
  const auto by_direction = [&](int i, int j) {
    const long xi = lattice.across(i), yi = lattice.up(i);
    const long xj = lattice.across(j), yj = lattice.up(j);
    const bool lower_i = yi < 0 || (yi == 0 && xi < 0), lower_j = yj < 0 || (yj == 0 && xj < 0);
    if (lower_i != lower_j) return lower_j;
    const long cross = xi * yj - yi * xj;
    if (cross != 0) return cross > 0;
    return xi * xi + yi * yi < xj * xj + yj * yj;
  };
  std::vector<int> order(options.n);
  std::iota(order.begin(), order.end(), 0);
  // The disk at the very centre has no direction: it comes first.
  const auto middle = std::stable_partition(order.begin(), order.end(), [&](int i) {
    return lattice.across(i) == 0 && lattice.up(i) == 0;
  });
  std::stable_sort(middle, order.end(), by_direction);

  const double arrival = options.horizon / 2;
  Uniform random(options.seed);
  const double turn = random();
  std::vector<Vec> velocity(options.n);
  for (int place = 0; place < options.n; ++place) {
    const Vec from = lattice.centre(order[place]);
    const Vec to = polar(two_pi * ((place + turn) / n), circle);
    velocity[order[place]] = {(to.x - from.x) / arrival, (to.y - from.y) / arrival};
  }

  Scene scene =
      empty_scene("swarm", options.n, options.seed,
                  lattice.round_up(circle + options.radius + options.spacing), options.horizon);
  scene.comment = "square lattice to circle: n " + std::to_string(options.n) + ", seed " +
                  std::to_string(options.seed) + ", spacing " + text(options.spacing) +
                  ", radius " + text(options.radius) + ", horizon " + text(options.horizon);
  for (int i = 0; i < options.n; ++i) {
    add_disk(scene, lattice.centre(i), options.radius, velocity[i]);
    Maneuver stop;
    stop.t = to_rational(arrival);
    stop.disk = i;
    scene.maneuvers.push_back(std::move(stop));
  }
  return scene;
}

}  // namespace voroproof::internal
