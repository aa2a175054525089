// Vectors of doubles, and the generators of a diagram file, for pictures.
#pragma once

#include <cmath>
#include <numbers>

#include "history/diagram_file.h"

namespace voroproof::internal {

inline constexpr double pi = std::numbers::pi;

inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Vec2 operator*(double k, const Vec2& a) { return {k * a[0], k * a[1]}; }
inline double dot(const Vec2& a, const Vec2& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double length(const Vec2& a) { return std::hypot(a[0], a[1]); }
inline double angle(const Vec2& a) { return std::atan2(a[1], a[0]); }
inline Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

inline double signed_radius(const DiagramFile& diagram, GenId id) {
  return id == container_id ? -diagram.container_radius : diagram.disks[id].radius;
}

inline const Vec2& center(const DiagramFile& diagram, GenId id) {
  return id == container_id ? diagram.container_center : diagram.disks[id].center;
}

}  // namespace voroproof::internal
