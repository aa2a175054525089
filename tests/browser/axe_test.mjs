// axe-core finds nothing serious in the pages that the program writes: the player and the certifier's page, in all that they show.
//
// usage: PROGRAM=... CORPUS=... node axe_test.mjs; exit code 77 where axe-core is not installed.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { axeFindings, hasAxe } from "./axe.mjs";
import { Browser } from "./browser.mjs";

if (!hasAxe) {
  console.log("axe-core is not installed: scripts/install-deps.sh browser");
  process.exit(77);
}

const { PROGRAM, CORPUS: corpus } = process.env;
const folder = mkdtempSync(join(tmpdir(), "axe-")), inside = (name) => join(folder, name);
const scene = join(corpus, "scenes/disks.scene.json"), wrong = join(corpus, "refuted/dropped-flip.history.jsonl");
let browser;

function program(...words) {
  const { status, stderr } = spawnSync(PROGRAM, words, { cwd: folder, encoding: "utf8" });
  assert.ok(status === 0 || status === 1, `${words.join(" ")}: ${stderr}`);
}

before(async () => {
  program("generate", "reference", "--n", "30", "--horizon", "50", "-o", "a.scene.json");
  program("simulate", "a.scene.json", "-o", "a.history.jsonl", "--quiet");
  program("movie", "a.scene.json", "a.history.jsonl", "-o", "player.html");
  program("certify", scene, wrong, "--report", "b.report.json");
  program("movie", scene, wrong, "--report", "b.report.json", "-o", "refuted.html");
  program("page", "-o", "certifier.html");
  browser = await Browser.open("1280,900");
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const drawn = () => browser.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");

test("axe sees what is wrong", async () => {
  writeFileSync(inside("wrong.html"), "<!DOCTYPE html><html lang=en><title>x</title><main><h1>x</h1><p style='color: #bbb; background: #fff'>pale</p><input></main>");
  const found = await axeFindings(browser, inside("wrong.html"));
  assert.equal(found.filter((line) => line.includes(": color-contrast:")).length, 4);
  assert.equal(found.filter((line) => line.includes(": label:")).length, 4);
});

test("the player: at the beginning, at an event with a disk followed, with its keys, of a refuted history", async () => {
  assert.deepEqual(await axeFindings(browser, inside("player.html"), drawn), []);
  assert.deepEqual(await axeFindings(browser, `${inside("player.html")}#event=20&follow=7`, drawn), []);
  assert.deepEqual(await axeFindings(browser, inside("player.html"), async () => {
    await drawn();
    await browser.evaluate("element('help').click()");
    await drawn();
  }), []);
  assert.deepEqual(await axeFindings(browser, inside("refuted.html"), drawn), []);
});

test("the certifier's page: empty, and with a refutation and its picture", async () => {
  assert.deepEqual(await axeFindings(browser, inside("certifier.html")), []);
  assert.deepEqual(await axeFindings(browser, inside("certifier.html"), async () => {
    for (const [role, file] of [["scene", scene], ["history", wrong]]) {
      await browser.choose(`#${role}`, [file]);
      await browser.evaluate(`new Promise((done) => {
        const look = () => (certifierPage.files.${role} ? done() : setTimeout(look, 5));
        look();
      })`);
    }
    await browser.evaluate(`new Promise((done) => {
      const look = () => (element("outcome").hidden || certifierPage.worker ? setTimeout(look, 5) : done());
      element("start").click();
      look();
    })`);
    assert.match(await browser.evaluate("element('verdict').textContent"), /refuted/i);
  }), []);
});
