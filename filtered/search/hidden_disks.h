// Which disks at rest have no cell.
#pragma once

#include <vector>

#include "exact/motion_input.h"
#include "filtered/search/framed.h"

namespace voroproof::internal {

inline constexpr GenId visible_disk = -2;

// Whether h contains g, touching it from inside or not: equal disks contain each other.
bool contains(const DiskInput& h, const DiskInput& g);
// Whether the disk lies outside of the container, touching it or not.
bool is_outside(const MotionInput& input, const DiskInput& disk);
// Whether the disk g lies behind the wall of a box, touching it or not.
bool is_behind(const MotionInput& input, GenId wall, GenId g);

// By disk, as it is at t = 0: `visible_disk`, or a visible disk that hides it, or the container, or
// a wall. Walls are visible.
//
// A disk is hidden if another contains it (of equal ones the one of larger id), or if it lies
// outside of the container or behind a wall: just then it has no cell. (From a point x of its cell
// to its centre its distance falls at least as fast as any other, so the centre is in the cell,
// too; and that is so iff no other disk contains it. Disks together hide nobody.)
std::vector<GenId> hosts_of(const MotionInput& input, Frame frame);

}  // namespace voroproof::internal
