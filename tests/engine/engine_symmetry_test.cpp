// What must not change a history, or must change it in a known way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "tests/support/compact_arithmetic.h"
#include "tests/support/random_scenes.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::testing {
namespace {

std::vector<Scene> some_scenes() {
  Random random(11);
  std::vector<Scene> scenes;
  for (int k = 0; k < 3; ++k) {
    scenes.push_back(random_scene({.n = 8, .horizon = 20, .maneuvers = 4}, random));
    scenes.push_back(random_scene({.n = 7, .rmin = 5, .rmax = 5, .horizon = 20}, random));
    scenes.push_back(
        random_scene({.n = 10, .rmin = 0.1, .rmax = 20, .horizon = 15, .density = 0.2}, random));
  }
  return scenes;
}

// Expects the same events in the same order, with times scaled by `factor` (but for their
// rounding).
void expect_corresponding(const RecordedRun& a, const RecordedRun& b, double factor,
                          const std::string& message) {
  ASSERT_TRUE(a.complete() && b.complete()) << message;
  EXPECT_EQ(a.initial, b.initial) << message;
  EXPECT_EQ(names(a), names(b)) << message;
  EXPECT_GT(a.events.size(), 3u);
  for (std::size_t k = 0; k < std::min(a.events.size(), b.events.size()); ++k) {
    EXPECT_NEAR(b.events[k].t, factor * a.events[k].t, 1e-15 * factor * a.events[k].t) << message;
  }
}

Scene transformed(const Scene& scene, const std::function<void(Rational&, Rational&)>& point,
                  const std::function<void(Rational&, Rational&)>& velocity, const Rational& length,
                  const Rational& time) {
  Scene image = scene;
  point(image.cx, image.cy);
  image.container_radius *= length;
  image.horizon *= time;
  for (DiskInput& d : image.disks) {
    change_both(d.x, d.y, point);
    change_both(d.vx, d.vy, velocity);
    d.radius *= length;
  }
  for (Maneuver& m : image.maneuvers) {
    velocity(m.vx, m.vy);
    m.t *= time;
  }
  return image;
}

TEST(EngineSymmetry, RotationByARationalAngle) {
  const auto rotate = [](Rational& x, Rational& y) {
    const Rational turned = (3 * x - 4 * y) / 5;
    y = (4 * x + 3 * y) / 5;
    x = turned;
  };
  for (const Scene& scene : some_scenes()) {
    expect_corresponding(run(scene), run(transformed(scene, rotate, rotate, 1, 1)), 1, text(scene));
  }
}

TEST(EngineSymmetry, TranslationScalingAndTempo) {
  const Rational length(7, 3), time(5, 4);
  const auto point = [&](Rational& x, Rational& y) {
    x = x * length + Rational(1000, 7);
    y = y * length - 17;
  };
  const auto velocity = [&](Rational& x, Rational& y) {
    x *= length / time;
    y *= length / time;
  };
  for (const Scene& scene : some_scenes()) {
    expect_corresponding(run(scene), run(transformed(scene, point, velocity, length, time)), 1.25,
                         text(scene));
  }
}

// A reflection turns every orientation.
TEST(EngineSymmetry, Reflection) {
  const auto mirror = [](Rational&, Rational& y) { y = -y; };
  for (const Scene& scene : some_scenes()) {
    const RecordedRun a = run(scene), b = run(transformed(scene, mirror, mirror, 1, 1));
    ASSERT_EQ(a.events.size(), b.events.size());
    for (std::size_t k = 0; k < a.events.size(); ++k) {
      EXPECT_EQ(a.events[k].t, b.events[k].t);
      ASSERT_EQ(a.events[k].kind, b.events[k].kind);
      if (a.events[k].kind != Event::Kind::flip) continue;
      // Left becomes right.
      const Quad q = a.events[k].edge;
      EXPECT_EQ(b.events[k].edge, canonical(Quad{q.r, q.l, q.s, q.e})) << text(scene);
    }
  }
}

TEST(EngineSymmetry, PermutedIds) {
  Random random(12);
  for (const Scene& scene : some_scenes()) {
    const int n = static_cast<int>(scene.disks.size());
    std::vector<int> image(static_cast<std::size_t>(n));
    std::iota(image.begin(), image.end(), 0);
    std::shuffle(image.begin(), image.end(), random);
    const auto of = [&](GenId g) {
      return g == container_id ? container_id : image[static_cast<std::size_t>(g)];
    };
    Scene permuted = scene;
    for (int g = 0; g < n; ++g) {
      permuted.disks[static_cast<std::size_t>(of(g))] = scene.disks[static_cast<std::size_t>(g)];
    }
    for (Maneuver& m : permuted.maneuvers) m.disk = of(m.disk);
    const RecordedRun a = run(scene), b = run(permuted);
    ASSERT_EQ(a.events.size(), b.events.size()) << text(scene);
    for (std::size_t k = 0; k < a.events.size(); ++k) {
      const Event &x = a.events[k], &y = b.events[k];
      EXPECT_EQ(x.t, y.t);
      ASSERT_EQ(x.kind, y.kind);
      if (x.kind == Event::Kind::flip) {
        const Quad q = x.edge;
        EXPECT_EQ(y.edge, canonical(Quad{of(q.l), of(q.r), of(q.s), of(q.e)}));
      } else {
        EXPECT_EQ(std::minmax(of(x.i), of(x.j)), std::minmax(y.i, y.j));
      }
    }
  }
}

// Up to the first collision or maneuver every state is rational: a run from any instant before
// it starts where the first run is, and goes on as it does.
TEST(EngineSymmetry, SplitAtAnInstant) {
  Random random(13);
  std::size_t later = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const Scene scene = random_scene({.n = 10, .rmin = 0.1, .rmax = 2, .horizon = 20}, random);
    const RecordedRun whole = run(scene);
    const auto first = std::find_if(whole.events.begin(), whole.events.end(),
                                    [](const Event& e) { return e.kind != Event::Kind::flip; });
    ASSERT_NE(first, whole.events.end());
    const Rational split = to_rational(first->t) * Rational(2, 3);
    Scene rest = scene;
    rest.horizon -= split;
    for (DiskInput& d : rest.disks) {
      d.x += split * d.vx;
      d.y += split * d.vy;
    }
    const RecordedRun second = run(rest);
    ASSERT_TRUE(whole.complete() && second.complete());
    std::vector<std::string> expected = names(whole);
    const auto done = std::count_if(whole.events.begin(), whole.events.end(),
                                    [&](const Event& e) { return to_rational(e.t) <= split; });
    expected.erase(expected.begin(), expected.begin() + done);
    EXPECT_EQ(names(second), expected) << text(scene);
    EXPECT_EQ(second.final_diagram, whole.final_diagram) << text(scene);
    for (std::size_t k = 0; k < second.events.size(); ++k) {
      const Event& e = whole.events[k + static_cast<std::size_t>(done)];
      EXPECT_NEAR(second.events[k].t, e.t - split.get_d(), 1e-14);
    }
    later += second.events.size();
  }
  EXPECT_GT(later, 100u);
}

