// The disks of a diagram at rest, and the circles that touch them.
#pragma once

#include <optional>
#include <vector>

#include "exact/generators.h"
#include "exact/motion_input.h"
#include "exact/predicates.h"
#include "library/places.h"
#include "voroproof/static_diagram.h"

namespace voroproof::internal {

// Throws std::invalid_argument, naming the disk, where a StaticDiagram may not be of them.
void require_disks(const std::vector<Circle>& disks, const std::optional<Circle>& frame);

// Without a frame the container is some circle, and radii are larger by one number: by that of the
// least, which is negative.
MotionInput resting_input(const std::vector<Circle>& disks, const std::optional<Circle>& frame);

// The circles of vertices, rounded to nearest. What it is made of must outlive it.
class VertexCircles {
 public:
  VertexCircles(const std::vector<Circle>& disks, const std::optional<Circle>& frame)
      : disks_(disks), frame_(frame) {}

  // None where the circle is a line, so that the vertex is at infinity.
  std::optional<Vertex> of(const Triple& name);

 private:
  template <class T, class Number>
  TangentTriple<T> triple(const Triple& name, const Number& number) const;
  Places& exactly();

  const std::vector<Circle>& disks_;
  const std::optional<Circle>& frame_;
  std::optional<Places> places_;
};

}  // namespace voroproof::internal
