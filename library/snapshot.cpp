#include "library/snapshot.h"

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "exact/names.h"
#include "exact/topology/named_diagram.h"
#include "history/error.h"
#include "history/json_text.h"
#include "library/illegal_edge.h"
#include "library/places.h"
#include "library/queries/replayed_motion.h"
#include "library/true_moment.h"

namespace voroproof::internal {
namespace {

// The diagram from scratch, by the true motion, but with the flips next to t on the side on which
// the history has them. In their order, each flip that happened is made if its edge is there; then
// backwards, each that did not is taken back if its edge is there.
Diagram diagram_at(const Scene& scene, const std::string& history_path, const Rational& t,
                   const EngineOptions& options) {
  ReplayedMotion replayed = replayed_motion(scene, history_path, t, options.motion);
  NamedDiagram diagram(diagram_at(replayed.motion, t));
  const auto& near = replayed.near_flips;
  for (const auto& [quad, happened] : near) {
    if (happened && diagram.has(quad)) diagram.flip(quad);
  }
  for (auto flip = near.rbegin(); flip != near.rend(); ++flip) {
    const Quad after = canonical(flipped(flip->first));
    if (!flip->second && diagram.has(after)) diagram.flip(after);
  }
  return diagram.take();
}

// Every generator where the history puts it or, where that does not say, where the engine does.
Places placed(const Scene& scene, const RecordedMoment& recorded, const Rational& t,
              const EngineOptions& options) {
  return recorded.states ? Places(scene, *recorded.states, t)
                         : Places(run_to(scene, t, options), t);
}

Diagram first_diagram(const Scene& scene, const EngineOptions& options) {
  return diagram_at(run_to(scene, 0, options)->motion(), 0);
}

// The moment at t, read from an entry of the index on.
RecordedMoment indexed_moment(const Scene& scene, const std::string& history_path,
                              const Rational& t, const IndexFile& index,
                              const EngineOptions& options) {
  const auto history =
      open_history(history_path, static_cast<int>(scene.disks.size()), scene.sha256);
  if (auto known = start_at_entry(index, scene, *history, history_path, t)) {
    return recorded_moment(*history, history_path, t, *std::move(known));
  }
  return recorded_moment(scene, *history, history_path, t, Move::colliding, true,
                         [&] { return first_diagram(scene, options); });
}

DiagramFile assemble(const Scene& scene, const Rational& t, Places& places,
                     const Diagram& diagram) {
  DiagramFile file;
  file.t = round_nearest(t);
  if (to_rational(file.t) != t) file.t_text = t.get_str();
  file.scene_sha256 = scene.sha256;
  const Places::Rounded container = places.generator(container_id);
  file.container_center = container.center;
  file.container_radius = -container.radius;
  for (GenId g = 0; g < static_cast<GenId>(scene.disks.size()); ++g) {
    const Places::Rounded disk = places.generator(g);
    file.disks.push_back({disk.center, disk.radius, disk.velocity});
  }
  file.edges = diagram.quads();
  std::set<Triple> vertices;
  for (const Quad& edge : file.edges) vertices.insert({start_vertex(edge), end_vertex(edge)});
  for (const Triple& name : vertices) {
    const Places::Rounded circle = places.circle(name);
    file.vertices.push_back({name, circle.center, circle.radius});
  }
  return file;
}

// Throws InputError where an edge of the diagram, which the history has, is illegal.
void require_legal(const std::string& history, const PlacedGenerators& generators,
                   const DiagramFile& diagram) {
  const auto illegal = illegal_edge(generators, diagram);
  if (!illegal) return;
  const DiagramVertex& circle = illegal->circle;
  throw InputError(
      history, 0, "",
      "its diagram at t = " + number_text(diagram.t) + " is not that of the disks: edge " +
          text_of(illegal->edge) + " is illegal, generator " + std::to_string(illegal->inside) +
          " lies " + number_text(illegal->depth) + " deep inside the circle of " +
          text_of(circle.generators) + " with centre (" + number_text(circle.center[0]) + ", " +
          number_text(circle.center[1]) + ") and radius " + number_text(circle.radius));
}

}  // namespace

DiagramFile snapshot(const Scene& scene, const Rational& t, const EngineOptions& options) {
  const std::shared_ptr<Engine> engine = run_to(scene, t, options);
  const Diagram diagram = diagram_at(engine->motion(), t);
  Places places(engine, t);
  return assemble(scene, t, places, diagram);
}

DiagramFile snapshot(const Scene& scene, const std::string& history_path, const Rational& t,
                     const EngineOptions& options, const SnapshotWay& way) {
  const bool by_flips = way.construct == Construct::by_flips;
  const RecordedMoment recorded =
      way.index ? indexed_moment(scene, history_path, t, *way.index, options)
                : recorded_moment(scene, history_path, t, way.move, by_flips,
                                  [&] { return first_diagram(scene, options); });
  Places places = placed(scene, recorded, t, options);
  DiagramFile file = assemble(
      scene, t, places, by_flips ? *recorded.diagram : diagram_at(scene, history_path, t, options));
  if (by_flips && way.checked) require_legal(history_path, places.near(), file);
  return file;
}

DiagramFile snapshot(const Scene& scene, HistorySource& history, const std::string& name,
                     const Rational& t, const EngineOptions& options, bool checked) {
  const RecordedMoment recorded = recorded_moment(scene, history, name, t, Move::colliding, true,
                                                  [&] { return first_diagram(scene, options); });
  Places places = placed(scene, recorded, t, options);
  DiagramFile file = assemble(scene, t, places, *recorded.diagram);
  if (checked) require_legal(name, places.near(), file);
  return file;
}

}  // namespace voroproof::internal
