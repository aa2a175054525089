#include "exact/motion_input.h"

namespace voroproof::internal {

MotionInput about_center(MotionInput input) {
  const CompactRational x = input.container_x, y = input.container_y;
  if (sgn(x) == 0 && sgn(y) == 0) return input;
  for (DiskInput& d : input.disks) {
    d.x = d.x - x;
    d.y = d.y - y;
  }
  input.origin[0] += input.container_x;
  input.origin[1] += input.container_y;
  input.container_x = input.container_y = 0;
  return input;
}

}  // namespace voroproof::internal
