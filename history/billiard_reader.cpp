#include <array>
#include <utility>

#include "history/billiard.h"
#include "history/descriptor.h"
#include "history/error.h"
#include "history/file_bytes.h"
#include "history/file_format.h"
#include "history/format_version.h"
#include "history/json_reader.h"
#include "history/scene_fields.h"
#include "history/sha256.h"

namespace voroproof::internal {
namespace {

class BilliardReader : SceneFields {
 public:
  BilliardReader(std::string_view bytes, const std::string& file)
      : SceneFields(bytes, file, world_version) {}

  Billiard read() {
    static constexpr std::array<std::string_view, 13> names = {
        "format",    "version", "name",        "comment", "seed",  "horizon",  "contacts",
        "dimension", "frame",   "restitution", "gravity", "disks", "maneuvers"};
    first_line_ = line_of_object();
    const std::uint32_t seen = json_.object(
        names, bit(format) | bit(version) | bit(horizon) | bit(contacts) | bit(frame) | bit(disks),
        [&](std::size_t member) { read_member(member); }, &dropped_);
    json_.finish();
    billiard_.horizon = horizon_;
    if (!(seen & bit(dimension))) billiard_.dimension = 2;
    check();
    return std::move(billiard_);
  }

 private:
  enum Member { contacts = first_other, dimension, frame, restitution, gravity, disks, plan };

  void read_member(std::size_t member) {
    switch (member) {
      case contacts:
        if (json_.text() != "bounce") json_.fail("not \"bounce\"");
        break;
      case dimension:
        billiard_.dimension = static_cast<int>(json_.integer(2, 3));
        break;
      case frame:
        read_frame();
        break;
      case restitution:
        read_restitution(billiard_.restitution);
        break;
      case gravity:
        read_vector(billiard_.gravity);
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
  }

  // The dimension may come later in the file: how many there are is checked at the end.
  void read_vector(Vec3& vector) {
    const std::size_t count = json_.array([&](std::size_t i) {
      if (i >= vector.size()) json_.fail("more than three coordinates");
      vector[i] = value();
    });
    require_coordinates(count);
  }

  void require_coordinates(std::size_t count) {
    if (count < 2) json_.fail("fewer than two coordinates");
    if (coordinates_ == 0) {
      coordinates_ = count;
      coordinates_field_ = json_.field();
    }
    if (coordinates_ != count)
      json_.fail("other than " + std::to_string(coordinates_) + " coordinates, as " +
                 coordinates_field_ + " has");
  }

  void read_frame() {
    if (json_.text_is_next()) {
      if (json_.text() != "none") json_.fail("neither \"none\" nor an object");
      return;
    }
    enum { center, radius, bounce, walls, periodic, shear };
    static constexpr std::array<std::string_view, 6> names = {"center", "radius",   "restitution",
                                                              "walls",  "periodic", "shear"};
    RoundFrame round;
    const std::uint32_t seen = json_.object(names, 0, [&](std::size_t member) {
      switch (member) {
        case center:
          read_vector(round.center);
          break;
        case radius:
          round.radius = value();
          if (round.radius <= 0) json_.fail("not positive");
          break;
        case bounce:
          read_positive_restitution(round.restitution);
          break;
        case walls:
          json_.array([&](std::size_t) { read_wall(); });
          break;
        case periodic:
          read_sides();
          break;
        case shear:
          billiard_.lattice.shear = value();
      }
    });
    const bool is_round = (seen & (bit(center) | bit(radius) | bit(bounce))) != 0;
    if (is_round && (seen & (bit(walls) | bit(periodic) | bit(shear))))
      json_.fail_in("center", "a frame is round, or has walls and periodic axes");
    if (is_round && (seen & (bit(center) | bit(radius))) != (bit(center) | bit(radius)))
      json_.fail_in(seen & bit(center) ? "radius" : "center", "missing");
    if (!is_round && !(seen & (bit(walls) | bit(periodic))))
      json_.fail("neither round (\"center\", \"radius\"), nor of \"walls\", nor \"periodic\"");
    if (is_round) billiard_.round = std::move(round);
    const PeriodicBox& lattice = billiard_.lattice;
    for (const BilliardWall& wall : billiard_.walls) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (wall.normal[axis] != 0 && lattice.sides[axis] != 0)
          json_.fail_in("walls", "a wall lies across an axis that is periodic");
      }
    }
    if (lattice.shear != 0 && (lattice.sides[0] == 0 || lattice.sides[1] == 0))
      json_.fail_in("shear", "the first two axes are not both periodic");
  }

  void read_wall() {
    if (billiard_.walls.size() >= max_disks)
      json_.fail("more than " + std::to_string(max_disks) + " walls");
    enum { normal, offset, speed, bounce };
    static constexpr std::array<std::string_view, 4> names = {"normal", "offset", "speed",
                                                              "restitution"};
    BilliardWall wall;
    json_.object(names, bit(normal) | bit(offset), [&](std::size_t member) {
      switch (member) {
        case normal:
          read_vector(wall.normal);
          if (dot(wall.normal, wall.normal) != 1) json_.fail("its length is not exactly 1");
          break;
        case offset:
          wall.offset = value();
          break;
        case speed:
          wall.speed = value();
          break;
        case bounce:
          read_positive_restitution(wall.restitution);
      }
    });
    billiard_.walls.push_back(std::move(wall));
  }

