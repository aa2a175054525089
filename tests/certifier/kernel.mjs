// The rules of the certifier's page without a page: the scripts that it gives its worker, but for the worker's own.
import { readFileSync, readdirSync, existsSync } from "node:fs";
import { join } from "node:path";
import { runInThisContext } from "node:vm";

const pageFolder = new URL("../../apps/certifier/page/", import.meta.url);
const page = readFileSync(new URL("page.html", pageFolder), "utf8");
const template = /<template id="core">([^]*?)<\/template>/.exec(page)[1];
const scripts = [...template.matchAll(/src="([^"]+)"/g)].map(([, name]) => name).filter((name) => name !== "worker.js");
const text = scripts.map((name) => readFileSync(new URL(name, pageFolder), "utf8")).join("\n");
const names = "Certification, linesOf, drawingOf, Fraction, Form, JsonReader, Stop, sha256, nearestBinary64, "
  + "binary64OfText, exactOfText, wholeRoot, lengthAbove";
export const core = runInThisContext(`(() => {\n${text}\nreturn { ${names} };\n})()`, { filename: "certifier" });

// The lines that the page and voroproof-kernel end with; `progress` as in Certification.
export function certify(scene, history, options = {}, progress = () => true) {
  return core.linesOf(new core.Certification(options, progress).run(scene, history));
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
