#include "tests/adversary/families.h"

#include <algorithm>
#include <numbers>

#include "tests/adversary/round_scenes.h"
#include "tests/adversary/truth.h"

namespace voroproof::internal::adversary {
namespace {

Pair2 direction(Random& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}

bool is_free(const SceneData& s, const DiskData& d, double room) {
  if (std::hypot(d.x - s.cx, d.y - s.cy) + d.radius > s.radius - room) return false;
  return std::all_of(s.disks.begin(), s.disks.end(), [&](const DiskData& o) {
    return std::hypot(d.x - o.x, d.y - o.y) > d.radius + o.radius + room;
  });
}

// Puts a disk of this radius at a random place that is free, with a random velocity.
bool add_disk(SceneData& s, double radius, double speed, Random& random) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    const Pair2 d = direction(random), v = direction(random);
    const double far = (s.radius - radius) * std::sqrt(random.uniform(0, 1));
    const double fast = random.uniform(0, 2 * speed);
    const DiskData disk{s.cx + far * d[0], s.cy + far * d[1], radius,
                        fast * v[0],       fast * v[1],       radius == 0 ? 1 : radius * radius};
    if (!is_free(s, disk, 1e-9 * s.radius)) continue;
    s.disks.push_back(disk);
    return true;
  }
  return false;
}

// Two disks that would meet at time t with the given least distance of their centres.
bool add_meeting_pair(SceneData& s, double r0, double r1, double t, double speed, double least,
                      Random& random) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    const Pair2 at = direction(random), v0 = direction(random), v1 = direction(random);
    const double far = 0.7 * s.radius * std::sqrt(random.uniform(0, 1));
    const double u0 = speed * random.uniform(0.1, 1), u1 = speed * random.uniform(0, 1);
    const Pair2 a{u0 * v0[0], u0 * v0[1]}, b{u1 * v1[0], u1 * v1[1]};
    const double wx = b[0] - a[0], wy = b[1] - a[1], w = std::hypot(wx, wy);
    if (w < 0.1 * speed) continue;
    const double x = s.cx + far * at[0], y = s.cy + far * at[1];
    const DiskData first{x - a[0] * t, y - a[1] * t, r0, a[0], a[1], r0 == 0 ? 1 : r0 * r0};
    const DiskData second{
        x - b[0] * t - wy / w * least, y - b[1] * t + wx / w * least, r1, b[0], b[1],
        r1 == 0 ? 1 : r1 * r1};
    if (!is_free(s, first, 1e-9 * s.radius)) continue;
    s.disks.push_back(first);
    if (is_free(s, second, 1e-9 * s.radius)) {
      s.disks.push_back(second);
      return true;
    }
    s.disks.pop_back();
  }
  return false;
}

void add_maneuvers(SceneData& s, int count, double speed, Random& random) {
  for (int k = 0; k < count; ++k) {
    const Pair2 v = direction(random);
    const double u = random.uniform(0, 2 * speed);
    s.maneuvers.push_back(
        {random.uniform(0, s.horizon), random.integer(0, s.size() - 1), u * v[0], u * v[1]});
  }
  std::sort(s.maneuvers.begin(), s.maneuvers.end(),
            [](const ManeuverData& a, const ManeuverData& b) { return a.t < b.t; });
}

// Disks at small integers with small integer velocities; those that touch are welcome or not.
void add_lattice(SceneData& s, int n, bool touching, Random& random) {
  s.radius = 8;
  s.horizon = random.integer(1, 6);
  const double r = touching ? (random.chance(0.5) ? 0.5 : 1) : random.chance(0.5) ? 0.25 : 0.4375;
  for (int attempt = 0; attempt < 400 && s.size() < n; ++attempt) {
    DiskData d{
        static_cast<double>(random.integer(-5, 5)), static_cast<double>(random.integer(-5, 5)), r,
        static_cast<double>(random.integer(-1, 1)), static_cast<double>(random.integer(-1, 1)), 1};
    if (touching && r == 1 && !s.disks.empty() && random.chance(0.6)) {
      const DiskData& o = s.disks[static_cast<std::size_t>(random.integer(0, s.size() - 1))];
      d.x = o.x + (random.chance(0.5) ? 2 : 0) * (random.chance(0.5) ? 1 : -1);
      d.y = o.y + (d.x == o.x ? 2 : 0) * (random.chance(0.5) ? 1 : -1);
    }
    if (std::hypot(d.x, d.y) + r >= s.radius) continue;
    const bool fits = std::all_of(s.disks.begin(), s.disks.end(), [&](const DiskData& o) {
      const double dx = d.x - o.x, dy = d.y - o.y, reach = d.radius + o.radius;
      const double gap = dx * dx + dy * dy - reach * reach;
      return touching ? gap >= 0 : gap > 0;
    });
    if (fits) s.disks.push_back(d);
  }
}

