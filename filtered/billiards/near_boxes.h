// Which disks of a billiard may meet in a window of time: those whose boxes meet, images included.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "filtered/billiards/billiard_gaps.h"

namespace voroproof::internal {

// Contains the disk at all times of the window.
struct SweptBox {
  std::array<double, 3> lo, hi;
};

// Contains nothing.
inline SweptBox empty_box() {
  SweptBox box;
  box.lo.fill(std::numeric_limits<double>::infinity());
  box.hi.fill(-std::numeric_limits<double>::infinity());
  return box;
}

// Makes `all` contain the other one.
inline void extend(SweptBox& all, const SweptBox& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    all.lo[k] = std::min(all.lo[k], other.lo[k]);
    all.hi[k] = std::max(all.hi[k], other.hi[k]);
  }
}

// Moves all sides outwards by that.
inline void widen(SweptBox& box, double by) {
  for (std::size_t k = 0; k < 3; ++k) {
    box.lo[k] -= by;
    box.hi[k] += by;
  }
}

inline bool is_bounded(const SweptBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(box.lo[k]) || !std::isfinite(box.hi[k])) return false;
  }
  return true;
}

inline bool contains(const SweptBox& all, const SweptBox& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.lo[k] < all.lo[k] || box.hi[k] > all.hi[k]) return false;
  }
  return true;
}

inline bool meet(const SweptBox& a, const SweptBox& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.lo[k] > b.hi[k] || b.lo[k] > a.hi[k]) return false;
  }
  return true;
}

class NearBoxes {
 public:
  explicit NearBoxes(const Billiard& billiard);

  // All pairs of disks, with the image of the second, whose boxes meet in the window [from, to],
  // each once, in order. Boxes are by disk, where the disks are, not folded. Nothing where so many
  // images would have to be looked at that the window is to be split.
  std::optional<std::vector<BilliardPair>> pairs(const std::vector<SweptBox>& boxes, double from,
                                                 double to);

  // The pairs of one disk in that window, looked for among all.
  std::vector<BilliardPair> partners(GenId disk, const std::vector<SweptBox>& boxes, double from,
                                     double to) const;

  // Moves the box by so many sides, by as much as that is at any time of the window.
  void shift(SweptBox& box, const LatticeImage& by, double from, double to) const;

  // How many boxes the last call has compared.
  std::size_t compared() const { return compared_; }

 private:
  // A disk's box, moved by `image` sides of the lattice.
  struct Copy {
    SweptBox box;
    GenId disk;
    LatticeImage image;
  };

  // A cell of the grid of a level, whose cells have the side 2^level.
  struct Cell {
    int level;
    std::array<std::int64_t, 3> at;
  };
  using Range = std::array<Cell, 2>;  // the first cell and the last one

  void fold(const std::vector<SweptBox>& boxes, double from, double to);
  bool add_images(double from, double to);
  void shift(Copy& copy, const LatticeImage& by, double from, double to) const;
  void choose_levels();
  Range cells_of(const SweptBox& box, int level) const;
  std::size_t bucket(const Cell& cell) const;
  void sort_into_buckets();
  void compare_in(std::size_t c, int level, std::vector<BilliardPair>& pairs);
  void compare(std::size_t c, std::size_t d, std::vector<BilliardPair>& pairs);
  void add(const Copy& a, const Copy& b, std::vector<BilliardPair>& pairs) const;

  std::array<double, 3> sides_;
  double drift_;  // how fast an image beyond the second side moves
  std::size_t axes_;
  std::vector<Copy> copies_;  // first those of the disks that are folded, by disk
  std::size_t folded_ = 0;
  SweptBox all_{};  // contains the folded ones
  // By copy: the level at which it is in few cells, and its cells there. All levels, the lowest
  // first.
  std::vector<Range> ranges_;
  std::vector<int> levels_;
  std::size_t buckets_ = 1;
  std::vector<std::size_t> begins_, members_;  // by bucket
  std::size_t compared_ = 0;
};

}  // namespace voroproof::internal
