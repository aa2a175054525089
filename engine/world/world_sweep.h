// From one instant of a world to the next: what comes for every V-edge and every hidden disk, and
// what is done at an instant.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "engine/world/live_diagram.h"
#include "engine/world/moving_rows.h"
#include "filtered/worlds/lazy_time.h"

namespace voroproof::internal {

// A change of the diagram that is no jump.
using WorldChange = std::variant<Quad, Hide, Appear, Swap>;

// Receives what a sweep does.
class ChangeSink {
 public:
  virtual ~ChangeSink() = default;
  virtual void change(const LazyTime& t, const WorldChange& change) = 0;
  // Whether it takes swaps. If not, where a disk takes the place of the one that hides it, since
  // both are the same for an instant, it receives steps that lead to the same diagram.
  virtual bool takes_swaps() const = 0;
  // All that is due at an instant has been told.
  virtual void instant_is_over() {}
};

class WorldSweep {
 public:
  // All outlive it. The diagram is that just after `now`, and nothing is looked for yet. Nothing
  // after `end` is.
  WorldSweep(LiveDiagram& live, const MovingRows& rows, const Rational& now, Rational end,
             ChangeSink& sink);

  const LazyTime& now() const { return now_; }

  // Every instant before `until`, or that too. Throws Undecided.
  void run_before(const Rational& until);
  void run_up_to(const Rational& until);
  // It is some time between the last instant and the next one now.
  void wait_until(const Rational& t) { now_ = t; }
  // It is the instant t now, before which everything has been done.
  void begin_instant(const Rational& t);
  // The paths of the disk are other ones from now on.
  void turn(GenId g);
  // So are those of one that has come for this instant: where it is one with another, that has been
  // seen to.
  void arrive(GenId g);
  // Edges and disks that may be due at the present instant.
  void suspect(const std::vector<int>& edges, const std::vector<GenId>& disks);
  // Does all that is due at the present instant. Throws Undecided.
  void settle();
  // Looks for what comes next for all that has become another.
  void look_ahead();
  // Everything that has been looked ahead for.
  const std::set<int>& edges_seen() const { return edges_seen_; }
  const std::set<GenId>& disks_seen() const { return disks_seen_; }

 private:
  using HalfEdge = Diagram::HalfEdge;
  // An edge's collapse and the meeting of its two generators, the exit of a hidden disk; that of a
  // lone visible disk, which has no edge, from the frame.
  enum class Kind { collapse, meeting, exit, alone };
  struct Item {
    Kind kind;
    int index;  // the edge's or the disk's
    auto operator<=>(const Item&) const = default;
  };
  using Pair = std::pair<GenId, GenId>;

  std::optional<LazyTime> next() const;
  void step(const LazyTime& t);
  void gather_due();
  void schedule(const Item& item, std::optional<LazyTime> time);
  std::optional<LazyTime> collapse_of(const Quad& q) const;
  void absorb();
  void suspect(int edge);
  void examine_pairs();
  void check_crowded();
  bool swap_one();
  bool hide_one();
  bool appear_one();
  bool touch_one();
  bool has_flipped(const Quad& q) const;
  bool flip_one();
  void flip(HalfEdge h);
  void exchange(GenId i, GenId j);
  void take_place(GenId g, GenId j);
  GenId visible_host(GenId j) const;

  LiveDiagram& live_;
  const MovingRows& rows_;
  LazyTime now_;
  Rational end_;
  ChangeSink& sink_;
  std::map<Item, LazyTime> found_;
  std::set<std::pair<double, Item>> queue_;  // by lower bounds
  // At the present instant: edges whose pair, or whose own state, is not examined yet; pairs that
  // meet, the inner one first where they are not the same; disks that may leave their hosts, edges
  // to be flipped.
  std::set<int> new_pairs_, new_edges_;
  std::set<Pair> swaps_, hides_, touches_;
  std::set<GenId> exits_;
  std::set<std::pair<Quad, int>> illegal_;
  std::set<int> due_edges_;           // their collapse was found for this instant
  std::set<int> fresh_edges_;         // that flips have made
  std::set<GenId> turned_, arrived_;  // whose paths are other ones
  std::set<GenId> crowded_;           // that have come out beside more than one
  std::vector<Quad> flips_;           // that were done
  // Edges and disks for which what comes next is not known.
  std::set<int> stale_edges_;
  std::set<GenId> stale_disks_;
  std::set<int> edges_seen_;
  std::set<GenId> disks_seen_;
};

}  // namespace voroproof::internal
