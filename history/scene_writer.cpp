#include "history/scene_writer.h"

#include <ostream>

#include "history/json_text.h"
#include "history/scene.h"
#include "history/scene_text.h"

namespace voroproof::internal {
namespace {

// A disk of radius 0 has no default mass; a lone one may have none at all.
bool has_default_mass(const DiskInput& disk) { return disk.mass == square(disk.radius); }

}  // namespace

void write_scene(std::ostream& out, const Scene& scene) {
  out << "{\"format\": \"voroproof-scene\", \"version\": 1,\n";
  out << lines_for_people(scene) << " \"container\": {\"center\": " << pair_text(scene.cx, scene.cy)
      << ", \"radius\": " << number_text(scene.container_radius);
  if (scene.container_restitution != 1)
    out << ", \"restitution\": " << number_text(scene.container_restitution);
  out << "},\n";
  if (scene.law == ContainerLaw::whole) out << " \"container_law\": \"whole\",\n";
  out << " \"restitution\": " << number_text(scene.restitution) << ",\n"
      << " \"horizon\": " << number_text(scene.horizon) << ",\n"
      << " \"disks\": [";
  const char* separator = "\n  ";
  for (std::size_t i = 0; i < scene.disks.size(); ++i) {
    const DiskInput& disk = scene.disks[i];
    out << separator << "{\"center\": " << pair_text(disk.x, disk.y)
        << ", \"radius\": " << number_text(disk.radius)
        << ", \"velocity\": " << pair_text(disk.vx, disk.vy);
    if (!has_default_mass(disk)) out << ", \"mass\": " << number_text(disk.mass);
    out << members_of(scene.disk_extensions, i) << '}';
    separator = ",\n  ";
  }
  out << ']';
  if (!scene.maneuvers.empty()) {
    out << ",\n \"maneuvers\": [";
    separator = "\n  ";
    for (std::size_t i = 0; i < scene.maneuvers.size(); ++i) {
      const Maneuver& maneuver = scene.maneuvers[i];
      out << separator << "{\"t\": " << number_text(maneuver.t) << ", \"disk\": " << maneuver.disk
          << ", \"velocity\": " << pair_text(maneuver.vx, maneuver.vy)
          << members_of(scene.maneuver_extensions, i) << '}';
      separator = ",\n  ";
    }
    out << ']';
  }
  if (!scene.extensions.empty()) {
    // On a line of their own, as all members of the scene.
    out << ",\n" << members_text(scene.extensions, true).substr(1);
  }
  out << "}\n";
}

}  // namespace voroproof::internal
