"use strict";
// Checks of values in files (docs/formats.md). Each reader throws Stop (INVALID) that names the field.

const CONTAINER = -1;
const SMALLEST_OF_SCENE = nearestBinary64(power(10, -100));
const LARGEST_OF_SCENE = nearestBinary64(power(10, 100));

function refuseField(value, reason) {
  invalid(reason, { field: value.path, at: value.at });
}

// An object with all fields of the first list, and of others only those of the second and, where it may have them,
// extensions.
function expectFields(value, required, optional = [], isExtensible = true) {
  if (value.kind !== "object") refuseField(value, "not a JSON object");
  for (const name of required) {
    if (!value.has(name)) refuseField(value, `the field '${name}' is missing`);
  }
  for (const [name, field] of value.value) {
    if (required.includes(name) || optional.includes(name) || (isExtensible && name.startsWith("x-"))) continue;
    refuseField(field, "an unknown field");
  }
}

// Before the other fields: a newer version may have some that are not known here.
function expectFormat(value, format) {
  if (value.kind !== "object") refuseField(value, "not a JSON object");
  const given = value.get("format"), version = value.get("version");
  if (given?.kind !== "string" || given.value !== format) refuseField(given ?? value, `not the format '${format}'`);
  if (version?.kind !== "number" || !version.isWhole) refuseField(version ?? value, "no version");
  if (BigInt(version.value) > 1n) refuseField(version, `of version ${version.value}; this page reads version 1`);
  if (version.value !== "1") refuseField(version, "another version than 1");
}

function readTextField(value) {
  if (value.kind !== "string") refuseField(value, "not a string");
  return value.value;
}

function readNumber(value) {
  if (value.kind === "string") return exactOfText(value.value, { field: value.path, at: value.at }).reduced();
  if (value.kind !== "number") refuseField(value, "not a number");
  const x = binary64OfText(value.value);
  if (x === null) refuseField(value, "beyond the range of binary64");
  return x;
}

function readSceneNumber(value) {
  const x = readNumber(value), size = x.abs();
  if (x.n !== 0n && (size.less(SMALLEST_OF_SCENE) || LARGEST_OF_SCENE.less(size))) {
    refuseField(value, "beyond a scene's limits");
  }
  if (value.kind === "string" && x.toString().length > MOST_CHARACTERS) {
    refuseField(value, "an exact number of more than 4096 characters");
  }
  return x;
}

function readHistoryNumber(value) {
  const x = readNumber(value);
  if (x.n !== 0n && value.kind === "string") {
    const nearest = nearestBinary64(x);
    if (nearest === null || nearest.n === 0n) refuseField(value, "beyond the range of binary64");
  }
  return x;
}

function readList(value, least, most) {
  if (value.kind !== "list") refuseField(value, "not a list");
  const { length } = value.value;
  if (length < least || length > most) refuseField(value, `a list of ${length}`);
  return value.value;
}

function readVector(value, read) {
  return readList(value, 2, 2).map(read);
}

function readWhole(value, least, most) {
  if (value.kind !== "number" || !value.isWhole) refuseField(value, "not an integer");
  const x = BigInt(value.value);
  if (x < BigInt(least) || x > BigInt(most)) refuseField(value, "an integer beyond its limits");
  return Number(x);
}

function readQuad(value, n) {
  const quad = readList(value, 4, 4).map((id) => readWhole(id, CONTAINER, n - 1));
  const [l, r, s, e] = quad;
  if (l === r || s === l || s === r || e === l || e === r) refuseField(value, "a quadruple that names no edge");
  return quad;
}

function quadName(quad) {
  return `[${quad.join(",")}]`;
}
