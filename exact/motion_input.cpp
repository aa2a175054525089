#include "exact/motion_input.h"

namespace voroproof::internal {

MotionInput about_center(MotionInput input) {
  const Rational x = input.container_x, y = input.container_y;
  if (sgn(x) == 0 && sgn(y) == 0) return input;
  for (DiskInput& d : input.disks) {
    d.x = Rational(d.x.value() - x);
    d.y = Rational(d.y.value() - y);
  }
  input.origin[0] += x;
  input.origin[1] += y;
  input.container_x = input.container_y = 0;
  return input;
}

}  // namespace voroproof::internal
