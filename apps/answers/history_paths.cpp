#include "apps/answers/history_paths.h"

#include <variant>

#include "exact/names.h"
#include "history/json_text.h"
#include "library/queries/history_cursor.h"
#include "library/queries/paths.h"
#include "library/true_moment.h"

namespace voroproof::internal {
namespace {

// Whether the claim is what the scene schedules, but for rounding.
bool is_scheduled(const ManeuverEvent& claim, const Maneuver& m) {
  const auto same = [](const Rational& a, const Rational& b) {
    return round_nearest(a) == round_nearest(b);
  };
  if (!same(exact_time(claim), m.t)) return false;
  const auto v = exact_velocity(claim);
  return !v || (same((*v)[0], m.vx) && same((*v)[1], m.vy));
}

// Maneuvers of the scene up to the end that the history lacks or has otherwise, and claims of
// maneuvers that the scene lacks.
void note_missing_maneuvers(const Scene& scene, const HistoryCursor& history, const Rational& end,
                            std::vector<std::string>& missing) {
  std::vector<std::vector<const ManeuverEvent*>> claims(scene.disks.size());
  for (std::size_t k = 0; k < history.size(); ++k) {
    const auto* claim = std::get_if<ManeuverEvent>(&history.event(k));
    if (claim != nullptr) claims[static_cast<std::size_t>(claim->disk)].push_back(claim);
  }
  std::vector<std::size_t> next(scene.disks.size(), 0);
  std::size_t count = 0;
  std::string first;
  for (const Maneuver& m : scene.maneuvers) {
    if (m.t > end) break;
    const auto g = static_cast<std::size_t>(m.disk);
    const std::size_t k = next[g]++;
    if (k < claims[g].size() && is_scheduled(*claims[g][k], m)) continue;
    if (count++ == 0) first = std::to_string(m.disk) + " at t = " + number_text(m.t);
  }
  for (std::size_t g = 0; g < claims.size(); ++g) {
    if (claims[g].size() <= next[g]) continue;
    missing.push_back("the scene has no such maneuver: disk " + std::to_string(g) +
                      " at t = " + number_text(exact_time(*claims[g][next[g]])));
    break;
  }
  if (count == 0) return;
  missing.push_back((count == 1 ? "a maneuver" : std::to_string(count) + " maneuvers") +
                    " of the scene, not in the history as scheduled: disk " + first);
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
  const auto* stop = std::get_if<HistoryStop>(&source->ending());
  const Rational end = stop == nullptr ? history.header().horizon
                       : stop->exact_t ? *stop->exact_t
                                       : to_rational(stop->t);
  // The horizon may be rounded in the history.
  if (stop != nullptr || round_nearest(end) < round_nearest(scene.horizon)) {
    given.missing.push_back("the time from t = " + number_text(end) + ", where the history " +
                            (stop == nullptr ? "ends" : "stops") + ", to the scene's horizon, " +
                            number_text(scene.horizon));
  }
  note_missing_maneuvers(scene, history, end, given.missing);
  if (const auto& apart = paths.collision_apart()) {
    given.missing.push_back("the contact of a collision of two that do not touch on these paths: " +
                            text_of(apart->i, apart->j) + " at t = " + number_text(apart->t));
  }
  given.container = {{scene.cx, scene.cy}, scene.container_radius};
  for (GenId g = 0; g < static_cast<GenId>(scene.disks.size()); ++g) {
    given.paths.push_back({std::to_string(g), paths.signed_radius(g), paths.waypoints(g, 0, end)});
  }
  given.contacts = paths.contacts();
  return given;
}

}  // namespace voroproof::internal
