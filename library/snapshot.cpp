#include "library/snapshot.h"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "exact/predicates.h"
#include "filtered/search/collapse.h"
#include "history/json_text.h"
#include "library/true_moment.h"
#include "queries/replayed_motion.h"
#include "topology/named_diagram.h"

namespace voroproof::internal {
namespace {

constexpr int bits = 160;

// Every generator at the instant, the container first.
using Moment = std::vector<MovingSite<Ball>>;

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

Moment moment_of(const Motion& motion, const Rational& t) {
  const Ball time(t, bits);
  Moment moment;
  moment.reserve(motion.size() + 1);
  for (GenId g = container_id; g < motion.size(); ++g) {
    moment.push_back(motion.moving_site(g, time));
  }
  return moment;
}

Moment moment_of(const Scene& scene, const std::vector<RecordedState>& states, const Rational& t) {
  const auto ball = [](const Rational& q) { return Ball(q, bits); };
  Moment moment;
  moment.reserve(states.size() + 1);
  moment.push_back({ball(scene.cx), ball(scene.cy), Ball(bits), Ball(bits),
                    ball(Rational(-scene.container_radius))});
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [since, center, velocity] = states[i];
    const Rational x = center[0] + velocity[0] * (t - since);
    const Rational y = center[1] + velocity[1] * (t - since);
    moment.push_back(
        {ball(x), ball(y), ball(velocity[0]), ball(velocity[1]), ball(scene.disks[i].radius)});
  }
  return moment;
}

// Every generator where the history puts it or, where that does not say, where the engine does.
Moment moment_of(const Scene& scene, const RecordedMoment& recorded, const Rational& t,
                 const EngineOptions& options) {
  return recorded.states ? moment_of(scene, *recorded.states, t)
                         : moment_of(run_to(scene, t, options)->motion(), t);
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

DiagramVertex vertex(const Moment& moment, const Triple& generators) {
  const auto [i, j, k] = disk_first(generators[0], generators[1], generators[2]);
  const auto site = [&](GenId g) {
    const MovingSite<Ball>& s = moment[g + 1];
    return Site<Ball>{s.x, s.y, s.r};
  };
  // Recorded positions are rounded: where two circles of three generators are about to become one,
  // their discriminant may come out below zero.
  const auto root = [](const Ball& x) {
    return x.sign() == Sign::negative ? Ball(x.precision()) : sqrt(x);
  };
  const TangentTriple<Ball> triple(site(i), site(j), site(k),
                                   j == container_id || k == container_id);
  const auto circle = tangent_circle(triple, root);
  return {generators, rounded(circle[0], circle[1]), rounded(circle[2])};
}

DiagramFile assemble(const Scene& scene, const Rational& t, const Moment& moment,
                     const Diagram& diagram) {
  DiagramFile file;
  file.t = round_nearest(t);
  if (to_rational(file.t) != t) file.t_text = t.get_str();
  file.scene_sha256 = scene.sha256;
  const MovingSite<Ball>& container = moment.front();
  file.container_center = rounded(container.x, container.y);
  file.container_radius = -rounded(container.r);
  for (std::size_t g = 1; g < moment.size(); ++g) {
    const MovingSite<Ball>& disk = moment[g];
    file.disks.push_back({rounded(disk.x, disk.y), rounded(disk.r), rounded(disk.vx, disk.vy)});
  }
  file.edges = diagram.quads();
  std::set<Triple> vertices;
  for (const Quad& edge : file.edges) vertices.insert({start_vertex(edge), end_vertex(edge)});
  for (const Triple& generators : vertices) file.vertices.push_back(vertex(moment, generators));
  return file;
}

}  // namespace

DiagramFile snapshot(const Scene& scene, const Rational& t, const EngineOptions& options) {
  const auto engine = run_to(scene, t, options);
  const Diagram diagram = diagram_at(engine->motion(), t);
  return assemble(scene, t, moment_of(engine->motion(), t), diagram);
}

DiagramFile snapshot(const Scene& scene, const std::string& history_path, const Rational& t,
                     const EngineOptions& options, const SnapshotWay& way) {
  const bool by_flips = way.construct == Construct::by_flips;
  const RecordedMoment recorded = recorded_moment(scene, history_path, t, way.move, by_flips,
                                                  [&] { return first_diagram(scene, options); });
  return assemble(
      scene, t, moment_of(scene, recorded, t, options),
      recorded.diagram ? *recorded.diagram : diagram_at(scene, history_path, t, options));
}

DiagramFile snapshot(const Scene& scene, HistorySource& history, const std::string& name,
                     const Rational& t, const EngineOptions& options) {
  const RecordedMoment recorded = recorded_moment(scene, history, name, t, Move::colliding, true,
                                                  [&] { return first_diagram(scene, options); });
  return assemble(scene, t, moment_of(scene, recorded, t, options), *recorded.diagram);
}

}  // namespace voroproof::internal
