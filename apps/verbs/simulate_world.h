// The verb simulate, for worlds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/cli/verb.h"
#include "exact/rational.h"

namespace voroproof::internal {

struct WorldRequest {
  std::string scene, history;
  std::optional<Rational> horizon;  // in place of the scene's
  std::uint64_t max_events = 0;
  bool filters = true, replace = false, quiet = false;
};

// Writes the history of a scene of version 2.
ExitCode simulate_world(const WorldRequest& request);

}  // namespace voroproof::internal
