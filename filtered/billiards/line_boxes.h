// Boxes around the disks of a billiard in a window of time, and which walls these may meet.
#pragma once

#include <optional>
#include <string>

#include "filtered/billiards/near_boxes.h"

namespace voroproof::internal {

class LineBoxes {
 public:
  // Both must outlive it.
  LineBoxes(const Billiard& billiard, const BilliardGaps<DoubleBall>& gaps);

  // Makes the box contain the disk on that flight from `from` to `to` >= from.
  void extend(SweptBox& box, GenId disk, const Flight<DoubleBall>& flight, const DoubleBall& from,
              const DoubleBall& to) const;

  // Throws Undecided where a box is farther out, up to that time, than images are counted.
  void require_near(GenId disk, const SweptBox& box, double to) const;

  // Whether a disk in the box may meet the wall, or the round frame, in the window.
  bool may_meet_wall(GenId wall, const SweptBox& box, double from, double to) const;

  // Gravity moves all disks alike, and nothing else is there: boxes are those of disks that do not
  // fall.
  bool fall_alike() const { return fall_alike_; }
  // How fast images beyond the second side of the box move.
  double drift() const { return drift_; }
  // The side of the periodic box along an axis; zero where that is not periodic.
  double side(std::size_t axis) const { return sides_[axis]; }

 private:
  const Billiard& billiard_;
  const BilliardGaps<DoubleBall>& gaps_;
  bool fall_alike_;
  std::array<double, 3> sides_{};
  double drift_ = 0;
};

// The first two, or a disk and a wall, that overlap at time 0; none where all are in their places.
std::optional<BilliardPair> find_overlap_at_start(const Billiard& billiard);

// "disk 0 and disk 1", "ball 3 and wall -2", with the image where it is not the disk itself.
std::string name_of(const Billiard& billiard, const BilliardPair& pair);

// For such a pair "disks[1]: overlaps ...": the field at fault, and why.
std::pair<std::string, std::string> placement_fault(const Billiard& billiard,
                                                    const BilliardPair& pair);

}  // namespace voroproof::internal
