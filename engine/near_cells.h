// Which disks may touch soon: the squares of a lattice that their centres are in.
#pragma once

#include <cstdint>
#include <vector>

#include "filtered/motion/motion.h"

namespace voroproof::internal {

// A disk stays with its square until its centre has left it by a margin, which is far larger than
// what doubles may err by. Squares are wider than any two disks that touch are apart, margins
// included: disks that touch are in the same square or in two that share a corner.
class NearCells {
 public:
  // `motion` must outlive this object. No disk has a square yet.
  explicit NearCells(const Motion& motion);

  // Whether squares are worth it and doubles tell them: not with disks so large that many others
  // are in a square, nor in a container very far from the origin.
  bool possible() const { return possible_; }

  // Gives the disk the square of its centre at time t; returns the one it had, -1 if it had none.
  int place(GenId g, double t);
  // When the disk, which is in its square at time t, may have to get another one; infinite if it
  // stays for good. Throws Undecided where doubles do not tell its place well.
  double leaves(GenId g, double t) const;
  // How many disks leave a square in a unit of time, about, moving as they do.
  double rate_of_leaving() const;
  // Whether the disk may touch the container while it is in its square.
  bool is_near_wall(GenId g) const { return wall_[cell_[g]] != 0; }

  // Whether it might before, in that square; not if it is -1.
  bool was_near_wall(int cell) const { return cell >= 0 && wall_[cell] != 0; }

  // Visits all other disks that may touch this one while both are in their squares. With `before`
  // those that might not while it was in that square.
  template <class Visit>
  void each_near(GenId g, Visit&& visit, int before = -1) const {
    const int cx = cell_[g] % side_, cy = cell_[g] / side_;
    const int bx = before < 0 ? -2 : before % side_, by = before < 0 ? -2 : before / side_;
    for (int y = cy > 0 ? cy - 1 : 0; y <= cy + 1 && y < side_; ++y) {
      const bool is_in_row = y >= by - 1 && y <= by + 1;
      for (int x = cx > 0 ? cx - 1 : 0; x <= cx + 1 && x < side_; ++x) {
        if (is_in_row && x >= bx - 1 && x <= bx + 1 && before >= 0) continue;
        for (GenId o = head_[y * side_ + x]; o >= 0; o = links_[o].next) {
          if (o != g) visit(o);
        }
      }
    }
  }

 private:
  struct Link {
    GenId next = -1, previous = -1;
  };
  int coordinate(double offset) const;
  void mark_wall(double rmax);

  const Motion& motion_;
  bool possible_ = false;
  double x0_ = 0, y0_ = 0;   // the corner of the lattice
  double width_ = 1;         // width of a square
  int side_ = 1;             // squares in a row
  std::vector<GenId> head_;  // by square: a disk in it, or -1
  std::vector<Link> links_;  // by disk: the others in its square
  std::vector<int> cell_;    // by disk, or -1
  std::vector<std::uint8_t> wall_;
};

}  // namespace voroproof::internal
