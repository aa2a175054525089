// The frame of disks at rest, as Python gives it.
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

#include "voroproof/static_diagram.h"

namespace voroproof::python {

// x, y, r of a circle, or x0, y0, x1, y1 of a rectangle.
using Frame = std::optional<std::vector<double>>;

// Throws std::invalid_argument for other numbers of numbers.
inline std::optional<Box> walls_of(const Frame& frame) {
  if (frame && frame->size() != 3 && frame->size() != 4) {
    throw std::invalid_argument("frame: neither x, y, r nor x0, y0, x1, y1");
  }
  if (!frame || frame->size() == 3) return std::nullopt;
  return Box{{(*frame)[0], (*frame)[1]}, {(*frame)[2], (*frame)[3]}};
}
inline std::optional<Circle> circle_of(const Frame& frame) {
  if (!frame || frame->size() != 3) return std::nullopt;
  return Circle{{(*frame)[0], (*frame)[1]}, (*frame)[2]};
}

}  // namespace voroproof::python
