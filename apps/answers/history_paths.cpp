#include "apps/answers/history_paths.h"

#include <variant>

#include "apps/answers/untold.h"
#include "exact/names.h"
#include "history/json_text.h"
#include "library/queries/history_cursor.h"
#include "library/queries/paths.h"
#include "library/true_moment.h"

namespace voroproof::internal {
namespace {

ToldHistory told_of(const HistoryCursor& history, const HistorySource& source, std::size_t disks) {
  ToldHistory told{history.header().horizon, false, source.counts_match()};
  if (const auto* stop = std::get_if<HistoryStop>(&source.ending())) {
    told.end = stop->exact_t ? *stop->exact_t : to_rational(stop->t);
    told.stops = true;
  }
  told.maneuvers.resize(disks);
  for (std::size_t k = 0; k < history.size(); ++k) {
    const auto* claim = std::get_if<ManeuverEvent>(&history.event(k));
    if (claim == nullptr) continue;
    std::optional<Vec3> v;
    if (const auto plane = exact_velocity(*claim)) v = Vec3{(*plane)[0], (*plane)[1]};
    told.maneuvers[static_cast<std::size_t>(claim->disk)].push_back({exact_time(*claim), v});
  }
  return told;
}

}  // namespace

GivenPaths history_paths(const Scene& scene, const std::string& history_path,
                         const EngineOptions& options) {
  const auto source =
      open_history(history_path, static_cast<int>(scene.disks.size()), scene.sha256);
  const HistoryCursor history(scene, *source, history_path,
                              [&] { return diagram_at(run_to(scene, 0, options)->motion(), 0); });
  const Paths paths(scene, history, history_path);
  GivenPaths given;
  given.meaning = "the paths that the history records";
  given.remarks = {"the history is not judged: certify does that"};
  const ToldHistory told = told_of(history, *source, scene.disks.size());
  std::vector<BilliardManeuver> scheduled;
  for (const Maneuver& m : scene.maneuvers) scheduled.push_back({m.t, m.disk, Vec3{m.vx, m.vy}});
  given.missing = untold(told, scene.horizon, scheduled);
  if (const auto& apart = paths.collision_apart()) {
    given.missing.push_back("the contact of a collision of two that do not touch on these paths: " +
                            text_of(apart->i, apart->j) + " at t = " + number_text(apart->t));
  }
  given.container = RoundFrame{{scene.cx, scene.cy}, scene.container_radius};
  for (GenId g = 0; g < static_cast<GenId>(scene.disks.size()); ++g) {
    given.paths.push_back(
        {std::to_string(g), paths.signed_radius(g), paths.waypoints(g, 0, told.end)});
  }
  given.contacts = paths.contacts();
  return given;
}

}  // namespace voroproof::internal
