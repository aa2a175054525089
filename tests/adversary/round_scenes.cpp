#include "tests/adversary/round_scenes.h"

#include <algorithm>

namespace voroproof::internal::adversary {
namespace {

// Vectors of length 5 with whole coordinates.
constexpr std::array<Pair2, 12> fives{{{5, 0},
                                       {4, 3},
                                       {3, 4},
                                       {0, 5},
                                       {-3, 4},
                                       {-4, 3},
                                       {-5, 0},
                                       {-4, -3},
                                       {-3, -4},
                                       {0, -5},
                                       {3, -4},
                                       {4, -3}}};

// Where the disk is at time t, if nothing happens to it.
DiskData at(DiskData d, double t) {
  d.x += t * d.vx;
  d.y += t * d.vy;
  return d;
}

// Whether the disk is apart from all others at time t.
bool are_apart(const SceneData& s, const DiskData& disk, double t) {
  const DiskData d = at(disk, t);
  return std::all_of(s.disks.begin(), s.disks.end(), [&](const DiskData& other) {
    const DiskData o = at(other, t);
    return std::hypot(d.x - o.x, d.y - o.y) > d.radius + o.radius;
  });
}

}  // namespace

void add_round(SceneData& s, Random& random) {
  const double x = random.integer(-20, 20), y = random.integer(-20, 20), t = random.integer(0, 2);
  s.horizon = t + random.integer(t > 0 ? 0 : 1, 8) / 4.0;
  const auto quarters = [&] { return random.chance(0.3) ? 0 : random.integer(-8, 8) / 4.0; };
  // A circle of radius 10 that those outside it touch.
  const double radii[] = {0, 1.25, 2.5, 5};
  const double common = radii[random.integer(0, 3)];
  const bool equal = random.chance(0.4);
  std::array<Pair2, 6> outwards{};  // of each, of length 5
  const int most = random.integer(4, 6);
  for (int attempt = 0; attempt < 60 && s.size() < most; ++attempt) {
    const Pair2 out = fives[static_cast<std::size_t>(random.integer(0, 11))];
    const double r = equal ? common : radii[random.integer(0, 3)], far = (10 + r) / 5;
    const DiskData then{x + far * out[0], y + far * out[1], r, quarters(), quarters(), 1};
    const DiskData d = at(then, -t);
    if (!are_apart(s, d, 0) || !are_apart(s, d, t)) continue;
    outwards[static_cast<std::size_t>(s.size())] = out;
    s.disks.push_back(d);
  }
  const int round = s.size();
  if (round == 0) return;
  const auto any = [&] { return random.integer(0, round - 1); };
  // One is hit from outside then.
  if (const int k = any(); random.chance(0.4) && s.disks[static_cast<std::size_t>(k)].radius > 0) {
    const DiskData& hit = s.disks[static_cast<std::size_t>(k)];
    const Pair2 out = outwards[static_cast<std::size_t>(k)];
    const double r = radii[random.integer(0, 3)], far = (hit.radius + r) / 5;
    const double towards = random.integer(1, 4) / 4.0;
    const DiskData then{at(hit, t).x + far * out[0], at(hit, t).y + far * out[1], r,
                        hit.vx - towards * out[0],   hit.vy - towards * out[1],   1};
    if (const DiskData d = at(then, -t); are_apart(s, d, 0)) s.disks.push_back(d);
  }
  for (int turns = random.integer(0, 2); turns > 0; --turns) {
    s.maneuvers.push_back({t, any(), quarters(), quarters()});
  }
}

}  // namespace voroproof::internal::adversary
