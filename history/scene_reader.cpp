#include "history/scene.h"

#include <set>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/placement.h"
#include "history/scene_value.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;

class SceneReader {
 public:
  SceneReader(std::string_view bytes, const std::string& file) : file_(file), json_(bytes, file) {}

  Scene read() {
    enum {
      format,
      version,
      name,
      comment,
      seed,
      container,
      restitution,
      law,
      horizon,
      disks,
      plan
    };
    static constexpr std::array<std::string_view, 11> names = {
        "format",      "version",       "name",    "comment", "seed",     "container",
        "restitution", "container_law", "horizon", "disks",   "maneuvers"};
    constexpr std::uint32_t required =
        bit(format) | bit(version) | bit(container) | bit(horizon) | bit(disks);
    json_.object(
        names, required,
        [&](std::size_t member) {
          switch (member) {
            case format:
              if (json_.text() != "voroproof-scene") json_.fail("not \"voroproof-scene\"");
              break;
            case version:
              read_version(json_);
              break;
            case name:
              scene_.name = json_.text();
              break;
            case comment:
              scene_.comment = json_.text();
              break;
            case seed:
              scene_.seed = read_seed(json_);
              break;
            case container:
              read_container();
              break;
            case restitution:
              scene_.restitution = value();
              if (scene_.restitution < 0 || scene_.restitution > 1) json_.fail("not in [0, 1]");
              break;
            case law:
              read_law();
              break;
            case horizon:
              scene_.horizon = value();
              if (scene_.horizon < 0) json_.fail("negative");
              break;
            case disks:
              json_.array([&](std::size_t i) { read_disk(i); });
              break;
            case plan:
              json_.array([&](std::size_t i) { read_maneuver(i); });
              break;
          }
        },
        &scene_.extensions);
    json_.finish();
    check_masses();
    check_maneuvers();
    if (const auto fault = find_placement_fault(scene_))
      fail(disk_lines_[fault->disk], "disks", fault->disk, "", fault->reason);
    return std::move(scene_);
  }

 private:
  CompactRational value() { return scene_value(json_); }

  template <class Number>
  void read_pair(Number& x, Number& y) {
    json_.array_of<2>([&](std::size_t i) { (i == 0 ? x : y) = value(); });
  }

  template <class Number>
  void read_radius(Number& radius) {
    radius = value();
    if (sgn(radius) < 0) json_.fail("negative");
  }

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
        case restitution: {
          Rational& r = scene_.container_restitution;
          r = value();
          if (r <= 0 || r > 1) json_.fail("not in (0, 1]");
        }
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
    if (index >= max_disks) json_.fail("more than " + std::to_string(max_disks) + " disks");
    enum { center, radius, velocity, mass };
    static constexpr std::array<std::string_view, 4> names = {"center", "radius", "velocity",
                                                              "mass"};
    DiskInput disk;
    Extensions extensions;
    json_.array_is_next();  // moves to the value, for its line
    disk_lines_.push_back(json_.line());
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
    if (index >= max_maneuvers)
      json_.fail("more than " + std::to_string(max_maneuvers) + " maneuvers");
    enum { t, disk, velocity };
    static constexpr std::array<std::string_view, 3> names = {"t", "disk", "velocity"};
    Maneuver maneuver;
    Extensions extensions;
    json_.object(
        names, bit(t) | bit(disk) | bit(velocity),
        [&](std::size_t member) {
          switch (member) {
            case t:
              maneuver.t = value();
              if (maneuver.t < 0) json_.fail("negative");
              if (!scene_.maneuvers.empty() && maneuver.t < scene_.maneuvers.back().t)
                json_.fail("earlier than the maneuver before it");
              break;
            case disk:
              maneuver.disk = static_cast<int>(json_.integer(0, max_disks - 1));
              maneuver_lines_.push_back(json_.line());
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
        fail(disk_lines_[i], "disks", i, ".mass", "missing (a disk of radius 0 has no default)");
  }

  void check_maneuvers() const {
    std::set<int> now;  // the disks with a maneuver at the current instant
    for (std::size_t i = 0; i < scene_.maneuvers.size(); ++i) {
      const Maneuver& maneuver = scene_.maneuvers[i];
      if (i > 0 && maneuver.t != scene_.maneuvers[i - 1].t) now.clear();
      if (maneuver.disk >= static_cast<int>(scene_.disks.size()))
        fail(maneuver_lines_[i], "maneuvers", i, ".disk", "no such disk");
      if (!now.insert(maneuver.disk).second)
        fail(maneuver_lines_[i], "maneuvers", i, ".disk",
             "second maneuver of one disk at one time");
    }
  }

  [[noreturn]] void fail(std::int64_t line, const char* list, std::size_t index, const char* member,
                         const std::string& reason) const {
    throw InputError(file_, line, list + ('[' + std::to_string(index) + ']') + member, reason);
  }

  const std::string& file_;
  JsonReader json_;
  Scene scene_;
  std::vector<std::int64_t> disk_lines_;      // lines of the opening braces
  std::vector<std::int64_t> maneuver_lines_;  // lines of the fields "disk"
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
