// Which pairs may touch, where no diagram tells the neighbours.
//
// Every disk is watched in windows of time, one after the other, and is in a box for as long as a
// window of it lasts. Two whose boxes are disjoint do not touch while both windows last. The
// container has no windows: it may be touched by every disk.
#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "filtered/motion/motion.h"

namespace voroproof::internal {

class NearPairs {
 public:
  // Nothing is asked for after the horizon.
  NearPairs(const Motion& motion, double horizon) : motion_(motion), horizon_(horizon) {}

  // Two generators, i < j, and the time since which the present windows of both last.
  struct Pair {
    GenId i, j;
    double since;
  };

  // The windows of all disks begin at t. No windows are there before.
  void assign(double t);
  bool assigned() const { return !windows_.empty(); }
  // A window of disk g begins at t in place of the one before, under the present motion of the
  // disk. It lasts until `least_end` at least.
  void begin(GenId g, double t, double least_end);
  // The windows of all disks last until t at least.
  void extend(double t);

  double begin_of(GenId g) const { return windows_[static_cast<std::size_t>(g)].begin; }
  double end_of(GenId g) const { return windows_[static_cast<std::size_t>(g)].end; }
  // The disk whose window ends first; nothing where all last until t.
  std::optional<GenId> first_to_end_before(double t);
  double since(GenId i, GenId j) const;

  // The pairs of disk g that may touch while both windows last.
  std::vector<Pair> around(GenId g);
  // All such pairs, in a fixed order.
  std::vector<Pair> all();

 private:
  struct Box {
    double lo[2], hi[2];
    bool meets(const Box& other) const;
  };
  struct Window {
    double begin = 0, end = 0;
    Box box;
    int first[2], last[2];  // the cells that the box meets, by column and row
  };
  Box box(GenId g, double from, double to) const;
  int cell(double x, int axis) const;
  template <class Visit>
  void each_cell(const Window& w, Visit&& visit);
  void watch(GenId g, double from, double to);
  void forget(GenId g);

  const Motion& motion_;
  double horizon_;
  // A grid over the container. What lies beyond it belongs to the cells at its border.
  int side_ = 1;
  double low_[2] = {0, 0}, size_ = 1;
  std::vector<std::vector<GenId>> cells_;
  std::vector<Window> windows_;  // by disk
  using Ending = std::pair<double, GenId>;
  // Ends of windows, those of windows that are no more among them.
  std::priority_queue<Ending, std::vector<Ending>, std::greater<>> endings_;
  std::vector<long> seen_;  // by disk: the last search that came upon it
  long search_ = 0;
};

}  // namespace voroproof::internal
