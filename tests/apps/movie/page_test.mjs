// The movie's page as people use it: by keys, with little motion, in light and dark; and what it saves.
//
// usage: PROGRAM=... CORPUS=... node page_test.mjs
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { accessibilityFaults } from "../../browser/accessibility.mjs";
import { Browser } from "../../browser/browser.mjs";

const { PROGRAM, CORPUS: corpus } = process.env;
const folder = mkdtempSync(join(tmpdir(), "movie-")), page = join(folder, "movie.html"), refuted = join(folder, "refuted.html");
let browser;

function program(...words) {
  const { status, stderr } = spawnSync(PROGRAM, words, { cwd: folder, encoding: "utf8" });
  assert.ok(status === 0 || status === 1, `${words.join(" ")}: ${stderr}`);
}

before(async () => {
  program("generate", "reference", "--n", "30", "--horizon", "50", "-o", "a.scene.json");
  program("simulate", "a.scene.json", "-o", "a.history.jsonl", "--quiet");
  program("certify", "a.scene.json", "a.history.jsonl", "--report", "a.report.json");
  program("movie", "a.scene.json", "a.history.jsonl", "--report", "a.report.json", "-o", page);
  const wrong = [join(corpus, "scenes/disks.scene.json"), join(corpus, "refuted/dropped-flip.history.jsonl")];
  program("certify", ...wrong, "--report", "b.report.json");
  program("movie", ...wrong, "--report", "b.report.json", "-o", refuted);
  browser = await Browser.open("1280,900");
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const frames = (count) => `new Promise((done) => {
  const next = (k) => (k === 0 ? done() : requestAnimationFrame(() => next(k - 1)));
  next(${count});
})`;
const press = (key, target = "window") =>
  browser.evaluate(`${target}.dispatchEvent(new KeyboardEvent("keydown", { key: ${JSON.stringify(key)}, bubbles: true, cancelable: true }))`);
const state = (name) => browser.evaluate(`player.state.${name}`);

test("all can use it: names, contrast, targets, narrow and dark", async () => {
  const wait = () => browser.evaluate(frames(2));
  assert.deepEqual(await accessibilityFaults(browser, `${page}#event=20&follow=7`, wait), []);
  assert.deepEqual(await accessibilityFaults(browser, refuted, wait), []);
  assert.equal(await browser.evaluate("element('verdict').textContent"), "refuted");
  await browser.resize(1280, 900);
  assert.deepEqual(browser.errors, []);
});

test("the list of events is filled when the page opens", async () => {
  await browser.visit(page);
  await browser.evaluate(frames(2));
  assert.ok(await browser.evaluate("document.querySelectorAll('#events .row').length") > 8);
  assert.equal(await browser.evaluate("document.querySelector('#events .row').getAttribute('aria-selected')"), "false");
});

test("list, time line and disks are moved through by keys", async () => {
  await browser.visit(page);
  await browser.evaluate(frames(2));
  const list = "element('events')";
  await press("ArrowDown", list);
  await press("ArrowDown", list);
  await browser.evaluate(frames(2));
  assert.equal(await state("selected"), 1);
  assert.equal(await browser.evaluate(`${list}.getAttribute("aria-activedescendant")`), "event-1");
  await press("ArrowUp", list);
  assert.equal(await state("selected"), 0);
  // List the collisions alone.
  await browser.evaluate("element('filter').value = 'collisions'; element('filter').dispatchEvent(new Event('change'))");
  await press("ArrowDown", list);
  const collisions = await browser.evaluate("Array.from(player.data.kinds).flatMap((kind, k) => (kind === COLLISION ? [k] : []))");
  const first = collisions.findIndex((k) => k > 0);
  assert.equal(await state("selected"), collisions[first]);
  await press("ArrowDown", list);
  assert.equal(await state("selected"), collisions[first + 1]);
  await press("ArrowUp", list);
  assert.equal(await state("selected"), collisions[first]);
  await press("Home");
  await browser.evaluate(frames(2));
  await press("PageUp", "element('timeline')");
  assert.ok(Math.abs(await state("t") - 5) < 1e-9);
  await browser.evaluate(frames(2));
  assert.match(await browser.evaluate("element('timeline').getAttribute('aria-valuetext')"), /^t = 5 of 50$/);
  await press("n");
  await press("n");
  assert.equal(await state("follow"), 1);
  await press("b");
  assert.equal(await state("follow"), 0);
  await press("z");
  assert.ok(await browser.evaluate("player.view.zoom") > 1.4);
  // A button that has the focus takes its own keys.
  await press(" ", "element('help')");
  assert.equal(await state("playing"), false);
  await press(" ");
  assert.equal(await state("playing"), true);
});

test("the plot of a disk has its gaps and its neighbours", async () => {
  await browser.visit(`${page}#t=10&follow=3`);
  await browser.evaluate(frames(2));
  const { samples, applied, standing, here, count } = await browser.evaluate(`(() => {
    const { plot, replay, motion, data } = player, at = 120, { t } = plot.samples[at];
    const applied = replay.applied, standing = player.state.applied;
    motion.moveTo(t);
    replay.moveTo(data.happened(t));
    const around = new Set(replay.diagram.neighbours(4)), unit = data.frame.radius;
    const far = (o) => Math.hypot(motion.x[4] - motion.x[o], motion.y[4] - motion.y[o]) * unit;
    const r = (o) => motion.radius[o] * unit;
    return { applied, standing, count: around.size, samples: plot.samples.map(({ t, gaps }) => ({ t, least: Math.min(...gaps), count: gaps.length })),
      here: { at, least: Math.min(...Array.from(around, (o) => (o === 0 ? unit - r(4) - far(0) : far(o) - r(4) - r(o)))) } };
  })()`);
  assert.equal(samples.length, 241);
  assert.equal(applied, standing);
  assert.equal(samples[240].t, 50);
  assert.ok(Math.abs(samples[here.at].least - here.least) < 1e-9);
  assert.equal(samples[here.at].count, count);
  assert.ok(samples.every(({ least }) => least > -1e-6));
  assert.match(await browser.evaluate("element('plot').getAttribute('aria-label')"), /least of all, .* at t = /);
  await browser.evaluate("element('plot').dispatchEvent(new PointerEvent('pointerdown', { bubbles: true, clientX: element('plot').getBoundingClientRect().right }))");
  assert.equal(await state("t"), 50);
});

test("with little motion there are no flashes, and playing goes in steps", async () => {
  await browser.prefer({ "prefers-reduced-motion": "reduce" });
  await browser.visit(page);
  const steps = await browser.evaluate(`(() => {
    player.play(true);
    const times = new Set();
    for (let k = 0; k <= 30; ++k) {
      player.tick(1e7 + 50 * k);
      times.add(player.state.t);
    }
    player.play(false);
    return [player.state.isStill, times.size];
  })()`);
  await browser.prefer({ "prefers-reduced-motion": "no-preference" });
  assert.equal(steps[0], true);
  assert.ok(steps[1] >= 3 && steps[1] <= 5, `${steps[1]} pictures in a second and a half`);
});

test("the picture is saved as PNG, and a film as WebM", async () => {
  await browser.visit(`${page}#t=10`);
  await browser.evaluate(frames(2));
  const picture = await browser.evaluate(`player.exporter.picture().then((blob) => createImageBitmap(blob)
    .then(({ width, height }) => ({ type: blob.type, width, height })))`);
  const size = await browser.evaluate("[element('picture').width & ~1, element('picture').height & ~1]");
  assert.deepEqual(picture, { type: "image/png", width: size[0], height: size[1] });
  const filmOf = (count) => browser.evaluate(`(async () => {
    const saved = [];
    Exporter.save = (blob, name) => saved.push([name, blob]);
    const done = player.saveFilm();
    await ${frames(count)};
    const during = [element("save-film").textContent, player.state.playing];
    player.saveFilm();
    await done;
    const [[name, blob]] = saved, start = new Uint8Array(await blob.slice(0, 4).arrayBuffer());
    return { name, during, size: blob.size, start: Array.from(start), label: element("save-film").textContent };
  })()`);
  // The browser encodes beside the page: on a busy machine it may not have come to any frame.
  let film = await filmOf(20);
  for (let count = 80; film.size <= 2000 && count <= 1280; count *= 4) film = await filmOf(count);
  assert.deepEqual(film.during, ["Stop", true]);
  assert.equal(film.name, "voroproof.webm");
  assert.equal(film.label, "Film");
  assert.deepEqual(film.start, [0x1a, 0x45, 0xdf, 0xa3]);  // EBML, as WebM begins
  assert.ok(film.size > 2000, `${film.size} bytes`);
  assert.deepEqual(browser.errors, []);
});
