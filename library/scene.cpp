#include "voroproof/scene.h"

#include <sstream>

#include "history/output_file.h"
#include "history/scene_writer.h"
#include "history/sha256.h"
#include "library/values.h"

namespace voroproof {
namespace internal {
namespace {

constexpr const char* name_in_memory = "scene";

CompactRational compact(const voroproof::Number& number) {
  return number.is_double() ? CompactRational(number.nearest()) : CompactRational(rational(number));
}

voroproof::Number number_of(const CompactRational& q) {
  return q.is_double() ? voroproof::Number(q.leading()) : number(q.value());
}

DiskInput disk_of(const voroproof::Disk& disk) {
  const CompactRational radius = compact(disk.radius);
  return {compact(disk.x),  compact(disk.y),  radius,
          compact(disk.vx), compact(disk.vy), disk.mass ? compact(*disk.mass) : square(radius)};
}

// The scene that write_scene() takes; it is not checked.
Scene unchecked(const voroproof::Scene& scene) {
  Scene out;
  out.cx = rational(scene.container_x);
  out.cy = rational(scene.container_y);
  out.container_radius = rational(scene.container_radius);
  out.restitution = rational(scene.restitution);
  out.container_restitution = rational(scene.container_restitution);
  out.law =
      scene.law == voroproof::ContainerLaw::whole ? ContainerLaw::whole : ContainerLaw::normal;
  out.horizon = rational(scene.horizon);
  out.name = scene.name;
  out.comment = scene.comment;
  out.extensions = scene.extensions;
  out.disk_extensions = scene.disk_extensions;
  out.maneuver_extensions = scene.maneuver_extensions;
  out.disks.reserve(scene.disks.size());
  for (const voroproof::Disk& disk : scene.disks) out.disks.push_back(disk_of(disk));
  for (const voroproof::Maneuver& m : scene.maneuvers) {
    out.maneuvers.push_back({rational(m.t), m.disk, rational(m.vx), rational(m.vy)});
  }
  return out;
}

std::string text_of(const Scene& scene) {
  std::ostringstream out;
  write_scene(out, scene);
  return std::move(out).str();
}

}  // namespace

Scene checked_scene(const voroproof::Scene& scene) {
  Scene checked = without_lines(
      name_in_memory, [&] { return parse_scene(text_of(unchecked(scene)), name_in_memory); });
  if (scene.source && scene.source->values_sha256 == checked.sha256) {
    checked.sha256 = scene.source->file_sha256;
  }
  return checked;
}

voroproof::Scene scene_value(const Scene& scene) {
  voroproof::Scene out;
  out.container_x = number(scene.cx);
  out.container_y = number(scene.cy);
  out.container_radius = number(scene.container_radius);
  out.restitution = number(scene.restitution);
  out.container_restitution = number(scene.container_restitution);
  out.law = scene.law == ContainerLaw::whole ? voroproof::ContainerLaw::whole
                                             : voroproof::ContainerLaw::normal;
  out.horizon = number(scene.horizon);
  out.name = scene.name;
  out.comment = scene.comment;
  out.extensions = scene.extensions;
  out.disk_extensions = scene.disk_extensions;
  out.maneuver_extensions = scene.maneuver_extensions;
  out.disks.reserve(scene.disks.size());
  for (const DiskInput& disk : scene.disks) {
    voroproof::Disk& to = out.disks.emplace_back();
    to.x = number_of(disk.x);
    to.y = number_of(disk.y);
    to.radius = number_of(disk.radius);
    to.vx = number_of(disk.vx);
    to.vy = number_of(disk.vy);
    if (sgn(disk.mass) > 0 && !(disk.mass == square(disk.radius))) to.mass = number_of(disk.mass);
  }
  for (const Maneuver& m : scene.maneuvers) {
    out.maneuvers.push_back({number(m.t), m.disk, number(m.vx), number(m.vy)});
  }
  if (!scene.sha256.empty()) {
    out.source = {scene.sha256, sha256_hex(text_of(unchecked(out)))};
  }
  return out;
}

}  // namespace internal

using internal::with_public_errors;

Scene read_scene(const std::string& path) {
  return with_public_errors([&] { return internal::scene_value(internal::read_scene(path)); });
}

Scene parse_scene(std::string_view bytes, const std::string& name) {
  return with_public_errors(
      [&] { return internal::scene_value(internal::parse_scene(bytes, name)); });
}

std::string scene_text(const Scene& scene) {
  return with_public_errors([&] { return internal::text_of(internal::checked_scene(scene)); });
}

void write_scene(const std::string& path, const Scene& scene) {
  with_public_errors(
      [&] { internal::write_output(path, internal::text_of(internal::checked_scene(scene))); });
}

std::string scene_sha256(const Scene& scene) {
  return with_public_errors([&] { return internal::checked_scene(scene).sha256; });
}

}  // namespace voroproof