// A rectangle of equal disks, two of which touch and approach: a tie at 0 that the velocities after
// the collision decide.
void add_rectangle(SceneData& s, Random& random) {
  s.radius = 16;
  s.horizon = random.integer(1, 6);
  const double x = random.integer(-3, 3), y = random.integer(-3, 3), h = random.integer(3, 7);
  const auto velocity = [&] { return random.integer(-4, 4) / 4.0; };
  const double towards = random.integer(1, 4) / 4.0, common = velocity();
  s.disks.push_back({x - 1, y, 1, common + towards, velocity(), 1});
  s.disks.push_back({x + 1, y, 1, common - towards, velocity(), 1});
  s.disks.push_back({x - 1, y + h, 1, velocity(), velocity(), 1});
  s.disks.push_back({x + 1, y + h, 1, s.disks[2].vx, velocity(), 1});
  for (int k = random.integer(0, 2); k > 0; --k) {
    const DiskData d{static_cast<double>(random.integer(-12, 12)),
                     static_cast<double>(random.integer(-12, 12)),
                     1,
                     velocity(),
                     velocity(),
                     1};
    if (is_free(s, d, 0.01)) s.disks.push_back(d);
  }
}

void add_mirrored(SceneData& s, int pairs, Random& random) {
  s.radius = 16;
  s.horizon = random.integer(2, 8);
  for (int attempt = 0; attempt < 200 && s.size() < 2 * pairs; ++attempt) {
    const double r = random.integer(1, 8) / 8.0;
    const DiskData d{random.integer(8, 96) / 8.0, random.integer(-96, 96) / 8.0, r,
                     random.integer(-8, 8) / 4.0, random.integer(-8, 8) / 4.0,   r * r};
    if (d.x <= r || !is_free(s, d, 0.01)) continue;
    DiskData m = d;
    m.x = -d.x;
    m.vx = -d.vx;
    s.disks.push_back(d);
    if (!is_free(s, m, 0.01)) {
      s.disks.pop_back();
      continue;
    }
    s.disks.push_back(m);
  }
  if (random.chance(0.5)) {
    const DiskData d{0, random.integer(-80, 80) / 8.0, 0.5, 0, random.integer(-4, 4) / 4.0, 0.25};
    if (is_free(s, d, 0.01)) s.disks.push_back(d);
  }
}

void fill(SceneData& s, int n, double rmin, double rmax, double speed, Random& random) {
  while (s.size() < n &&
         add_disk(s, rmin == rmax ? rmax : random.log_uniform(rmin, rmax), speed, random)) {
  }
}

// Two that touch at rest; at a maneuver one is sent into the other.
void add_sent_pair(SceneData& s, Random& random) {
  const double x = random.integer(-40, 40), y = random.integer(-40, 40), r = random.integer(1, 4);
  const bool upright = random.chance(0.5);
  const Pair2 v = direction(random);
  const double common = random.chance(0.5) ? random.integer(1, 4) / 8.0 : 0;
  DiskData a{x, y, r, common, 0, r * r}, b = a;
  (upright ? b.y : b.x) += 2 * r;
  if (!is_free(s, a, 1e-6) || !is_free(s, b, 1e-6)) return;
  s.disks.push_back(a);
  s.disks.push_back(b);
  const double t = random.chance(0.3) ? 0 : random.integer(1, 16) / 8.0;
  s.maneuvers.push_back({t, s.size() - 1 - random.integer(0, 1), 3 * v[0], 3 * v[1]});
}

// A point that hits a disk head-on, both at binary numbers for as long as nothing else does: where
// nothing is restored it rests on the disk, until a maneuver sends it away.
void add_resting_point(SceneData& s, Random& random) {
  const double x = random.integer(-20, 20), y = random.integer(-20, 20), r = random.integer(1, 4);
  const double masses[] = {1, 3, 7};
  const DiskData a{x, y, r, random.integer(-1, 1) / 4.0, 0, masses[random.integer(0, 2)]};
  const bool upright = random.chance(0.5);
  const double side = random.chance(0.5) ? 1 : -1, way = r + random.integer(1, 4);
  DiskData p{x, y, 0, a.vx, a.vy, 1};
  (upright ? p.y : p.x) += side * way;
  (upright ? p.vy : p.vx) -= side;
  if (!is_free(s, a, 0.01)) return;
  s.disks.push_back(a);
  if (!is_free(s, p, 0.01)) {
    s.disks.pop_back();
    return;
  }
  s.disks.push_back(p);
  const Pair2 v = direction(random);
  const double t = random.integer(5, 20);
  if (t < s.horizon) s.maneuvers.push_back({t, s.size() - 1, v[0], v[1]});
}

