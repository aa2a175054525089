#include "history/scene_writer.h"

#include <ostream>

#include "history/json_text.h"
#include "history/scene.h"

namespace voroproof::internal {
namespace {

std::string pair_text(const Rational& x, const Rational& y) {
  return '[' + number_text(x) + ", " + number_text(y) + ']';
}

std::string seed_text(const std::variant<std::string, Integer>& seed) {
  if (const auto* text = std::get_if<std::string>(&seed)) return string_text(*text);
  return std::get<Integer>(seed).get_str();
}

// Those of the disk or maneuver of that index, as members of its object.
std::string members_of(const std::map<std::size_t, Extensions>& extensions, std::size_t index) {
  const auto found = extensions.find(index);
  return found == extensions.end() ? std::string() : members_text(found->second, true);
}

// A disk of radius 0 has no default mass; a lone one may have none at all.
bool has_default_mass(const DiskInput& disk) { return disk.mass == square(disk.radius); }

}  // namespace

void write_scene(std::ostream& out, const Scene& scene) {
  out << "{\"format\": \"voroproof-scene\", \"version\": 1,\n";
  if (!scene.name.empty()) out << " \"name\": " << string_text(scene.name) << ",\n";
  if (!scene.comment.empty()) out << " \"comment\": " << string_text(scene.comment) << ",\n";
  if (scene.seed) out << " \"seed\": " << seed_text(*scene.seed) << ",\n";
  out << " \"container\": {\"center\": " << pair_text(scene.cx, scene.cy)
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
