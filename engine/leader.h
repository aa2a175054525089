// The motion of all disks, ahead of their diagram: a run in slices (engine/sliced_run.h) begins
// with it.
//
// Collisions, maneuvers and their order are those of an engine's run, by the same searches, proofs
// and laws. Pairs are found by the lattice of NearCells in place of V-edges: disks that collide are
// neighbours in the diagram (the paper's Lemma 3), so both ways find the same.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "engine/certified.h"
#include "engine/engine.h"
#include "engine/instant_order.h"
#include "engine/led_turns.h"
#include "engine/near_cells.h"
#include "engine/waiting_queue.h"

namespace voroproof::internal {

class Leader : OwnMotion, Turning<Leader, Certified> {
 public:
  Leader(MotionInput input, std::vector<ManeuverInput> maneuvers, const MotionOptions& options);
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;

  // Whether this scene can be led: it has no points, and NearCells are possible.
  bool possible() const { return cells_.possible() && !arithmetic_.has_points(); }

  // Goes on for about `work` changes of a motion or of a square, and adds the instants to `turns`.
  // Returns a time after them and before all others at which to go on, or nothing where the horizon
  // is reached and its events are told. `border`, unless it is null, chooses that time. Throws
  // Undecided where a run would, and where it cannot tell; it is of no further use then.
  std::optional<double> lead(LedTurns& turns, std::uint64_t work,
                             const std::function<double(double, double)>& border);

  // About how much work there is still to come, if it goes on as it did, or, before the first
  // lead(), as the disks move then.
  double work_ahead() const;

  const ComputedMotion& motion() const { return motion_; }
  ComputedMotion& motion() { return motion_; }
  const EngineStats& stats() const { return stats_; }
  // InelasticCollapse::pasts().
  const std::vector<InelasticCollapse::Past>& collapses() const { return collapse_watch_.pasts(); }

  // ---- What next_instant() asks of a source (engine/instant_order.h). ----
  bool advance() { return is_near(std::numeric_limits<double>::infinity()); }
  bool is_near(double bound);
  std::optional<FoundEvent> take();
  void put_back(const FoundEvent& event);

 private:
  friend Turning;

  // An item of the queue: a contact of i < j in [lo, hi] while both are in the states of these ids,
  // or, with j = kLeaves, the time at which i leaves its square, while stays_[i] is state_j; or the
  // next maneuvers, or the horizon, with such a j. The queue has the next contact of any two disks
  // whose squares share a corner.
  struct Entry {
    double key, lo, hi;
    GenId i, j;
    int state_i, state_j;
    bool operator<(const Entry& o) const { return key > o.key; }  // the least is the heap's head
  };
  static constexpr GenId kLeaves = -2, kManeuvers = -3, kHorizon = -4;

  void start();
  bool step();
  bool is_tied(const Entry& entry) const;
  const Entry* head();
  bool is_stale(const Entry& e) const;
  void process_turns();
  // ---- What Turning asks for. ----
  void tell_collision(GenId i, GenId j, const Impact& impact, bool lone);
  void tell_maneuver(GenId disk, const RoundedState& state);
  void look_around(GenId g);
  std::vector<ManeuverInput> take_maneuvers();
  double quiet_until() const { return maneuvers_.next_down(); }

  void renew(GenId g, double t);
  void leave(GenId g, double t);
  void await_maneuvers();
  void await_leaving(GenId g, double t);
  void search_near(GenId g, int before);
  void search(GenId g, GenId other);

  EngineStats stats_;
  Certified arithmetic_;
  Maneuvers maneuvers_;
  Rational horizon_;
  double horizon_up_;
  NearCells cells_;
  WaitingQueue<Entry> queue_;
  std::vector<int> stays_;  // by disk: how often the time was found at which it leaves
  bool started_ = false;
  std::uint64_t work_ = 0;  // changes so far of a motion or of a square
  // The present instant.
  std::vector<FoundEvent> ties_, near_;
  DueTurns due_;
  bool is_settled_ = false;  // all of it is processed
  std::vector<GenId> changed_;
  std::vector<GenId> near_disks_;  // the memory of search_near()
  LedTurns* turns_ = nullptr;
};

}  // namespace voroproof::internal
