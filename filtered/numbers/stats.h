// How often each predicate was decided, and in which tier.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace voroproof::internal {

// Tiers in order of cost: double with error bound, double-double with error bound,
// balls, proofs by symmetry, exact arithmetic.
enum class Tier { filter, dd, ball, symmetry, exact, count };
inline constexpr std::array<std::string_view, static_cast<int>(Tier::count)> tier_names{
    "double", "double-double", "ball", "symmetry", "exact"};

enum class Predicate { flip_search, contact_search, compare, round_time, incircle, count };
inline constexpr std::array<std::string_view, static_cast<int>(Predicate::count)> predicate_names{
    "flip_search", "contact_search", "compare_times", "round_time", "incircle"};

// Counters of one thread. Each thread of a run has its own; sums are taken at the end.
struct TierCounts {
  std::array<std::array<std::uint64_t, static_cast<int>(Tier::count)>,
             static_cast<int>(Predicate::count)>
      decided{};
  // Comparisons of times that took more than double-doubles, and the certifier's questions of lives
  // and flips that its first filter leaves open.
  std::int64_t beyond_filter = 0;
  void count(Predicate p, Tier t, std::uint64_t decisions = 1) {
    decided[static_cast<int>(p)][static_cast<int>(t)] += decisions;
  }
  TierCounts& operator+=(const TierCounts& o) {
    for (std::size_t p = 0; p < decided.size(); ++p) {
      for (std::size_t t = 0; t < decided[p].size(); ++t) decided[p][t] += o.decided[p][t];
    }
    beyond_filter += o.beyond_filter;
    return *this;
  }
};

}  // namespace voroproof::internal
