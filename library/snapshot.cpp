#include "library/snapshot.h"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "exact/names.h"
#include "history/error.h"
#include "history/json_text.h"
#include "library/illegal_edge.h"
#include "library/true_moment.h"
#include "queries/replayed_motion.h"
#include "topology/named_diagram.h"

namespace voroproof::internal {
namespace {

constexpr int bits = 160;

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

PlacedGenerators placed(const Motion& motion, const Rational& t) {
  const Ball time(t, bits);
  PlacedGenerators generators;
  generators.reserve(motion.size() + 1);
  for (GenId g = container_id; g < motion.size(); ++g) {
    generators.push_back({motion.moving_site(g, time), motion.doubles(g).t});
  }
  return generators;
}

PlacedGenerators placed(const Scene& scene, const std::vector<RecordedState>& states,
                        const Rational& t) {
  const auto ball = [](const Rational& q) { return Ball(q, bits); };
  PlacedGenerators generators;
  generators.reserve(states.size() + 1);
  generators.push_back({{ball(scene.cx), ball(scene.cy), Ball(bits), Ball(bits),
                         ball(Rational(-scene.container_radius))},
                        0});
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [since, center, velocity] = states[i];
    const Rational x = center[0] + velocity[0] * (t - since);
    const Rational y = center[1] + velocity[1] * (t - since);
    generators.push_back(
        {{ball(x), ball(y), ball(velocity[0]), ball(velocity[1]), ball(scene.disks[i].radius)},
         round_nearest(since)});
  }
  return generators;
}

// Every generator where the history puts it or, where that does not say, where the engine does.
PlacedGenerators placed(const Scene& scene, const RecordedMoment& recorded, const Rational& t,
                        const EngineOptions& options) {
  return recorded.states ? placed(scene, *recorded.states, t)
                         : placed(run_to(scene, t, options)->motion(), t);
}

Diagram first_diagram(const Scene& scene, const EngineOptions& options) {
  return diagram_at(run_to(scene, 0, options)->motion(), 0);
}

// The binary64 nearest to the number in the ball; where the ball straddles the boundary between
// two, the one nearest to its midpoint, and zero where that is in the ball.
double rounded(const Ball& ball) {
  double x = 0;
  if (ball.round_to_double(x)) return x;
  if (!ball.is_finite()) {
    throw Undecided("a coordinate of the diagram is not known to " + std::to_string(bits) +
                    " bits");
  }
  return ball.sign() == Sign::unknown ? 0 : ball.midpoint_as_double();
}

Vec2 rounded(const Ball& x, const Ball& y) { return {rounded(x), rounded(y)}; }

DiagramFile assemble(const Scene& scene, const Rational& t, const PlacedGenerators& generators,
                     const Diagram& diagram) {
  DiagramFile file;
  file.t = round_nearest(t);
  if (to_rational(file.t) != t) file.t_text = t.get_str();
  file.scene_sha256 = scene.sha256;
  const MovingSite<Ball>& container = generators.front().site;
  file.container_center = rounded(container.x, container.y);
  file.container_radius = -rounded(container.r);
  for (std::size_t g = 1; g < generators.size(); ++g) {
    const MovingSite<Ball>& disk = generators[g].site;
    file.disks.push_back({rounded(disk.x, disk.y), rounded(disk.r), rounded(disk.vx, disk.vy)});
  }
  file.edges = diagram.quads();
  std::set<Triple> vertices;
  for (const Quad& edge : file.edges) vertices.insert({start_vertex(edge), end_vertex(edge)});
  const auto site = [&](GenId g) {
    const MovingSite<Ball>& s = generators[static_cast<std::size_t>(g + 1)].site;
    return Site<Ball>{s.x, s.y, s.r};
  };
  for (const Triple& name : vertices) {
    const auto circle = circle_of(name, site);
    file.vertices.push_back({name, rounded(circle[0], circle[1]), rounded(circle[2])});
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
  const auto engine = run_to(scene, t, options);
  const Diagram diagram = diagram_at(engine->motion(), t);
  return assemble(scene, t, placed(engine->motion(), t), diagram);
}

DiagramFile snapshot(const Scene& scene, const std::string& history_path, const Rational& t,
                     const EngineOptions& options, const SnapshotWay& way) {
  const bool by_flips = way.construct == Construct::by_flips;
  const RecordedMoment recorded = recorded_moment(scene, history_path, t, way.move, by_flips,
                                                  [&] { return first_diagram(scene, options); });
  const PlacedGenerators generators = placed(scene, recorded, t, options);
  DiagramFile file =
      assemble(scene, t, generators,
               by_flips ? *recorded.diagram : diagram_at(scene, history_path, t, options));
  if (by_flips && way.checked) require_legal(history_path, generators, file);
  return file;
}

DiagramFile snapshot(const Scene& scene, HistorySource& history, const std::string& name,
                     const Rational& t, const EngineOptions& options, bool checked) {
  const RecordedMoment recorded = recorded_moment(scene, history, name, t, Move::colliding, true,
                                                  [&] { return first_diagram(scene, options); });
  const PlacedGenerators generators = placed(scene, recorded, t, options);
  DiagramFile file = assemble(scene, t, generators, *recorded.diagram);
  if (checked) require_legal(name, generators, file);
  return file;
}

}  // namespace voroproof::internal
