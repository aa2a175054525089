// SPDX-License-Identifier: CC0-1.0
//
// Reads the truth set (../README.md), asks an engine its questions, counts the wrong answers.
//
//     node voroproof_truth.mjs [--tolerance X] [--json] FILE...
//
// FILE is text or .gz, - the standard input. In a page, where nothing of Node is loaded:
//
//     const reader = new Reader();
//     const score = new Score(engine);
//     for (const line of text.replace(/\n$/, "").split("\n")) score.ask(reader, reader.read(line));
//     table = asText(score);
//
// An engine has a name and any of these methods, which return null where they are undecided:
//
//     incircle(g), exists(g)      a sign
//     contact(g)                  { kind: "none" | "graze" | "hit", time }
//     collapse(g, t0, t1)         { s0, zeros: [{ time, sign }] }
//     rootorder(question)         a sign
//     static(frame, disks)        { pairs: [[a, b]], hidden: [id] }; the frame: null or a container
//
// A malformed line throws an Error with its number.

export const SETS = ["incircle", "exists", "contact", "collapse", "rootorder", "static"];
const COLUMNS = ["queries", "wrong_sign", "wrong_none", "wrong_some", "wrong_time", "undecided"];
const MANY = 4096;
const MOST_ZEROS = 32;
const LONGEST_LINE = 1 << 24;

const NUMBER = /^(-?)0x([0-9a-f])(?:\.([0-9a-f]{1,13}))?p([+-]?[0-9]{1,4})$/;

// -0x1.8p+1, as printf's %a writes it; NaN for anything else.
export function number(text) {
  const parts = NUMBER.exec(text);
  if (!parts) return NaN;
  const places = parts[3] ? parts[3].length : 0;
  let power = Number(parts[4]) - 4 * places;
  let value = parseInt(parts[2] + (parts[3] ?? ""), 16);
  // In steps, so that no power of two is too large or too small to be a number.
  for (; power < -1000 && value !== 0; power += 1000) value *= 2 ** -1000;
  for (; power > 970 && value !== 0; power -= 970) value *= 2 ** 970;
  value = value === 0 ? 0 : value * 2 ** power;
  return value === Infinity ? NaN : parts[1] ? -value : value;
}

// The fields of a line, from left to right.
class Fields {
  constructor(text, line) {
    this.fields = text.split(" ");
    this.line = line;
    this.at = 0;
  }
  next() {
    return this.fields[this.at++] ?? "";
  }
  fail(expected) {
    throw new Error(`line ${this.line}, field ${this.at}: expected ${expected}`);
  }
  word(words) {
    const word = this.next();
    return words.includes(word) ? word : this.fail(words.join(" "));
  }
  name() {
    const name = this.next();
    return /^[A-Za-z0-9_.+-]{1,63}$/.test(name) ? name : this.fail("a name");
  }
  integer(low, high, expected) {
    const text = this.next();
    const value = /^-?[0-9]{1,9}$/.test(text) ? Number(text) : NaN;
    return value >= low && value <= high ? value : this.fail(expected);
  }
  number() {
    const value = number(this.next());
    return value === value ? value : this.fail("a hexadecimal float");
  }
  end() {
    if (this.at++ < this.fields.length) this.fail("the end of the line");
  }
  times() {
    const times = [this.number(), this.number()];
    return times[0] <= times[1] ? times : this.fail("times in their order");
  }
  window() {
    const times = this.times();
    return times[0] < times[1] ? times : this.fail("a window that is not empty");
  }
  generator(letter, moving) {
    const g = { letter, x: this.number(), y: this.number(), r: this.number(), vx: 0, vy: 0, vr: 0 };
    if (letter !== "w" && !(g.r >= 0)) this.fail("a radius >= 0");
    if (letter === "w" && (g.x * g.y !== 0 || Math.abs(g.x + g.y) !== 1)) {
      this.fail("a wall along an axis");
    }
    if (!moving) return g;
    [g.vx, g.vy, g.vr] = [this.number(), this.number(), this.number()];
    if (letter !== "d" && (g.vx !== 0 || g.vy !== 0 || g.vr !== 0)) this.fail("rates of 0");
    return g;
  }
  // `circle`: the first three have a circle, so that one of them is a disk.
  generators(n, moving, circle) {
    const g = [];
    while (g.length < n) g.push(this.generator(this.word(["d", "c", "w"]), moving));
    const containers = g.filter((one) => one.letter === "c").length;
    if (containers > 1 || (containers && g.some((one) => one.letter === "w"))) {
      this.fail("one container and no walls");
    }
    if (circle && !g.slice(0, 3).some((one) => one.letter === "d")) {
      this.fail("a disk among the first three");
    }
    return g;
  }
}

