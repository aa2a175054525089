// Flips, and the searches for flips that a change of motion or another flip asks for.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/engine_stats.h"
#include "engine/fetch.h"
#include "engine/flip_kind.h"
#include "engine/instant_record.h"
#include "engine/schedule.h"

namespace voroproof::internal {

template <class Arithmetic>
class Flipping {
 public:
  using HalfEdge = Diagram::HalfEdge;

  // All must outlive this object.
  Flipping(Diagram& diagram, const Motion& motion, Arithmetic& arithmetic,
           Schedule<Arithmetic>& schedule, InstantRecord& instant, EngineStats& stats)
      : diagram_(diagram),
        disks_(motion.size()),
        arithmetic_(arithmetic),
        schedule_(schedule),
        instant_(instant),
        stats_(stats),
        fetch_(diagram, motion) {}

  // The diagram has all its edges.
  void start() { stamp_.assign(diagram_.edges(), 0); }
  // The diagram is that of the first instant: its flips are events from now on.
  void begin() {
    degrees_ = Degrees(diagram_, disks_);
    begun_ = true;
  }
  bool begun() const { return begun_; }
  Degrees& degrees() { return degrees_; }

  void search_all() {
    for (int e = 0; e < diagram_.edges(); ++e) schedule_.search_flip_from_now(e);
  }
  // Another change of motions, for search_once().
  void next_change() { ++stamp_now_; }
  // Once for all changes of an instant.
  void search_once(int edge) {
    if (stamp_[edge] == stamp_now_) return;
    stamp_[edge] = stamp_now_;
    schedule_.forget_flip_of(edge);
    if (begun_) schedule_.search_flip_from_now(edge);
  }

  // Flips the edge, which is due. The contact of its new pair is the caller's.
  void process(int edge) {
    const HalfEdge h = 2 * edge;
    const Quad q = diagram_.quad(h);
    const auto root = schedule_.take_root(edge);
    if (!root.isolated) arithmetic_.note_flip(q);
    ++stats_.flips[static_cast<int>(degrees_.kind_of_flip(diagram_, q))];
    const HalfEdge sides[4] = {diagram_.next(h), diagram_.previous(h), diagram_.next(h ^ 1),
                               diagram_.previous(h ^ 1)};
    int around[4];
    for (int k = 0; k < 4; ++k) {
      around[k] = sides[k] / 2;
      fetch_.beyond(sides[k]);
    }
    diagram_.flip(h);
    degrees_.flip(q);
    instant_.add_flip(canonical(q));
    // Edges with the same four generators have the flip time as a root: they start
    // beyond its isolating interval, where they are legal by construction.
    const auto search = [&](int e) {
      schedule_.forget_flip_of(e);
      const bool same = e == edge || same_generators(diagram_.quad(2 * e), q);
      if (same && root.isolated) {
        schedule_.search_flip_after(e, root.hi, root.fine.get());
      } else {
        schedule_.search_flip_from_now(e);
      }
    };
    search(edge);
    for (int k = 0; k < 4; ++k) {
      // In small configurations one edge may appear twice.
      if (std::find(around, around + k, around[k]) == around + k && around[k] != edge) {
        search(around[k]);
      }
    }
  }

 private:
  Diagram& diagram_;
  int disks_;
  Arithmetic& arithmetic_;
  Schedule<Arithmetic>& schedule_;
  InstantRecord& instant_;
  EngineStats& stats_;
  Fetch fetch_;
  Degrees degrees_;
  bool begun_ = false;
  std::vector<std::uint64_t> stamp_;  // by edge: the last change of motions they were searched for
  std::uint64_t stamp_now_ = 0;
};

// How far the first searches look ahead: a quarter of the time in which a disk of this speed goes
// as far as from one disk to the next.
inline double window_at_speed(const Motion& motion, double speed) {
  const double spacing =
      2 * round_nearest(motion.input().container_radius) / std::sqrt(1.0 + motion.size());
  return speed > 0 ? 0.25 * spacing / speed : round_up(motion.input().horizon);
}
// At the start of a run: with the speed of the fastest disk.
inline double first_window(const Motion& motion) {
  double speed = 0;
  for (GenId g = 0; g < motion.size(); ++g) {
    const DoubleMotion& m = motion.doubles(g);
    speed = std::fmax(speed, std::hypot(m.vx, m.vy));
  }
  return window_at_speed(motion, speed);
}

}  // namespace voroproof::internal
