#include "tests/support/random_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace voroproof::internal::testing {
namespace {

constexpr double kContainer = 100;
constexpr int kMaxFailures = 1'000'000;

struct Place {
  double x, y;
};

Place direction(Random& random) {
  const double angle = uniform(random, 0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

double uniform(Random& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

Scene random_scene(const RandomScene& options, Random& random) {
  std::vector<double> radii;
  double area = 0;
  for (int k = 0; k < options.n; ++k) {
    const double r =
        options.rmax == 0 ? 0
        : options.rmin == options.rmax
            ? options.rmax
            : options.rmin * std::exp(uniform(random, 0, std::log(options.rmax / options.rmin)));
    radii.push_back(r);
    area += r * r;
  }
  std::sort(radii.rbegin(), radii.rend());
  if (options.density > 0) {
    const double factor = kContainer * std::sqrt(options.density / area);
    for (double& r : radii) r *= factor;
  }

  Scene scene;
  scene.cx = uniform(random, -50, 50);
  scene.cy = uniform(random, -50, 50);
  scene.container_radius = kContainer;
  scene.horizon = options.horizon;
  std::vector<Place> places;
  int failures = 0;
  while (places.size() < radii.size()) {
    const double r = radii[places.size()];
    const Place d = direction(random);
    const double reach = (kContainer - r) * std::sqrt(uniform(random, 0, 1)) * (1 - 1e-9);
    const Place p{reach * d.x, reach * d.y};
    bool free = true;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double gap = std::hypot(p.x - places[k].x, p.y - places[k].y) - r - radii[k];
      free = free && gap > 1e-9;
    }
    if (free) {
      places.push_back(p);
      failures = 0;
    } else if (++failures == kMaxFailures) {
      // A large disk in the middle can leave no room for the next.
      places.clear();
      failures = 0;
    }
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place d = direction(random);
    const double speed = uniform(random, 0, 2 * options.speed), r = radii[k];
    // Sums are rounded: a hair's breadth of room was left for that.
    scene.disks.push_back({scene.cx.get_d() + places[k].x, scene.cy.get_d() + places[k].y, r,
                           speed * d.x, speed * d.y,
                           r == 0 ? Rational(1) : Rational(r) * Rational(r)});
  }
  std::shuffle(scene.disks.begin(), scene.disks.end(), random);
  for (int k = 0; k < options.maneuvers; ++k) {
    const Place d = direction(random);
    const double speed = uniform(random, 0, 2 * options.speed);
    const int id = static_cast<int>(random() % static_cast<std::uint64_t>(options.n));
    scene.maneuvers.push_back({uniform(random, 0, options.horizon), id, speed * d.x, speed * d.y});
  }
  std::sort(scene.maneuvers.begin(), scene.maneuvers.end(),
            [](const Maneuver& a, const Maneuver& b) { return a.t < b.t; });
  return scene;
}

}  // namespace voroproof::internal::testing
