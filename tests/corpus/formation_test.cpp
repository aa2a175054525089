// Formation flights: where the disks are, that they never touch, and the bytes of the scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "corpus/formations.h"
#include "corpus/generate.h"
#include "history/scene_writer.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

const std::vector<std::string> all_formations{"square", "staggered", "frame", "circle",
                                              "rings",  "h",         "y"};

std::string bytes(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return out.str();
}

Rational square(const Rational& q) { return q * q; }
Rational distance2(const Point2& p, const Point2& q) {
  return square(p.x - q.x) + square(p.y - q.y);
}
bool before(const Point2& p, const Point2& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

FormationOptions flight(int n, std::vector<std::string> route) {
  FormationOptions options;
  options.n = n;
  options.flight = std::move(route);
  return options;
}

// Where the disks are at the start and at each instant of maneuvers, by the motion of the scene.
struct Stops {
  std::vector<Rational> times{0};
  std::vector<std::vector<Point2>> places;
  std::vector<Point2> last_velocities;
};

Stops stops_of(const Scene& s) {
  Stops stops;
  stops.places.emplace_back();
  for (const DiskInput& d : s.disks) {
    stops.places.back().push_back({d.x, d.y});
    stops.last_velocities.push_back({d.vx, d.vy});
  }
  for (const Maneuver& m : s.maneuvers) {
    if (m.t != stops.times.back()) {
      const Rational dt = m.t - stops.times.back();
      std::vector<Point2> here = stops.places.back();
      for (std::size_t i = 0; i < here.size(); ++i) {
        here[i].x += dt * stops.last_velocities[i].x;
        here[i].y += dt * stops.last_velocities[i].y;
      }
      stops.times.push_back(m.t);
      stops.places.push_back(std::move(here));
    }
    stops.last_velocities[m.disk] = {m.vx, m.vy};
  }
  return stops;
}

// The least square of a distance of two disks over all time.
Rational least_distance2(const Scene& s) {
  const Stops stops = stops_of(s);
  Rational least = -1;
  for (std::size_t k = 0; k < stops.places.size(); ++k) {
    const auto& from = stops.places[k];
    const auto& to = stops.places[std::min(k + 1, stops.places.size() - 1)];
    for (std::size_t i = 0; i < from.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Rational x = from[i].x - from[j].x, y = from[i].y - from[j].y;
        const Rational u = to[i].x - to[j].x - x, v = to[i].y - to[j].y - y;
        const Rational length = u * u + v * v;
        Rational s_nearest = 0;
        if (length != 0) s_nearest = std::clamp<Rational>(-(x * u + y * v) / length, 0, 1);
        const Rational d = square(x + s_nearest * u) + square(y + s_nearest * v);
        if (least < 0 || d < least) least = d;
      }
    }
  }
  return least;
}

TEST(Formations, PlacesAreASpacingApart) {
  for (const std::string& name : all_formations) {
    for (const int n : {0, 1, 2, 3, 4, 5, 7, 8, 9, 19, 20, 25, 58, 100}) {
      const std::vector<Point2> places = formation_places(name, n, Rational(5, 3));
      ASSERT_EQ(places.size(), static_cast<std::size_t>(n));
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GE(distance2(places[i], places[j]), square(Rational(5, 3))) << name << n;
      }
    }
  }
}

TEST(Formations, CirclesAreExact) {
  for (const int n : {1, 2, 8, 20, 45, 200}) {
    const auto circle = formation_places("circle", n, 5);
    for (const Point2& p : circle) EXPECT_EQ(distance2(p, {}), distance2(circle[0], {}));
  }
  // 1 + 8 + 16 + 24, and one more.
  const auto rings = formation_places("rings", 50, 5);
  EXPECT_EQ(distance2(rings[0], {}), 0);
  for (int i = 1; i < 50; ++i) {
    const int ring = i < 9 ? 1 : i < 25 ? 2 : i < 49 ? 3 : 4;
    EXPECT_EQ(distance2(rings[i], {}), ring * ring * distance2(rings[1], {}));
  }
}

