// The counts that an engine keeps while it runs.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>

#include "engine/flip_kind.h"
#include "filtered/numbers/stats.h"

namespace voroproof::internal {

struct EngineStats {
  std::array<std::uint64_t, static_cast<int>(FlipKind::count)> flips{};
  std::uint64_t disk_collisions = 0, wall_collisions = 0, maneuvers = 0;
  // Collapses and contacts that were predicted (found by a search), whether or not they
  // came true; and the searches made.
  std::uint64_t predicted_flips = 0, predicted_collisions = 0;
  std::uint64_t flip_searches = 0, contact_searches = 0;
  std::uint64_t ties = 0;            // pairs of events proved simultaneous
  std::uint64_t settling_flips = 0;  // at t = 0, not events
  std::uint64_t replays = 0;
  int highest_bits = 0, goal_bits = 0;
  std::uint64_t slices = 0;  // on several threads; 0 if one thread has made all of the history
  double end = 0;            // time reached
  // The paper's four steps (section 7.3), in seconds; only where asked for.
  double flip_seconds = 0, collision_seconds = 0, queue_seconds = 0, move_seconds = 0;
  double initial_seconds = 0;
  TierCounts tiers;
  std::uint64_t flip_count() const {
    std::uint64_t sum = 0;
    for (const auto f : flips) sum += f;
    return sum;
  }

  // Adds what a part of the same run counted. How far it came, and what settled its first diagram,
  // is of the part alone.
  void add(const EngineStats& part) {
    for (std::size_t k = 0; k < flips.size(); ++k) flips[k] += part.flips[k];
    disk_collisions += part.disk_collisions;
    wall_collisions += part.wall_collisions;
    maneuvers += part.maneuvers;
    predicted_flips += part.predicted_flips;
    predicted_collisions += part.predicted_collisions;
    flip_searches += part.flip_searches;
    contact_searches += part.contact_searches;
    ties += part.ties;
    replays += part.replays;
    highest_bits = std::max(highest_bits, part.highest_bits);
    goal_bits = std::max(goal_bits, part.goal_bits);
    slices += part.slices;
    flip_seconds += part.flip_seconds;
    collision_seconds += part.collision_seconds;
    queue_seconds += part.queue_seconds;
    move_seconds += part.move_seconds;
    initial_seconds += part.initial_seconds;
    tiers += part.tiers;
  }
};

// Adds the time spent in a scope to a sum, if it is wanted.
class Stopwatch {
 public:
  Stopwatch(bool wanted, double& sum) : sum_(wanted ? &sum : nullptr) {
    if (sum_ != nullptr) start_ = Clock::now();
  }
  ~Stopwatch() {
    if (sum_ != nullptr) *sum_ += std::chrono::duration<double>(Clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double* sum_;
  Clock::time_point start_{};
};

}  // namespace voroproof::internal
