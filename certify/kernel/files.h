// Scenes and histories as their files say (docs/formats.md), read strictly.
#pragma once

#include <optional>

#include "certify/kernel/algebra.h"

namespace voroproof_kernel {

constexpr int container = -1;

struct Disk {
  Vec center, velocity;
  Rat radius, mass;  // mass 0: none given, and none by default (radius 0)
};
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
  Rat t;      // exact time of a collision or maneuver under the exact truth
  Rat filed;  // as the file has it
  Quad quad;  // for a flip
  int id[2];  // for a collision, the smaller first; for a maneuver id[1]
  int first;  // the disks that turn are id[first] ... id[1]; 2 where none does
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

// Both throw Stop (invalid) where the text is not of the format. A history is read for n disks.
Scene read_scene(const std::string& text);
History read_history(const std::string& text, int n);
// SHA-256 of a text as 64 hexadecimal digits.
std::string sha256(const std::string& text);

}  // namespace voroproof_kernel
