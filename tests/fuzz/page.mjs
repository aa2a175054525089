// Changed pairs of files for the certifier's page: each ends in a verdict, and in the kernel's own.
//
// usage: node page.mjs KERNEL FOLDER     FOLDER/0.scene.json, FOLDER/0.history.jsonl and so on
//
// Both follow the same rules, so that a verdict of one that the other does not share is a find, and so is
// whatever the page throws. Prints how many ended how, and for each find the pair; exit code 1 where there is one.
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { certify } from "../certifier/kernel.mjs";

const [kernel, folder] = process.argv.slice(2);
const VERDICT = /^s (CERTIFIED|REFUTED|UNDECIDED|INVALID)$/;
const verdicts = {};
let finds = 0;

function pageSays(scene, history, truth) {
  try {
    const lines = certify(readFileSync(scene), readFileSync(history), { truth });
    const printable = lines.every((line) => !/[\u0000-\u001f\u007f-\u009f]/.test(line));
    return printable ? lines.at(-1) : `a line that is not printable: ${JSON.stringify(lines)}`;
  } catch (error) {
    return `throws ${error.stack}`;
  }
}

function kernelSays(scene, history, truth) {
  const { stdout, status } = spawnSync(kernel, [scene, history, "--truth", truth], { encoding: "utf8" });
  return `${stdout.trimEnd().split("\n").at(-1)}${status > 3 || status === null ? ` and exit code ${status}` : ""}`;
}

let k = 0;
for (; existsSync(join(folder, `${k}.scene.json`)); ++k) {
  const scene = join(folder, `${k}.scene.json`), history = join(folder, `${k}.history.jsonl`);
  const truth = k % 2 === 0 ? "recorded" : "exact";
  const ours = pageSays(scene, history, truth), theirs = kernelSays(scene, history, truth);
  verdicts[ours.slice(2)] = (verdicts[ours.slice(2)] ?? 0) + 1;
  if (VERDICT.test(ours) && ours === theirs) continue;
  ++finds;
  console.log(`find: ${k}, ${truth} truth: the page ${ours}, the kernel ${theirs}`);
}
console.log(`page           ${k} runs`, verdicts);
process.exit(k > 0 && finds === 0 ? 0 : 1);
