// The scene: disks in a circular container, and what is to happen to them (docs/formats.md).
#pragma once

#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "exact/motion_input.h"
#include "exact/point2.h"
#include "history/extensions.h"

namespace voroproof::internal {

// At time t the velocity of the disk becomes (vx, vy).
struct Maneuver {
  Rational t;
  int disk;
  Rational vx, vy;
};

// The part of the velocity that container_restitution scales at the wall: the normal part, or all.
enum class ContainerLaw { normal, whole };

struct Scene {
  Rational cx, cy, container_radius;
  Rational restitution = 1;            // between disks, in [0,1]
  Rational container_restitution = 1;  // in (0,1]
  ContainerLaw law = ContainerLaw::normal;
  Rational horizon;  // >= 0
  std::vector<DiskInput> disks;
  std::vector<Maneuver> maneuvers;  // sorted by t
  std::string name, comment;
  Extensions extensions;
  std::map<std::size_t, Extensions> disk_extensions, maneuver_extensions;  // those that have any
  std::optional<std::variant<std::string, Integer>> seed;
  std::string sha256;  // hash of the bytes that were read; empty for a scene that was not read
};

// Limits on what is read; see docs/formats.md.
inline constexpr std::size_t max_scene_bytes = std::size_t{1} << 30;
inline constexpr int max_disks = 2'000'000;
inline constexpr int max_maneuvers = 2'000'000;
inline constexpr double max_scene_value = 1e100;   // greatest magnitude
inline constexpr double min_scene_value = 1e-100;  // least magnitude that is not zero

// Reads and checks a scene completely: form, values, and that the disks lie inside the container
// without overlap. Takes O(n log n) comparisons, whatever the positions and radii.
// Throws InputError.
Scene read_scene(const std::string& path);

// Reads and checks a scene file's bytes as read_scene() does; `file_name` is for messages.
Scene parse_scene(std::string_view bytes, const std::string& file_name);

}  // namespace voroproof::internal
