#include "history/world_writer.h"

#include <ostream>
#include <sstream>

#include "history/json_text.h"
#include "history/output_file.h"
#include "history/scene_text.h"

namespace voroproof::internal {
namespace {

std::string point_text(const Point2& point) { return pair_text(point.x, point.y); }

std::string unless_zero(const char* name, const Rational& value) {
  if (value == 0) return {};
  return std::string(", \"") + name + "\": " + number_text(value);
}

std::string frame_text(const std::optional<WorldCircle>& circle) {
  if (!circle) return "\"none\"";
  return "{\"center\": " + point_text(circle->center) +
         ", \"radius\": " + number_text(circle->radius) + unless_zero("growth", circle->growth) +
         '}';
}

std::string disk_text(const WorldDisk& disk) {
  const GrowingDisk& state = disk.state;
  std::string text =
      "{\"center\": " + pair_text(state.x, state.y) + ", \"radius\": " + number_text(state.radius) +
      unless_zero("growth", state.growth) + ", \"velocity\": " + pair_text(state.vx, state.vy) +
      unless_zero("enter", disk.enter);
  if (disk.leave) text += ", \"leave\": " + number_text(*disk.leave);
  return text;
}

std::string maneuver_text(const WorldManeuver& maneuver) {
  std::string text =
      "{\"t\": " + number_text(maneuver.t) + ", \"disk\": " + std::to_string(maneuver.disk);
  if (maneuver.center) text += ", \"center\": " + point_text(*maneuver.center);
  if (maneuver.radius) text += ", \"radius\": " + number_text(*maneuver.radius);
  if (maneuver.velocity) text += ", \"velocity\": " + point_text(*maneuver.velocity);
  if (maneuver.growth) text += ", \"growth\": " + number_text(*maneuver.growth);
  return text;
}

}  // namespace

void write_world(std::ostream& out, const World& world) {
  out << "{\"format\": \"voroproof-scene\", \"version\": 2,\n"
      << lines_for_people(world) << " \"horizon\": " << number_text(world.horizon) << ",\n"
      << " \"contacts\": \"pass\",\n"
      << " \"frame\": " << frame_text(world.circle) << ",\n"
      << " \"disks\": [";
  const char* separator = "\n  ";
  for (std::size_t i = 0; i < world.disks.size(); ++i) {
    out << separator << disk_text(world.disks[i]) << members_of(world.disk_extensions, i) << '}';
    separator = ",\n  ";
  }
  out << ']';
  if (!world.maneuvers.empty()) {
    out << ",\n \"maneuvers\": [";
    separator = "\n  ";
    for (std::size_t i = 0; i < world.maneuvers.size(); ++i) {
      out << separator << maneuver_text(world.maneuvers[i])
          << members_of(world.maneuver_extensions, i) << '}';
      separator = ",\n  ";
    }
    out << ']';
  }
  if (!world.missing.empty()) {
    out << ",\n \"missing\": [";
    separator = "";
    for (const std::string& who : world.missing) {
      out << separator << string_text(who);
      separator = ", ";
    }
    out << ']';
  }
  if (!world.extensions.empty()) {
    // On a line of their own, as all members of the world.
    out << ",\n" << members_text(world.extensions, true).substr(1);
  }
  out << "}\n";
}

void write_world(const std::string& path, const World& world) {
  std::ostringstream text;
  write_world(text, world);
  write_output(path, text.str());
}

}  // namespace voroproof::internal
