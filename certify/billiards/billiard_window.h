// Which pairs of a billiard may meet in a window of time, given the lines of all disks.
#pragma once

#include <vector>

#include "certify/billiards/billiard_path.h"
#include "filtered/billiards/line_boxes.h"

namespace voroproof::internal {

class MeetingPairs {
 public:
  // Both must outlive it.
  MeetingPairs(const Billiard& billiard, const BilliardGaps<DoubleBall>& gaps);

  // All pairs of disks that may meet in the window, and all of a wall and a disk, in order. Throws
  // Undecided where a disk is farther out than images are counted. A path is a sequence of lines,
  // of which it takes `near`; a line ends where the next begins.
  template <class Path>
  std::vector<BilliardPair> in(const std::vector<Path>& paths, const BilliardTime& from,
                               const BilliardTime& to);

  // Whether the two may meet while each is on one of its lines, counted from the one at the
  // beginning of the window that was asked for last: boxes of these do.
  bool may_meet(const BilliardPair& pair, std::size_t line_a, std::size_t line_b) const;

  // How long the next window is to be: as long as disks take for about the way between neighbours;
  // longer as long as few pairs may meet, and shorter where too many pairs may meet, or images have
  // to be looked at. Infinite where nothing moves, or nothing can meet.
  double good_length() const { return good_length_ * stretch_; }

  // To be told of each window how many pairs were followed in it.
  void adapt(std::size_t pairs);

 private:
  template <class Path>
  void make_boxes(const std::vector<Path>& paths, const BilliardTime& from, const BilliardTime& to);
  template <class Path>
  void add_disks(const std::vector<Path>& paths, const BilliardTime& from, const BilliardTime& to,
                 int splits, std::vector<BilliardPair>& pairs);
  template <class Path>
  SweptBox box_of(GenId disk, const Path& path, const BilliardTime& from, const BilliardTime& to);
  template <class Path>
  void measure(const std::vector<Path>& paths, const BilliardTime& to);

  const Billiard& billiard_;
  const BilliardGaps<DoubleBall>& gaps_;
  LineBoxes lines_;
  NearBoxes near_;
  std::vector<SweptBox> boxes_;
  // The boxes of all lines, and where those of a disk begin.
  std::vector<SweptBox> line_boxes_;
  std::vector<std::size_t> first_line_;
  double from_ = 0, to_ = 0;
  bool splits_ = false;  // the boxes are those of a part of the window
  double good_length_ = 0, stretch_ = 1;
};

}  // namespace voroproof::internal
