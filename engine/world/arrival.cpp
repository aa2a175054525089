#include "engine/world/arrival.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace voroproof::internal {
namespace {

using Rates = std::array<Rational, 3>;
Rates rates(const GrowingDisk& d) { return {d.vx, d.vy, d.growth}; }

}  // namespace

GrowingDisk led(const GrowingDisk& comes, const std::vector<MetDisk>& met) {
  std::set<std::pair<Rates, Rates>> ways;  // those that are the same for ever count once
  for (const MetDisk& d : met) ways.insert({rates(d.before), rates(d.after)});
  const Rates own = rates(comes);
  Rates back;
  for (std::size_t k = 0; k < own.size(); ++k) {
    Rational sum = 0;
    for (const auto& [before, after] : ways) sum += before[k] + after[k];
    back[k] = sum / static_cast<long>(ways.size()) - own[k];
  }
  return {comes.x, comes.y, comes.radius, back[0], back[1], back[2]};
}

}  // namespace voroproof::internal
