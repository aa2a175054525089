// What scenes of small worlds are made of.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/world/degenerate_worlds.h"

namespace voroproof::internal::testing {

using Lines = std::vector<ExpectedLine>;

inline GrowingDisk disk(const Rational& x, const Rational& y, const Rational& radius,
                        const Rational& vx = 0, const Rational& vy = 0,
                        const Rational& growth = 0) {
  return {x, y, radius, vx, vy, growth};
}

inline World world_of(const Rational& horizon, const std::vector<GrowingDisk>& disks,
                      std::optional<WorldCircle> circle = {}) {
  World world;
  world.horizon = horizon;
  world.circle = std::move(circle);
  for (const GrowingDisk& d : disks) world.disks.push_back({0, {}, d});
  return world;
}

inline WorldCircle circle_of(const Rational& radius, const Rational& growth = 0) {
  return {{0, 0}, radius, growth};
}

inline World with(World world, std::vector<WorldManeuver> maneuvers) {
  world.maneuvers = std::move(maneuvers);
  return world;
}
inline WorldManeuver turn(const Rational& t, int g, const Rational& vx, const Rational& vy) {
  return {t, g, {}, Point2{vx, vy}, {}, {}};
}
inline WorldManeuver jump(const Rational& t, int g, const Rational& x, const Rational& y) {
  return {t, g, Point2{x, y}, {}, {}, {}};
}

// The disks among four that have nothing to do with them.
inline std::vector<GrowingDisk> among_others(std::vector<GrowingDisk> disks) {
  for (const GrowingDisk& d : {disk(-12, 5, 1), disk(10, 8, 2, 0, Rational(1, 7)),
                               disk(3, -13, 1, Rational(1, 9)), disk(-7, -9, 3)}) {
    disks.push_back(d);
  }
  return disks;
}

class SceneList {
 public:
  void add(const std::string& name, World world, std::optional<Lines> lines,
           std::optional<int> flips = {}) {
    world.name = name;
    all_.push_back({name, std::move(world), std::move(lines), flips, {}});
  }
  // The same in the plane and in a circle that nothing comes near to.
  void add_in_both(const std::string& name, World world, const std::optional<Lines>& lines,
                   const std::optional<Rational>& undecided = {}) {
    for (const std::string frame : {"plane", "circle"}) {
      if (frame == "circle") world.circle = circle_of(30);
      add(name + ", " + frame, world, lines);
      all_.back().undecided = undecided;
    }
  }

 protected:
  std::vector<DegenerateWorld> all_;
};

}  // namespace voroproof::internal::testing
