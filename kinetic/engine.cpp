#include "kinetic/engine.h"

#include "kinetic/certified.h"
#include "kinetic/processing.h"

namespace voroproof::internal {

class Engine::Implementation : public EngineOver<Certified> {
 public:
  using EngineOver<Certified>::EngineOver;
};

Engine::Engine(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(input), std::move(maneuvers),
                                                       std::move(options))) {}
Engine::~Engine() = default;

Outcome Engine::run(EventSink& sink) { return implementation_->run(sink); }
Outcome Engine::resume(const std::function<void(EventSink&)>& told, const Rational& t0,
                       EventSink& sink) {
  return implementation_->resume(told, t0, sink);
}
const EngineStats& Engine::stats() const { return implementation_->stats(); }
const Diagram& Engine::diagram() const { return implementation_->diagram(); }
const Motion& Engine::motion() const { return implementation_->motion(); }
Motion& Engine::motion() { return implementation_->motion(); }

}  // namespace voroproof::internal
