#include "library/queries/paths.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "history/error.h"

namespace voroproof::internal {

ExactVec2 position_at(const RecordedState& piece, const Rational& t) {
  const Rational passed = t - piece.since;
  return {piece.center[0] + piece.velocity[0] * passed,
          piece.center[1] + piece.velocity[1] * passed};
}

Paths::Paths(const Scene& scene, const HistoryCursor& history, const std::string& history_path) {
  pieces_.push_back({{0, {scene.cx, scene.cy}, {0, 0}}});
  radii_.push_back(-scene.container_radius);
  for (const DiskInput& disk : scene.disks) {
    pieces_.push_back({{0, {disk.x, disk.y}, {disk.vx, disk.vy}}});
    radii_.push_back(disk.radius);
  }
  const auto turn = [&](GenId g, Rational t, ExactVec2 velocity) {
    std::vector<RecordedState>& pieces = pieces_[g + 1];
    ExactVec2 here = position_at(pieces.back(), t);
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

const RecordedState& Paths::piece(GenId g, const Rational& t) const {
  const std::vector<RecordedState>& all = pieces(g);
  const auto after =
      std::upper_bound(all.begin(), all.end(), t,
                       [](const Rational& time, const RecordedState& s) { return time < s.since; });
  return *std::prev(after);
}

std::vector<Rational> Paths::turns(const std::vector<GenId>& generators, const Rational& from,
                                   const Rational& to) const {
  std::vector<Rational> times;
  for (const GenId g : generators) {
    for (const RecordedState& s : pieces(g)) {
      if (s.since > from && s.since < to) times.push_back(s.since);
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace voroproof::internal
