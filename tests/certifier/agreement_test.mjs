// The page's module says what voroproof-kernel says.
//
// usage: MODULE=... KERNEL=... CORPUS=... node agreement_test.mjs                  each fourth history of the corpus; all of
//                                                                                 them with VOROPROOF_EVERY=1
//        MODULE=... KERNEL=... WORLDS=... node agreement_test.mjs --worlds COUNT  wrong worlds (tests/adversary)
//        MODULE=... KERNEL=... node agreement_test.mjs --folders FOLDER...        all histories in the folders, beside their scenes
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { answer, corpusHistories } from "./kernel.mjs";

const { KERNEL: kernel, CORPUS: corpus, WORLDS: writeWorlds } = process.env, [mode, ...rest] = process.argv.slice(2);
const every = Number(process.env.VOROPROOF_EVERY ?? 4);
const folder = mkdtempSync(join(tmpdir(), "worlds-"));

function historiesOf(folder) {
  return readdirSync(folder).filter((name) => name.endsWith(".scene.json"))
    .map((name) => [join(folder, name), join(folder, name.replace(".scene.json", ".history.jsonl"))]);
}

function histories() {
  if (mode === "--folders") return rest.flatMap(historiesOf);
  if (mode !== "--worlds") return corpusHistories(corpus).filter((_, k) => k % every === 0);
  if (spawnSync(writeWorlds, [folder, rest[0], "20260101"]).status !== 0) throw new Error("no worlds");
  return historiesOf(folder);
}

function kernelSays(scene, history, truth) {
  return spawnSync(kernel, [scene, history, "--truth", truth], { encoding: "utf8" }).stdout;
}

const verdicts = {};
let different = 0, compared = 0;
for (const [scene, history] of histories()) {
  const files = [readFileSync(scene), readFileSync(history)];
  for (const truth of ["recorded", "exact"]) {
    const { lines, verdict: ours } = answer(...files, { truth }), theirs = kernelSays(scene, history, truth);
    const verdict = `${truth} ${ours}`;
    verdicts[verdict] = (verdicts[verdict] ?? 0) + 1;
    ++compared;
    if (lines === theirs) continue;
    ++different;
    console.log(`${history}, ${truth}:\n${lines}but voroproof-kernel:\n${theirs}`);
  }
}
console.log(`${compared} verdicts compared, ${different} differ;`, verdicts);
rmSync(folder, { recursive: true });
// A comparison of nothing is no agreement.
const kinds = new Set(Object.keys(verdicts).map((name) => name.split(" ")[1]));
process.exit(different === 0 && kinds.has("CERTIFIED") && kinds.has("REFUTED") ? 0 : 1);
