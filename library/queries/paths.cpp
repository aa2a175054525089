#include "library/queries/paths.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "history/error.h"

namespace voroproof::internal {
namespace {

// The first piece that starts after t, or the end.
std::vector<RecordedState>::const_iterator first_after(const std::vector<RecordedState>& pieces,
                                                       const Rational& t) {
  return std::upper_bound(
      pieces.begin(), pieces.end(), t,
      [](const Rational& time, const RecordedState& s) { return time < s.since; });
}

}  // namespace

ExactVec2 position_at(const RecordedState& piece, const Rational& t) {
  const Rational passed = t - piece.since;
  return {piece.center[0] + piece.velocity[0] * passed,
          piece.center[1] + piece.velocity[1] * passed};
}

Rational squared_distance(const ExactVec2& a, const ExactVec2& b) {
  const Rational x = a[0] - b[0], y = a[1] - b[1];
  return x * x + y * y;
}

Paths::Paths(const Scene& scene, const HistoryCursor& history, const std::string& history_path)
    : extent_(abs(scene.cx) + abs(scene.cy) + scene.container_radius) {
  pieces_.push_back({{0, {scene.cx, scene.cy}, {0, 0}}});
  radii_.push_back(-scene.container_radius);
  for (const DiskInput& disk : scene.disks) {
    pieces_.push_back({{0, {disk.x, disk.y}, {disk.vx, disk.vy}}});
    radii_.push_back(disk.radius);
  }
  roundings_.resize(radii_.size());
  // A turn allows for what certify allows for (docs/claim.md, section 3: rounding of a pair), and
  // for times that are long for that: rounding its velocity v and the times of its ends to nearest
  // moves a piece up to t by at most 2^-52 |v| t.
  const auto turn = [&](GenId g, Rational t, ExactVec2 velocity) {
    std::vector<RecordedState>& pieces = pieces_[g + 1];
    const RecordedState& last = pieces.back();
    roundings_[g + 1] += extent_;
    if (t > last.since) roundings_[g + 1] += (abs(last.velocity[0]) + abs(last.velocity[1])) * t;
    ExactVec2 here = position_at(last, t);
    if (t == pieces.back().since) pieces.pop_back();
    pieces.push_back({std::move(t), std::move(here), std::move(velocity)});
  };
  std::vector<std::size_t> next_maneuver(scene.disks.size(), 0);
  for (std::size_t k = 0; k < history.size(); ++k) {
    const Event& event = history.event(k);
    // The header has a line of its own before the events.
    const std::int64_t line = static_cast<std::int64_t>(k) + 2;
    if (const auto* collision = std::get_if<CollideEvent>(&event)) {
      for (const int side : {0, 1}) {
        const GenId g = side == 0 ? collision->i : collision->j;
        if (g == container_id) continue;
        auto velocity = exact_velocity(*collision, side);
        if (!velocity) throw InputError(history_path, line, "collide", "its v is needed");
        turn(g, exact_time(event), *std::move(velocity));
      }
      GivenContact contact{collision->i, collision->j,
                           std::min(exact_time(event), history.header().horizon)};
      if (touch(contact.i, contact.j)) {
        contacts_.insert(std::move(contact));
      } else if (!collision_apart_) {
        collision_apart_ = std::move(contact);
      }
    } else if (const auto* maneuver = std::get_if<ManeuverEvent>(&event)) {
      std::size_t& m = next_maneuver[maneuver->disk];
      while (m < scene.maneuvers.size() && scene.maneuvers[m].disk != maneuver->disk) ++m;
      if (m == scene.maneuvers.size()) {
        throw InputError(history_path, line, "maneuver", "not one of the scene");
      }
      const Maneuver& given = scene.maneuvers[m++];
      turn(maneuver->disk, exact_time(event),
           exact_velocity(*maneuver).value_or(ExactVec2{given.vx, given.vy}));
    }
  }
}

bool Paths::touch(GenId i, GenId j) const {
  const Rational distance2 = squared_distance(pieces(i).back().center, pieces(j).back().center);
  const Rational reach = abs(signed_radius(i) + signed_radius(j));
  const Rational rounding = (roundings_[i + 1] + roundings_[j + 1]) / (Rational(1) << 51);
  const Rational low = std::max<Rational>(reach - rounding, 0), high = reach + rounding;
  return may_explain(rounding, reach, extent_) && distance2 >= low * low &&
         distance2 <= high * high;
}

const RecordedState& Paths::piece(GenId g, const Rational& t) const {
  return *std::prev(first_after(pieces(g), t));
}

std::vector<Waypoint> Paths::waypoints(GenId g, const Rational& from, const Rational& to) const {
  const std::vector<RecordedState>& all = pieces(g);
  const auto waypoint = [](const Rational& t, const ExactVec2& at) {
    return Waypoint{t, {at[0], at[1], 0}};
  };
  auto next = first_after(all, from);
  std::vector<Waypoint> path{waypoint(from, position_at(*std::prev(next), from))};
  for (; next != all.end() && next->since < to; ++next) {
    path.push_back(waypoint(next->since, next->center));
  }
  if (from < to) path.push_back(waypoint(to, position_at(*std::prev(next), to)));
  return path;
}

std::vector<Rational> Paths::turns(const std::vector<GenId>& generators, const Rational& from,
                                   const Rational& to) const {
  std::vector<Rational> times;
  for (const GenId g : generators) {
    const std::vector<RecordedState>& all = pieces(g);
    for (auto s = first_after(all, from); s != all.end() && s->since < to; ++s) {
      times.push_back(s->since);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace voroproof::internal
