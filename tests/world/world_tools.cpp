#include "tests/world/world_tools.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "history/world_writer.h"
#include "tests/world/world_oracle.h"

namespace voroproof::internal::testing {

namespace {

// The time until two disks come to have one place and one radius, or since then, if there is just
// one such time.
std::optional<Rational> meeting(const GrowingDisk& a, const GrowingDisk& b) {
  const std::array<std::pair<Rational, Rational>, 3> parts{
      {{a.x - b.x, a.vx - b.vx},
       {a.y - b.y, a.vy - b.vy},
       {a.radius - b.radius, a.growth - b.growth}}};
  std::optional<Rational> t;
  for (const auto& [at, rate] : parts) {
    if (rate != 0 && !t) t = -at / rate;
  }
  if (!t) return t;
  for (const auto& [at, rate] : parts) {
    if (at + rate * *t != 0) return std::nullopt;
  }
  return t;
}

bool is_same_for_ever(const GrowingDisk& a, const GrowingDisk& b) {
  return a.x == b.x && a.y == b.y && a.radius == b.radius && a.vx == b.vx && a.vy == b.vy &&
         a.growth == b.growth;
}

// The times at which three come together, at most so far from now.
std::vector<Rational> triples(const std::vector<GrowingDisk>& disks, const Rational& most) {
  std::vector<Rational> found;
  for (const GrowingDisk& a : disks) {
    std::map<Rational, int> others;  // how many it meets, by time
    int same = 0;
    for (const GrowingDisk& b : disks) {
      if (&a == &b) continue;
      if (const auto t = meeting(a, b); t && abs(*t) <= most) ++others[*t];
      same += is_same_for_ever(a, b);
    }
    for (const auto& [t, count] : others) {
      if (count + same >= 2) found.push_back(t);
    }
  }
  return found;
}

}  // namespace

World in_units(const World& world, const Rational& length, const Rational& time) {
  World out = world;
  const Rational speed = length / time;
  const auto scale = [](std::optional<Point2>& p, const Rational& by) {
    if (p) p = Point2{p->x * by, p->y * by};
  };
  out.horizon *= time;
  if (out.circle) {
    out.circle->center = {out.circle->center.x * length, out.circle->center.y * length};
    out.circle->radius *= length;
    out.circle->growth *= speed;
  }
  for (WorldDisk& disk : out.disks) {
    disk.enter *= time;
    if (disk.leave) *disk.leave *= time;
    for (Rational* q : {&disk.state.x, &disk.state.y, &disk.state.radius}) *q *= length;
    for (Rational* q : {&disk.state.vx, &disk.state.vy, &disk.state.growth}) *q *= speed;
  }
  for (WorldManeuver& m : out.maneuvers) {
    m.t *= time;
    scale(m.center, length);
    scale(m.velocity, speed);
    if (m.radius) *m.radius *= length;
    if (m.growth) *m.growth *= speed;
  }
  return out;
}

void make_valid(World& world) {
  std::sort(world.maneuvers.begin(), world.maneuvers.end(), [](const auto& a, const auto& b) {
    return std::pair(a.t, a.disk) < std::pair(b.t, b.disk);
  });
  if (world.circle && world.circle->radius + world.circle->growth * world.horizon <= 0) {
    world.circle->growth = 0;
  }
  for (GenId g = 0; g < static_cast<GenId>(world.disks.size()); ++g) {
    WorldDisk& disk = world.disks[g];
    std::vector<std::pair<Rational, WorldManeuver*>> starts{{disk.enter, nullptr}};
    for (WorldManeuver& m : world.maneuvers) {
      if (m.disk == g) starts.emplace_back(m.t, &m);
    }
    const Rational last = disk.leave ? std::min(*disk.leave, world.horizon) : world.horizon;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const auto& [from, maneuver] = starts[k];
      const Rational to = k + 1 < starts.size() ? std::min(last, starts[k + 1].first) : last;
      if (to <= from) continue;
      const GrowingDisk s = state_at(world, g, from);
      if (s.radius + s.growth * (to - from) >= 0) continue;
      const Rational rate = -s.radius / (to - from);
      if (maneuver != nullptr) {
        maneuver->growth = rate;
      } else {
        disk.state.growth = rate;
      }
    }
  }
}

std::optional<Rational> first_triple(const World& world) {
  std::set<Rational> cuts{0, world.horizon};
  const auto cut = [&](const Rational& t) {
    if (t < world.horizon) cuts.insert(t);
  };
  for (const WorldDisk& disk : world.disks) {
    cut(disk.enter);
    if (disk.leave) cut(*disk.leave);
  }
  for (const WorldManeuver& m : world.maneuvers) cut(m.t);
  std::optional<Rational> first;
  for (auto from = cuts.begin(); std::next(from) != cuts.end(); ++from) {
    const Rational to = *std::next(from), middle = (*from + to) / 2;
    std::vector<GrowingDisk> disks;
    for (GenId g = 0; g < static_cast<GenId>(world.disks.size()); ++g) {
      if (is_present(world, g, middle)) disks.push_back(state_at(world, g, middle));
    }
    for (const Rational& t : triples(disks, to - middle)) {
      if (!first || middle + t < *first) first = middle + t;
    }
  }
  return first;
}

std::string text(const World& world) {
  std::ostringstream out;
  write_world(out, world);
  return out.str();
}

}  // namespace voroproof::internal::testing
