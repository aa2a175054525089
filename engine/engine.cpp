#include "engine/engine.h"

#include <algorithm>

#include "engine/certified.h"
#include "engine/processing.h"
#include "engine/sliced_run.h"

namespace voroproof::internal {

namespace {

// Leaves out what the sink was told before.
class Continuation final : public EventSink {
 public:
  Continuation(EventSink& sink, const SlicedRun::Told& told) : sink_(sink), told_(told) {}
  void begin(const std::vector<Quad>& initial) override {
    if (!told_.begun) sink_.begin(initial);
  }
  void flip(double t, const Quad& edge) override {
    if (is_new()) sink_.flip(t, edge);
  }
  void collide(double t, GenId i, GenId j, const RoundedState& first,
               const RoundedState& second) override {
    if (is_new()) sink_.collide(t, i, j, first, second);
  }
  void maneuver(double t, GenId disk, const RoundedState& state) override {
    if (is_new()) sink_.maneuver(t, disk, state);
  }

 private:
  bool is_new() { return ++events_ > told_.events; }

  EventSink& sink_;
  SlicedRun::Told told_;
  std::uint64_t events_ = 0;
};

}  // namespace

class Engine::Implementation {
 public:
  Implementation(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options)
      : input_(std::move(input)), maneuvers_(std::move(maneuvers)), options_(std::move(options)) {
    const auto least = static_cast<std::size_t>(std::max(0, options_.least_sliced));
    if (options_.threads > 1 && input_.disks.size() >= least) {
      sliced_ = std::make_unique<SlicedRun>(input_, maneuvers_, options_);
      if (!sliced_->possible()) sliced_.reset();
    }
    if (!sliced_) make_whole();
  }

  Outcome run(EventSink& sink) {
    if (!sliced_) return whole_->run(sink);
    if (const std::optional<Outcome> outcome = sliced_->run(sink)) return *outcome;
    return run_on(sink);
  }
  Outcome resume(const KeptRun& kept, const std::function<void(EventSink&)>& told,
                 EventSink& sink) {
    sliced_.reset();
    if (!whole_) make_whole();
    return whole_->resume(kept, told, sink);
  }

  const EngineStats& stats() const { return sliced_ ? sliced_->stats() : whole_->stats(); }
  const Diagram& diagram() const { return sliced_ ? sliced_->diagram() : whole_->diagram(); }
  ComputedMotion& motion() { return sliced_ ? sliced_->motion() : whole_->motion(); }

 private:
  void make_whole() {
    whole_ =
        std::make_unique<EngineOver<Certified>>(std::move(input_), std::move(maneuvers_), options_);
  }

  // Slices have come to something that asks for a run of one thread, which begins anew: what it
  // tells, and where it stops, is what it would be without slices.
  Outcome run_on(EventSink& sink) {
    const SlicedRun::Told told = sliced_->told();
    sliced_.reset();
    if (const auto monitor = options_.monitor) {
      options_.monitor = [monitor, told](double t, std::uint64_t events) {
        return monitor(std::max(t, told.t), std::max(events, told.events));
      };
    }
    // A state within the part told before is not kept again.
    if (const auto keep = options_.keep) {
      options_.keep = [keep, told](KeptRun&& kept) {
        if (kept.events >= told.events) keep(std::move(kept));
      };
    }
    make_whole();
    Continuation rest(sink, told);
    Outcome outcome = whole_->run(rest);
    outcome.t = std::max(outcome.t, told.t);
    return outcome;
  }

  MotionInput input_;  // until the whole run has it
  std::vector<ManeuverInput> maneuvers_;
  EngineOptions options_;
  std::unique_ptr<SlicedRun> sliced_;
  std::unique_ptr<EngineOver<Certified>> whole_;
};

Engine::Engine(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(input), std::move(maneuvers),
                                                       std::move(options))) {}
Engine::~Engine() = default;

Outcome Engine::run(EventSink& sink) { return implementation_->run(sink); }
Outcome Engine::resume(const KeptRun& kept, const std::function<void(EventSink&)>& told,
                       EventSink& sink) {
  return implementation_->resume(kept, told, sink);
}
const EngineStats& Engine::stats() const { return implementation_->stats(); }
const Diagram& Engine::diagram() const { return implementation_->diagram(); }
const ComputedMotion& Engine::motion() const { return implementation_->motion(); }
ComputedMotion& Engine::motion() { return implementation_->motion(); }

}  // namespace voroproof::internal
