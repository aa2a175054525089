// Generated scenes: what they promise, checked in exact arithmetic, and their bytes.
#include "corpus/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "corpus/paper_sets.h"
#include "history/scene_writer.h"
#include "history/sha256.h"
#include "tests/support/compact_arithmetic.h"

namespace voroproof::internal {
namespace {

std::string bytes(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return out.str();
}

Rational square(const Rational& q) { return q * q; }

// No two disks overlap or touch and none touches the container, by definition.
void expect_apart(const Scene& s) {
  for (std::size_t i = 0; i < s.disks.size(); ++i) {
    const DiskInput& a = s.disks[i];
    ASSERT_LT(a.radius, s.container_radius);
    ASSERT_LT(square(a.x - s.cx) + square(a.y - s.cy), square(s.container_radius - a.radius)) << i;
    for (std::size_t j = 0; j < i; ++j) {
      const DiskInput& b = s.disks[j];
      ASSERT_GT(square(a.x - b.x) + square(a.y - b.y), square(a.radius + b.radius))
          << i << ' ' << j;
    }
  }
}

bool is_binary64(const Rational& q) { return to_rational(round_nearest(q)) == q; }

// The scene can be read (the reader checks everything), and reading it gives the
// same scene; every number in it is a binary64 number.
void expect_valid(const Scene& s) {
  const std::string text = bytes(s);
  const Scene read = parse_scene(text, "generated");
  EXPECT_EQ(bytes(read), text);
  ASSERT_EQ(read.disks.size(), s.disks.size());
  EXPECT_FALSE(read.name.empty());
  EXPECT_FALSE(read.comment.empty());
  EXPECT_TRUE(read.seed.has_value());
  EXPECT_TRUE(is_binary64(s.container_radius));
  for (const DiskInput& disk : s.disks) {
    for (const Rational q : {disk.x, disk.y, disk.radius, disk.vx, disk.vy})
      EXPECT_TRUE(is_binary64(q));
    EXPECT_EQ(disk.mass, square(disk.radius));
  }
}

// |v| differs from the speed by at most one unit in its last place, exactly.
void expect_speed(const Scene& s, double speed) {
  const double above = std::nextafter(speed, std::numeric_limits<double>::infinity());
  const Rational ulp = to_rational(above) - to_rational(speed);
  for (const DiskInput& disk : s.disks) {
    const Rational v2 = square(disk.vx) + square(disk.vy);
    EXPECT_GE(v2, square(to_rational(speed) - ulp));
    EXPECT_LE(v2, square(to_rational(speed) + ulp));
  }
}

Rational density(const Scene& s) {
  Rational area = 0;
  for (const DiskInput& disk : s.disks) area += square(disk.radius.value());
  return area / square(s.container_radius);
}

ReferenceOptions reference(int n, ReferenceOptions::Radii radii, double density) {
  ReferenceOptions options;
  options.n = n;
  options.radii = radii;
  options.density = density;
  return options;
}

using Radii = ReferenceOptions::Radii;
using Motion = GridOptions::Motion;

TEST(GenerateReference, DisksAreApart) {
  expect_apart(generate_reference(reference(300, Radii::uniform, 0.05)));
  expect_apart(generate_reference(reference(300, Radii::uniform, 0.5)));
  expect_apart(generate_reference(reference(300, Radii::equal, 0.5)));
  ReferenceOptions wide = reference(300, Radii::log, 0.5);
  wide.rmin = 1e-3;
  wide.rmax = 30;
  expect_apart(generate_reference(wide));
}

TEST(GenerateReference, ReachesTheDensity) {
  for (const double wanted : {1e-6, 0.05, 0.5}) {
    for (const Radii radii : {Radii::uniform, Radii::log, Radii::equal}) {
      const double reached =
          round_nearest(density(generate_reference(reference(300, radii, wanted))));
      EXPECT_NEAR(reached / wanted, 1, 1e-12);
    }
  }
}

TEST(GenerateReference, RadiiFollowTheirDistribution) {
  ReferenceOptions options = reference(2000, Radii::uniform, 0.05);
  options.rmin = 2;
  options.rmax = 32;
  // Each half of the distribution holds half of the disks (binomial, sigma 22),
  // wherever the ids are.
  const auto count_above = [](const Scene& s, double bound, std::size_t from, std::size_t to) {
    return std::count_if(s.disks.begin() + from, s.disks.begin() + to,
                         [&](const DiskInput& disk) { return disk.radius > bound; });
  };
  const auto expect_halves = [&](Radii radii, double median) {
    options.radii = radii;
    const Scene s = generate_reference(options);
    for (const DiskInput& disk : s.disks) {
      EXPECT_GE(disk.radius, 2);
      EXPECT_LE(disk.radius, 32);
    }
    EXPECT_NEAR(static_cast<double>(count_above(s, median, 0, 2000)), 1000, 110);
    EXPECT_NEAR(static_cast<double>(count_above(s, median, 0, 1000)), 500, 80);
  };
  expect_halves(Radii::uniform, 17);
  expect_halves(Radii::log, 8);
  options.radii = Radii::equal;
  for (const DiskInput& disk : generate_reference(options).disks) EXPECT_EQ(disk.radius, 32);
}

TEST(GenerateReference, PlacesAndDirectionsAreSpreadEvenly) {
  const Scene s = generate_reference(reference(4000, Radii::uniform, 0.05));
  std::array<int, 4> place{}, direction{};
  int inner = 0;
  for (const DiskInput& disk : s.disks) {
    ++place[(disk.x > 0) + 2 * (disk.y > 0)];
    ++direction[(disk.vx > 0) + 2 * (disk.vy > 0)];
    inner += square(disk.x) + square(disk.y) < square(s.container_radius) / 2;
  }
  // Binomial with p = 1/4 (sigma 27) and p = 1/2 (sigma 32).
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    EXPECT_NEAR(place[quadrant], 1000, 140);
    EXPECT_NEAR(direction[quadrant], 1000, 140);
  }
  EXPECT_NEAR(inner, 2000, 160);
}

TEST(GenerateReference, HasTheCommonSpeed) {
  for (const double speed : {1.0, 0.1, 1.9999999999999998, 37.5}) {
    ReferenceOptions options = reference(500, Radii::uniform, 0.05);
    options.speed = speed;
    expect_speed(generate_reference(options), speed);
  }
  ReferenceOptions still = reference(5, Radii::uniform, 0.05);
  still.speed = 0;
  for (const DiskInput& disk : generate_reference(still).disks) {
    EXPECT_EQ(disk.vx, 0);
    EXPECT_EQ(disk.vy, 0);
  }
}

TEST(GenerateReference, IsValid) {
  for (const Radii radii : {Radii::uniform, Radii::log, Radii::equal})
    expect_valid(generate_reference(reference(100, radii, 0.3)));
  for (const int n : {0, 1, 2, 3})
    expect_valid(generate_reference(reference(n, Radii::uniform, 0.05)));
  ReferenceOptions options = reference(10, Radii::uniform, 0.05);
  options.restitution = 0.75;
  options.horizon = 12.5;
  options.seed = ~std::uint64_t{0};
  const Scene s = generate_reference(options);
  expect_valid(s);
  EXPECT_EQ(s.restitution, Rational(3, 4));
  EXPECT_EQ(s.horizon, Rational(25, 2));
  EXPECT_NE(bytes(s).find("\"seed\": 18446744073709551615"), std::string::npos);
}

TEST(GenerateReference, TheSeedDecides) {
  ReferenceOptions options = reference(20, Radii::uniform, 0.05);
  const std::string first = bytes(generate_reference(options));
  EXPECT_EQ(bytes(generate_reference(options)), first);
  options.seed = 2;
  EXPECT_NE(bytes(generate_reference(options)), first);
}

TEST(GenerateReference, SaysWhenTheDensityIsOutOfReach) {
  EXPECT_THROW(generate_reference(reference(100, Radii::equal, 0.85)), std::runtime_error);
  EXPECT_THROW(generate_reference(reference(2, Radii::equal, 0.5)), std::runtime_error);
}

TEST(GenerateReference, RefusesOptionsWithoutMeaning) {
  const auto refused = [](auto change) {
    ReferenceOptions options;
    change(options);
    EXPECT_THROW(generate_reference(options), std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](auto& o) { o.n = -1; });
  refused([](auto& o) { o.rmin = 0; });
  refused([](auto& o) { o.rmin = 11; });
  refused([](auto& o) { o.rmax = std::numeric_limits<double>::infinity(); });
  refused([](auto& o) { o.density = 0; });
  refused([](auto& o) { o.density = 1; });
  refused([&](auto& o) { o.density = nan; });
  refused([](auto& o) { o.speed = -1; });
  refused([&](auto& o) { o.speed = nan; });
  refused([](auto& o) { o.restitution = 1.5; });
  refused([](auto& o) { o.horizon = -1; });
}

GridOptions grid(int n, Motion motion) {
  GridOptions options;
  options.n = n;
  options.motion = motion;
  return options;
}

TEST(GenerateGrid, IsASquareLattice) {
  for (const int n : {1, 2, 3, 5, 9, 12, 100}) {
    const Scene s = generate_grid(grid(n, Motion::rest));
    ASSERT_EQ(s.disks.size(), static_cast<std::size_t>(n));
    expect_apart(s);
    expect_valid(s);
    std::set<Rational> columns, rows;
    for (const DiskInput& disk : s.disks) {
      columns.insert(disk.x);
      rows.insert(disk.y);
      EXPECT_EQ(Rational(disk.x / 2).get_den(), 1);
      EXPECT_EQ(Rational(disk.y / 2).get_den(), 1);
    }
    EXPECT_LE(columns.size() - rows.size(), 1u);
    EXPECT_EQ(*columns.begin(), -*columns.rbegin());
    EXPECT_EQ(*rows.begin(), -*rows.rbegin());
    if (n > 1) {
      EXPECT_EQ(*std::next(columns.begin()) - *columns.begin(), 4);
    }
  }
  expect_valid(generate_grid(grid(0, Motion::rest)));
}

TEST(GenerateGrid, MovesAsAsked) {
  for (const DiskInput& disk : generate_grid(grid(30, Motion::rest)).disks)
    EXPECT_TRUE(disk.vx == 0 && disk.vy == 0);
  for (const DiskInput& disk : generate_grid(grid(30, Motion::common)).disks)
    EXPECT_TRUE(disk.vx == 1 && disk.vy == 0);
  const Scene random = generate_grid(grid(30, Motion::random));
  expect_speed(random, 1);
  EXPECT_NE(random.disks[0].vx, random.disks[1].vx);

  for (const int n : {1, 2, 30, 100}) {
    // A shear: the velocity is one exact multiple of the height.
    const Scene shear = generate_grid(grid(n, Motion::shear));
    expect_valid(shear);
    const DiskInput& top = shear.disks.back();
    EXPECT_LE(top.vx, 1);
    if (top.y != 0) {
      EXPECT_GT(top.vx, Rational(1, 4));
    }
    for (const DiskInput& disk : shear.disks) {
      EXPECT_EQ(disk.vx * top.y, top.vx * disk.y);
      EXPECT_EQ(disk.vy, 0);
    }
  }
}

TEST(GenerateGrid, MayTouch) {
  GridOptions options = grid(9, Motion::rest);
  options.spacing = 2;
  expect_valid(generate_grid(options));
  options.spacing = 1.75;
  EXPECT_THROW(generate_grid(options), std::invalid_argument);
  options.spacing = 2;
  options.radius = 0;
  EXPECT_THROW(generate_grid(options), std::invalid_argument);
}

SwarmOptions swarm(int n) {
  SwarmOptions options;
  options.n = n;
  return options;
}

TEST(GenerateSwarm, AllArriveOnTheCircleAndStop) {
  for (const int n : {1, 2, 3, 20, 49, 100}) {
    const Scene s = generate_swarm(swarm(n));
    expect_apart(s);
    expect_valid(s);
    Scene arrived = s;
    double least = 1e300, most = 0;
    for (DiskInput& disk : arrived.disks) {
      disk.x += disk.vx * s.horizon / 2;
      disk.y += disk.vy * s.horizon / 2;
      const double distance = std::sqrt(round_nearest(square(disk.x) + square(disk.y)));
      least = std::min(least, distance);
      most = std::max(most, distance);
    }
    EXPECT_NEAR(least, most, 1e-9);
    expect_apart(arrived);
    for (std::size_t i = 1; i < arrived.disks.size(); ++i) {
      const Rational apart = square(arrived.disks[i].x - arrived.disks[0].x) +
                             square(arrived.disks[i].y - arrived.disks[0].y);
      EXPECT_GT(round_nearest(apart), 16 - 1e-9);
    }
    ASSERT_EQ(s.maneuvers.size(), s.disks.size());
    for (std::size_t i = 0; i < s.maneuvers.size(); ++i) {
      EXPECT_EQ(s.maneuvers[i].disk, static_cast<int>(i));
      EXPECT_EQ(s.maneuvers[i].t, s.horizon / 2);
      EXPECT_TRUE(s.maneuvers[i].vx == 0 && s.maneuvers[i].vy == 0);
    }
  }
  expect_valid(generate_swarm(swarm(0)));
}

TEST(GenerateSwarm, TheSeedTurnsTheCircle) {
  SwarmOptions options = swarm(12);
  const std::string first = bytes(generate_swarm(options));
  EXPECT_EQ(bytes(generate_swarm(options)), first);
  options.seed = 2;
  EXPECT_NE(bytes(generate_swarm(options)), first);
}

TEST(GenerateSwarm, RefusesOptionsWithoutMeaning) {
  const auto refused = [](auto change) {
    SwarmOptions options;
    change(options);
    EXPECT_THROW(generate_swarm(options), std::invalid_argument);
  };
  refused([](auto& o) { o.n = -1; });
  refused([](auto& o) { o.spacing = 2; });
  refused([](auto& o) { o.radius = 0; });
  refused([](auto& o) { o.horizon = 0; });
}

// The same bytes on every platform. A change of these values changes everybody's
// data sets: it needs a word in the change log.
TEST(Generate, BytesArePinned) {
  ReferenceOptions log = reference(40, Radii::log, 0.3);
  log.speed = 0.7;
  const std::map<std::string, Scene> scenes{
      {"uniform", generate_reference(reference(40, Radii::uniform, 0.05))},
      {"log", generate_reference(log)},
      {"equal", generate_reference(reference(40, Radii::equal, 0.4))},
      {"grid", generate_grid(grid(20, Motion::random))},
      {"shear", generate_grid(grid(20, Motion::shear))},
      {"swarm", generate_swarm(swarm(20))}};
  const std::map<std::string, std::string> pinned{
      {"uniform", "f6dff8c203987c949bbc3de8c81dcaabf50da7bfec5e14dae23bd8cfd87b0deb"},
      {"log", "80b2ae540fa44111408cb6bdaf71388ead27b1c1f7a130273ae797ad618dda56"},
      {"equal", "cb037fdf091583ba342e6370c811baf15d07346bf1c1abfe5cfd28e6ad891886"},
      {"grid", "f0657b1244ca88460bed99e2bdd2b1555cd0ba33210de2ca065c692edc6cdf2a"},
      {"shear", "300e6ead248b43a1f082d8c88f4edb266febb39956dbf46721f5873dcdb2c12b"},
      {"swarm", "7a76ee1126b08fb0269e8a99d0e5d094438a56a09a17a71f0c7c217ff1af2eb9"}};
  for (const auto& [name, scene] : scenes)
    EXPECT_EQ(sha256_hex(bytes(scene)), pinned.at(name)) << name;
}

// Section 7.1, member by member.
TEST(PaperSets, AreThoseOfThePaper) {
  for (int k = 1; k <= 10; ++k) {
    EXPECT_EQ(paper_set_member("reference", k).n, 1000 * k);
    EXPECT_EQ(paper_set_member("speed", k).speed, k);
    EXPECT_EQ(paper_set_member("size", k).rmax, k);
    EXPECT_DOUBLE_EQ(paper_set_member("density", k).density, 0.05 * k);
    for (const std::string name : {"reference", "speed", "size", "density"}) {
      const ReferenceOptions o = paper_set_member(name, k);
      EXPECT_EQ(o.rmin, 1);
      EXPECT_EQ(o.horizon, 1000);
      EXPECT_EQ(o.restitution, 1);
      EXPECT_TRUE(name == "reference" || o.n == 1000);
      EXPECT_TRUE(name == "speed" || o.speed == 1);
      EXPECT_TRUE(name == "size" || o.rmax == 10);
      EXPECT_TRUE(name == "density" || o.density == 0.05);
    }
  }
  for (int k = 1; k <= 5; ++k) {
    EXPECT_EQ(paper_set_member("restitution", k).restitution, (5 + k) / 10.0);
    EXPECT_EQ(paper_set_member("restitution", k).n, 300);
  }
  EXPECT_THROW(paper_set_member("restitution", 6), std::invalid_argument);
  EXPECT_THROW(paper_set_member("speed", 0), std::invalid_argument);
  EXPECT_THROW(paper_set_member("colour", 1), std::invalid_argument);
}

}  // namespace
}  // namespace voroproof::internal
