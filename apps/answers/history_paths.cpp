#include "apps/answers/history_paths.h"

#include <algorithm>
#include <variant>

#include "library/true_moment.h"
#include "queries/history_cursor.h"
#include "queries/paths.h"

namespace voroproof::internal {
namespace {

Point2 point(const ExactVec2& v) { return {v[0], v[1]}; }

GivenPath path_of(const Scene& scene, const Paths& paths, GenId g, const Rational& end) {
  GivenPath path{std::to_string(g), scene.disks[static_cast<std::size_t>(g)].radius, {}};
  const std::vector<RecordedState>& pieces = paths.pieces(g);
  for (const RecordedState& piece : pieces) {
    if (piece.since > end) break;
    path.waypoints.push_back({piece.since, point(piece.center)});
  }
  if (path.waypoints.back().t < end) {
    path.waypoints.push_back({end, point(position_at(paths.piece(g, end), end))});
  }
  return path;
}

}  // namespace

GivenPaths history_paths(const Scene& scene, const std::string& history_path,
                         const EngineOptions& options) {
  const auto source =
      open_history(history_path, static_cast<int>(scene.disks.size()), scene.sha256);
  const HistoryCursor history(scene, *source, history_path,
                              [&] { return diagram_at(run_to(scene, 0, options)->motion(), 0); });
  const Paths paths(scene, history, history_path);
  Rational end = history.header().horizon;
  GivenPaths given;
  given.remarks = {"the history is not judged: certify does that",
                   "a disk's places are the scene's until it first collides, and then those that "
                   "the history gives, which are rounded"};
  if (const auto* stop = std::get_if<HistoryStop>(&source->ending())) {
    end = to_rational(stop->t);
    given.remarks.push_back("the history stops before its horizon");
  }
  given.container = {{scene.cx, scene.cy}, scene.container_radius};
  for (GenId g = 0; g < static_cast<GenId>(scene.disks.size()); ++g) {
    given.paths.push_back(path_of(scene, paths, g, end));
  }
  for (std::size_t k = 0; k < history.size(); ++k) {
    const auto* collision = std::get_if<CollideEvent>(&history.event(k));
    if (collision == nullptr) continue;
    given.contacts.push_back({collision->i, collision->j, exact_time(history.event(k))});
  }
  return given;
}

}  // namespace voroproof::internal
