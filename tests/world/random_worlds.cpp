#include "tests/world/random_worlds.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "tests/world/world_tools.h"

namespace voroproof::internal::testing {

namespace {

// The sizes that worlds of a family have in common. Numbers are whole multiples of 1 / grain.
struct Recipe {
  int most_disks = 12;
  int grain = 64;
  int span = 9;                  // of centres
  int speed = 3;                 // of each coordinate
  int low = 0, high = 4;         // radii
  int shrink = 0, grow = 0;      // rates, in eighths
  int one_in_points = 0;         // so many disks have one point among them; 0: none
  bool equal = false;            // radii and rates
  int maneuvers = 0, lives = 0;  // at most so many
  bool whole_times = false;
  int one_in_circles = 2;            // so many worlds have one circle among them
  int circle = 14, circle_rate = 0;  // the rate is up to so many eighths
  int horizon = 4;
};

Recipe recipe_of(WorldFamily family) {
  switch (family) {
    case WorldFamily::overlapping:
      return {};
    case WorldFamily::growing:
      return {.most_disks = 9, .shrink = 4, .grow = 12, .horizon = 5};
    case WorldFamily::equal_radii:
      return {.high = 3, .shrink = 2, .grow = 4, .equal = true};
    case WorldFamily::points:
      return {.most_disks = 10, .high = 3, .one_in_points = 1};
    case WorldFamily::nested:
      return {.grain = 16, .span = 6, .speed = 2, .high = 2, .shrink = 1, .grow = 3};
    case WorldFamily::lattice:
      return {.most_disks = 7, .grain = 1, .span = 3, .speed = 1, .high = 1};
    case WorldFamily::lifetimes:
      return {.most_disks = 9, .shrink = 1, .grow = 3, .lives = 6, .horizon = 5};
    case WorldFamily::jumping:
      return {.most_disks = 8, .shrink = 1, .grow = 2, .maneuvers = 8, .lives = 2};
    case WorldFamily::simultaneous:
      return {.most_disks = 6,
              .grain = 1,
              .span = 3,
              .speed = 1,
              .high = 2,
              .maneuvers = 6,
              .lives = 3,
              .whole_times = true};
    case WorldFamily::crossing_circle:
      return {.most_disks = 8,
              .span = 7,
              .speed = 4,
              .high = 3,
              .shrink = 1,
              .grow = 2,
              .lives = 2,
              .one_in_circles = 1,
              .circle = 6};
    default:
      return {.most_disks = 7,
              .span = 5,
              .speed = 2,
              .high = 4,
              .shrink = 2,
              .grow = 14,
              .one_in_circles = 1,
              .circle = 7,
              .circle_rate = 8};
  }
}

class WorldMaker {
 public:
  WorldMaker(WorldFamily family, std::mt19937_64& random)
      : family_(family), recipe_(recipe_of(family)), random_(random) {}

  World world() {
    world_.name = name_of(family_);
    world_.horizon = recipe_.horizon;
    if (whole(1, recipe_.one_in_circles) == 1) put_circle();
    const int n = whole(0, recipe_.most_disks);
    for (int k = 0; k < n; ++k) put_disk();
    if (n > 0) {
      put_lives();
      put_maneuvers();
    }
    make_valid(world_);
    constexpr std::array<int, 8> exponents{0, 0, 0, 0, 0, -40, 3, 50};
    const int length = exponents[whole(0, 7)];
    const int time = exponents[whole(0, 7)];
    return in_units(world_, power(length), power(time));
  }