// Without collisions the way back passes the same flips, inverted, in reverse order.
TEST(EngineSymmetry, TimeReversal) {
  Random random(14);
  std::size_t flips = 0;
  for (int trial = 0; trial < 12; ++trial) {
    Scene scene = random_scene({.n = 8, .rmin = 0.1, .rmax = 2, .horizon = 20}, random);
    const RecordedRun first_try = run(scene);
    for (const Event& e : first_try.events) {
      if (e.kind != Event::Kind::flip) {
        scene.horizon = to_rational(e.t) * Rational(9, 10);
        break;
      }
    }
    const RecordedRun there = run(scene);
    Scene way_back = scene;
    for (DiskInput& d : way_back.disks) {
      d.x += scene.horizon * d.vx;
      d.y += scene.horizon * d.vy;
      d.vx = -d.vx;
      d.vy = -d.vy;
    }
    const RecordedRun back = run(way_back);
    ASSERT_EQ(there.events.size(), back.events.size()) << text(scene);
    EXPECT_EQ(there.final_diagram, back.initial);
    EXPECT_EQ(there.initial, back.final_diagram);
    for (std::size_t k = 0; k < there.events.size(); ++k) {
      const Event &e = there.events[k], &b = back.events[there.events.size() - 1 - k];
      ASSERT_EQ(e.kind, Event::Kind::flip);
      EXPECT_EQ(b.edge, canonical(flipped(e.edge))) << text(scene);
      EXPECT_NEAR(b.t, scene.horizon.get_d() - e.t, 1e-13);
      ++flips;
    }
  }
  EXPECT_GT(flips, 30u);
}

// Every written number is correctly rounded, so neither the precision inside nor the filters
// can be seen in a history.
TEST(EngineSymmetry, PrecisionInsideIsInvisible) {
  for (const Scene& scene : some_scenes()) {
    const RecordedRun reference = run(scene);
    for (int bits : {64, 512, 4096}) {
      MotionOptions options;
      options.start_bits = bits;
      EXPECT_EQ(difference(reference, run(scene, options)), "") << bits << text(scene);
    }
  }
}

// Mirror images in pairs have flip polynomials with double roots, each beyond an event that comes
// first: balls leave them for later as double-doubles do.
TEST(EngineSymmetry, FiltersAreInvisibleInAMirror) {
  Scene scene;
  scene.container_radius = 16;
  scene.horizon = 8;
  for (const int side : {1, -1}) {
    for (const auto& [x, y, r, vy] : {std::array<Rational, 4>{{{69, 8}, {21, 4}, {3, 4}, {7, 4}}},
                                      std::array<Rational, 4>{{7, {67, 8}, {1, 2}, {5, 4}}}}) {
      DiskInput d;
      d.x = Rational(side * x);
      d.y = y;
      d.radius = r;
      d.vx = Rational(Rational(-3, 4) * side);
      d.vy = vy;
      d.mass = Rational(r * r);
      scene.disks.push_back(d);
    }
  }
  MotionOptions options;
  options.filters = false;
  const RecordedRun a = run(scene), b = run(scene, options);
  EXPECT_TRUE(b.complete()) << b.outcome.reason;
  EXPECT_EQ(difference(a, b), "");
  EXPECT_EQ(a.count(Event::Kind::collision), 8u);
}

TEST(EngineSymmetry, FiltersAreInvisible) {
  const std::vector<Scene> scenes = some_scenes();
  for (std::size_t k = 0; k < 3; ++k) {
    Scene scene = scenes[k];
    scene.horizon /= 2;
    MotionOptions options;
    options.filters = false;
    const RecordedRun a = run(scene), b = run(scene, options);
    EXPECT_EQ(difference(a, b), "") << text(scene);
    const auto& searches = b.stats.tiers.decided[static_cast<int>(Predicate::flip_search)];
    EXPECT_EQ(searches[static_cast<int>(Tier::filter)] + searches[static_cast<int>(Tier::dd)], 0u);
    EXPECT_GT(searches[static_cast<int>(Tier::ball)], 0u);
  }
}

}  // namespace
}  // namespace voroproof::internal::testing