// Points that meet, at binary numbers: where both graze a disk, where they hit it or the wall, or
// in the open. Some meet at the horizon, and some where one of them or the disk has a maneuver.
void add_meeting_points(SceneData& s, Random& random) {
  s.cx = s.cy = 0;
  s.radius = 16;
  const double t = random.chance(0.1) ? 0 : random.integer(1, 8) / 4.0;
  s.horizon = t == 0 || random.chance(0.4) ? t + random.integer(1, 4) / 2.0 : t;
  if (t > 0 && random.chance(0.2)) s.horizon = t + random.uniform(-2, 2) * tolerance;
  const auto quarter = [&] { return random.integer(-4, 4) / 4.0; };
  const bool wall = random.chance(0.15), open = !wall && random.chance(0.25);
  const double side = random.chance(0.5) ? 1 : -1, r = wall ? 16 : random.integer(1, 4);
  DiskData k{static_cast<double>(random.integer(-6, 6)),
             static_cast<double>(random.integer(-6, 6)),
             r,
             quarter(),
             quarter(),
             1};
  if (wall) k = {0, 0, r, 0, 0, 1};
  const auto place = [&](DiskData d) {
    d.x -= t * d.vx;
    d.y -= t * d.vy;
    s.disks.push_back(d);
  };
  if (!wall && !open) place(k);
  const bool grazes = !wall && random.chance(0.7);
  for (int n = random.chance(0.2) ? 3 : 2; n > 0; --n) {
    // The normal at the meeting leads along x, away from the disk.
    const double along = quarter(), towards = grazes ? 0 : (wall ? 1 : -1) * random.integer(1, 4);
    place({k.x + side * r, k.y, 0, k.vx + side * towards / 4, k.vy + along, 1});
  }
  if (random.chance(0.3)) {
    s.maneuvers.push_back({t, random.integer(0, s.size() - 1), quarter(), quarter()});
  }
  for (int attempt = 0, more = s.size() + random.integer(0, 3); attempt < 50; ++attempt) {
    const DiskData d{static_cast<double>(random.integer(-12, 12)),
                     static_cast<double>(random.integer(-12, 12)),
                     random.integer(0, 4) / 2.0,
                     quarter(),
                     quarter(),
                     1};
    if (s.size() < more && is_free(s, d, 0.25)) s.disks.push_back(d);
  }
}

}  // namespace

