#include "history/scene.h"

#include <array>
#include <utility>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/placement.h"
#include "history/scene_fields.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

class SceneReader : SceneFields {
 public:
  SceneReader(std::string_view bytes, const std::string& file)
      : SceneFields(bytes, file, format_version) {}

  Scene read() {
    enum { container = first_other, restitution, law, disks, plan };
    static constexpr std::array<std::string_view, 11> names = {
        "format",    "version",     "name",          "comment", "seed",     "horizon",
        "container", "restitution", "container_law", "disks",   "maneuvers"};
    constexpr std::uint32_t required =
        bit(format) | bit(version) | bit(container) | bit(horizon) | bit(disks);
    json_.object(
        names, required,
        [&](std::size_t member) {
          switch (member) {
            case container:
              read_container();
              break;
            case restitution:
              read_restitution(scene_.restitution);
              break;
            case law:
              read_law();
              break;
            case disks:
              json_.array([&](std::size_t i) { read_disk(i); });
              break;
            case plan:
              json_.array([&](std::size_t i) { read_maneuver(i); });
              break;
            default:
              read_common(member);
          }
        },
        &scene_.extensions);
    json_.finish();
    give_title(scene_);
    scene_.horizon = horizon_;
    check_masses();
    check_maneuvers(scene_.maneuvers, scene_.disks.size(), [](std::size_t, const Maneuver&) {});
    if (const auto fault = find_placement_fault(scene_))
      fail_in_disk(static_cast<std::size_t>(fault->disk), "", fault->reason);
    return std::move(scene_);
  }

 private:
  void read_container() {
    enum { center, radius, restitution };
    static constexpr std::array<std::string_view, 3> names = {"center", "radius", "restitution"};
    json_.object(names, bit(center) | bit(radius), [&](std::size_t member) {
      switch (member) {
        case center:
          read_pair(scene_.cx, scene_.cy);
          break;
        case radius:
          read_radius(scene_.container_radius);
          if (scene_.container_radius == 0) json_.fail("not positive");
          break;
        case restitution:
          read_positive_restitution(scene_.container_restitution);
      }
    });
  }

  void read_law() {
    const std::string_view law = json_.text();
    if (law == "normal")
      scene_.law = ContainerLaw::normal;
    else if (law == "whole")
      scene_.law = ContainerLaw::whole;
    else
      json_.fail("neither \"normal\" nor \"whole\"");
  }

  void read_disk(std::size_t index) {
    begin_disk(index);
    enum { center, radius, velocity, mass };
    static constexpr std::array<std::string_view, 4> names = {"center", "radius", "velocity",
                                                              "mass"};
    DiskInput disk;
    Extensions extensions;
    const std::uint32_t seen = json_.object(
        names, bit(center) | bit(radius) | bit(velocity),
        [&](std::size_t member) {
          switch (member) {
            case center:
              read_pair(disk.x, disk.y);
              break;
            case radius:
              read_radius(disk.radius);
              break;
            case velocity:
              read_pair(disk.vx, disk.vy);
              break;
            case mass:
              disk.mass = value();
              if (sgn(disk.mass) <= 0) json_.fail("not positive");
          }
        },
        &extensions);
    if (!extensions.empty()) scene_.disk_extensions.emplace(index, std::move(extensions));
    if (!(seen & bit(mass))) disk.mass = square(disk.radius);
    scene_.disks.push_back(std::move(disk));
  }

  void read_maneuver(std::size_t index) {
    begin_maneuver(index);
    enum { t, disk, velocity };
    static constexpr std::array<std::string_view, 3> names = {"t", "disk", "velocity"};
    Maneuver maneuver;
    Extensions extensions;
    json_.object(
        names, bit(t) | bit(disk) | bit(velocity),
        [&](std::size_t member) {
          switch (member) {
            case t:
              read_maneuver_time(maneuver.t, scene_.maneuvers);
              break;
            case disk:
              maneuver.disk = read_maneuver_disk();
              break;
            case velocity:
              read_pair(maneuver.vx, maneuver.vy);
          }
        },
        &extensions);
    if (!extensions.empty()) scene_.maneuver_extensions.emplace(index, std::move(extensions));
    scene_.maneuvers.push_back(std::move(maneuver));
  }

  void check_masses() const {
    // Alone in the container, whose mass is infinite, a disk needs no mass.
    if (scene_.disks.size() < 2) return;
    for (std::size_t i = 0; i < scene_.disks.size(); ++i)
      if (scene_.disks[i].mass == 0)
        fail_in_disk(i, "mass", "missing (a disk of radius 0 has no default)");
  }

  Scene scene_;
};

}  // namespace

Scene parse_scene(std::string_view bytes, const std::string& file_name) {
  Scene scene = of_this_version(bytes, file_name, "voroproof-scene",
                                [&] { return SceneReader(bytes, file_name).read(); });
  scene.sha256 = sha256_hex(bytes);
  return scene;
}

Scene read_scene(const std::string& path) {
  return parse_scene(file_bytes(path, max_scene_bytes), path);
}

}  // namespace voroproof::internal
