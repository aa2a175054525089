#include "certify/shard.h"

#include <algorithm>
#include <utility>

namespace voroproof::internal {

int shard_of(double t, double horizon, int of) {
  if (!(horizon > 0)) return 1;
  return std::min(of, 1 + static_cast<int>(t / horizon * of));
}

void append(Certificate& total, Certificate&& next) {
  total.verdict = next.verdict;
  total.divergence = std::move(next.divergence);
  total.reason = std::move(next.reason);
  total.reason_line = next.reason_line;
  total.prefix_events += next.prefix_events;
  total.prefix_t = next.prefix_t;
  total.flips += next.flips;
  total.collisions += next.collisions;
  total.maneuvers += next.maneuvers;
  total.edge_lives += next.edge_lives;
  total.pair_lives += next.pair_lives;
  total.simultaneous += next.simultaneous;
  total.swaps += next.swaps;
  total.resolved += next.resolved;
  total.grazes += next.grazes;
  total.rounding_overlaps += next.rounding_overlaps;
  total.at_horizon += next.at_horizon;
  total.left_out += next.left_out;
  total.proved_anew += next.proved_anew;
  total.computed_velocities += next.computed_velocities;
  total.other_orders += next.other_orders;
  if (next.ulps_max > total.ulps_max) {
    total.ulps_max = next.ulps_max;
    total.ulps_max_line = next.ulps_max_line;
  }
  total.ulps_sum += next.ulps_sum;
  total.ulps_count += next.ulps_count;
  total.highest_bits = std::max(total.highest_bits, next.highest_bits);
  total.tiers += next.tiers;
  for (std::string& remark : next.remarks) {
    if (std::find(total.remarks.begin(), total.remarks.end(), remark) == total.remarks.end()) {
      total.remarks.push_back(std::move(remark));
    }
  }
}

}  // namespace voroproof::internal
