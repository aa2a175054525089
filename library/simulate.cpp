#include "voroproof/simulate.h"

#include <stdexcept>
#include <utility>

#include "engine/billiard/billiard_run.h"
#include "engine/engine.h"
#include "history/scene_motion.h"
#include "library/billiard_values.h"
#include "library/maneuver_input.h"
#include "library/values.h"
#include "voroproof/version.h"

namespace voroproof {

const char* version() { return VOROPROOF_VERSION; }

namespace internal {
namespace {

// Hands the engine's calls on to those of the library.
class Forwarding final : public EventSink {
 public:
  explicit Forwarding(voroproof::EventSink& sink) : sink_(sink) {}

  void begin(const std::vector<Quad>& initial) override {
    std::vector<voroproof::Edge> edges;
    edges.reserve(initial.size());
    for (const Quad& q : initial) edges.push_back(edge_value(q));
    sink_.begin(edges);
  }
  void flip(double t, const Quad& edge) override {
    sink_.event(voroproof::FlipEvent{t, edge_value(edge)});
  }
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    voroproof::CollisionEvent event{t, i, j, {}, {}};
    if (i == container_id) {
      set(event, 1, second);
    } else {
      set(event, 0, first);
      set(event, 1, second);
    }
    sink_.event(event);
  }
  void maneuver(double t, GenId disk, const RoundedState& state) override {
    sink_.event(
        voroproof::ManeuverEvent{t, disk, Vec2{state.vx, state.vy}, Vec2{state.px, state.py}});
  }

 private:
  static void set(voroproof::CollisionEvent& event, int side, const RoundedState& state) {
    event.velocity[side] = Vec2{state.vx, state.vy};
    event.center[side] = Vec2{state.px, state.py};
  }

  voroproof::EventSink& sink_;
};

template <class Outcome>
voroproof::Ending ending_of(const Outcome& outcome) {
  using Kind = decltype(outcome.kind);
  if (outcome.kind == Kind::complete) return {true, outcome.t, {}};
  return {false, outcome.t, outcome.kind == Kind::interrupted ? "interrupted" : outcome.reason};
}

voroproof::Ending run(const Scene& scene, voroproof::EventSink& sink,
                      const voroproof::SimulateOptions& options) {
  if (options.threads < 1) throw std::invalid_argument("threads: less than 1");
  EngineOptions settings = engine_options(options.max_bits);
  settings.threads = options.threads;
  settings.max_events = options.max_events;
  settings.monitor = options.monitor;
  Forwarding forwarding(sink);
  Engine engine(motion_input(scene), maneuver_input(scene), std::move(settings));
  return ending_of(engine.run(forwarding));
}

voroproof::Ending run(const Billiard& billiard, voroproof::BilliardHistory& history,
                      const voroproof::SimulateOptions& options) {
  BilliardOptions settings;
  settings.max_bits = motion_options(options.max_bits).max_bits;
  settings.max_events = options.max_events;
  settings.monitor = options.monitor;
  return ending_of(run_billiard(billiard, settings,
                                [&](const BilliardEvent& event) { append(history, event); }));
}

}  // namespace
}  // namespace internal

Ending simulate(const Scene& scene, EventSink& sink, const SimulateOptions& options) {
  return internal::with_public_errors(
      [&] { return internal::run(internal::checked_scene(scene), sink, options); });
}

History simulate(const Scene& scene, const SimulateOptions& options) {
  return internal::with_public_errors([&] {
    const internal::Scene checked = internal::checked_scene(scene);
    History history;
    history.scene_sha256 = checked.sha256;
    history.horizon = internal::number(checked.horizon);
    history.producer = "voroproof " VOROPROOF_VERSION;
    internal::Collecting sink(history);
    history.ending = internal::run(checked, sink, options);
    return history;
  });
}

BilliardHistory simulate(const Billiard& billiard, const SimulateOptions& options) {
  return internal::with_public_errors([&] {
    BilliardHistory history;
    history.scene_sha256 = billiard.sha256();
    history.dimension = billiard.dimension();
    history.horizon = billiard.horizon();
    history.producer = "voroproof " VOROPROOF_VERSION;
    history.ending = internal::run(billiard.read(), history, options);
    return history;
  });
}

}  // namespace voroproof
