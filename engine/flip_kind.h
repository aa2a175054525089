// The paper's kinds of flips.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "exact/topology/diagram.h"

namespace voroproof::internal {

// The paper's flips by the cells they change (Figs. 4 to 15): `ordinary` is every other
// flip; `two_two_to_three_three` is Configuration W to its neighbour, an ordinary flip to the
// paper.
enum class FlipKind {
  ordinary,
  three_to_two,
  two_to_three,
  twofour_to_threethree,
  threethree_to_twofour,
  threethree_to_twotwo,
  twotwo_to_threethree,
  count
};
inline constexpr std::array<std::string_view, static_cast<int>(FlipKind::count)> flip_kind_names{
    "ordinary", "3-to-2", "2-to-3", "24-to-33", "33-to-24", "33-to-22", "22-to-33"};

// The number of V-edges of each cell, kept up to date flip by flip.
class Degrees {
 public:
  Degrees() = default;
  // The degrees of the cells of a diagram of this many disks.
  Degrees(const Diagram& diagram, int disks);
  // Precondition: the diagram has the edge q and is the one that these are the degrees of.
  FlipKind kind_of_flip(const Diagram& diagram, const Quad& q) const;
  // The edge q is flipped.
  void flip(const Quad& q) {
    --degree_[q.l + 1];
    --degree_[q.r + 1];
    ++degree_[q.s + 1];
    ++degree_[q.e + 1];
  }

 private:
  std::vector<int> degree_;  // number of generator g's edges, at g + 1
};

}  // namespace voroproof::internal