  void read_sides() {
    Vec3& sides = billiard_.lattice.sides;
    const std::size_t count = json_.array([&](std::size_t i) {
      if (i >= sides.size()) json_.fail("more than three sides");
      if (json_.null()) return;
      sides[i] = value();
      if (sides[i] <= 0) json_.fail("not positive; an axis that is not periodic has null");
    });
    require_coordinates(count);
  }

  void read_disk(std::size_t index) {
    begin_disk(index);
    enum { center, radius, velocity, growth, mass, fixed };
    static constexpr std::array<std::string_view, 6> names = {"center", "radius", "velocity",
                                                              "growth", "mass",   "fixed"};
    BilliardDisk disk;
    const std::uint32_t seen = json_.object(
        names, bit(center) | bit(radius),
        [&](std::size_t member) {
          switch (member) {
            case center:
              read_vector(disk.center);
              break;
            case radius:
              read_radius(disk.radius);
              break;
            case velocity:
              read_vector(disk.velocity);
              break;
            case growth:
              disk.growth = value();
              break;
            case mass:
              disk.mass = value();
              if (disk.mass <= 0) json_.fail("not positive");
              break;
            case fixed:
              disk.fixed = json_.boolean();
          }
        },
        &dropped_);
    if (disk.fixed && disk.velocity != Vec3{}) json_.fail_in("velocity", "a fixed disk has none");
    if (!disk.fixed && !(seen & bit(velocity))) json_.fail_in("velocity", "missing");
    if (!(seen & bit(mass))) disk.mass = disk.radius * disk.radius;
    billiard_.disks.push_back(std::move(disk));
  }

  void read_maneuver(std::size_t index) {
    begin_maneuver(index);
    enum { t, disk, velocity };
    static constexpr std::array<std::string_view, 3> names = {"t", "disk", "velocity"};
    BilliardManeuver maneuver{};
    json_.object(
        names, bit(t) | bit(disk) | bit(velocity),
        [&](std::size_t member) {
          switch (member) {
            case t:
              read_maneuver_time(maneuver.t, billiard_.maneuvers);
              break;
            case disk:
              maneuver.disk = read_maneuver_disk();
              break;
            case velocity:
              read_vector(maneuver.velocity);
          }
        },
        &dropped_);
    billiard_.maneuvers.push_back(std::move(maneuver));
  }

  void check() const {
    if (coordinates_ != 0 && coordinates_ != static_cast<std::size_t>(billiard_.dimension))
      throw InputError(file_, first_line_, coordinates_field_,
                       "has " + std::to_string(coordinates_) +
                           " coordinates, and \"dimension\" is " +
                           std::to_string(billiard_.dimension));
    const bool alone = billiard_.disks.size() == 1;
    for (std::size_t i = 0; i < billiard_.disks.size(); ++i) {
      const BilliardDisk& disk = billiard_.disks[i];
      const Rational last = disk.radius + disk.growth * billiard_.horizon;
      if (last < 0) fail_in_disk(i, "growth", "the radius becomes negative before the horizon");
      if (disk.mass == 0 && !disk.fixed && !alone) fail_in_disk(i, "mass", "missing for a point");
      if (billiard_.round && std::max(disk.radius, last) > billiard_.round->radius)
        fail_in_disk(i, "radius", "the disk does not fit into the frame up to the horizon");
      for (const Rational& side : billiard_.lattice.sides) {
        if (side != 0 && 2 * std::max(disk.radius, last) >= side)
          fail_in_disk(i, "radius", "the disk reaches its own image up to the horizon");
      }
    }
    check_maneuvers(billiard_.maneuvers, billiard_.disks.size(),
                    [this](std::size_t k, const BilliardManeuver& maneuver) {
                      if (billiard_.disks[static_cast<std::size_t>(maneuver.disk)].fixed)
                        fail_in_maneuver(k, "disk", "is fixed");
                    });
  }

  Billiard billiard_;
  Extensions dropped_;  // nothing is written back
  std::int64_t first_line_ = 0;
  std::size_t coordinates_ = 0;  // as many as the first vector has; 0 before it
  std::string coordinates_field_;
};

}  // namespace

bool is_billiard_file(const std::string& path) {
  if (is_stream(path)) return false;
  bool bounce = false;
  try {
    const FileFormat format = format_of_file(path);
    if (format.name != "voroproof-scene" || !is_of_worlds(format)) return false;
    const std::string bytes = file_bytes(path, max_scene_bytes);
    JsonReader json(bytes, path);
    json.any_object([&](std::string_view name) {
      if (name != "contacts") {
        json.any();
        return true;
      }
      bounce = json.text() == "bounce";
      return false;
    });
  } catch (const InputError&) {
    return bounce;  // whoever reads it says what is wrong
  }
  return bounce;
}

Billiard parse_billiard(std::string_view bytes, const std::string& file_name) {
  Billiard billiard = of_this_version(
      bytes, file_name, "voroproof-scene", [&] { return BilliardReader(bytes, file_name).read(); },
      world_version);
  billiard.sha256 = sha256_hex(bytes);
  return billiard;
}

Billiard read_billiard(const std::string& path) {
  return parse_billiard(file_bytes(path, max_scene_bytes), path);
}

}  // namespace voroproof::internal
