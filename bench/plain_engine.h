// The engine in plain doubles: the same processing and the same schedule as the exact one, over an
// arithmetic that proves nothing. It exists to be measured against.
#pragma once

#include <memory>
#include <vector>

#include "engine/engine.h"

namespace voroproof::internal::bench {

class PlainEngine {
 public:
  // The members are as those of Engine.
  PlainEngine(MotionInput input, std::vector<ManeuverInput> maneuvers, EngineOptions options);
  ~PlainEngine();
  Outcome run(EventSink& sink);
  const EngineStats& stats() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace voroproof::internal::bench