const REST = {
  incircle(f) {
    const truth = f.integer(-1, 1, "a sign");
    return { truth, question: [f.generators(4, false, true)] };
  },
  exists(f) {
    const truth = f.integer(-1, 1, "a sign");
    return { truth, question: [f.generators(3, false, true)] };
  },
  contact(f) {
    const kind = f.word(["none", "graze", "hit"]);
    const [lo, hi] = kind === "none" ? [f.word(["-"]), f.word(["-"])] : f.times();
    return { truth: { kind, lo, hi }, question: [f.generators(2, true, false)] };
  },
  collapse(f) {
    const s0 = f.integer(-1, 1, "a sign");
    if (s0 === 0) f.fail("1 or -1");
    const zeros = [];
    let sign = s0;
    for (let n = f.integer(0, MOST_ZEROS, "a number of zeros"); n > 0; --n) {
      const [lo, hi] = f.times();
      const order = f.integer(1, 99, "an order");
      if (order % 2) sign = -sign;
      zeros.push({ lo, hi, order, sign: f.integer(sign, sign, "another sign, for this order") });
    }
    const window = f.window();
    return { truth: { s0, zeros }, question: [f.generators(4, true, true), ...window] };
  },
  rootorder(f) {
    const truth = f.integer(-1, 1, "a sign");
    const windows = [], ids = [[], []];
    for (let i = 0; i < 2; ++i) {
      windows.push(f.window());
      while (ids[i].length < 4) ids[i].push(f.integer(0, MANY - 1, "the number of a generator"));
    }
    const n = f.integer(Math.max(...ids[0], ...ids[1]) + 1, MANY, "more generators");
    return { truth, question: [{ windows, ids, g: f.generators(n, true, false) }] };
  },
  static(f) {
    const frame = f.word(["p", "c"]) === "c" ? f.generator("c", false) : null;
    const disks = [], pairs = [], hidden = [];
    const n = f.integer(0, MANY, "a number of disks");
    while (disks.length < n) disks.push(f.generator("d", false));
    let last = -1;
    for (let e = f.integer(0, (n * (n + 1)) / 2, "a number of pairs"); e > 0; --e) {
      const a = f.integer(frame ? -1 : 0, n - 1, "an id");
      const b = f.integer(a + 1, n - 1, "a larger id");
      const place = (a + 1) * MANY + b;
      if (place <= last) f.fail("pairs in their order");
      last = place;
      pairs.push([a, b]);
    }
    for (let h = f.integer(0, n, "a number of hidden disks"); h > 0; --h) {
      hidden.push(f.integer(0, n - 1, "an id"));
    }
    return { truth: { pairs, hidden }, question: [frame, disks] };
  },
};

// Takes one line after the other, without its end. A record has name, bits, proof,
// question (the arguments of the engine's method) and truth.
export class Reader {
  line = 0;
  set = null;
  version = null;

  // A record, or null for a comment.
  read(text) {
    ++this.line;
    if (text.length > LONGEST_LINE) throw new Error(`line ${this.line}: the line is too long`);
    if (text.includes("\0")) throw new Error(`line ${this.line}: a byte is zero`);
    const f = new Fields(text.replace(/\r$/, ""), this.line);
    if (this.set === null) {
      f.word(["#"]);
      f.word(["voroproof-truth"]);
      this.set = f.word(SETS);
      this.version = f.name();
      f.end();
      return null;
    }
    if (text.startsWith("#")) return null;
    const record = { name: f.name(), bits: f.integer(0, 99999999, "a number of bits") };
    record.proof = f.word(["interval", "exact"]);
    Object.assign(record, REST[this.set](f));
    f.end();
    return record;
  }
}

// ---- Scoring ----

const fewer = (has, had) => (has < had ? "wrong_none" : "wrong_some");
const without = (items, others) => items.some((item) => !others.includes(item));

// The column in which an answer counts: the first one that fits, of undecided, none or some (the
// answer has less or more of what there is), sign, time. null where it is right.
function verdict(set, truth, answer, tolerance) {
  if (answer === null) return "undecided";
  if (set === "exists" && answer > 0 !== truth > 0) return fewer(answer > 0, truth > 0);
  if (set === "incircle" || set === "exists" || set === "rootorder") {
    return answer === truth ? null : "wrong_sign";
  }
  if (set === "static") {
    const right = truth.pairs.map(String), pairs = answer.pairs.map(String);
    if (without(right, pairs) || without(truth.hidden, answer.hidden)) return "wrong_none";
    return without(pairs, right) || without(answer.hidden, truth.hidden) ? "wrong_some" : null;
  }
  const contact = set === "contact";
  const listed = (one) => (contact ? (one.kind === "none" ? [] : [one]) : one.zeros);
  const found = listed(answer), zeros = listed(truth);
  if (found.length !== zeros.length) return fewer(found.length, zeros.length);
  if (contact ? answer.kind !== truth.kind : answer.s0 !== truth.s0) return "wrong_sign";
  if (zeros.some((zero, i) => !contact && zero.sign !== found[i].sign)) return "wrong_sign";
  const late = zeros.some(({ lo, hi }, i) => {
    const time = found[i].time, reach = tolerance * (1 + Math.abs(time));
    return !(lo - reach <= time && time <= hi + reach);
  });
  return late ? "wrong_time" : null;
}

