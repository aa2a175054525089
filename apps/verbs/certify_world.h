// The verb certify, for worlds.
#pragma once

#include <cstdint>
#include <string>

#include "apps/cli/verb.h"
#include "exact/rational.h"

namespace voroproof::internal {

struct WorldClaim {
  std::string scene, history;
  Rational tolerance;
  std::uint64_t max_events = 0;
  bool quiet = false;
};

// Judges the history of a scene of version 2, whose exact truth is also the recorded one.
ExitCode certify_world(const WorldClaim& claim);

}  // namespace voroproof::internal
