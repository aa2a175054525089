// The motion of all disks, ahead of their diagram: a run in slices (engine/sliced_run.h) begins
// with it.
//
// Collisions, maneuvers and their order are those of an engine's run, by the same searches, proofs
// and laws. Pairs are found by the lattice of NearCells in place of V-edges: disks that collide are
// neighbours in the diagram (the paper's Lemma 3), so both ways find the same.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "engine/certified.h"
#include "engine/engine.h"
#include "engine/inelastic_collapse.h"
#include "engine/led_turns.h"
#include "engine/near_cells.h"
#include "engine/waiting_queue.h"

namespace voroproof::internal {

class Leader {
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

 private:
  // An item of the queue: a contact of i < j in [lo, hi] while both are in the states of these ids,
  // or, with j = kLeaves, the time at which i leaves its square, while stays_[i] is state_j. The
  // queue has the next contact of any two disks whose squares share a corner.
  struct Entry {
    double key, lo, hi;
    GenId i, j;
    int state_i, state_j;
    bool operator<(const Entry& o) const { return key > o.key; }  // the least is the heap's head
  };
  static constexpr GenId kLeaves = -2;

  void start();
  bool step();
  bool next_instant();
  std::optional<FoundEvent> take(double bound);
  void put_back(const FoundEvent& event, double key);
  bool is_tied(const FoundEvent& event) const;
  const Entry* head();
  double next_key();
  bool is_stale(const Entry& e) const;
  void process_due();
  void process_contact(GenId i, GenId j, bool lone);
  void process_maneuvers(const std::vector<ManeuverInput>& together);
  void change(GenId g);
  void renew(GenId g, double t);
  void leave(GenId g, double t);
  void await_leaving(GenId g, double t);
  void search_near(GenId g, int before);
  void search(GenId g, GenId other);

  EngineStats stats_;
  ComputedMotion motion_;
  Certified arithmetic_;
  Maneuvers maneuvers_;
  Rational horizon_;
  double horizon_up_;
  InelasticCollapse collapse_watch_;
  NearCells cells_;
  WaitingQueue<Entry> queue_;
  std::vector<int> stays_;  // by disk: how often the time was found at which it leaves
  bool started_ = false;
  std::uint64_t work_ = 0;  // changes so far of a motion or of a square
  // The present instant.
  std::vector<TimedEvent> ties_, near_;
  bool has_maneuvers_ = false, has_horizon_ = false;  // among what was taken for it
  std::set<std::pair<GenId, GenId>> due_;
  bool due_maneuvers_ = false;
  bool is_settled_ = false;  // all of it is processed
  std::vector<GenId> changed_;
  std::vector<GenId> near_disks_;  // the memory of search_near()
  LedTurns* turns_ = nullptr;
};

}  // namespace voroproof::internal
