// --frame: the circle or the rectangle in which disks at rest are.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "apps/cli/numbers_argument.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

struct FrameArgument {
  std::optional<Circle> circle{};
  std::optional<Box> walls{};
};

// X,Y,R or X0,Y0,X1,Y1, or neither where the text is empty. Throws UsageError.
inline FrameArgument frame_argument(const std::string& text) {
  FrameArgument frame;
  if (text.empty()) return frame;
  if (std::count(text.begin(), text.end(), ',') == 3) {
    const auto [x0, y0, x1, y1] = numbers_argument<4>("--frame", text);
    if (!(x0 < x1 && y0 < y1)) throw UsageError("--frame: no area");
    frame.walls = Box{{x0, y0}, {x1, y1}};
  } else {
    const auto [x, y, r] = numbers_argument<3>("--frame", text);
    if (!(r > 0)) throw UsageError("--frame: its radius is not positive");
    frame.circle = Circle{{x, y}, r};
  }
  return frame;
}

}  // namespace voroproof::internal
