#include "tests/support/lattice_scene.h"

#include <algorithm>
#include <tuple>

#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

constexpr int kContainer = 12;
constexpr int kHorizon = 6;

bool fits(const std::vector<LatticeDisk>& others, const LatticeDisk& d) {
  const int room = kContainer - d.radius, from_centre = d.x * d.x + d.y * d.y;
  // Touching the wall: not by a point, and not sliding.
  if (from_centre > room * room) return false;
  const bool rests = d.vx == 0 && d.vy == 0;
  if (from_centre == room * room && (d.radius == 0 || (!rests && d.x * d.vx + d.y * d.vy == 0))) {
    return false;
  }
  return std::all_of(others.begin(), others.end(), [&](const LatticeDisk& o) {
    const int dx = d.x - o.x, dy = d.y - o.y, reach = d.radius + o.radius;
    const int squared = dx * dx + dy * dy;
    return squared > reach * reach || (squared == reach * reach && d.radius > 0 && o.radius > 0);
  });
}

}  // namespace

Scene scene_of(const LatticeScene& lattice) {
  std::vector<LatticeDisk> kept;
  for (const LatticeDisk& d : lattice.disks) {
    if (fits(kept, d)) kept.push_back(d);
  }
  Scene scene = scene_of(kContainer, kHorizon, {});
  for (const LatticeDisk& d : kept) {
    const int mass = d.radius == 0 ? 1 : d.radius * d.radius;
    scene.disks.push_back(disk(d.x, d.y, d.radius, d.vx, d.vy, mass));
  }
  scene.restitution = Rational(lattice.restitution_halves, 2);
  scene.restitution.canonicalize();
  scene.container_restitution = Rational(lattice.wall_quarters, 4);
  scene.container_restitution.canonicalize();
  scene.law = lattice.whole_law ? ContainerLaw::whole : ContainerLaw::normal;
  if (kept.empty()) return scene;
  for (const LatticeManeuver& m : lattice.maneuvers) {
    const Maneuver wanted{m.t, m.disk % static_cast<int>(kept.size()), m.vx, m.vy};
    const bool taken =
        std::any_of(scene.maneuvers.begin(), scene.maneuvers.end(),
                    [&](const Maneuver& o) { return o.t == wanted.t && o.disk == wanted.disk; });
    if (!taken) scene.maneuvers.push_back(wanted);
  }
  std::stable_sort(scene.maneuvers.begin(), scene.maneuvers.end(),
                   [](const Maneuver& a, const Maneuver& b) { return a.t < b.t; });
  return scene;
}

void showValue(const LatticeScene& lattice, std::ostream& out) { out << text(scene_of(lattice)); }

rc::Gen<LatticeScene> lattice_scenes(const LatticeFamily& family) {
  // The numbers do not depend on the size of the test case; only the lengths of the lists do.
  const auto number = [](int low, int high) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
  };
  const auto place = number(-(kContainer - 1), kContainer - 1);
  const auto speed = number(-family.max_speed, family.max_speed);
  const auto disks = rc::gen::scale(
      0.3, rc::gen::container<std::vector<LatticeDisk>>(rc::gen::construct<LatticeDisk>(
               place, place, number(family.min_radius, family.max_radius), speed, speed)));
  const auto maneuvers =
      family.maneuvers
          ? rc::gen::scale(0.05, rc::gen::container<std::vector<LatticeManeuver>>(
                                     rc::gen::construct<LatticeManeuver>(
                                         number(0, kHorizon), number(0, 11), speed, speed)))
          : rc::gen::just(std::vector<LatticeManeuver>{});
  const auto always = [](int value) { return rc::gen::just(value); };
  return rc::gen::construct<LatticeScene>(
      disks, maneuvers, family.elastic ? always(2) : number(0, 2),
      family.elastic ? always(4) : number(1, 4),
      family.elastic ? rc::gen::just(false) : rc::gen::arbitrary<bool>());
}

}  // namespace voroproof::internal::testing
