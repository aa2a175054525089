// The certifier's page in a browser: what is dropped on it is judged as voroproof-kernel does, the work can be ended,
// and all can use it.
//
// usage: MODULE=... PROGRAM=... KERNEL=... CORPUS=... node page_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { accessibilityFaults } from "../browser/accessibility.mjs";
import { Browser } from "../browser/browser.mjs";
import { corpusHistories } from "./kernel.mjs";

const { PROGRAM: program, KERNEL: kernel, CORPUS: corpus } = process.env;
const folder = mkdtempSync(join(tmpdir(), "certifier-")), page = join(folder, "certifier.html");
const scene = join(corpus, "scenes/disks.scene.json"), right = join(corpus, "certified/disks.history.jsonl");
let browser;

before(async () => {
  assert.equal(spawnSync(program, ["page", "-o", page]).status, 0);
  browser = await Browser.open("1280,900");
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const outcome = `new Promise((done) => {
  const look = () => element("outcome").hidden || certifierPage.worker ? setTimeout(look, 5) : done(
    { lines: element("lines").textContent, verdict: element("verdict").textContent, meaning: element("meaning").textContent });
  look();
})`;

async function given(files) {
  for (const [role, file] of Object.entries(files)) {
    await browser.evaluate(`certifierPage.files.${role} = null`);
    await browser.choose(`#${role}`, [file]);
    await browser.evaluate(`new Promise((done) => {
      const look = () => (certifierPage.files.${role} ? done() : setTimeout(look, 5));
      look();
    })`);
  }
}

async function judged(sceneFile, historyFile, truth = "recorded") {
  await given({ scene: sceneFile, history: historyFile });
  await browser.evaluate(`document.querySelector("input[value=${truth}]").click(); element("start").click()`);
  return browser.evaluate(outcome);
}

// Every ninth of the corpus: the module is compared with all of it elsewhere.
test("histories of the corpus get the kernel's last lines", async () => {
  await browser.visit(page);
  const histories = corpusHistories(corpus).filter((_, k) => k % 9 === 0), verdicts = new Set();
  assert.ok(histories.length > 60);
  for (const [k, [sceneFile, history]] of histories.entries()) {
    const truth = k % 2 === 0 ? "recorded" : "exact";
    const { lines, verdict } = await judged(sceneFile, history, truth);
    verdicts.add(verdict);
    assert.equal(lines, spawnSync(kernel, [sceneFile, history, "--truth", truth], { encoding: "utf8" }).stdout, history);
  }
  for (const verdict of ["certified", "refuted", "undecided"]) assert.ok(verdicts.has(verdict), verdict);
  assert.deepEqual(browser.errors, []);
});

test("both files are dropped at once, also packed, and find their places", async () => {
  await browser.visit(page);
  const packed = gzipSync(readFileSync(right)).toString("base64"), plain = readFileSync(scene).toString("base64");
  await browser.evaluate(`(async () => {
    const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), transfer = new DataTransfer();
    transfer.items.add(new File([bytes("${packed}")], "b.jsonl.gz"));
    transfer.items.add(new File([bytes("${plain}")], "a.json"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    while (element("start").disabled) await new Promise((done) => setTimeout(done, 5));
    element("start").click();
  })()`);
  const { verdict, lines } = await browser.evaluate(outcome);
  assert.equal(verdict, "certified");
  assert.match(lines, /s CERTIFIED\n$/);
  assert.equal(await browser.evaluate("element('picture-box').hidden"), true);
});

test("a refuted history shows its line, and the fault in a picture", async () => {
  await browser.visit(page);
  const { meaning } = await judged(scene, join(corpus, "refuted/dropped-flip.history.jsonl"));
  assert.match(meaning, /^line 4: edge \[1,3,0,6\] collapses/);
  assert.equal(await browser.evaluate("document.querySelectorAll('#picture .disk.named').length"), 4);
  // When an edge collapses, the circles of its ends are one.
  const circles = await browser.evaluate(`[...document.querySelectorAll("#picture .tangent")].map((one) =>
    ["cx", "cy", "r"].map((name) => Number(one.getAttribute(name))))`);
  assert.equal(circles.length, 2);
  assert.ok(circles[0].every((x, k) => Math.abs(x - circles[1][k]) < 1e-3), `${circles}`);
  assert.match(await browser.evaluate("element('picture').getAttribute('aria-label')"), /disk 1, disk 3, disk 0 and disk 6/);
  assert.match(await browser.evaluate("element('claim').textContent"), /^\{"t":1.95/);
  const radius = "Number(document.querySelector('#picture .disk.named').getAttribute('r'))";
  const near = await browser.evaluate(radius);
  await browser.evaluate("element('whole').click()");
  assert.ok(await browser.evaluate(radius) < near);
});

test("a broken file is invalid, with line and reason", async () => {
  await browser.visit(page);
  const broken = join(folder, "broken.jsonl");
  writeFileSync(broken, readFileSync(right, "utf8").replace('\n{"t":', '\n{"t":0,"t":'));
  const { verdict, meaning } = await judged(scene, broken);
  assert.equal(verdict, "invalid");
  assert.equal(meaning, "line 2: a field occurs twice.");
});

test("a kernel that ends by itself gives no verdict", async () => {
  await browser.visit(page);
  await browser.evaluate("element('core').content.querySelector('script').textContent += 'JSON.parse = () => { throw new Error(`broken`); };'");
  const { verdict, lines } = await judged(scene, right);
  assert.equal(verdict, "failed");
  assert.equal(lines, "c broken");
});

test("the work can be ended, by hand and by a limit of time, and is then undecided", async () => {
  await browser.visit(page);
  const long = join(corpus, "cases/cocircular-instant/points-64");
  await given({ scene: join(long, "scene.scene.json"), history: join(long, "exact.history.jsonl") });
  await browser.evaluate("element('start').click()");
  assert.equal(await browser.evaluate("document.activeElement.id"), "cancel");
  await browser.evaluate("window.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }))");
  assert.equal((await browser.evaluate(outcome)).lines, "c ended on request\ns UNDECIDED");
  await browser.evaluate("element('seconds').value = '0.001'; element('start').click()");
  const { lines, verdict } = await browser.evaluate(outcome);
  assert.equal(verdict, "undecided");
  assert.match(lines, /limit of time/);
});

test("all can use it: names, contrast, targets, narrow and dark", async () => {
  const results = async () => {
    await browser.evaluate("document.querySelectorAll('details').forEach((one) => { one.open = true; })");
    await judged(scene, join(corpus, "refuted/dropped-flip.history.jsonl"));
  };
  assert.deepEqual(await accessibilityFaults(browser, page), []);
  assert.deepEqual(await accessibilityFaults(browser, page, results), []);
});
