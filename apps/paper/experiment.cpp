#include "apps/paper/experiment.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <set>
#include <variant>

#include "apps/paper/predictions.h"
#include "library/maneuver_input.h"

namespace voroproof::internal {
namespace {

class Recorder final : public EventSink {
 public:
  Recorder(ExperimentRun& run, double horizon, bool keep) : run_(run), keep_(keep) {
    const auto bins = static_cast<std::size_t>(std::ceil(horizon / frequency_interval));
    run_.flip_frequency.assign(std::max<std::size_t>(bins, 1), 0);
    run_.collision_frequency = run_.flip_frequency;
  }

  void begin(const std::vector<Quad>& initial) override { initial_ = initial; }
  void flip(double t, const Quad& edge) override {
    count(run_.flip_frequency, t);
    if (keep_) events_.emplace_back(FlipEvent{.t = t, .quad = edge});
  }
  void collide(double t, GenId i, GenId j, const RoundedState&, const RoundedState&) override {
    count(run_.collision_frequency, t);
    if (keep_) events_.emplace_back(CollideEvent{.t = t, .i = i, .j = j});
  }
  void maneuver(double, GenId, const RoundedState&) override {}

  // Counts after the run, so that the run's time is the engine's own. Stops before the end where
  // the monitor says so.
  void count_predictions(const MotionInput& input,
                         const std::function<bool(double t, std::uint64_t events)>& monitor) {
    PredictionCounter counter(input);
    counter.begin(initial_);
    std::uint64_t counted = 0;
    for (const auto& event : events_) {
      const double t = std::visit([](const auto& e) { return e.t; }, event);
      if (monitor && !monitor(t, counted++)) return;
      if (const auto* flip = std::get_if<FlipEvent>(&event)) {
        counter.flip(flip->t, flip->quad);
      } else {
        const auto& collision = std::get<CollideEvent>(event);
        counter.collide(collision.t, collision.i, collision.j);
      }
    }
    counter.finish();
    run_.predicted_flips = counter.flips();
    run_.predicted_flips_before_contact = counter.flips_before_contact();
    run_.predicted_roots = counter.roots();
    run_.predicted_collisions = counter.collisions();
  }

 private:
  static void count(std::vector<std::uint64_t>& bins, double t) {
    ++bins[std::min(static_cast<std::size_t>(t / frequency_interval), bins.size() - 1)];
  }

  ExperimentRun& run_;
  bool keep_;
  std::vector<Quad> initial_;
  std::vector<std::variant<FlipEvent, CollideEvent>> events_;
};

struct Place {
  double x, y, r;
};

void measure_end(ExperimentRun& run, const Motion& motion, const Diagram& diagram) {
  std::vector<Place> places;
  std::vector<double> speeds, distances;
  for (GenId g = 0; g < motion.size(); ++g) {
    const DoubleMotion& m = motion.doubles(g);
    places.push_back({m.x + (run.outcome.t - m.t) * m.vx, m.y + (run.outcome.t - m.t) * m.vy, m.r});
    speeds.push_back(std::hypot(m.vx, m.vy));
  }
  for (GenId g = 0; g < motion.size(); ++g) {
    std::set<GenId> neighbors;
    if (const auto first = diagram.anchor(g); first >= 0) {
      auto h = first;
      do {
        if (diagram.dest(h) != container_id) neighbors.insert(diagram.dest(h));
        h = diagram.rotate(h);
      } while (h != first);
    }
    double sum = 0;
    for (const GenId other : neighbors) {
      const Place &a = places[g], &b = places[other];
      sum += std::hypot(b.x - a.x, b.y - a.y) - a.r - b.r;
    }
    if (!neighbors.empty()) distances.push_back(sum / static_cast<double>(neighbors.size()));
  }
  run.speed = distribution_of(std::move(speeds));
  run.neighbor_distance = distribution_of(std::move(distances));
}

}  // namespace

Distribution distribution_of(std::vector<double> values) {
  Distribution d;
  d.count = values.size();
  if (values.empty()) return d;
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  d.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  double squares = 0;
  for (const double x : values) squares += (x - d.mean) * (x - d.mean);
  d.deviation = std::sqrt(squares / n);
  // A quantile lies between the two values nearest to its place, linearly.
  const auto quantile = [&](double q) {
    const double place = q * (n - 1);
    const auto below = static_cast<std::size_t>(place);
    const double above = values[std::min(below + 1, values.size() - 1)];
    return values[below] + (place - static_cast<double>(below)) * (above - values[below]);
  };
  d.least = values.front();
  d.lower_quartile = quantile(0.25);
  d.median = quantile(0.5);
  d.upper_quartile = quantile(0.75);
  d.greatest = values.back();
  return d;
}

ExperimentRun run_experiment(const Scene& scene, bool predictions, EngineOptions options) {
  using Clock = std::chrono::steady_clock;
  ExperimentRun run;
  run.disks = static_cast<int>(scene.disks.size());
  const MotionInput input = motion_input(scene);
  Recorder recorder(run, round_nearest(scene.horizon), predictions);
  options.profile = true;
  const Clock::time_point start = Clock::now();
  Engine engine(input, maneuver_input(scene), options);
  run.outcome = engine.run(recorder);
  run.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  run.stats = engine.stats();
  measure_end(run, engine.motion(), engine.diagram());
  if (predictions && run.outcome.kind == Outcome::Kind::complete) {
    recorder.count_predictions(input, options.monitor);
  }
  return run;
}

}  // namespace voroproof::internal