SceneData scene_of(Family family, Random& random) {
  SceneData s;
  s.cx = random.integer(-8, 8);
  s.cy = random.integer(-8, 8);
  const int few = random.integer(2, 7);
  s.horizon = random.uniform(5, 90.0 / few);
  switch (family) {
    case Family::generic:
      fill(s, few, 2, 8, 3, random);
      break;
    case Family::equal_radii:
      fill(s, few, 5, 5, 3, random);
      break;
    case Family::points:
      for (int k = 0; k < few; ++k) add_disk(s, random.chance(0.7) ? 0 : 4, 3, random);
      break;
    case Family::dense:
      s.horizon = random.uniform(1, 4);
      fill(s, random.integer(5, 9), 15, 28, 5, random);
      break;
    case Family::log_radii:
      fill(s, few, 0.01, 30, 3, random);
      break;
    case Family::two:
      s.horizon = random.uniform(20, 60);
      fill(s, 2, 3, 30, 4, random);
      break;
    case Family::maneuvers:
      fill(s, few, 2, 8, 3, random);
      add_maneuvers(s, random.integer(1, 5), 3, random);
      break;
    case Family::inelastic:
      s.restitution = random.chance(0.4) ? 0 : random.integer(1, 9) / 10.0;
      s.horizon = random.uniform(2, 8);
      fill(s, random.integer(3, 7), 8, 25, 6, random);
      break;
    case Family::wall_laws:
      s.whole = random.chance(0.5);
      s.wall_restitution = random.chance(0.3) ? 1 : random.integer(3, 9) / 10.0;
      fill(s, random.integer(2, 5), 4, 20, 8, random);
      break;
    case Family::tiny:
    case Family::tiny_fast: {
      const double speed =
          family == Family::tiny ? random.uniform(0.5, 5) : random.log_uniform(10, 1e7);
      s.horizon = random.uniform(0.3, 1) * s.radius / speed;
      for (int k = random.integer(1, 2); k > 0; --k) {
        const double r0 = random.log_uniform(1e-7, 1e-3);
        const double r1 = random.chance(0.5) ? random.log_uniform(1e-7, 1e-3) : r0;
        add_meeting_pair(s, r0, r1, random.uniform(0.1, 0.8) * s.horizon, speed,
                         random.uniform(-0.9, 0.9) * (r0 + r1), random);
      }
      fill(s, s.size() + random.integer(0, 2), 1, 8, speed, random);
      break;
    }
    case Family::fast: {
      const double speed = random.log_uniform(1e3, 1e7);
      s.horizon = random.uniform(0.5, 2) * s.radius / speed;
      fill(s, random.integer(2, 5), 1, 10, speed, random);
      break;
    }
    case Family::near_miss: {
      const double speed = random.log_uniform(1, 1000);
      s.horizon = random.uniform(0.3, 1) * s.radius / speed;
      const double r0 = random.log_uniform(0.1, 8), r1 = random.log_uniform(0.1, 8);
      const double gap = random.log_uniform(1e-9, 1e-3);
      add_meeting_pair(s, r0, r1, random.uniform(0.2, 0.8) * s.horizon, speed, r0 + r1 + gap,
                       random);
      fill(s, s.size() + random.integer(0, 3), 1, 8, speed, random);
      break;
    }
    case Family::stranger: {
      fill(s, random.integer(2, 6), 2, 10, 3, random);
      s.horizon = random.uniform(8, 25);
      const double t = random.uniform(0.01, 3), speed = random.log_uniform(1e3, 1e6);
      const Pair2 v = direction(random);
      s.maneuvers.push_back({t, 0, speed * v[0], speed * v[1]});
      s.maneuvers.push_back({t + 4e-6, 0, s.disks[0].vx, s.disks[0].vy});
      break;
    }
    case Family::lattice:
    case Family::touching:
      s.cx = s.cy = 0;
      if (family == Family::touching && random.chance(0.3)) {
        add_rectangle(s, random);
        break;
      }
      add_lattice(s, random.integer(2, 8), family == Family::touching, random);
      if (family == Family::touching && random.chance(0.3)) {
        s.maneuvers.push_back({0, random.integer(0, s.size() - 1), 1.0 * random.integer(-1, 1),
                               1.0 * random.integer(-1, 1)});
      }
      break;
    case Family::mirror:
      s.cx = s.cy = 0;
      add_mirrored(s, random.integer(1, 4), random);
      break;
    case Family::touch_maneuver:
      s.horizon = random.uniform(3, 10);
      for (int k = random.integer(1, 2); k > 0; --k) add_sent_pair(s, random);
      fill(s, s.size() + random.integer(0, 3), 2, 8, 3, random);
      std::sort(s.maneuvers.begin(), s.maneuvers.end(),
                [](const ManeuverData& a, const ManeuverData& b) { return a.t < b.t; });
      break;
    case Family::horizon_touch: {
      const double speed = random.uniform(1, 10), t = random.uniform(1, 5);
      const double r0 = random.uniform(1, 8), r1 = random.uniform(1, 8);
      if (add_meeting_pair(s, r0, r1, t, speed, random.uniform(0, 0.9) * (r0 + r1), random)) {
        const DiskData &a = s.disks[0], &b = s.disks[1];
        const double dx = b.x - a.x, dy = b.y - a.y, wx = b.vx - a.vx, wy = b.vy - a.vy;
        const double p = dx * wx + dy * wy, q = wx * wx + wy * wy;
        const double c = dx * dx + dy * dy - (r0 + r1) * (r0 + r1);
        const double contact = (-p - std::sqrt(std::max(0.0, p * p - q * c))) / q;
        s.horizon = contact + random.uniform(-1, 1) * random.log_uniform(1e-12, 4e-6);
      }
      fill(s, s.size() + random.integer(0, 3), 1, 8, 3, random);
      break;
    }
    case Family::large:
      s.horizon = random.uniform(0.5, 4);
      fill(s, random.integer(20, 60), 1, 8, 3, random);
      break;
    case Family::resting:
      s.cx = s.cy = 0;
      s.radius = 32;
      s.horizon = random.integer(6, 24);
      s.restitution = random.chance(0.8) ? 0 : 0.5;
      for (int k = random.integer(1, 2); k > 0; --k) add_resting_point(s, random);
      fill(s, s.size() + random.integer(1, 4), 1, 4, 1, random);
      std::sort(s.maneuvers.begin(), s.maneuvers.end(),
                [](const ManeuverData& a, const ManeuverData& b) { return a.t < b.t; });
      break;
    case Family::crowded: {
      const double speed = random.log_uniform(1e4, 1e7);
      s.horizon = random.uniform(2, 10) * tolerance;
      fill(s, random.integer(3, 8), 0.5, 8, speed, random);
      add_maneuvers(s, random.integer(1, 4), speed, random);
      for (ManeuverData& m : s.maneuvers) {
        if (random.chance(0.2)) m.t = random.chance(0.5) ? 0 : s.horizon;
      }
      std::sort(s.maneuvers.begin(), s.maneuvers.end(),
                [](const ManeuverData& a, const ManeuverData& b) { return a.t < b.t; });
      break;
    }
    case Family::meeting:
      add_meeting_points(s, random);
      break;
    case Family::round:
      add_round(s, random);
      break;
    case Family::count:
      break;
  }
  return s;
}

}  // namespace voroproof::internal::adversary
