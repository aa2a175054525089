// How many decisions each tier made, as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "filtered/stats.h"

namespace voroproof::bench {

inline nlohmann::ordered_json tiers_json(const TierCounts& tiers) {
  nlohmann::ordered_json out;
  for (std::size_t p = 0; p < tiers.decided.size(); ++p) {
    for (std::size_t t = 0; t < tier_names.size(); ++t) {
      out[std::string(predicate_names[p])][std::string(tier_names[t])] = tiers.decided[p][t];
    }
  }
  return out;
}

}  // namespace voroproof::bench