// Mirrored in both axes and, but for the letters, turned by a right angle.
TEST(Formations, AreSymmetric) {
  const auto image_is_itself = [](const std::string& name, int n, auto map) {
    std::vector<Point2> places = formation_places(name, n, 5), image;
    for (const Point2& p : places) image.push_back(map(p));
    std::sort(places.begin(), places.end(), before);
    std::sort(image.begin(), image.end(), before);
    return std::equal(places.begin(), places.end(), image.begin(),
                      [](auto p, auto q) { return p.x == q.x && p.y == q.y; });
  };
  const auto mirror = [](const Point2& p) -> Point2 { return {-p.x, p.y}; };
  const auto quarter = [](const Point2& p) -> Point2 { return {-p.y, p.x}; };
  for (const auto& [name, n] : std::vector<std::pair<std::string, int>>{
           {"square", 49}, {"frame", 20}, {"circle", 20}, {"circle", 16}, {"rings", 49}}) {
    EXPECT_TRUE(image_is_itself(name, n, mirror)) << name << n;
    EXPECT_TRUE(image_is_itself(name, n, quarter)) << name << n;
  }
  for (const std::string letter : {"h", "y"}) {
    EXPECT_TRUE(image_is_itself(letter, 19, mirror));
    EXPECT_FALSE(image_is_itself(letter, 19, quarter));
  }
}

TEST(Formations, ThereAreNotEndlesslyManyPointsOnACircle) {
  EXPECT_NO_THROW(formation_places("circle", 1000, 5));
  EXPECT_THROW(formation_places("circle", 5000, 5), std::invalid_argument);
  EXPECT_THROW(formation_places("triangle", 5, 5), std::invalid_argument);
}

