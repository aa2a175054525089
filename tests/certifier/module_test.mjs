// Histories reach these seldom: spellings of numbers, options, pictures of faults, and a kernel without memory.
//
// usage: MODULE=... KERNEL=... CORPUS=... node module_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { answer } from "./kernel.mjs";

const { KERNEL: kernel, CORPUS: corpus } = process.env;
const scene = readFileSync(join(corpus, "scenes/disks.scene.json"));
const history = readFileSync(join(corpus, "certified/disks.history.jsonl"));
const bytes = (text) => new TextEncoder().encode(text);

// Repeatable numbers of 0 ... below - 1.
let state = 1n;
function any(below) {
  state = (state * 6364136223846793005n + 1442695040888963407n) % 2n ** 64n;
  return Number((state >> 33n) % BigInt(below));
}
const digits = (length) => Array.from({ length }, () => any(10)).join("");

// The history of an empty scene; its horizon is spelled so. Another one than the scene's is told in full.
function compare(folder, horizon) {
  const empty = '{"format":"voroproof-scene","version":1,"container":{"center":[0,0],"radius":1},"horizon":7,"disks":[]}';
  const header = { format: "voroproof-history", version: 1, scene_sha256: createHash("sha256").update(empty).digest("hex"), producer: "" };
  const text = `${JSON.stringify(header).slice(0, -1)},"horizon":${horizon}}\n{"end":{"t":${horizon},"flips":0,"collisions":0,"maneuvers":0}}\n`;
  const files = [["a.scene.json", empty], ["a.history.jsonl", text]].map(([name, content]) => {
    writeFileSync(join(folder, name), content);
    return join(folder, name);
  });
  const options = { tolerance: "1e-20" }, { lines } = answer(bytes(empty), bytes(text), options);
  assert.equal(lines, spawnSync(kernel, [...files, "--tolerance", options.tolerance], { encoding: "utf8" }).stdout, horizon);
  return lines;
}

test("numbers are read as the native kernel reads them", () => {
  const folder = mkdtempSync(join(tmpdir(), "numbers-")), half = "9007199254740993";
  const spellings = ["0.1", "1e22", "1e23", half, "5e-324", "2.2250738585072011e-308", "1.5e3", "1.7976931348623157e308", "1e999", "2e-324",
    "1.7976931348623159e308", "2.4703282292062328e-324", "0.0e5", "-0.0", "1E+2", "18446744073709551615", "18446744073709551616",
    `${half}.${"0".repeat(900)}`, `${half}.${"0".repeat(900)}1`, "1".repeat(5000), "01", "1.", ".5", "+1", "1e", "nan",
    ...["1/3", "0x1.8p-3", "007.50e-1", "1/0", "1/2/3", "1e401", "0x1p1201", "1e-400", "", "1".repeat(4096), "1".repeat(4097)].map((text) => `"${text}"`)];
  for (let k = 0; k < 60; ++k) {
    spellings.push(`${1 + any(9)}.${digits(1 + any(30))}e${any(640) - 325}`, `0.${"0".repeat(300 + any(22))}${digits(1 + any(60))}1`);
    // Half way between two, as a decimal; and just above.
    const exact = (2n ** 53n + 2n * BigInt(any(2 ** 31)) + 1n) * 5n ** BigInt(k), point = exact.toString();
    spellings.push(`${point}e-${k}`, `${point}${"0".repeat(any(700))}1e-${k + 700}`);
  }
  const told = spellings.map((text) => compare(folder, text));
  assert.ok(told.filter((lines) => lines.includes("of the scene's 7")).length > 200);
  assert.ok(told.filter((lines) => lines.endsWith("s INVALID\n")).length > 15);
  rmSync(folder, { recursive: true });
});

test("options are those of the kernel", () => {
  const without = readFileSync(join(corpus, "certified/disks-quadruplets-not-oriented.history.jsonl"));
  assert.equal(answer(scene, without).verdict, "REFUTED");
  assert.equal(answer(scene, without, { unoriented: true }).verdict, "CERTIFIED");
  for (const options of [{ tolerance: "0" }, { tolerance: "1e9" }, { lawTolerance: "2" }, { tolerance: "x" }]) {
    assert.equal(answer(scene, history, options).verdict, "INVALID");
  }
  const longer = bytes(history.toString().replace(/("horizon"|"end":{"t"):[0-9.]+/g, "$1:1e3"));
  const { horizon, horizonNote } = answer(scene, longer);
  assert.equal(horizon, 1000);
  assert.match(horizonNote, /^horizon 1000 of the scene's /);
  assert.match(answer(scene, longer, { strict: true }).reason, /another horizon/);
});

test("the work tells how far it is", () => {
  const told = new Map();
  answer(scene, history, {}, (rule, claim, of) => told.set(rule, [...(told.get(rule) ?? []), claim / of]));
  assert.deepEqual([...told.keys()], ["paths", "contacts", "edges"]);
  for (const shares of told.values()) assert.ok(shares[0] === 0 && shares.every((share, k) => k === 0 || share > shares[k - 1]) && shares.at(-1) < 1);
});

test("a fault is seen where it is, and only a fault", () => {
  const { drawing, line } = answer(scene, readFileSync(join(corpus, "refuted/dropped-flip.history.jsonl")));
  assert.deepEqual(drawing.named, [1, 3, 0, 6]);
  assert.equal(line, 4);
  const flip = history.toString().split("\n").find((text) => /"flip":\[(1,3,0,6|3,1,6,0)\]/.test(text));
  assert.ok(Math.abs(drawing.t - JSON.parse(flip).t) < 1e-6);
  assert.deepEqual(drawing.generators.slice(0, 2).map(({ id }) => id), [-1, 0]);
  assert.equal(answer(scene, history).drawing, null);
  assert.equal(answer(scene, history, { tolerance: "x" }).drawing, null);
  // Without a place of its own, a fault is at its claim.
  const moved = bytes(history.toString().replace(/\{"t":([0-9.]+),"flip":\[(.*?)\]/, '{"t":$1,"flip":[-1,0,1,1]'));
  const strange = answer(scene, moved);
  assert.equal(strange.verdict, "REFUTED");
  assert.deepEqual(strange.drawing.named, [-1, 0, 1, 1]);
});

test("without memory there is no verdict", () => {
  assert.throws(() => answer({ length: 2 ** 32 - 2 ** 20 }, history), /no memory left/);
});
