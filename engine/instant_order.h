// The events of an instant and their order, for a run and for the leader of one in slices.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/event.h"
#include "engine/inelastic_collapse.h"
#include "engine/maneuvers.h"
#include "exact/patience.h"

namespace voroproof::internal {

// Sets `ties` to the next event of `source` and all that are simultaneous with it; false if there
// are no more. `near`: memory. A source has
//   bool advance()               whether there is an event, found so far that take() gives it;
//   bool is_near(double bound)   whether there may be an event at the bound or before it;
//   optional<FoundEvent> take()  takes the one that may be next, once one of these has said so;
//                                nothing where it turns out to be none as yet;
//   void put_back(event)         of those that were taken.
template <class Arithmetic, class Source>
bool next_instant(Arithmetic& arithmetic, Source& source, std::vector<FoundEvent>& ties,
                  std::vector<FoundEvent>& near) {
  ties.clear();
  near.clear();
  if (!source.advance()) return false;
  // A contact that nothing is near needs no refinement: its collision computes it.
  FoundEvent first = *source.take();
  if (!first.is_contact()) arithmetic.tighten(first);
  ties.push_back(first);
  while (source.is_near(first.hi)) {
    Patience::ask();
    if (!first.tight) {
      arithmetic.tighten(first);
      ties.assign(1, first);
      continue;
    }
    std::optional<FoundEvent> event = source.take();
    if (!event) continue;
    arithmetic.tighten(*event);
    const int order = event->lo > first.hi ? -1 : arithmetic.order(first, *event);
    if (order < 0) {
      near.push_back(*event);
    } else if (order > 0) {
      near.insert(near.end(), ties.begin(), ties.end());
      ties.assign(1, *event);
      first = *event;
    } else {
      ties.push_back(*event);
    }
  }
  for (const FoundEvent& event : near) source.put_back(event);
  return true;
}

// The base that a class has before those that refer to its motion.
struct OwnMotion {
  ComputedMotion motion_;
};

// The pairs and maneuvers that are due at the present instant.
struct DueTurns {
  std::set<std::pair<GenId, GenId>> contacts;  // that touch and approach
  bool maneuvers = false;
};

// The turns of an instant, in their order, by the class `Self` derived from this one:
//   void tell_collision(i, j, impact, lone)  `lone`: it tells the time of the instant;
//   void tell_maneuver(disk, state);
//   void look_around(g)     the disk has a new velocity: adds what it touches and approaches now;
//   vector take_maneuvers() those that are due, in the order of their disks;
//   double quiet_until()    no other maneuver comes before this time.
template <class Self, class Arithmetic>
class Turning {
 protected:
  // All outlive this object. `profile`: whether the time that the motion takes is noted.
  Turning(const Motion& motion, Arithmetic& arithmetic, DueTurns& due, EngineStats& stats,
          bool profile)
      : collapse_watch_(motion),
        arithmetic_(arithmetic),
        due_(due),
        stats_(stats),
        profile_(profile) {}

  // Collisions, the smallest pair first, then maneuvers, then the collisions that these cause.
  void process_due() {
    for (;;) {
      if (!due_.contacts.empty()) {
        const auto [i, j] = due_.contacts.extract(due_.contacts.begin()).value();
        collide(i, j);
      } else if (std::exchange(due_.maneuvers, false)) {
        maneuver(self().take_maneuvers());
      } else {
        return;
      }
    }
  }

  bool tells_time_ = false;  // the contact that is due is alone at the instant and tells its time
  InelasticCollapse collapse_watch_;

 private:
  Self& self() { return static_cast<Self&>(*this); }

  void collide(GenId i, GenId j) {
    const bool lone = std::exchange(tells_time_, false);
    Impact impact;
    {
      const Stopwatch watch(profile_, stats_.move_seconds);
      impact = arithmetic_.collide(i, j, lone);
    }
    self().tell_collision(i, j, impact, lone);
    collapse_watch_.after_collision(i, j, arithmetic_.now(), self().quiet_until());
    for (const GenId g : {i, j}) change(g);
  }
  void maneuver(const std::vector<ManeuverInput>& together) {
    arithmetic_.is_at(Moment::at(together.front().t));
    for (const ManeuverInput& m : together) {
      const Stopwatch watch(profile_, stats_.move_seconds);
      self().tell_maneuver(m.disk, arithmetic_.maneuver(m.disk, m.t, m.vx, m.vy));
    }
    for (const ManeuverInput& m : together) change(m.disk);
  }
  void change(GenId g) {
    if (g == container_id) return;
    std::erase_if(due_.contacts, [g](const auto& p) { return p.first == g || p.second == g; });
    self().look_around(g);
  }

  Arithmetic& arithmetic_;
  DueTurns& due_;
  EngineStats& stats_;
  bool profile_;
};

}  // namespace voroproof::internal
