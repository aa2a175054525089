// The parts of the rules that histories reach seldom: files that are no files, numbers, and an end on request.
//
// usage: CORPUS=... node rules_test.mjs
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { certify, core } from "./kernel.mjs";

const corpus = process.env.CORPUS;
const scene = readFileSync(join(corpus, "scenes/disks.scene.json"));
const history = readFileSync(join(corpus, "certified/disks.history.jsonl"));
const bytes = (text) => new TextEncoder().encode(text);
const hash = (text) => createHash("sha256").update(text).digest("hex");
const lastTwo = (lines) => lines.slice(-2);

// The value of a binary64, by its bits.
function valueOf(number) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, number);
  const bits = view.getBigUint64(0), exponent = Number((bits >> 52n) & 2047n);
  const digits = (bits & (2n ** 52n - 1n)) + (exponent > 0 ? 2n ** 52n : 0n);
  const scale = new core.Fraction(1n, 1n, 0).scaled(Math.max(1, exponent) - 1075);
  return core.Fraction.whole(bits >> 63n ? -digits : digits).times(scale);
}

// The history with the line, from 1, changed.
function withLine(line, change) {
  const lines = history.toString().split("\n");
  lines[line - 1] = change(lines[line - 1]);
  return bytes(lines.join("\n"));
}

test("a file that is not of its format is invalid, with file, line and field", () => {
  const sceneText = scene.toString();
  const cases = [
    [sceneText.replace('"radius"', '"radius": 1, "radius"'), "occurs twice"],
    [sceneText.replace('"horizon"', '"horizont"'), "is missing"],
    [sceneText.replace('"version": 1', '"version": 2').replace('"version":1', '"version":2'), "version: of version 2; this page reads version 1"],
    [`\ufeff${sceneText}`, "not JSON"],
    [sceneText.replace(/("velocity": ?\[)[^\]]*/, "$11e400, 0"), "disks[0].velocity[0]: beyond the range"],
    [sceneText.replace(/("velocity": ?\[)[^\]]*/, "$11e-400, 0"), "disks[0].velocity[0]: beyond the range"],
    [sceneText.replace(/("velocity": ?\[)[^\]]*/, '$1"1/0", 0'), "disks[0].velocity[0]: a fraction with denominator"],
    [sceneText.replace(/("velocity": ?\[)[^\]]*/, "$101, 0"), "not JSON"],
    // A row of touching disks whose abscissas were computed in binary64.
    [`{"format":"voroproof-scene","version":1,"horizon":2,"container":{"center":[0,0],"radius":3},"disks":[
      {"center":[0.1143,0],"radius":0.028575,"velocity":[0,0]},
      {"center":[0.17145,0],"radius":0.028575,"velocity":[0,0]}]}`, "the disk overlaps disk 0 by 6.93889e-18"],
  ];
  for (const [text, words] of cases) {
    assert.notEqual(text, sceneText);
    const [reason, verdict] = lastTwo(certify(bytes(text), history));
    assert.equal(verdict, "s INVALID", words);
    assert.match(reason, /^c scene:[0-9]+: /);
    assert.ok(reason.includes(words), reason);
  }
});

test("a part begins after the flips before it, which may be of no edge", () => {
  const lines = history.toString().trimEnd().split("\n"), flips = [];
  for (let k = 1; k < 9000; ++k) flips.push(`{"t":${k / 10000},"flip":[0,1,-1,-1]}`);
  const wrong = [lines[0], ...flips, lines.at(-1)].join("\n") + "\n";
  const [reason, verdict] = lastTwo(certify(scene, bytes(wrong)));
  assert.equal(verdict, "s REFUTED");
  assert.match(reason, /^c line 2: wrong quadruple: the diagram has no such edge/);
});