export class Score {
  classes = new Map();

  constructor(engine, tolerance = 1e-9) {
    this.engine = engine;
    this.tolerance = tolerance;
  }
  // Asks the engine for what the reader has read.
  ask(reader, record) {
    this.set = reader.set;
    this.version = reader.version;
    if (record === null) return;
    if (!this.engine[this.set]) {
      throw new Error(`line ${reader.line}: the engine has no answers to this set`);
    }
    const begin = performance.now();
    const answer = this.engine[this.set](...record.question);
    const end = performance.now();
    let of = this.classes.get(record.name);
    if (!of) {
      of = Object.fromEntries([...COLUMNS, "nanoseconds"].map((key) => [key, 0]));
      this.classes.set(record.name, of);
    }
    ++of.queries;
    of.nanoseconds += (end - begin) * 1e6;
    const column = verdict(this.set, record.truth, answer, this.tolerance);
    if (column) ++of[column];
  }
}

// As printf's %g writes it, of six digits, for what is small.
const short = (x) => {
  if (x === 0 || x >= 1e-4) return String(Number(x.toPrecision(6)));
  return x.toExponential(5).replace(/\.?0*e/, "e").replace(/e-(\d)$/, (_, digit) => `e-0${digit}`);
};

export function asText(score) {
  const all = Object.fromEntries([...COLUMNS, "nanoseconds"].map((key) => [key, 0]));
  for (const of of score.classes.values()) for (const key in all) all[key] += of[key];
  const width = Math.max(5, ...[...score.classes.keys()].map((name) => name.length));
  const row = (name, fields) => {
    return name.padEnd(width) + fields.map((f) => " " + String(f).padStart(10)).join("") + "\n";
  };
  let text = `${score.set} ${score.version}, engine ${score.engine.name}, `;
  text += `tolerance ${short(score.tolerance)}\n`;
  text += row("class", [...COLUMNS, "ns/query"]);
  for (const [name, of] of [...score.classes, ["all", all]]) {
    const time = (of.nanoseconds / (of.queries || 1)).toFixed(0);
    text += row(name, [...COLUMNS.map((key) => of[key]), time]);
  }
  return text;
}

export function asJson(score) {
  const classes = [...score.classes].map(([name, of]) => {
    return JSON.stringify({ class: name, ...of, nanoseconds: Math.round(of.nanoseconds) });
  });
  const head = { format: "voroproof-truth-score", version: 1, set: score.set };
  Object.assign(head, { set_version: score.version, engine: score.engine.name });
  const start = JSON.stringify(head).slice(0, -1);
  return `${start},"tolerance":${short(score.tolerance)},"classes":[${classes.join(",")}]}\n`;
}

// ---- Node ----

async function* linesOf(name) {
  const { createReadStream } = await import("node:fs");
  const { createGunzip } = await import("node:zlib");
  const { pipeline } = await import("node:stream");
  let stream = name === "-" ? process.stdin : createReadStream(name);
  if (name.endsWith(".gz")) stream = pipeline(stream, createGunzip(), () => {});
  stream.setEncoding("latin1");
  let rest = "";
  for await (const chunk of stream) {
    const lines = (rest + chunk).split("\n");
    rest = lines.pop();
    yield* lines;
    if (rest.length > LONGEST_LINE) break;
  }
  if (rest) yield rest;
}

async function main(options) {
  const usage = () => {
    console.error("usage: node voroproof_truth.mjs [--tolerance X] [--json] FILE...");
    process.exit(2);
  };
  let tolerance = 1e-9, show = asText;
  while (options.length && options[0].startsWith("--")) {
    const option = options.shift();
    if (option === "--json") show = asJson;
    else if (option === "--tolerance" && options.length) tolerance = Number(options.shift());
    else usage();
  }
  if (!options.length || !(tolerance >= 0)) usage();
  const { plain } = await import("./judge_plain.mjs");
  for (const name of options) {
    try {
      const reader = new Reader(), score = new Score(plain, tolerance);
      for await (const line of linesOf(name)) score.ask(reader, reader.read(line));
      if (reader.set === null) throw new Error("line 1: the file is empty");
      process.stdout.write(show(score));
    } catch (error) {
      console.error(`${name}: ${error.message}`);
      process.exitCode = 1;
    }
  }
}

if (typeof process !== "undefined" && process.argv?.[1]) {
  const { realpathSync } = await import("node:fs");
  const { fileURLToPath } = await import("node:url");
  const started = realpathSync(process.argv[1]) === fileURLToPath(import.meta.url);
  if (started) await main(process.argv.slice(2));
}
