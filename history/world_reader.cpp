#include <array>
#include <utility>

#include "history/error.h"
#include "history/file_bytes.h"
#include "history/file_format.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/json_text.h"
#include "history/scene_value.h"
#include "history/sha256.h"
#include "history/world.h"

namespace voroproof::internal {
namespace {

constexpr auto bit = JsonReader::bit;

constexpr const char* only_pass =
    "\"pass\" is wanted here; only simulate, certify and validate read billiards, whose disks "
    "bounce";

class WorldReader {
 public:
  WorldReader(std::string_view bytes, const std::string& file) : file_(file), json_(bytes, file) {}

  World read() {
    static constexpr std::array<std::string_view, 13> names = {
        "format", "version",   "name",  "comment",   "seed",        "horizon",      "contacts",
        "frame",  "container", "disks", "maneuvers", "restitution", "container_law"};
    const std::int64_t first_line = line_of_object();
    const std::uint32_t seen = json_.object(
        names, bit(format) | bit(version) | bit(horizon) | bit(disks),
        [&](std::size_t member) { read_member(member); }, &world_.extensions);
    json_.finish();
    if (!(seen & bit(contacts)))
      throw InputError(file_, first_line, "contacts", std::string("missing: ") + only_pass);
    if (!(seen & (bit(frame) | bit(container))))
      throw InputError(file_, first_line, "frame",
                       "missing: \"none\", or a circle, or \"container\" in its place");
    if ((seen & bit(frame)) && (seen & bit(container)))
      throw InputError(file_, circle_line_, "container", "a world has it or a frame, not both");
    check_circle();
    check_maneuvers();
    check_radii();
    return std::move(world_);
  }

 private:
  enum Member {
    format,
    version,
    name,
    comment,
    seed,
    horizon,
    contacts,
    frame,
    container,
    disks,
    plan,
    restitution,
    law
  };

  void read_member(std::size_t member) {
    switch (member) {
      case format:
        if (json_.text() != "voroproof-scene") json_.fail("not \"voroproof-scene\"");
        break;
      case version:
        read_version(json_, world_version);
        break;
      case name:
        world_.name = json_.text();
        break;
      case comment:
        world_.comment = json_.text();
        break;
      case seed:
        world_.seed = read_seed(json_);
        break;
      case horizon:
        read_time(world_.horizon);
        break;
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
      case restitution:
      case law:
        fail_as_bouncing();
    }
  }

  Rational value() { return scene_value(json_); }

  void read_time(Rational& t) {
    t = value();
    if (t < 0) json_.fail("negative");
  }

  void read_radius(Rational& radius) {
    radius = value();
    if (radius < 0) json_.fail("negative");
  }

  void read_pair(Rational& x, Rational& y) {
    json_.array_of<2>([&](std::size_t i) { (i == 0 ? x : y) = value(); });
  }

  void read_point(Point2& point) { read_pair(point.x, point.y); }

  // Moves to the object that is next, for its line.
  std::int64_t line_of_object() {
    json_.array_is_next();
    return json_.line();
  }

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
    if (index >= max_disks) json_.fail("more than " + std::to_string(max_disks) + " disks");
    enum { center, radius, velocity, growth, enter, leave, mass };
    static constexpr std::array<std::string_view, 7> names = {
        "center", "radius", "velocity", "growth", "enter", "leave", "mass"};
    disk_lines_.push_back(line_of_object());
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
    if (index >= max_maneuvers)
      json_.fail("more than " + std::to_string(max_maneuvers) + " maneuvers");
    enum { t, disk, center, radius, velocity, growth };
    static constexpr std::array<std::string_view, 6> names = {"t",      "disk",     "center",
                                                              "radius", "velocity", "growth"};
    maneuver_lines_.push_back(line_of_object());
    WorldManeuver maneuver{};
    Extensions extensions;
    const std::uint32_t seen = json_.object(
        names, bit(t) | bit(disk),
        [&](std::size_t member) {
          switch (member) {
            case t:
              read_time(maneuver.t);
              if (!world_.maneuvers.empty() && maneuver.t < world_.maneuvers.back().t)
                json_.fail("earlier than the maneuver before it");
              break;
            case disk:
              maneuver.disk = static_cast<int>(json_.integer(0, max_disks - 1));
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
              maneuver.growth = value();
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

  void check_maneuvers() const {
    std::vector<const Rational*> last(world_.disks.size());  // when the disk's last one was
    for (std::size_t i = 0; i < world_.maneuvers.size(); ++i) {
      const auto& [t, id, center, velocity, radius, growth] = world_.maneuvers[i];
      const auto index = static_cast<std::size_t>(id);
      if (index >= world_.disks.size()) fail_in_maneuver(i, "disk", "no such disk");
      const WorldDisk& disk = world_.disks[index];
      if (t < disk.enter || (t == disk.enter && t != 0))
        fail_in_maneuver(i, "t", "not after the disk enters");
      if (disk.leave && t >= *disk.leave) fail_in_maneuver(i, "t", "the disk has left");
      if (last[index] != nullptr && *last[index] == t)
        fail_in_maneuver(i, "disk", "second maneuver of one disk at one time");
      last[index] = &t;
    }
  }

  void check_radii() const {
    const auto paths = world_.motion().paths;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      for (const WorldPiece& piece : paths[i]) {
        const Rational& end = piece.to ? *piece.to : world_.horizon;
        if (after(piece.state, end - piece.from).radius >= 0) continue;
        throw InputError(file_, disk_lines_[i], "disks[" + std::to_string(i) + ']',
                         "its radius becomes negative before t = " + number_text(end));
      }
    }
  }

  [[noreturn]] void fail_in_maneuver(std::size_t index, const char* member,
                                     const std::string& reason) const {
    throw InputError(file_, maneuver_lines_[index],
                     "maneuvers[" + std::to_string(index) + "]." + member, reason);
  }

  const std::string& file_;
  JsonReader json_;
  World world_;
  // Lines of the opening braces.
  std::int64_t circle_line_ = 0;
  std::vector<std::int64_t> disk_lines_, maneuver_lines_;
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
