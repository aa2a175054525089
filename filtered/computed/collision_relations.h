// Relations that are proved of collisions at one instant. A collision is named by its id: that of
// the state after it (Motion::state_id).
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "exact/generators.h"

namespace voroproof::internal {

// Three disks of one mass in a row, and three elastic collisions of theirs at one instant: of an
// end and the middle, of the middle and the other end, and again of the first two. Together they
// exchange the velocities of the ends along the row and leave the middle as it was.
struct Cradle {
  GenId end, middle, far_end;
  std::array<int, 3> ids;
};

// Whoever notes something has proved it.
class CollisionRelations {
 public:
  // Two collisions of one disk at one instant with normals at right angles: 1 where that of id b,
  // seen from the disk, is to the left of that of a, -1 to the right, 0 where nothing was noted.
  int right_angle(int a, int b) const {
    const auto it = right_angles_.find(std::minmax(a, b));
    if (it == right_angles_.end()) return 0;
    return a < b ? it->second : -it->second;
  }
  void note_right_angle(int a, int b, int turn) {
    right_angles_[std::minmax(a, b)] = a < b ? turn : -turn;
  }

  // The cradle that the collision with this id belongs to, or null; valid until another is noted.
  const Cradle* cradle(int id) const {
    const auto it = cradle_.find(id);
    return it == cradle_.end() ? nullptr : &cradles_[it->second];
  }
  // Precondition: none of its collisions belongs to another.
  void note_cradle(const Cradle& c) {
    for (const int id : c.ids) cradle_[id] = static_cast<int>(cradles_.size());
    cradles_.push_back(c);
  }

 private:
  std::map<std::pair<int, int>, int> right_angles_;
  std::vector<Cradle> cradles_;
  std::map<int, int> cradle_;  // by the ids of their collisions: which
};

}  // namespace voroproof::internal
