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

// Whether they part, or come from apart, by so little that neither is in the other on the way.
bool go_apart(const GrowingDisk& a, const GrowingDisk& b) {
  const Rational x = a.vx - b.vx, y = a.vy - b.vy, r = a.growth - b.growth;
  return x * x + y * y > r * r;
}

// A time in which nothing is scheduled, seen from its middle.
class Stretch {
 public:
  Stretch(const World& world, const Rational& from, const Rational& to)
      : world_(world), to_(to), middle_((from + to) / 2), half_((to - from) / 2) {
    for (GenId g = 0; g < static_cast<GenId>(world.disks.size()); ++g) {
      if (is_present(world, g, middle_)) disks_.emplace(g, state_at(world, g, middle_));
    }
  }

  // The first time in it, or at its end, at which nobody decides what follows.
  std::optional<Rational> first() const {
    std::optional<Rational> first;
    for (const auto& [g, a] : disks_) {
      std::map<Rational, int> others;  // how many it meets, by time
      for (const auto& [h, b] : disks_) {
        const auto t = meeting(a, b);
        if (g == h || !t || *t <= -half_ || *t > half_) continue;
        const bool at_end = *t == half_;
        if (at_end && (!stays(g) || !stays(h))) continue;
        others[*t] += at_end && turns(g) && part(g, h) ? 2 : 1;
      }
      for (const auto& [t, count] : others) {
        if (count + same(g, t == half_) < 2) continue;
        if (!first || middle_ + t < *first) first = middle_ + t;
      }
    }
    return first;
  }

 private:
  // Whether it is not gone at the end, nor elsewhere.
  bool stays(GenId g) const {
    return is_present(world_, g, to_) &&
           std::none_of(
               world_.maneuvers.begin(), world_.maneuvers.end(),
               [&](const WorldManeuver& m) { return m.disk == g && m.t == to_ && m.is_jump(); });
  }
  bool turns(GenId g) const {
    return std::any_of(world_.maneuvers.begin(), world_.maneuvers.end(),
                       [&](const WorldManeuver& m) { return m.disk == g && m.t == to_; });
  }
  // Whether two that meet at the end, where one of them turns, both have a cell before and after.
  bool part(GenId g, GenId h) const {
    return go_apart(disks_.at(g), disks_.at(h)) &&
           go_apart(state_at(world_, g, to_), state_at(world_, h, to_));
  }
  int same(GenId g, bool at_end) const {
    return static_cast<int>(std::count_if(disks_.begin(), disks_.end(), [&](const auto& other) {
      return other.first != g && is_same_for_ever(other.second, disks_.at(g)) &&
             (!at_end || stays(other.first));
    }));
  }

  const World& world_;
  Rational to_, middle_, half_;
  std::map<GenId, GrowingDisk> disks_;
};

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

std::optional<Rational> first_undecided(const World& world) {
  std::set<Rational> cuts{0, world.horizon};
  const auto cut = [&](const Rational& t) {
    if (t < world.horizon) cuts.insert(t);
  };
  for (const WorldDisk& disk : world.disks) {
    cut(disk.enter);
    if (disk.leave) cut(*disk.leave);
  }
  for (const WorldManeuver& m : world.maneuvers) cut(m.t);
  for (auto from = cuts.begin(); std::next(from) != cuts.end(); ++from) {
    if (auto t = Stretch(world, *from, *std::next(from)).first()) return t;
  }
  return std::nullopt;
}

std::string text(const World& world) {
  std::ostringstream out;
  write_world(out, world);
  return out.str();
}

}  // namespace voroproof::internal::testing
