#include <array>
#include <utility>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/file_format.h"
#include "history/format_version.h"
#include "history/json_text.h"
#include "history/scene_fields.h"
#include "history/sha256.h"
#include "history/world.h"

namespace voroproof::internal {
namespace {

constexpr const char* only_pass =
    "\"pass\" is wanted here; only simulate, certify, clearance and validate read billiards, whose "
    "disks bounce";

class WorldReader : SceneFields {
 public:
  WorldReader(std::string_view bytes, const std::string& file)
      : SceneFields(bytes, file, world_version) {}

  World read() {
    static constexpr std::array<std::string_view, 14> names = {
        "format", "version",   "name",  "comment",   "seed",    "horizon",     "contacts",
        "frame",  "container", "disks", "maneuvers", "missing", "restitution", "container_law"};
    const std::int64_t first_line = line_of_object();
    const std::uint32_t seen = json_.object(
        names, bit(format) | bit(version) | bit(horizon) | bit(disks),
        [&](std::size_t member) { read_member(member); }, &world_.extensions);
    json_.finish();
    give_title(world_);
    world_.horizon = horizon_;
    if (!(seen & bit(contacts)))
      throw InputError(file_, first_line, "contacts", std::string("missing: ") + only_pass);
    if (!(seen & (bit(frame) | bit(container))))
      throw InputError(file_, first_line, "frame",
                       "missing: \"none\", or a circle, or \"container\" in its place");
    if ((seen & bit(frame)) && (seen & bit(container)))
      throw InputError(file_, circle_line_, "container", "a world has it or a frame, not both");
    check_circle();
    check_maneuvers(world_.maneuvers, world_.disks.size(),
                    [this](std::size_t k, const WorldManeuver& m) { check_maneuver(k, m); });
    check_radii();
    return std::move(world_);
  }

 private:
  enum Member { contacts = first_other, frame, container, disks, plan, missing, restitution, law };

  void read_member(std::size_t member) {
    switch (member) {
      case contacts:
        if (json_.text() != "pass") json_.fail(only_pass);
        break;
      case frame:
        read_frame();
        break;
      case container:
        read_circle(false);
        break;
      case disks:
        json_.array([&](std::size_t i) { read_disk(i); });
        break;
      case plan:
        json_.array([&](std::size_t i) { read_maneuver(i); });
        break;
      case missing:
        json_.array([&](std::size_t) { world_.missing.emplace_back(json_.text()); });
        break;
      case restitution:
      case law:
        fail_as_bouncing();
      default:
        read_common(member);
    }
  }

  void read_point(Point2& point) { read_pair(point.x, point.y); }

  [[noreturn]] void fail_as_bouncing() const { json_.fail("disks that pass do not bounce"); }

  void read_frame() {
    if (!json_.text_is_next()) return read_circle(true);
    if (json_.text() != "none") json_.fail("neither \"none\" nor a circle");
  }

  void read_circle(bool may_grow) {
    enum { center, radius, growth, walls, bounce };
    static constexpr std::array<std::string_view, 5> names = {"center", "radius", "growth", "walls",
                                                              "restitution"};
    circle_line_ = line_of_object();
    WorldCircle& circle = world_.circle.emplace();
    json_.object(names, bit(center) | bit(radius), [&](std::size_t member) {
      switch (member) {
        case center:
          read_point(circle.center);
          break;
        case radius:
          read_radius(circle.radius);
          if (circle.radius == 0) json_.fail("not positive");
          break;
        case growth:
          if (!may_grow) json_.fail("a container does not grow; a frame does");
          circle.growth = value();
          break;
        case walls:
          json_.fail("walls are not built yet");
        case bounce:
          fail_as_bouncing();
      }
    });
  }

