// The findings of axe-core on a page as it is shown: a second judge of what accessibility.mjs asks for, by another's rules.
import { existsSync, readFileSync } from "node:fs";
import { homedir } from "node:os";
import { join } from "node:path";

// Where scripts/install-deps.sh puts it.
const script = join(process.env.XDG_CACHE_HOME || join(homedir(), ".cache"), "voroproof/axe-core-4.10.3.min.js");
export const hasAxe = existsSync(script);

// Those that axe calls serious or critical, in light and dark, wide and narrow; `prepare` is called for each after loading.
export async function axeFindings(browser, page, prepare = async () => {}) {
  const source = readFileSync(script, "utf8"), all = [];
  for (const scheme of ["light", "dark"]) {
    for (const [width, height] of [[1280, 900], [390, 844]]) {
      await browser.prefer({ "prefers-color-scheme": scheme });
      await browser.resize(width, height);
      await browser.visit(page);
      await prepare();
      await browser.evaluate(`${source}; undefined`);
      const { violations, passes } = await browser.evaluate(`axe.run().then(({ violations, passes }) => ({
        passes: passes.length,
        violations: violations.map(({ id, impact, nodes }) => [impact, id, nodes.map(({ target, failureSummary }) => [target.join(" "), failureSummary])]),
      }))`);
      if (passes === 0) all.push(`${scheme}, ${width}: axe looked at nothing`);
      for (const [impact, id, nodes] of violations) {
        if (impact !== "serious" && impact !== "critical") continue;
        for (const [target, summary] of nodes) all.push(`${scheme}, ${width}: ${impact}: ${id}: ${target}: ${summary}`);
      }
    }
  }
  return all;
}
