// Who receives a history while it is computed.
#pragma once

#include <vector>

#include "exact/generators.h"
#include "filtered/computed/computed_motion.h"

namespace voroproof::internal {

// Receives the history in its order. Times and states are rounded to nearest.
class EventSink {
 public:
  virtual ~EventSink() = default;
  // The diagram at 0+, canonical and sorted. Called first.
  virtual void begin(const std::vector<Quad>& initial) = 0;
  virtual void flip(double t, const Quad& edge) = 0;  // canonical, just before the flip
  // i < j; `first` is the state of i, meaningless where i is the container.
  virtual void collide(double t, GenId i, GenId j, const RoundedState& first,
                       const RoundedState& second) = 0;
  virtual void maneuver(double t, GenId disk, const RoundedState& state) = 0;
};

// Keeps nothing: for runs whose engine alone matters.
class NoSink final : public EventSink {
 public:
  void begin(const std::vector<Quad>&) override {}
  void flip(double, const Quad&) override {}
  void collide(double, GenId, GenId, const RoundedState&, const RoundedState&) override {}
  void maneuver(double, GenId, const RoundedState&) override {}
};

}  // namespace voroproof::internal
