// The engine of billiards: all collisions of a scene, in their exact order.
//
// Pairs that may meet in a window of time are found by boxes around their ways in it, in doubles
// (filtered/billiards/). When two meet is a root of a quadratic; a run is exact in fractions as
// long as all such roots are fractions, and in balls of as many bits as it needs otherwise: where a
// ball does not tell what comes first, or how a value rounds, the run is repeated with twice the
// bits. What has been told stays: it was certain. Times that are the same are told in fractions
// only.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "exact/billiard_events.h"

namespace voroproof::internal {

struct BilliardOptions {
  int start_bits = 256, max_bits = 32768;
  std::uint64_t max_events = 0;  // a run of more stops; 0: no limit
  // Called now and then, also within a long decision, with the time and the number of events; false
  // interrupts.
  std::function<bool(double t, std::uint64_t events)> monitor;
};

struct BilliardOutcome {
  enum class Kind { complete, stopped, interrupted } kind = Kind::complete;
  double t = 0;        // up to which all events were told
  std::string reason;  // why it is not complete
  int bits = 0;        // that the run took; 0: fractions
};

// Precondition: find_overlap_at_start() finds none. Tells the events up to the horizon, each once,
// in their order (docs/formats.md, section 21). Times, velocities and centres are rounded to
// nearest; in balls a coordinate below 2^-90 of the largest may be told as 0.
BilliardOutcome run_billiard(const Billiard& billiard, const BilliardOptions& options,
                             const std::function<void(const BilliardEvent&)>& tell);

}  // namespace voroproof::internal
