// The kernel's module without a page: the scripts that the page gives its worker, but for the worker's own.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { runInThisContext } from "node:vm";

const page = (name) => new URL(`../../apps/certifier/page/${name}`, import.meta.url);
const text = [process.env.MODULE, page("kernel.js"), page("judge.js")].map((file) => readFileSync(file, "utf8")).join("\n");
const { kernelModule, judge } = runInThisContext(`(() => {\n${text}\nreturn { kernelModule, judge };\n})()`, { filename: "kernel" });
const module = await kernelModule();

const DEFAULTS = { truth: "recorded", tolerance: "1e-6", lawTolerance: "1e-9", strict: false, unoriented: false };

export function answer(scene, history, options = {}, progress = () => {}) {
  return judge(module, scene, history, { ...DEFAULTS, ...options }, progress);
}

// [scene, history] of all histories of the corpus that are no .evtsq files.
export function corpusHistories(corpus) {
  const all = [], jsonl = (folder) => readdirSync(folder).filter((name) => name.endsWith(".jsonl")).sort();
  for (const family of readdirSync(join(corpus, "cases"), { withFileTypes: true })) {
    if (!family.isDirectory()) continue;
    for (const name of readdirSync(join(corpus, "cases", family.name)).sort()) {
      const folder = join(corpus, "cases", family.name, name), scene = join(folder, "scene.scene.json");
      if (!existsSync(scene)) continue;
      for (const history of jsonl(folder)) all.push([scene, join(folder, history)]);
      const wrong = join(folder, "wrong");
      if (existsSync(wrong)) for (const history of jsonl(wrong)) all.push([scene, join(wrong, history)]);
    }
  }
  for (const line of readFileSync(join(corpus, "cases.txt"), "utf8").split("\n")) {
    const [history, scene] = line.trim().split(/\s+/);
    if (!history || history.startsWith("#") || !history.endsWith(".jsonl")) continue;
    all.push([join(corpus, "scenes", `${scene}.scene.json`), join(corpus, history)]);
  }
  return all;
}