test("extensions are ignored where they may stand", () => {
  const extended = bytes(scene.toString().replace('"format"', '"x-a": [{"x-b": null}], "format"'));
  const claims = history.toString().replace(/[0-9a-f]{64}/, hash(extended)).replaceAll('{"t"', '{"x-k":1,"t"');
  const ours = claims.replace(/"end":\{"x-k":1,/, '"end":{');
  assert.equal(certify(extended, bytes(ours)).at(-1), "s CERTIFIED");
  assert.match(certify(extended, bytes(claims)).at(-2), /end\.x-k: an unknown field/);
  const inside = bytes(scene.toString().replace('"radius"', '"x-r": 1, "radius"'));
  assert.match(certify(inside, history).at(-2), /container\.x-r: an unknown field/);
});

test("a broken line of a history is invalid, with its field", () => {
  const cases = [
    [2, (line) => line.replace('"t":', '"t":0,"t":'), "history:2: the field 't' occurs twice"],
    [3, (line) => line.slice(0, -1), "history:3: "],
    [4, (line) => line.replace(/"t":[0-9.e-]+/, '"t":1e999'), "history:4: t: beyond the range of binary64"],
    [4, (line) => line.replace(/"t":[0-9.e-]+/, '"t":-1'), "history:4: t: the times decrease"],
    [2, (line) => `{"t":0,"maneuver":[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]}${line.slice(0, 0)}`, "nested too deeply"],
    [2, () => '{"t":0,"flip":[0,1,2,99]}', "history:2: flip[3]: an integer beyond its limits"],
    [2, () => '{"t":0,"flip":[0,1,2,3.0]}', "history:2: flip[3]: not an integer"],
    [2, () => '{"t":0,"flip":[0,1,2,3],"\\ud800":1}', "not JSON"],
  ];
  for (const [line, change, words] of cases) {
    const [reason, verdict] = lastTwo(certify(scene, withLine(line, change)));
    assert.equal(verdict, "s INVALID", reason);
    assert.ok(reason.includes(words), `${reason}, not: ${words}`);
  }
  assert.equal(certify(scene, history.subarray(0, -10)).at(-1), "s INVALID");
  assert.equal(certify(scene, new Uint8Array([...history.subarray(0, 40), 0xff])).at(-1), "s INVALID");
  assert.match(lastTwo(certify(scene, withLine(1, (line) => line.replace(/[0-9a-f]{64}/, hash("")))))[0],
    /history:1: scene_sha256: another scene's history/);
});

test("decimals become the nearest binary64, and exact strings stay exact", () => {
  const { binary64OfText, exactOfText } = core;
  for (const text of ["0.1", "1e22", "1e23", "9007199254740993", "5e-324", "2.2250738585072011e-308", "-1.5e3",
    "1.7976931348623157e308", "0.3", "123456789012345678901234567890.5", "2.4703282292062328e-324"]) {
    assert.ok(binary64OfText(text).equals(valueOf(Number(text))), text);
  }
  // Halfway between two, and a hair above: digits that Number() need not look at.
  const half = "9007199254740993";
  assert.equal(binary64OfText(`${half}.${"0".repeat(900)}`).toString(), "9007199254740992");
  assert.equal(binary64OfText(`${half}.${"0".repeat(900)}1`).toString(), "9007199254740994");
  assert.equal(binary64OfText("1.7976931348623159e308"), null);
  assert.equal(binary64OfText("2e-324"), null);
  assert.equal(binary64OfText("-0.0e5").toString(), "0");
  assert.equal(exactOfText("1/3").toString(), "1/3");
  assert.equal(exactOfText("-0x1.8p-3").toString(), "-3/16");
  assert.equal(exactOfText("007.50e-1").toString(), "3/4");
  for (const text of ["", "1/2/3", "1e401", "0x1p1201", "+1", "1.", ".5", "1/0", "nan", " 1"]) {
    assert.throws(() => exactOfText(text), core.Stop, text);
  }
});

test("divisors, roots and lengths are exact", () => {
  const { Fraction, wholeRoot, lengthAbove } = core;
  let x = 1n;
  for (let k = 1n; k < 400n; ++k) {
    x = (x * 6364136223846793005n + k) % (1n << (40n + 3n * k));
    const a = x * (2n * k + 1n) ** 20n, b = (x + 1n) * (2n * k + 1n) ** 20n;
    const euclid = (u, v) => (v === 0n ? u : euclid(v, u % v));
    const [n, d] = Fraction.ratio(a, b).terms;
    assert.equal(a / n, euclid(a, b));
    assert.equal(n * b, d * a);
    const root = wholeRoot(a);
    assert.ok(root * root <= a && a < (root + 1n) ** 2n);
  }
  const above = lengthAbove([Fraction.whole(3), Fraction.whole(4)]).minus(Fraction.whole(5));
  assert.ok(above.sign > 0 && above.less(new Fraction(5n, 1n, 60)));
});

test("common divisors of forms are found, also beyond what a prime shows", () => {
  const { Form } = core, product = (...forms) => forms.reduce((p, q) => Form.product(p, q));
  const one = [-1n, 3n], other = [7n, -2n, 5n], third = [-67108859n, 1n];
  assert.deepEqual(Form.common(one, other).length, 1);
  assert.equal(Form.common(product(one, other), product(one, third)).length, 2);
  assert.equal(Form.common(product(other, third), product(third, one)).length, 2);
  assert.equal(Form.squarefree(product(one, one, one, other)).length, 4);
  assert.equal(Form.variations(Form.squarefree(product(one, one, third, third))), 2);
  // Zeros at the ends are roots at the ends of the interval, and dropped.
  assert.equal(Form.squarefree([0n, 0n, -1n, 3n, 0n]).length, 2);
  const [left, right] = Form.halves([-1n, 0n, 0n, 8n]);
  assert.equal(Form.variations(left) + Form.variations(right), 1);
});

test("hashes are those of SHA-256", () => {
  for (const length of [0, 1, 55, 56, 63, 64, 65, 1000]) {
    const data = Uint8Array.from({ length }, (_, k) => (k * 37) % 251);
    assert.equal(core.sha256(data), hash(data));
  }
});

test("a certification that is ended is undecided, wherever it is", () => {
  let asked = 0;
  assert.equal(certify(scene, history, {}, () => (++asked, true)).at(-1), "s CERTIFIED");
  assert.ok(asked > 10);
  for (let end = 1; end <= asked; ++end) {
    let k = 0;
    const lines = certify(scene, history, {}, () => ++k < end);
    assert.equal(lines.at(-1), "s UNDECIDED");
    assert.match(lines.at(-2), /ended on request/);
  }
});

test("what a verdict is about is said of the options that were judged, whatever it is", () => {
  const about = (text, options) => new core.Certification(options, () => true).run(scene, text).about;
  const horizon = JSON.parse(history.toString().split("\n")[0]).horizon;
  assert.equal(about(history, { truth: "recorded", tolerance: "1/3", strict: true }),
    `all events, recorded truth, up to t = ${horizon}, times within 1/3, velocities within 1e-9, strict`);
  const longer = bytes(history.toString().replace(/("horizon"|"end":{"t"):[0-9.]+/g, "$1:1e3"));
  assert.equal(about(longer, { truth: "exact" }), `all events, exact truth, up to t = 1000, times within 1e-6, `
    + `velocities within 1e-9, horizon 1000 of the scene's ${horizon}`);
  assert.equal(about(bytes("{}"), { truth: "exact" }), "");
});

test("options are those of the kernel", () => {
  const without = readFileSync(join(corpus, "certified/disks-quadruplets-not-oriented.history.jsonl"));
  assert.equal(certify(scene, without).at(-1), "s REFUTED");
  assert.equal(certify(scene, without, { unoriented: true }).at(-1), "s CERTIFIED");
  for (const options of [{ tolerance: "0" }, { tolerance: "1e9" }, { lawTolerance: "2" }, { tolerance: "x" }]) {
    assert.equal(certify(scene, history, options).at(-1), "s INVALID");
  }
});

test("a fault is drawn with its generators and the circles of its edge", () => {
  const dropped = readFileSync(join(corpus, "refuted/dropped-flip.history.jsonl"));
  const certification = new core.Certification({}, () => true), result = certification.run(scene, dropped);
  const drawing = core.drawingOf(certification.problem, result.witness);
  assert.equal(drawing.named.length, 4);
  assert.equal(drawing.circles.length, 2);
  // At the collapse the two circles are one.
  const [a, b] = drawing.circles;
  assert.ok(Math.hypot(a.x - b.x, a.y - b.y, a.radius - b.radius) < 1e-6 * a.radius);
  for (const g of drawing.named) {
    const { x, y, r } = drawing.generators[g + 1];
    const gap = Math.abs(Math.hypot(a.x - x, a.y - y) - Math.abs(r + a.radius));
    assert.ok(gap < 1e-6 * a.radius, `${g}: ${gap}`);
  }
  const certified = new core.Certification({}, () => true);
  assert.equal(core.drawingOf(certified.problem, certified.run(scene, history).witness), null);
});
