// The disks of a diagram at rest, and the circles that touch them.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/generators.h"
#include "exact/motion_input.h"
#include "exact/predicates.h"
#include "filtered/search/framed.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// The circle or the walls around disks, or neither.
struct RestingFrame {
  std::optional<Circle> circle{};
  std::optional<Box> walls{};

  Frame kind() const { return circle ? Frame::circle : walls ? Frame::box : Frame::plane; }
  // For so many disks, and the walls.
  Framed framed(std::size_t disks) const;
  // A place on the wall: the left or the right one, and the bottom or the top one, meet in it.
  Vector place(int quarter) const { return quarter < 2 ? walls->low : walls->high; }
};

// Throws std::invalid_argument, naming the disk, where a StaticDiagram may not be of them.
void require_disks(const std::vector<Circle>& disks, const RestingFrame& frame);

// Without a frame the container is some circle, and radii are larger by one number: by that of the
// least, which is negative. Walls follow the disks (framed.h).
MotionInput resting_input(const std::vector<Circle>& disks, const RestingFrame& frame);

// The circles of vertices, rounded to nearest. The disks must outlive it.
class VertexCircles {
 public:
  VertexCircles(const std::vector<Circle>& disks, const RestingFrame& frame)
      : disks_(disks), frame_(frame), framed_(frame.framed(disks.size())) {}

  // None where the circle is a line, so that the vertex is at infinity. Throws Undecided where the
  // budgets do not tell what is nearest.
  std::optional<Vertex> of(const Triple& name) const;

 private:
  template <class T, class Number>
  auto sites(const Number& number) const;
  template <class T, class Number, class Root>
  std::array<T, 3> circle(const Triple& name, const Number& number, const Root& root) const;

  const std::vector<Circle>& disks_;
  RestingFrame frame_;
  Framed framed_;
};

}  // namespace voroproof::internal