TEST(GenerateFormation, ArrivesInFormationAndStops) {
  for (const std::string& name : all_formations) {
    const Scene s = generate_formation(flight(30, {"square", "east", name, "north"}));
    const Stops stops = stops_of(s);
    ASSERT_EQ(stops.places.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(stops.times[k], s.horizon * k / 4);
    for (const Point2& v : stops.last_velocities) EXPECT_TRUE(v.x == 0 && v.y == 0);
    std::vector<Point2> arrived = stops.places[2], expected = formation_places(name, 30, 5);
    for (Point2& p : expected) p.x += 20;
    std::sort(arrived.begin(), arrived.end(), before);
    std::sort(expected.begin(), expected.end(), before);
    for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(distance2(arrived[i], expected[i]), 0) << name;
    for (std::size_t i = 0; i < 30; ++i) {
      EXPECT_EQ(stops.places[3][i].x, stops.places[2][i].x);
      EXPECT_EQ(stops.places[3][i].y, stops.places[2][i].y + 20);
    }
  }
}

TEST(GenerateFormation, MovesTheSwarmAboutItsCentre) {
  const Scene s =
      generate_formation(flight(9, {"square", "west", "turn", "shear", "spread", "rest"}));
  const Stops stops = stops_of(s);
  const auto relative = [&](std::size_t k, std::size_t i) -> Point2 {
    return {stops.places[k][i].x - stops.places[k][4].x,
            stops.places[k][i].y - stops.places[k][4].y};
  };
  for (std::size_t k = 1; k < 6; ++k) {
    EXPECT_EQ(stops.places[k][4].x, -20);
    EXPECT_EQ(stops.places[k][4].y, 0);
  }
  for (std::size_t i = 0; i < 9; ++i) {
    const Point2 start = relative(1, i), turned = relative(2, i), sheared = relative(3, i),
                 spread = relative(4, i), rested = relative(5, i);
    EXPECT_EQ(distance2(turned, {(3 * start.x - 4 * start.y) / 5, (4 * start.x + 3 * start.y) / 5}),
              0);
    EXPECT_EQ(distance2(sheared, {turned.x + 3 * turned.y / 4, turned.y}), 0);
    EXPECT_EQ(distance2(spread, {3 * sheared.x / 2, 3 * sheared.y / 2}), 0);
    EXPECT_EQ(distance2(rested, spread), 0);
  }
}

// CAPT's bound, and the motion itself.
TEST(GenerateFormation, NobodyCollides) {
  for (const std::string& from : all_formations) {
    for (const std::string& to : all_formations) {
      for (const int n : {2, 19, 33}) {
        FormationOptions options = flight(n, {from, "turn", to});
        options.radius = 1.767;  // 5 / (2 sqrt 2), nearly
        const Rational least = least_distance2(generate_formation(options));
        EXPECT_GT(least, square(2 * to_rational(options.radius))) << from << ' ' << to << ' ' << n;
      }
    }
  }
}

TEST(GenerateFormation, RefusesAFlightWithCollisions) {
  FormationOptions options = flight(25, {"square", "turn", "shear"});
  EXPECT_NO_THROW(generate_formation(options));
  options.radius = 2.4;
  EXPECT_THROW(generate_formation(options), std::invalid_argument);
}

TEST(GenerateFormation, IsValid) {
  for (const int n : {0, 1, 2, 3, 40}) {
    FormationOptions options = flight(n, {"h", "turn", "turn", "rings"});
    options.spacing = 4.3;
    options.horizon = 10;
    const Scene s = generate_formation(options);
    const Scene read = parse_scene(bytes(s), "generated");
    EXPECT_EQ(bytes(read), bytes(s));
    EXPECT_EQ(read.maneuvers.size(), static_cast<std::size_t>(3 * n));
    EXPECT_FALSE(s.seed.has_value());
  }
}

// The presets need no fractions: an engine that computes in doubles starts from the same scene.
TEST(GenerateFormation, PresetsAreOfBinary64) {
  const std::map<std::string, int> sizes{{"figure24", 20},
                                         {"h-to-y", 19},
                                         {"segments58", 58},
                                         {"drones1218", 1218},
                                         {"drones2018", 2018}};
  for (const auto& [name, n] : sizes) {
    const Scene s = generate_formation(formation_preset(name));
    EXPECT_EQ(s.disks.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(bytes(s).find('/'), std::string::npos) << name;
  }
  EXPECT_THROW(formation_preset("figure25"), std::invalid_argument);
}

TEST(GenerateFormation, PresetsFlyApart) {
  for (const std::string name : {"figure24", "h-to-y", "segments58"})
    EXPECT_GE(least_distance2(generate_formation(formation_preset(name))), Rational(25, 2));
}

TEST(GenerateFormation, RefusesOptionsWithoutMeaning) {
  const auto refused = [](auto change) {
    FormationOptions options;
    change(options);
    EXPECT_THROW(generate_formation(options), std::invalid_argument);
  };
  refused([](auto& o) { o.n = -1; });
  refused([](auto& o) { o.n = max_formation_disks + 1; });
  refused([](auto& o) { o.flight = {}; });
  refused([](auto& o) { o.flight = {"east", "circle"}; });
  refused([](auto& o) { o.flight = {"circle", "somewhere"}; });
  refused([](auto& o) { o.spacing = 2; });
  refused([](auto& o) { o.radius = 0; });
  refused([](auto& o) { o.horizon = 0; });
}

// The same bytes on every platform, as in generate_test.cpp.
TEST(GenerateFormation, BytesArePinned) {
  const std::map<std::string, std::string> pinned{
      {"figure24", "d1e95637df48edb3794d2c994db5142937890b0fe4225f6cdc3f608e30942933"},
      {"h-to-y", "5e31dc59f4ca522cab7d58f7de59230cfa629b006990a1cbff94254fe4108175"},
      {"segments58", "d89c924cb2a01e8b4d3ccc75c8bd1d15f087fafcd1d2ccbae2baab14cd7e1795"},
      {"drones1218", "c7636b619bf9ae4f61e88099c438ef8df97251076307b469822fc50bd13ffa45"},
      {"drones2018", "d27be1e167542563775ff9860bb794430eeb38538a00287f6c54453b798e9e4e"}};
  for (const auto& [name, hash] : pinned)
    EXPECT_EQ(sha256_hex(bytes(generate_formation(formation_preset(name)))), hash) << name;
}

}  // namespace
}  // namespace voroproof::internal
