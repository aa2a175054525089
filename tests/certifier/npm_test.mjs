// The npm package as its users have it: packed, unpacked elsewhere, and asked.
//
// usage: PACKAGE=... KERNEL=... CORPUS=... node npm_test.mjs
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

const { KERNEL: kernel, CORPUS: corpus, PACKAGE: packed } = process.env;
const folder = mkdtempSync(join(tmpdir(), "npm-"));
execFileSync("tar", ["-xzf", packed, "-C", folder]);
const { exports, license, version } = JSON.parse(readFileSync(join(folder, "package/package.json"), "utf8"));
const { certify } = await import(pathToFileURL(join(folder, "package", exports["."].default)));

const scene = join(corpus, "scenes/disks.scene.json");
const right = readFileSync(join(corpus, "certified/disks.history.jsonl"), "utf8");

test("its answers are those of the program", async () => {
  const flip = right.split("\n").findIndex((line) => line.includes('"flip"'));
  const wrong = right.split("\n").filter((_, k) => k !== flip).join("\n");
  for (const [history, verdict] of [[right, "CERTIFIED"], [wrong, "REFUTED"], ["{}", "INVALID"]]) {
    const answer = await certify(readFileSync(scene), history);
    assert.equal(answer.verdict, verdict);
    const file = join(folder, "a.history.jsonl");
    writeFileSync(file, history);
    assert.equal(answer.lines, spawnSync(kernel, [scene, file], { encoding: "utf8" }).stdout);
    assert.equal(verdict === "CERTIFIED", answer.reason === "");
  }
});

test("options", async () => {
  const early = right.replace(/"t":(\d+\.\d{6})\d*,"flip"/, '"t":$1,"flip"');
  assert.notEqual(early, right);
  assert.equal((await certify(readFileSync(scene), early, { tolerance: 1e-3 })).verdict, "CERTIFIED");
  assert.equal((await certify(readFileSync(scene), early, { tolerance: "1e-12" })).verdict, "REFUTED");
  await assert.rejects(certify("", "", { tolerances: 1 }), TypeError);
  await assert.rejects(certify("", "", { truth: "true" }), TypeError);
  let told = 0;
  await certify(readFileSync(scene), right, { progress: () => ++told });
  assert.ok(told > 0);
});

test("what is in it", () => {
  assert.equal(license, "MIT");
  assert.match(version, /^\d+\.\d+\.\d+$/);
  assert.match(readFileSync(join(folder, "package/LICENSE"), "utf8"), /^MIT License/);
  const types = readFileSync(join(folder, "package", exports["."].types), "utf8");
  for (const member of ["verdict", "reason", "line", "isFirst", "counts", "lines", "horizon", "horizonNote"])
    assert.match(types, new RegExp(`^  ${member}: `, "m"));
  rmSync(folder, { recursive: true });
});
