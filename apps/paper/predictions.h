// How many events the paper's algorithm would predict on the way through a history.
#pragma once

#include <cstdint>
#include <set>
#include <utility>

#include "engine/engine.h"
#include "exact/topology/named_diagram.h"
#include "filtered/search/contact.h"

namespace voroproof::internal {

// Follows the engine's events with a motion of its own, and searches after every instant what
// Algorithm 2 of the paper searches: the next flip of every edge whose four generators or their
// motion have changed (after a flip five edges, after a collision all that the two disks are
// generators of), and the next contact of every pair whose adjacency or motion is new; at first
// all. A search looks up to the horizon, as if nothing
// else happened, not even contacts. It starts at the first
// binary64 after the instant, and what it finds there and then is exact. Each event found counts
// once a search.
class PredictionCounter {
 public:
  explicit PredictionCounter(const MotionInput& input);

  void begin(const std::vector<Quad>& initial);
  void flip(double t, const Quad& edge);
  void collide(double t, GenId i, GenId j);
  // To be called after the last event.
  void finish() { predict(); }

  std::uint64_t flips() const { return flips_; }
  // The predicted flips that no contact among the four generators precedes: after a contact they
  // would have to pass through each other.
  std::uint64_t flips_before_contact() const { return flips_before_contact_; }
  // The predicted flips if any root of the flip polynomial counts: the rule of Algorithm 2 as it is
  // printed (line 9), by which roots that are no collapses are found only when their time comes.
  std::uint64_t roots() const { return roots_; }
  std::uint64_t collisions() const { return collisions_; }

 private:
  void advance(double t);
  void predict();
  void predict_flip(const Quad& edge, const Instant& now);
  double first_contact(const Quad& edge, const Instant& now);
  bool flips_within(const Quad& edge, double start, double end);

  double horizon_;
  ComputedMotion motion_;
  TierCounts tiers_;
  CollapseSearch collapses_;
  ContactSearch contacts_;
  NamedDiagram diagram_;
  double now_ = 0;
  // Changes since the last instant: half-edges of changed edges and of new adjacencies, and disks
  // that have collided.
  std::set<Diagram::HalfEdge> changed_, adjacent_;
  std::set<GenId> moved_;
  std::uint64_t flips_ = 0, flips_before_contact_ = 0, roots_ = 0, collisions_ = 0;
};

}  // namespace voroproof::internal
