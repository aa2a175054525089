// Scenes and histories as their files say (docs/formats.md), read strictly: of version 1, and of
// billiards.
#pragma once

#include <optional>

#include "certify/kernel/algebra.h"

namespace voroproof_kernel {

constexpr int container = -1;  // or a round frame; walls are -1, -2, ...

struct Disk {
  Vec center, velocity;
  Rat radius, mass;  // mass 0: none given, and none by default (radius 0)
  Rat growth = 0;    // in billiards
  bool fixed = false;
};
// All x with normal.x >= offset + speed t.
struct Wall {
  Vec normal;
  Rat offset, speed, restitution;
};
using Image = std::array<int, 3>;  // counted along the axes of a periodic box
struct Maneuver {
  Rat t;
  int disk;
  Vec velocity;
};
struct Scene {
  Vec center;
  Rat radius, restitution = 1, wall_restitution = 1, horizon;
  bool whole_law = false;
  std::vector<Disk> disks;
  std::vector<Maneuver> maneuvers;
  // A billiard's, in the plane or in space. Radius 0: its frame is not round.
  int dimension = 0;  // 0: disks in a container, with a diagram
  std::vector<Wall> walls;
  Vec sides, gravity;  // side 0: the axis is not periodic
  Rat shear;

  bool is_billiard() const { return dimension > 0; }
  bool is_periodic() const { return norm2(sides) != 0; }
  int coordinates() const { return dimension == 3 ? 3 : 2; }
  int last_wall() const { return radius > 0 ? container : -static_cast<int>(walls.size()); }
};

// The edge from vertex [l,s,r] to vertex [l,r,e], l on its left and r on its right.
struct Quad {
  int l, r, s, e;
  bool operator==(const Quad&) const = default;
  Quad reversed() const { return {r, l, e, s}; }
};
std::string name(const Quad& q);

struct Claim {
  enum class Kind { flip, collision, maneuver } kind;
  std::int64_t line;
  Rat t;                       // exact time of a collision or maneuver under the exact truth
  Rat filed;                   // as the file has it
  Quad quad;                   // for a flip
  int id[2];                   // for a collision, the smaller first; for a maneuver id[1]
  int first;                   // the disks that turn are id[first] ... id[1]; 2 where none does
  std::optional<Image> image;  // that of id[1] which touches
  std::optional<Vec> v[2], p[2];
};

struct History {
  Rat horizon;
  std::string scene_sha256;
  std::optional<std::vector<Quad>> initial;
  std::vector<Claim> claims;
  std::int64_t last_line = 0;
  bool stopped = false;               // before its horizon
  std::int64_t ended[3] = {0, 0, 0};  // flips, collisions, maneuvers by the last line
};

// Both throw Stop (invalid) where the text is not of the format. A history is read for its scene.
Scene read_scene(const std::string& text);
History read_history(const std::string& text, const Scene& scene);
// SHA-256 of a text as 64 hexadecimal digits.
std::string sha256(const std::string& text);

}  // namespace voroproof_kernel
