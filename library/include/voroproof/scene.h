// Scenes: disks in a circular container, and what is to happen to them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "voroproof/export.h"
#include "voroproof/extensions.h"
#include "voroproof/number.h"

namespace voroproof {

// A disk at t = 0. Lengths, times and speeds are in one consistent set of units of the caller's.
struct Disk {
  Number x, y;                 // centre
  Number radius;               // >= 0
  Number vx, vy;               // velocity
  std::optional<Number> mass;  // > 0; without one radius^2, and nothing for a lone point
};

// At time t the velocity of the disk becomes (vx, vy).
struct Maneuver {
  Number t;
  int disk = 0;  // an index of Scene::disks
  Number vx, vy;
};

// The part of the velocity that the container's restitution scales at the wall: normal, or all.
enum class ContainerLaw { normal, whole };

// A scene as its file states it (docs/formats.md). Disks are named by their index, the container
// is -1. Each function that takes a scene checks it as the reader checks a file and throws
// InputError where it is none: disks that overlap or are not inside the container, say.
struct Scene {
  Number container_x, container_y;
  Number container_radius = 1;
  Number restitution = 1;            // between disks, in [0, 1]
  Number container_restitution = 1;  // in (0, 1]
  ContainerLaw law = ContainerLaw::normal;
  Number horizon;  // >= 0: histories cover [0, horizon]
  std::vector<Disk> disks;
  std::vector<Maneuver> maneuvers;  // sorted by t
  std::string name, comment;
  Extensions extensions;
  // By index, of the disks and maneuvers that have any.
  std::map<std::size_t, Extensions> disk_extensions, maneuver_extensions;

  // Histories name their scene by the SHA-256 of its file. read_scene() notes the hash of the bytes
  // and that of the values read, so that a scene which was changed since has another identity.
  struct Source {
    std::string file_sha256, values_sha256;
  };
  std::optional<Source> source;
};

// The disk k of every list of ids below; the container's.
inline constexpr int container = -1;

// Reads a scene file (`path`), or its bytes (`name` is for messages). Throws InputError.
VOROPROOF_API Scene read_scene(const std::string& path);
VOROPROOF_API Scene parse_scene(std::string_view bytes, const std::string& name = "scene");

// The scene as JSON, in the one form that this library writes; and into a file, whole or not at
// all. Throw InputError where it is no scene, and OutputError.
VOROPROOF_API std::string scene_text(const Scene& scene);
VOROPROOF_API void write_scene(const std::string& path, const Scene& scene);

// The hash by which histories name the scene: 64 hexadecimal digits.
VOROPROOF_API std::string scene_sha256(const Scene& scene);

}  // namespace voroproof
