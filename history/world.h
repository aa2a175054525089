// Worlds: scenes of version 2, in which disks pass through each other, grow, come and go
// (docs/formats.md, section 20).
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "exact/rational.h"
#include "exact/world_motion.h"
#include "history/extensions.h"
#include "history/scene.h"

namespace voroproof::internal {

// It is there at enter <= t < leave, up to the horizon where it never leaves.
struct WorldDisk {
  Rational enter;                 // >= 0
  std::optional<Rational> leave;  // > enter
  GrowingDisk state;              // at `enter`
};

// At time t the disk becomes what is given here; the rest stays. The disk is there: it enters
// before t, or at 0 = t, and leaves after t.
struct WorldManeuver {
  Rational t;
  int disk;
  std::optional<Point2> center, velocity;
  std::optional<Rational> radius, growth;
  // Whether the disk goes out of the diagram and in again.
  bool is_jump() const { return center || radius; }
};

struct World {
  std::optional<WorldCircle> circle;  // none: the frame is the plane
  Rational horizon;                   // >= 0
  std::vector<WorldDisk> disks;
  std::vector<WorldManeuver> maneuvers;  // sorted by t; one of a disk at one time
  std::vector<std::string> missing;      // who may come near and is not in it
  std::string name, comment;
  std::optional<std::variant<std::string, Integer>> seed;
  Extensions extensions;
  std::map<std::size_t, Extensions> disk_extensions, maneuver_extensions;  // those that have any
  std::string sha256;  // hash of the bytes that were read; empty for a world that was not read

  // How its disks move up to the horizon.
  WorldMotion motion() const;
};

// Whether a file says that it is a scene of version 2: only its beginning is looked at. False where
// it cannot be read.
bool is_world_file(const std::string& path);

// Reads and checks a world completely: form, values, and that no radius becomes negative. Throws
// InputError.
World read_world(const std::string& path);

// Reads and checks a file's bytes as read_world() does; `file_name` is for messages.
World parse_world(std::string_view bytes, const std::string& file_name);

}  // namespace voroproof::internal
