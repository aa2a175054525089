// The diagram of a run, and what is done to it at each instant.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/fetch.h"
#include "engine/flipping.h"
#include "engine/instant_order.h"
#include "engine/instant_record.h"
#include "engine/schedule.h"
#include "engine/static_diagram.h"

namespace voroproof::internal {

// The paper's Algorithm 2, but for how disks turn. That is told by the class `Self` derived from
// this one:
//   void begin_instant()       the events of the next instant are found: ties_; it may add to them;
//   bool tells_time()          whether its turns tell the time of the instant;
//   void process_turns()       does what is due to turn, if anything is, then settle_turns();
//   void search_contact(edge)  searches for the next contact of the edge's pair.
// `Arithmetic` is Certified (engine/certified.h) or a class with the same members.
template <class Self, class Arithmetic>
class Run {
 public:
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  const EngineStats& stats() const { return stats_; }
  Diagram& diagram() { return diagram_; }

 protected:
  using HalfEdge = Diagram::HalfEdge;

  // The motion outlives this object. `max_events`: see InstantRecord.
  Run(ComputedMotion& motion, std::vector<ManeuverInput> maneuvers, bool profile,
      std::uint64_t max_events)
      : motion_(motion),
        diagram_(motion.size()),
        arithmetic_(motion, stats_),
        schedule_(diagram_, arithmetic_, stats_, profile, std::move(maneuvers),
                  motion.input().horizon),
        instant_(max_events),
        flipping_(diagram_, motion, arithmetic_, schedule_, instant_, stats_),
        fetch_(diagram_, motion) {}
  ~Run() = default;

  // Makes a diagram that is right at the time t, at which the run begins.
  void construct(double t) {
    arithmetic_.is_at(Moment::at(t));
    diagram_ = static_diagram(motion_, to_rational(t), stats_.tiers);
    flipping_.start();
  }

  // One instant; false if it is the horizon and has no event, or there is none.
  bool step() {
    if (!next_instant(arithmetic_, schedule_, ties_, near_)) return false;
    self().begin_instant();
    if (diagram_.edges() > 0) {
      const int item = ties_.front().item;
      if (item < schedule_.maneuver_item()) fetch_.around_edge(item & ~1);
      schedule_.fetch_ahead(fetch_);
    }
    arithmetic_.begin(ties_);
    const bool alone = ties_.size() == 1;
    if (alone && schedule_.is_horizon(ties_.front())) return false;
    if (!self().tells_time()) instant_.set_time(arithmetic_.rounded(ties_.front()));
    if (alone && ties_.front().is_flip()) {
      process_flip(ties_.front().item / 2);
    } else {
      for (const FoundEvent& event : ties_) schedule_.make_due(event);
    }
    self().process_turns();
    while (const std::optional<int> edge = schedule_.take_due_flip()) process_flip(*edge);
    return true;
  }

  // The disk has another velocity since the present instant.
  void note_turn(GenId g) {
    if (g == container_id) return;
    if (std::find(turned_.begin(), turned_.end(), g) == turned_.end()) turned_.push_back(g);
  }
  // All turns of the instant are done. The searches are made only now: with some of the instant's
  // velocities most would be for nothing, and harder than those that count.
  void settle_turns() {
    if (turned_.empty()) return;
    arithmetic_.after_changes();
    if (arithmetic_.has_points()) {
      for (const GenId g : turned_) require_areas(g);
    }
    flipping_.next_change();
    for (const GenId g : turned_) search_around(g);
    turned_.clear();
  }

  // The half-edges of the disk's cell, counterclockwise; half-edge 0 for a lone disk.
  template <class Visit>
  void for_each_half_edge_of(GenId g, Visit&& visit) const {
    if (diagram_.anchor(g) < 0) return visit(0);
    for (const HalfEdge h : diagram_.ring(g)) visit(h);
  }

  EngineStats stats_;
  ComputedMotion& motion_;
  Diagram diagram_;
  Arithmetic arithmetic_;
  Schedule<Arithmetic> schedule_;
  InstantRecord instant_;
  Flipping<Arithmetic> flipping_;
  std::vector<FoundEvent> ties_;  // the events of the present instant

 private:
  Self& self() { return static_cast<Self&>(*this); }

  void process_flip(int edge) {
    flipping_.process(edge);
    self().search_contact(edge);
  }
  // The disk's motion and that of its neighbours is settled for the instant.
  void search_around(GenId g) {
    const HalfEdge first = diagram_.anchor(g);
    if (first >= 0) fetch_.around_cell(first);
    for_each_half_edge_of(g, [&](HalfEdge h) {
      self().search_contact(h / 2);
      if (first < 0) return;
      flipping_.search_once(h / 2);
      flipping_.search_once(diagram_.next(h) / 2);
    });
  }
  // The cells of the disk, if it is a point, and of its neighbours that are points.
  void require_areas(GenId g) const {
    const std::vector<GenId> near = diagram_.neighbours(g);
    arithmetic_.require_area(g, near);
    for (const GenId n : near) arithmetic_.require_area(n, diagram_.neighbours(n));
  }

  Fetch fetch_;
  std::vector<FoundEvent> near_;  // the memory of next_instant()
  std::vector<GenId> turned_;     // at the present instant
};

}  // namespace voroproof::internal