 private:
  // One draw of it a statement: the order of draws is that of statements.
  int whole(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }
  Rational number(int low, int high) {
    return ratio(whole(low * recipe_.grain, high * recipe_.grain), recipe_.grain);
  }
  static Rational ratio(int a, int b) {
    Rational q(a, b);
    q.canonicalize();
    return q;
  }
  static Rational power(int exponent) {
    Rational q = 1;
    mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), std::max(exponent, 0));
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), std::max(-exponent, 0));
    return q;
  }
  // A time of the world, 0 and the horizon included.
  Rational time() {
    constexpr std::array<int, 4> parts{1, 2, 3, 32};
    const int choice = whole(0, 3);
    const int part = recipe_.whole_times ? parts[choice % 2] : parts[choice];
    return ratio(whole(0, recipe_.horizon * part), part);
  }

  void put_circle() {
    WorldCircle circle{{0, 0}, recipe_.circle, 0};
    circle.growth = ratio(whole(-recipe_.circle_rate, recipe_.circle_rate), 8);
    if (whole(0, 3) == 0) circle.center = {ratio(1, 3), -1};
    world_.circle = circle;
  }

  Point2 place() {
    const Rational x = number(-recipe_.span, recipe_.span);
    const Rational y = number(-recipe_.span, recipe_.span);
    return {x, y};
  }
  Point2 velocity() {
    const int divisor = recipe_.grain > 1 && whole(0, 4) == 0 ? 3 : 1;
    const Rational x = number(-recipe_.speed, recipe_.speed) / divisor;
    const Rational y = number(-recipe_.speed, recipe_.speed) / divisor;
    return {x, y};
  }
  Rational radius() {
    if (recipe_.one_in_points > 0 && whole(0, 3) > 0) return 0;
    return number(recipe_.low, recipe_.high);
  }
  Rational rate() { return ratio(whole(-recipe_.shrink, recipe_.grow), 8); }

  void put_disk() {
    const Point2 c = place();
    const Point2 v = velocity();
    const Rational r = radius();
    const Rational s = rate();
    WorldDisk disk{0, std::nullopt, {c.x, c.y, r, v.x, v.y, s}};
    if (!world_.disks.empty()) {
      const GrowingDisk& first = world_.disks.front().state;
      if (recipe_.equal) disk.state.radius = first.radius, disk.state.growth = first.growth;
      // Some are within another, or about a centre.
      const int kind = family_ == WorldFamily::nested ? whole(0, 2) : 0;
      if (kind > 0) {
        const GrowingDisk& host =
            world_.disks[whole(0, static_cast<int>(world_.disks.size()) - 1)].state;
        const Rational share = kind == 1 ? 0 : ratio(1, 4);
        disk.state.x = host.x + share * c.x;
        disk.state.y = host.y + share * c.y;
      }
    } else if (family_ == WorldFamily::nested) {
      disk.state.radius += 5;
    }
    world_.disks.push_back(std::move(disk));
  }

  int any_disk() { return whole(0, static_cast<int>(world_.disks.size()) - 1); }

  void put_lives() {
    const int count = recipe_.lives == 0 ? 0 : whole(0, recipe_.lives);
    for (int k = 0; k < count; ++k) {
      WorldDisk& disk = world_.disks[any_disk()];
      const Rational enter = time();
      const Rational leave = time();
      disk.enter = whole(0, 2) > 0 ? enter : Rational(0);
      disk.leave.reset();
      if (leave > disk.enter && whole(0, 2) > 0) disk.leave = leave;
    }
  }

  void put_maneuvers() {
    const int count = recipe_.maneuvers == 0 ? 0 : whole(0, recipe_.maneuvers);
    std::set<std::pair<Rational, int>> taken;
    for (int k = 0; k < count; ++k) {
      WorldManeuver m;
      m.t = time();
      m.disk = any_disk();
      const WorldDisk& disk = world_.disks[m.disk];
      const bool there = m.t == 0 ? disk.enter == 0 : disk.enter < m.t;
      if (!there || (disk.leave && *disk.leave <= m.t)) continue;
      if (!taken.emplace(m.t, m.disk).second) continue;
      if (whole(0, 1) == 0) m.center = place();
      if (whole(0, 1) == 0) m.velocity = velocity();
      if (whole(0, 2) == 0) m.radius = radius();
      if (whole(0, 2) == 0) m.growth = rate();
      if (!m.center && !m.radius && !m.growth) m.velocity = velocity();
      world_.maneuvers.push_back(std::move(m));
    }
  }

  WorldFamily family_;
  Recipe recipe_;
  std::mt19937_64& random_;
  World world_;
};

}  // namespace

const char* name_of(WorldFamily family) {
  constexpr std::array names{"overlapping",  "growing",        "equalradii",   "points",
                             "nested",       "lattice",        "lifetimes",    "jumping",
                             "simultaneous", "crossingcircle", "growingcircle"};
  return names[static_cast<std::size_t>(family)];
}

World random_world(WorldFamily family, std::mt19937_64& random) {
  return WorldMaker(family, random).world();
}

}  // namespace voroproof::internal::testing
