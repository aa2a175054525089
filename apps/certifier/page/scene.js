"use strict";
// A scene as its file says (docs/formats.md, section 4).

const MOST_OF_LIST = 2000000;

function readDisk(value, alone) {
  expectFields(value, ["center", "radius", "velocity"], ["mass"]);
  const disk = {
    center: readVector(value.get("center"), readSceneNumber),
    velocity: readVector(value.get("velocity"), readSceneNumber),
    radius: readSceneNumber(value.get("radius")),
  };
  if (disk.radius.sign < 0) refuseField(value.get("radius"), "a negative radius");
  const given = value.get("mass");
  disk.mass = given ? readSceneNumber(given) : disk.radius.square();
  if (disk.mass.sign <= 0 && (given || !alone)) refuseField(given ?? value, "a mass that is not positive");
  return disk;
}

function readContainer(scene, value) {
  expectFields(value, ["center", "radius"], ["restitution"], false);
  scene.center = readVector(value.get("center"), readSceneNumber);
  scene.radius = readSceneNumber(value.get("radius"));
  if (scene.radius.sign <= 0) refuseField(value.get("radius"), "a radius that is not positive");
  const given = value.get("restitution");
  scene.wallRestitution = given ? readSceneNumber(given) : UNIT;
  if (scene.wallRestitution.sign <= 0 || UNIT.less(scene.wallRestitution)) {
    refuseField(given, "a restitution beyond its limits");
  }
}

function readManeuvers(value, disks) {
  let last = ZERO, seen = new Set();
  return readList(value, 0, MOST_OF_LIST).map((one) => {
    expectFields(one, ["t", "disk", "velocity"]);
    const t = readSceneNumber(one.get("t")), disk = readWhole(one.get("disk"), 0, disks - 1);
    const order = t.against(last);
    if (order > 0) seen = new Set();
    if (order < 0 || seen.has(disk)) {
      refuseField(one, "maneuvers are sorted by t, from 0, one of a disk at an instant");
    }
    last = t;
    seen.add(disk);
    return { t, disk, velocity: readVector(one.get("velocity"), readSceneNumber) };
  });
}

// By how much two disks overlap: the distance is the reach times the root of 1 - part.
function overlapText(distance2, reach) {
  const part = UNIT.minus(distance2.over(reach.square())).near();
  return String(Number((reach.near() * part / (1 + Math.sqrt(1 - part))).toPrecision(6)));
}

// Disks lie in the container and do not overlap: by a sweep over their abscissas.
function checkPlaces(scene, values) {
  let widest = ZERO;
  scene.disks.forEach((disk, k) => {
    const n = difference(disk.center, scene.center);
    const gap = scene.radius.minus(disk.radius).square().minus(norm2(n));
    if (!disk.radius.less(scene.radius) || gap.sign < 0) refuseField(values[k], "the disk is not inside the container");
    if (gap.sign === 0 && dot(n, disk.velocity).sign === 0 && norm2(disk.velocity).sign !== 0) {
      refuseField(values[k], "the disk touches the container and moves along it");
    }
    widest = greater(widest, disk.radius);
  });
  const order = scene.disks.map((_, k) => k);
  order.sort((a, b) => scene.disks[a].center[0].against(scene.disks[b].center[0]));
  for (let i = 0; i < order.length; ++i) {
    const a = scene.disks[order[i]], most = a.radius.plus(widest);
    for (let k = i + 1; k < order.length; ++k) {
      const b = scene.disks[order[k]];
      if (most.less(b.center[0].minus(a.center[0]))) break;
      const distance2 = norm2(difference(a.center, b.center)), reach = a.radius.plus(b.radius);
      const [first, second] = [order[i], order[k]].sort((x, y) => x - y);
      if (distance2.less(reach.square())) {
        refuseField(values[second], `the disk overlaps disk ${first} by ${overlapText(distance2, reach)}`);
      }
      if (distance2.sign === 0) refuseField(values[second], `the point coincides with point ${first}`);
    }
  }
}

function sceneOf(text) {
  const json = new JsonReader(text).read();
  expectFormat(json, "voroproof-scene");
  expectFields(json, ["format", "version", "container", "horizon", "disks"],
    ["name", "comment", "seed", "container_law", "restitution", "maneuvers"]);
  for (const name of ["name", "comment"]) if (json.has(name)) readTextField(json.get(name));
  const seed = json.get("seed");
  if (seed && !(seed.kind === "number" && seed.isWhole && seed.value.length <= 1000)) readTextField(seed);
  const scene = { name: json.get("name")?.value ?? "", horizon: readSceneNumber(json.get("horizon")) };
  readContainer(scene, json.get("container"));
  if (scene.horizon.sign < 0) refuseField(json.get("horizon"), "a negative horizon");
  const between = json.get("restitution"), law = json.get("container_law");
  scene.restitution = between ? readSceneNumber(between) : UNIT;
  if (scene.restitution.sign < 0 || UNIT.less(scene.restitution)) {
    refuseField(between, "a restitution beyond its limits");
  }
  scene.wholeLaw = law !== undefined && readTextField(law) === "whole";
  if (law && !scene.wholeLaw && law.value !== "normal") refuseField(law, "an unknown law");
  const disks = readList(json.get("disks"), 0, MOST_OF_LIST);
  scene.disks = disks.map((one) => readDisk(one, disks.length === 1));
  const maneuvers = json.get("maneuvers");
  scene.maneuvers = maneuvers ? readManeuvers(maneuvers, disks.length) : [];
  checkPlaces(scene, disks);
  return scene;
}

function textOf(bytes, more) {
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return invalid("not UTF-8", more);
  }
}

// The scene of the bytes of a file.
function readScene(bytes) {
  let text = "";
  try {
    if (bytes.length > 2 ** 30) invalid("a file of more than 2^30 bytes");
    text = textOf(bytes);
    return sceneOf(text);
  } catch (stop) {
    if (!(stop instanceof Stop)) throw stop;
    stop.file = "scene";
    stop.fileLine = text.slice(0, stop.at ?? 0).split("\n").length;
    throw stop;
  }
}
