// Changed pairs of files for the page's module: each ends in a verdict, and all that is said is what voroproof-kernel says.
//
// usage: MODULE=... node page.mjs KERNEL FOLDER     FOLDER/0.scene.json, FOLDER/0.history.jsonl and so on
//
// Prints how many ended how, and for each that is not so the pair; exit code 1 where there is one.
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { answer } from "../certifier/kernel.mjs";

const [kernel, folder] = process.argv.slice(2);
const VERDICT = /^s (CERTIFIED|REFUTED|UNDECIDED|INVALID)$/;
const verdicts = {};
let finds = 0;

function pageSays(scene, history, truth) {
  try {
    const { lines } = answer(readFileSync(scene), readFileSync(history), { truth });
    const printable = !/[\u0000-\u0009\u000b-\u001f\u007f-\u009f]/.test(lines);
    return printable ? lines : `a line that is not printable: ${JSON.stringify(lines)}`;
  } catch (error) {
    return `throws ${error.stack}`;
  }
}

function kernelSays(scene, history, truth) {
  return spawnSync(kernel, [scene, history, "--truth", truth], { encoding: "utf8" }).stdout;
}

let k = 0;
for (; existsSync(join(folder, `${k}.scene.json`)); ++k) {
  const scene = join(folder, `${k}.scene.json`), history = join(folder, `${k}.history.jsonl`);
  const truth = k % 2 === 0 ? "recorded" : "exact";
  const ours = pageSays(scene, history, truth), theirs = kernelSays(scene, history, truth);
  const verdict = ours.trimEnd().split("\n").at(-1);
  verdicts[verdict.slice(2)] = (verdicts[verdict.slice(2)] ?? 0) + 1;
  if (VERDICT.test(verdict) && ours === theirs) continue;
  ++finds;
  console.log(`find: ${k}, ${truth} truth: the page ${ours}, the kernel ${theirs}`);
}
console.log(`page           ${k} runs`, verdicts);
process.exit(k > 0 && finds === 0 ? 0 : 1);