  void read_disk(std::size_t index) {
    begin_disk(index);
    enum { center, radius, velocity, growth, enter, leave, mass };
    static constexpr std::array<std::string_view, 7> names = {
        "center", "radius", "velocity", "growth", "enter", "leave", "mass"};
    WorldDisk& disk = world_.disks.emplace_back();
    GrowingDisk& state = disk.state;
    Extensions extensions;
    json_.object(
        names, bit(center) | bit(radius) | bit(velocity),
        [&](std::size_t member) {
          switch (member) {
            case center:
              read_pair(state.x, state.y);
              break;
            case radius:
              read_radius(state.radius);
              break;
            case velocity:
              read_pair(state.vx, state.vy);
              break;
            case growth:
              state.growth = value();
              break;
            case enter:
              read_time(disk.enter);
              break;
            case leave:
              read_time(disk.leave.emplace());
              break;
            case mass:
              json_.fail("disks that pass have no mass");
          }
        },
        &extensions);
    if (disk.leave && *disk.leave <= disk.enter) json_.fail_in("leave", "not later than \"enter\"");
    if (!extensions.empty()) world_.disk_extensions.emplace(index, std::move(extensions));
  }

  void read_maneuver(std::size_t index) {
    begin_maneuver(index);
    enum { t, disk, center, radius, velocity, growth };
    static constexpr std::array<std::string_view, 6> names = {"t",      "disk",     "center",
                                                              "radius", "velocity", "growth"};
    WorldManeuver maneuver{};
    Extensions extensions;
    const std::uint32_t seen = json_.object(
        names, bit(t) | bit(disk),
        [&](std::size_t member) {
          switch (member) {
            case t:
              read_maneuver_time(maneuver.t, world_.maneuvers);
              break;
            case disk:
              maneuver.disk = read_maneuver_disk();
              break;
            case center:
              read_point(maneuver.center.emplace());
              break;
            case radius:
              read_radius(maneuver.radius.emplace());
              break;
            case velocity:
              read_point(maneuver.velocity.emplace());
              break;
            case growth:
              maneuver.growth.emplace() = value();
          }
        },
        &extensions);
    if (seen == (bit(t) | bit(disk)))
      json_.fail("changes nothing: it has neither center, radius, velocity nor growth");
    if (!extensions.empty()) world_.maneuver_extensions.emplace(index, std::move(extensions));
    world_.maneuvers.push_back(std::move(maneuver));
  }

  void check_circle() const {
    if (!world_.circle) return;
    const WorldCircle& circle = *world_.circle;
    if (circle.radius + circle.growth * world_.horizon <= 0)
      throw InputError(file_, circle_line_, "frame.growth",
                       "the radius is not positive up to the horizon");
  }

  void check_maneuver(std::size_t k, const WorldManeuver& maneuver) const {
    const WorldDisk& disk = world_.disks[static_cast<std::size_t>(maneuver.disk)];
    const Rational& t = maneuver.t;
    if (t < disk.enter || (t == disk.enter && t != 0))
      fail_in_maneuver(k, "t", "not after the disk enters");
    if (disk.leave && t >= *disk.leave) fail_in_maneuver(k, "t", "the disk has left");
  }

  void check_radii() const {
    const auto paths = world_.motion().paths;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      for (const WorldPiece& piece : paths[i]) {
        const Rational& end = piece.to ? *piece.to : world_.horizon;
        if (after(piece.state, end - piece.from).radius >= 0) continue;
        fail_in_disk(i, "", "its radius becomes negative before t = " + number_text(end));
      }
    }
  }

  World world_;
  std::int64_t circle_line_ = 0;  // the line of its opening brace
};

}  // namespace

bool is_world_file(const std::string& path) {
  const FileFormat format = format_at_beginning(path);
  return format.name == "voroproof-scene" && is_of_worlds(format);
}

World parse_world(std::string_view bytes, const std::string& file_name) {
  World world = of_this_version(
      bytes, file_name, "voroproof-scene", [&] { return WorldReader(bytes, file_name).read(); },
      world_version);
  world.sha256 = sha256_hex(bytes);
  return world;
}

World read_world(const std::string& path) {
  return parse_world(file_bytes(path, max_scene_bytes), path);
}

}  // namespace voroproof::internal
