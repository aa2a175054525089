#include "tests/metamorphic/scenes.h"

#include <algorithm>
#include <cmath>

#include "corpus/generate.h"
#include "exact/rational.h"
#include "tests/support/compact_arithmetic.h"
#include "tests/support/correspondence.h"
#include "tests/support/scene_run.h"

namespace voroproof::internal::metamorphic {
Rational power_of_two(int exponent) {
  Rational x = 1;
  if (exponent < 0) {
    x >>= static_cast<mp_bitcnt_t>(-exponent);
  } else {
    x <<= static_cast<mp_bitcnt_t>(exponent);
  }
  return x;
}

namespace {

using adversary::Random;
using testing::disk;

// With so many bits after the point.
Rational dyadic(Random& random, double low, double high, int bits = 12) {
  return to_rational(std::ldexp(std::round(std::ldexp(random.uniform(low, high), bits)), -bits));
}

// Of length 1; from a slope, which may be tiny.
Point2 unit_vector(const Rational& slope) {
  const Rational square = slope * slope;
  return {(1 - square) / (1 + square), 2 * slope / (1 + square)};
}

Point2 unit_vector(Random& random) {
  Point2 u = unit_vector(Rational(random.integer(-16, 16), random.integer(1, 16)));
  if (random.chance(0.5)) u.x = -u.x;
  return u;
}

Point2 along(const Point2& from, const Rational& length, const Point2& direction) {
  return {from.x + length * direction.x, from.y + length * direction.y};
}

Rational mass_of(const Rational& radius) {
  return sgn(radius) == 0 ? Rational(1) : radius * radius;
}

bool is_free(const Scene& s, const DiskInput& d) {
  const Rational room = s.container_radius - d.radius;
  const auto square = [](const Rational& x, const Rational& y) { return Rational(x * x + y * y); };
  if (sgn(room) <= 0 || square(d.x - s.cx, d.y - s.cy) >= room * room) return false;
  return std::all_of(s.disks.begin(), s.disks.end(), [&](const DiskInput& o) {
    const Rational reach = d.radius + o.radius;
    return square(d.x - o.x, d.y - o.y) > reach * reach;
  });
}

// Adds disks at random places until there are so many; their radii are of `radius`.
template <class Radius>
void fill(Scene& s, std::size_t count, const Radius& radius, Random& random) {
  const double far = s.container_radius.get_d();
  for (int attempt = 0; attempt < 300 && s.disks.size() < count; ++attempt) {
    const Rational r = radius();
    const DiskInput d = disk(dyadic(random, -far, far), dyadic(random, -far, far), r,
                             dyadic(random, -2, 2), dyadic(random, -2, 2), mass_of(r));
    if (is_free(s, d)) s.disks.push_back(d);
  }
}

Scene empty(int radius, const Rational& horizon) { return testing::scene_of(radius, horizon, {}); }

// At time `when` all disks touch one circle of radius c, which touches the wall.
struct Tie {
  Point2 contact;  // of the circle with the wall, as a direction
  Rational c, when;
};

Tie random_tie(Random& random, const Rational& c, int when) {
  return {unit_vector(random), c, when};
}

// A disk that touches the tie's circle in this direction at the tie's time.
bool add_tied(Scene& s, const Tie& tie, const Point2& direction, const Rational& r,
              Random& random) {
  const Point2 middle = along({s.cx, s.cy}, s.container_radius - tie.c, tie.contact);
  const Point2 then = along(middle, tie.c + r, direction);
  const Rational vx = dyadic(random, -2, 2, 5), vy = dyadic(random, -2, 2, 5);
  const DiskInput d = disk(then.x - tie.when * vx, then.y - tie.when * vy, r, vx, vy, mass_of(r));
  const bool free = is_free(s, d);
  if (free) s.disks.push_back(d);
  return free;
}

template <class Radius>
void add_tied_disks(Scene& s, const Tie& tie, std::size_t count, const Radius& radius,
                    Random& random) {
  for (int attempt = 0; attempt < 60 && s.disks.size() < count; ++attempt) {
    add_tied(s, tie, unit_vector(random), radius(), random);
  }
}

Rational quarters(Random& random, int low, int high) {
  return Rational(random.integer(low, high), 4);
}

// Disks and wall have a common tangent circle at 0 or later.
Scene wall_tie(Random& random) {
  const int when = random.chance(0.6) ? 0 : random.integer(1, 2);
  Scene s = empty(16, when + quarters(random, 1, 8));
  const Tie tie = random_tie(random, quarters(random, 4, 32), when);
  add_tied_disks(
      s, tie, static_cast<std::size_t>(random.integer(3, 4)),
      [&] { return quarters(random, 1, 6); }, random);
  if (random.chance(0.3)) {
    fill(
        s, s.disks.size() + 1, [&] { return quarters(random, 1, 4); }, random);
  }
  return s;
}

// All times divided by a power of two, and all velocities multiplied by it.
Scene faster(const Scene& s, int exponent) {
  testing::Image image;
  image.time = power_of_two(-exponent);
  return testing::image_of(s, image);
}

// The same at great speed.
Scene fast_tie(Random& random) { return faster(wall_tie(random), random.integer(40, 100)); }

// The same, and all come to rest after a moment; then nothing happens for long, or little.
Scene kick(Random& random) {
  Scene s = fast_tie(random);
  const Rational end = s.horizon;
  for (std::size_t k = 0; k < s.disks.size(); ++k) {
    const bool rests = random.chance(0.7);
    s.maneuvers.push_back({end, static_cast<int>(k), rests ? Rational(0) : dyadic(random, -1, 1),
                           rests ? Rational(0) : dyadic(random, -1, 1)});
  }
  s.horizon = random.chance(0.5) ? 1000 : 4;
  return s;
}

// Tiny disks near the wall in an ordinary container.
Scene tiny_tie(Random& random) {
  const int unit = random.integer(-80, -50);
  Scene s = empty(32, Rational(1, 64));
  const Tie tie = random_tie(random, random.integer(1, 64) * power_of_two(unit), 0);
  add_tied_disks(
      s, tie, static_cast<std::size_t>(random.integer(3, 4)),
      [&] { return Rational(random.integer(1, 64) * power_of_two(unit)); }, random);
  return s;
}

// Of a tie one disk is off by a hair.
Scene near_tie(Random& random) {
  Scene s = random.chance(0.5) ? wall_tie(random) : tiny_tie(random);
  if (s.disks.empty()) return s;
  DiskInput& d =
      s.disks[static_cast<std::size_t>(random.integer(0, static_cast<int>(s.disks.size()) - 1))];
  d.x += random.integer(-8, 8) * power_of_two(-random.integer(30, 110));
  return s;
}

// Almost a point, between the wall and the tie's circle, that touches the wall at nearly the time
// of the tie.
Scene hair_at_the_wall(Random& random) {
  Scene s = empty(32, Rational(65, 64));
  const Tie tie = random_tie(random, quarters(random, 8, 60), 1);
  const int narrow = random.integer(16, 32);
  const Point2 near = unit_vector(random.integer(1, 3) * power_of_two(-narrow));
  const Point2 u = tie.contact;
  const Point2 direction{near.x * u.x - near.y * u.y, near.x * u.y + near.y * u.x};
  const int tiny = random.integer(-2 * narrow - 3, -2 * narrow + 2);
  add_tied(s, tie, direction, random.chance(0.2) ? Rational(0) : power_of_two(tiny), random);
  add_tied_disks(
      s, tie, static_cast<std::size_t>(random.integer(3, 4)),
      [&] { return Rational(random.integer(8, 64), 64); }, random);
  return s;
}

Scene points(Random& random) {
  Scene s = empty(16, random.integer(2, 6));
  fill(
      s, static_cast<std::size_t>(random.integer(2, 6)),
      [&] { return random.chance(0.5) ? Rational(0) : dyadic(random, 0.5, 2.5); }, random);
  return s;
}

// Radii that differ by a relative hair.
Scene near_radii(Random& random) {
  Scene s = empty(16, random.integer(2, 6));
  const Rational hair = to_rational(random.log_uniform(1e-15, 1e-9));
  const Rational r = dyadic(random, 0.5, 1.5);
  fill(
      s, static_cast<std::size_t>(random.integer(3, 7)),
      [&] { return Rational(r + (random.integer(0, 3) * hair)); }, random);
  return s;
}

Scene wide_ratios(Random& random) {
  Scene s = empty(16, random.integer(2, 6));
  fill(
      s, static_cast<std::size_t>(random.integer(3, 7)),
      [&] { return to_rational(random.log_uniform(3e-6, 3)); }, random);
  return s;
}

// Many maneuvers within a moment, some of them at one time.
Scene burst(Random& random) {
  Scene s = random.chance(0.5) ? points(random) : wall_tie(random);
  if (s.disks.empty()) return s;
  const Rational at = random.chance(0.3) ? Rational(0) : quarters(random, 1, 4);
  const Rational moment = power_of_two(-random.integer(8, 90));
  const int most = static_cast<int>(s.disks.size()) - 1;
  for (int k = random.integer(4, 20); k > 0; --k) {
    s.maneuvers.push_back({at + random.integer(0, 12) * moment, random.integer(0, most),
                           dyadic(random, -2, 2, 6), dyadic(random, -2, 2, 6)});
  }
  return s;
}

// Nothing moves until late.
Scene late(Random& random) {
  Scene s = empty(16, 0);
  fill(
      s, static_cast<std::size_t>(random.integer(3, 5)), [&] { return dyadic(random, 0.25, 2); },
      random);
  const Rational begin = power_of_two(random.integer(10, 28)) + quarters(random, 0, 3);
  for (std::size_t k = 0; k < s.disks.size(); ++k) {
    DiskInput& d = s.disks[k];
    s.maneuvers.push_back({begin + quarters(random, 0, 4), static_cast<int>(k), d.vx, d.vy});
    d.vx = d.vy = 0;
  }
  s.horizon = begin + random.integer(3, 8);
  return s;
}

Scene grid(Random& random) {
  using Motion = GridOptions::Motion;
  const Motion motions[] = {Motion::rest, Motion::common, Motion::random, Motion::shear};
  return generate_grid({.n = random.integer(3, 7),
                        .seed = static_cast<std::uint64_t>(random.integer(1, 1 << 20)),
                        .motion = motions[random.integer(0, 3)],
                        .horizon = static_cast<double>(random.integer(1, 4))});
}

Scene swarm(Random& random) {
  return generate_swarm({.n = random.integer(3, 6),
                         .seed = static_cast<std::uint64_t>(random.integer(1, 1 << 20)),
                         .horizon = static_cast<double>(random.integer(4, 16))});
}

}  // namespace

const std::vector<SceneFamily>& scene_families() {
  static const std::vector<SceneFamily> families{
      {"wall tie", false, wall_tie},
      {"fast tie", false, fast_tie},
      {"kick", false, kick},
      {"tiny tie", false, tiny_tie},
      {"near tie", false, near_tie},
      {"hair at the wall", false, hair_at_the_wall},
      {"dyadic points", true, points},
      {"near radii", true, near_radii},
      {"wide ratios", true, wide_ratios},
      {"burst", false, burst},
      {"late", true, late},
      {"grid", false, grid},
      {"swarm", false, swarm},
  };
  return families;
}

}  // namespace voroproof::internal::metamorphic
