// What the programs that measure whole runs write as JSON.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "filtered/numbers/stats.h"

namespace voroproof::internal::bench {

// Throws std::runtime_error where the file cannot be written.
inline void write_report(const std::string& path, const nlohmann::ordered_json& report) {
  std::ofstream out(path);
  out << report.dump(2) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

// How many decisions each tier made.
inline nlohmann::ordered_json tiers_json(const TierCounts& tiers) {
  nlohmann::ordered_json out;
  for (std::size_t p = 0; p < tiers.decided.size(); ++p) {
    for (std::size_t t = 0; t < tier_names.size(); ++t) {
      out[std::string(predicate_names[p])][std::string(tier_names[t])] = tiers.decided[p][t];
    }
  }
  return out;
}

}  // namespace voroproof::internal::bench
