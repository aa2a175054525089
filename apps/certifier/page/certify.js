"use strict";
// The verdict on a history of a scene by the rules of docs/kernel.md.

const COUNT_NAMES = ["flips", "collisions", "maneuvers", "lives", "pairLives", "freshProofs", "swaps", "grazes",
  "roundingOverlaps", "horizonEvents", "unoriented"];

// The problem to judge: the scene and the options. `legs` of generator g, at g + 1, are found by tracePaths.
class Problem {
  constructor(options) {
    this.isExact = options.truth === "exact";
    this.strict = options.strict === true;
    this.unoriented = options.unoriented === true;
    this.tolerance = exactOfText(options.tolerance ?? "1e-6", { field: "tolerance" });
    this.lawTolerance = exactOfText(options.lawTolerance ?? "1e-9", { field: "law tolerance" });
    if (this.tolerance.sign <= 0 || this.lawTolerance.sign < 0 || UNIT.less(this.lawTolerance)) {
      invalid("a bad tolerance");
    }
    this.legs = [];
  }

  get disks() {
    return this.scene.disks.length;
  }

  radius(g) {
    return g === CONTAINER ? this.scene.radius.negative() : this.scene.disks[g].radius;
  }

  reach(i, j) {
    return this.radius(i).plus(this.radius(j)).abs();
  }
}

class Certification {
  // `progress(phase, done, of)` returns false to end the work.
  constructor(options, progress) {
    this.options = options;
    this.progress = (phase, done, of) => {
      if (progress(phase, done, of) === false) {
        undecided(`ended on request, or for the limit of time, after ${Math.floor((100 * done) / Math.max(1, of))}% of: ${phase}`,
          { isCancelled: true });
      }
    };
    this.counts = Object.fromEntries(COUNT_NAMES.map((name) => [name, 0]));
    this.problem = null;
    this.horizonNote = "";
    this.isFirst = true;  // no earlier claim is false: not known of most refutations
  }

  // Judges the bytes of both files.
  run(sceneBytes, historyBytes) {
    try {
      this.problem = new Problem(this.options);
      this.read(sceneBytes, historyBytes);
      this.judge();
      return this.result("CERTIFIED", "", {});
    } catch (stop) {
      if (!(stop instanceof Stop)) throw stop;
      return this.result(stop.verdict, stop.reason, stop);
    }
  }

  result(verdict, reason, { line = 0, file = "", fileLine = 0, field = "", witness = null }) {
    const { counts, horizonNote, about, isFirst } = this;
    return { verdict, reason, line, file, fileLine, field, witness, counts, horizonNote, about, isFirst };
  }

  // States what the verdict is about, in the words of `certify`. Empty before both files are read.
  get about() {
    const { problem, options } = this;
    if (!problem?.history) return "";
    return [`all events, ${problem.isExact ? "exact" : "recorded"} truth, up to t = ${problem.history.horizon}`,
      `times within ${options.tolerance ?? "1e-6"}`, `velocities within ${options.lawTolerance ?? "1e-9"}`,
      ...(problem.strict ? ["strict"] : []), ...(this.horizonNote ? [this.horizonNote] : [])].join(", ");
  }

  read(sceneBytes, historyBytes) {
    const { problem } = this;
    this.progress("reading the scene", 0, 1);
    problem.scene = readScene(sceneBytes);
    problem.history = readHistory(historyBytes, problem.disks, this.progress);
    // A tolerance of times beyond that would accept any.
    if (greater(problem.history.horizon, power(10, -6)).less(problem.tolerance)) invalid("a tolerance beyond the horizon");
    if (problem.history.hash !== sha256(sceneBytes)) {
      invalid("another scene's history", { line: 1, file: "history", fileLine: 1, field: "scene_sha256" });
    }
  }

  judge() {
    const { problem } = this, { history, scene } = problem;
    if (history.stopped) undecided("the history stops before its horizon");
    if (!history.horizon.equals(scene.horizon)) {
      if (problem.strict) refute("the history has another horizon than its scene");
      this.horizonNote = `horizon ${history.horizon} of the scene's ${scene.horizon}`;
    }
    this.isFirst = false;  // each rule looks at all claims before the next does
    tracePaths(problem, this.counts, this.progress);
    if (!history.initial && problem.disks >= 2) undecided("the history has no initial diagram");
    if (history.initial && problem.disks < 2 && history.initial.length > 0) refute("wrong initial diagram");
    this.runTasks();
    this.isFirst = true;
    const { flips, collisions, maneuvers } = this.counts;
    if ([flips, collisions, maneuvers].some((n, k) => n !== history.ended[k])) {
      throw new Stop("REFUTED", "bad count", { line: history.lastLine });
    }
  }

  // The first refuted line counts, unless no rule holds by then; else the first that is undecided.
  runTasks() {
    const { problem } = this, checks = [new ContactCheck(problem, this.counts)];
    if (problem.disks >= 2) for (const part of partsOf(problem)) checks.push(new LifeCheck(problem, part, this.counts));
    let first = null;
    const rank = (stop) => (stop.verdict === "REFUTED" || stop.isLast ? 0 : 1);
    for (let k = 0; k < checks.length; ++k) {
      const check = checks[k];
      checks[k] = null;  // its diagram takes room
      try {
        check.run(this.progress);
      } catch (stop) {
        if (!(stop instanceof Stop) || stop.isCancelled) throw stop;
        stop.line = check.line;
        if (first === null || (rank(stop) - rank(first) || stop.line - first.line) < 0) first = stop;
      }
    }
    if (first !== null) throw first;
  }
}

// As voroproof-kernel writes it; a fault in a file with the names of file and field.
function linesOf({ verdict, reason, line, file, fileLine, field, counts: c, horizonNote, isFirst }) {
  const lines = [
    `c ${c.flips} flips, ${c.collisions} collisions, ${c.maneuvers} maneuvers; ${c.lives} lives of edges, `
      + `${c.pairLives} of pairs, ${c.freshProofs} fresh proofs`,
    `c ${c.swaps} swaps, ${c.grazes} grazes, ${c.roundingOverlaps} overlaps by rounding, `
      + `${c.horizonEvents} events at the horizon, ${c.unoriented} quadruplets without orientation`];
  if (horizonNote !== "") lines.push(`c ${horizonNote}`);
  if (verdict === "REFUTED" && !isFirst) lines.push("c the first fault that was found; an earlier one may exist");
  const place = file !== "" ? `${file}:${fileLine}: ${field === "" ? "" : `${field}: `}` : line > 0 ? `line ${line}: ` : "";
  if (reason !== "") lines.push(`c ${place}${reason}`);
  return [...lines, `s ${verdict}`];
}
