// Scenes of version 2 whose disks bounce (docs/formats.md, section 21).
#include "certify/kernel/json.h"

namespace voroproof_kernel {
namespace {

// In [0, 1], or in (0, 1] for frames.
Rat restitution(const Json& of, bool positive) {
  const Rat e = scene_number(of.value("restitution", Json(1)));
  if (e < 0 || e > 1 || (positive && e == 0)) invalid("a restitution beyond its limits");
  return e;
}

void read_walls(const Json& frame, Scene& scene) {
  const Json walls = frame.value("walls", Json::array());
  for (const Json& one : list(walls, 0, 2000000)) {
    expect_fields(one, {"normal", "offset"}, {"speed", "restitution"}, false);
    const Wall wall{vec(one["normal"], scene_number, scene.dimension), scene_number(one["offset"]),
                    scene_number(one.value("speed", Json(0))), restitution(one, true)};
    if (norm2(wall.normal) != 1) invalid("the length of a wall's normal is not 1");
    for (int k = 0; k < 3; ++k) {
      if (wall.normal[k] * scene.sides[k] != 0) invalid("a wall lies across a periodic axis");
    }
    scene.walls.push_back(wall);
  }
}

void read_frame(const Json& frame, Scene& scene) {
  if (frame == "none") return;
  if (!frame.is_object()) invalid("an unknown frame");
  if (frame.contains("center") || frame.contains("radius")) {
    expect_fields(frame, {"center", "radius"}, {"restitution"}, false);
    scene.center = vec(frame["center"], scene_number, scene.dimension);
    scene.radius = scene_number(frame["radius"]);
    scene.wall_restitution = restitution(frame, true);
    if (scene.radius <= 0) invalid("a radius that is not positive");
    return;
  }
  expect_fields(frame, {}, {"walls", "periodic", "shear"}, false);
  if (!frame.contains("walls") && !frame.contains("periodic")) invalid("a frame of nothing");
  if (frame.contains("periodic")) {
    const Json& sides = list(frame["periodic"], scene.dimension, scene.dimension);
    for (int k = 0; k < scene.dimension; ++k) {
      if (sides[k].is_null()) continue;
      scene.sides[k] = scene_number(sides[k]);
      if (scene.sides[k] <= 0) invalid("a side that is not positive");
    }
  }
  scene.shear = scene_number(frame.value("shear", Json(0)));
  if (scene.shear * scene.shear > 0 && scene.sides[0] * scene.sides[1] == 0)
    invalid("shear along axes that are not periodic");
  read_walls(frame, scene);
}

Disk read_disk(const Json& json, const Scene& scene, bool alone) {
  expect_fields(json, {"center", "radius"}, {"velocity", "mass", "growth", "fixed"});
  Disk disk{
      vec(json["center"], scene_number, scene.dimension), {}, scene_number(json["radius"]), 0};
  const Json fixed = json.value("fixed", Json(false));
  if (!fixed.is_boolean()) invalid("neither true nor false");
  disk.fixed = fixed == true;
  if (json.contains("velocity")) {
    disk.velocity = vec(json["velocity"], scene_number, scene.dimension);
    if (disk.fixed && norm2(disk.velocity) != 0) invalid("a fixed disk has no velocity");
  } else if (!disk.fixed) {
    invalid("the field 'velocity' is missing");
  }
  disk.mass = json.contains("mass") ? scene_number(json["mass"]) : square(disk.radius);
  if (disk.mass <= 0 && (json.contains("mass") || !(alone || disk.fixed)))
    invalid("a mass that is not positive");
  disk.growth = scene_number(json.value("growth", Json(0)));
  const Rat last = disk.radius + disk.growth * scene.horizon, most = std::max(disk.radius, last);
  if (disk.radius < 0 || last < 0) invalid("a negative radius");
  if (scene.radius > 0 && most > scene.radius) invalid("a disk that does not fit into the frame");
  for (const Rat& side : scene.sides) {
    if (side > 0 && 2 * most >= side) invalid("a disk reaches its own image");
  }
  return disk;
}

}  // namespace

Scene read_billiard(const Json& json) {
  if (json.value("contacts", Json()) == "pass") undecided("the kernel does not know worlds");
  expect_fields(json, {"format", "version", "contacts", "frame", "horizon", "disks"},
                {"name", "comment", "seed", "dimension", "restitution", "gravity", "maneuvers"});
  if (json["contacts"] != "bounce") invalid("unknown contacts");
  read_remarks(json);
  Scene scene;
  scene.dimension = static_cast<int>(whole(json.value("dimension", Json(2)), 2, 3));
  scene.horizon = scene_number(json["horizon"]);
  if (scene.horizon < 0) invalid("a negative horizon");
  scene.restitution = restitution(json, false);
  if (json.contains("gravity")) scene.gravity = vec(json["gravity"], scene_number, scene.dimension);
  read_frame(json["frame"], scene);
  const Json& disks = list(json["disks"], 0, 2000000);
  for (const Json& one : disks) scene.disks.push_back(read_disk(one, scene, disks.size() == 1));
  read_maneuvers(json, scene);
  return scene;
}

}  // namespace voroproof_kernel
