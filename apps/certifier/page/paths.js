"use strict";
// The paths of the disks that the claims define (docs/kernel.md, section 3).

// Two units in the last place.
const TWO_ULPS = new Fraction(1n, ONE, 51);
const LONGEST_TIME = 20000;  // bits

// The gap |d|^2 - reach^2 = a s^2 + 2 b s + c of two on their legs, s = t - start.
class Gap {
  constructor(i, j) {
    this.start = greater(i.start, j.start);
    const d = difference(j.at(this.start), i.at(this.start)), w = difference(j.velocity, i.velocity);
    this.a = norm2(w);
    this.b = dot(d, w);
    this.c = norm2(d).minus(i.radius.plus(j.radius).square());
  }

  value(t) {
    const s = t.minus(this.start);
    return this.a.times(s).plus(this.b).plus(this.b).times(s).plus(this.c);
  }

  // Half the derivative.
  slope(t) {
    return this.a.times(t.minus(this.start)).plus(this.b);
  }

  get hasRoots() {
    return this.a.sign > 0 && this.discriminant.sign > 0;
  }

  get discriminant() {
    return this.b.square().minus(this.a.times(this.c));
  }

  // When the two are nearest; a > 0.
  get nearest() {
    return this.start.minus(this.b.over(this.a));
  }

  // For two points: the time at which they meet, where that is not after t; else null.
  meeting(t) {
    const time = this.a.sign > 0 ? this.nearest : this.start;
    return time.less(this.start) || t.less(time) || this.value(time).sign !== 0 ? null : time;
  }
}

// Follows the claims in the order of the file, and adds to each generator's legs.
class PathTracer {
  constructor(problem, counts) {
    const { scene } = problem;
    this.problem = problem;
    this.counts = counts;
    this.law = new Law(problem);
    this.done = scene.maneuvers.map(() => false);
    this.schedule = scene.disks.map(() => []);  // by disk: its maneuvers that are not claimed, the first last
    for (let k = scene.maneuvers.length - 1; k >= 0; --k) this.schedule[scene.maneuvers[k].disk].push(k);
    this.told = scene.disks.map((disk) => disk.velocity);  // as the file has it
    problem.legs = [[new Leg(ZERO, scene.center, [ZERO, ZERO], problem.radius(CONTAINER), -1)]];
    for (const disk of scene.disks) problem.legs.push([new Leg(ZERO, disk.center, disk.velocity, disk.radius, -1)]);
  }

  leg(g) {
    const legs = this.problem.legs[g + 1];
    return legs[legs.length - 1];
  }

  take(claim, number) {
    if (claim.kind === "flip") return;
    const { problem } = this, isCollision = claim.kind === "collision";
    const turning = claim.ids.map((_, k) => k).slice(claim.first);
    this.witness = { t: claim.filed, pair: claim.ids };
    const due = isCollision ? null : this.maneuverOf(claim);
    if (problem.isExact) this.settleTime(claim, due);
    const at = [null, null], before = [null, null];
    for (const k of turning) {
      const leg = this.leg(claim.ids[k]);
      at[k] = leg.at(claim.t).map((x) => x.reduced());
      before[k] = leg.velocity;
    }
    const after = isCollision ? this.collide(claim, at, before) : [null, this.turned(claim, due)];
    for (const k of turning) {
      const g = claim.ids[k];
      this.checkCentre(claim.p[k], at[k], before[k], after[k]);
      this.told[g] = claim.v[k] ?? after[k];
      this.checkSliding(g, at[k], after[k]);
      problem.legs[g + 1].push(new Leg(claim.t, at[k], after[k], problem.radius(g), number));
    }
  }

  settleTime(claim, due) {
    claim.t = due ? due.t : this.exactContact(claim).reduced();
    if (this.problem.tolerance.less(claim.t.minus(claim.filed).abs())) this.refute(`its time is ${claim.t.about()}`);
    if (this.problem.history.horizon.less(claim.t)) this.refute("its time is after the horizon");
  }

  refute(reason) {
    refute(reason, this.witness);
  }

  checkCentre(claimed, at, before, after) {
    if (claimed === null) return;
    const way = lengthAbove(before).plus(lengthAbove(after));
    const most = this.problem.tolerance.times(way).plus(lengthAbove(at).times(TWO_ULPS));
    if (most.square().less(norm2(difference(claimed, at)))) this.refute("the centre is elsewhere");
  }

  checkSliding(g, at, after) {
    const { scene } = this.problem, n = difference(at, scene.center);
    const touches = norm2(n).equals(scene.radius.minus(this.problem.radius(g)).square());
    if (touches && dot(n, after).sign === 0 && norm2(after).sign !== 0) {
      undecided(`disk ${g} slides along the container`, this.witness);
    }
  }

  // The claimed maneuver must be the first of its disk that is not yet claimed.
  maneuverOf(claim) {
    const { problem, schedule } = this, rest = schedule[claim.ids[1]];
    ++this.counts.maneuvers;
    if (rest.length === 0) this.refute("the scene has no such maneuver");
    const k = rest.pop(), due = problem.scene.maneuvers[k];
    if (problem.tolerance.less(due.t.minus(claim.t).abs())) this.refute(`the maneuver is at ${due.t.about()}`);
    if (problem.history.horizon.less(due.t)) this.refute("the maneuver is after the horizon");
    this.done[k] = true;
    return due;
  }

  checkVelocity(claimed, due, allowed) {
    const most = allowed.plus(lengthAbove(due).times(TWO_ULPS));
    if (most.square().less(norm2(difference(claimed, due)))) this.refute("the velocity is another");
  }

  rounded(v) {
    return v.map((x) => nearestBinary64(x) ?? invalid("a number beyond binary64"));
  }

  turned(claim, due) {
    const v = due.velocity;
    if (claim.v[1]) this.checkVelocity(claim.v[1], v, this.problem.lawTolerance.times(lengthAbove(v)));
    if (this.problem.isExact) return v;
    return claim.v[1] ?? v;
  }

  collide(claim, at, before) {
    const { problem, law } = this, [i, j] = claim.ids;
    ++this.counts.collisions;
    if (problem.reach(i, j).sign === 0) undecided("two points that meet", this.witness);
    if (claim.first === 0 && law.mass(i).plus(law.mass(j)).sign === 0) {
      undecided("two points without mass touch", this.witness);
    }
    const filed = claim.p.map((p, k) => p ?? at[k]);
    if (problem.isExact) return this.collideExactly(claim, at, before, filed);
    if (claim.v[1]) {
      if (!law.isObeyed(claim, at, before, claim.t)) this.refute("the velocities are not those of the law");
      return claim.v;
    }
    return law.response(claim, filed, before).map((v) => v && this.rounded(v));
  }

  collideExactly(claim, at, before, filed) {
    const { problem, law } = this;
    const told = claim.ids.map((g) => (g === CONTAINER ? null : this.told[g]));
    if (claim.v[1] && claim.p[1] && !law.isObeyed(claim, filed, told, ZERO)) {
      this.refute("the velocities are not those of the law");
    }
    const v = law.response(claim, at, before), speed = law.speeds(claim, before);
    const moved = lesser(Fraction.whole(4).times(problem.tolerance).times(speed.square()).over(problem.reach(...claim.ids)),
      speed.scaled(-10));
    const allowed = problem.lawTolerance.times(speed).plus(moved);
    for (let k = claim.first; claim.v[1] && k < 2; ++k) this.checkVelocity(claim.v[k], v[k], allowed);
    return v;
  }

  // When the two come into contact next, if that is rational.
  exactContact(claim) {
    const [i, j] = claim.ids, gap = new Gap(this.leg(i), this.leg(j));
    const latest = claim.t.plus(this.problem.tolerance);
    if (i !== CONTAINER && this.problem.reach(i, j).sign === 0 && gap.meeting(latest)) undecided("two points that meet", this.witness);
    if (!gap.hasRoots) this.refute(`generators ${i} and ${j} do not touch`);
    const [above, below] = gap.discriminant.terms, root = Fraction.ratio(wholeRoot(above), wholeRoot(below));
    if (!root.square().equals(gap.discriminant)) {
      undecided(`the collision time of ${i} and ${j} is irrational`, this.witness);
    }
    if (bitLength(gap.start.terms[1]) > LONGEST_TIME + 1) undecided("exact times have become too long", this.witness);
    return gap.start.plus((claim.first === 1 ? root : root.negative()).minus(gap.b).over(gap.a));
  }

  finish() {
    this.problem.scene.maneuvers.forEach((m, k) => {
      if (this.done[k] || this.problem.history.horizon.less(m.t)) return;
      refute(`disk ${m.disk} has a maneuver at ${m.t.about()}`, { t: m.t, disks: [m.disk] });
    });
  }
}

function tracePaths(problem, counts, progress) {
  const tracer = new PathTracer(problem, counts), { claims } = problem.history;
  claims.forEach((claim, k) => {
    if ((k & 63) === 0) progress("following the paths", k, claims.length);
    try {
      tracer.take(claim, k);
    } catch (stop) {
      if (!(stop instanceof Stop)) throw stop;
      stop.line = claim.line;
      throw stop;
    }
  });
  tracer.finish();
}

// A walk along the claims: the diagram, none for fewer than two disks, and the leg of each generator.
class Walk {
  constructor(problem) {
    this.problem = problem;
    this.diagram = problem.disks >= 2 ? new Diagram(problem.history.initial, problem.disks) : null;
    this.legOf = new Int32Array(problem.disks + 1);
  }

  leg(g) {
    return this.problem.legs[g + 1][this.legOf[g + 1]];
  }

  // Edge k on its generators' present legs.
  edge(k) {
    const quad = [...this.diagram.edges[k]];
    return new MovingEdge(quad, quad.map((g) => this.leg(g)));
  }

  // The edge that a flip names, or -1; without orientation it may be a mirrored one.
  edgeOf(claim) {
    if (this.diagram === null) return { k: -1, isMirrored: true };
    const [l, r, s, e] = claim.quad, k = this.diagram.find(claim.quad), isMirrored = k < 0;
    if (!this.problem.unoriented || s === e) return { k, isMirrored };
    const other = this.diagram.find([l, r, e, s]);
    if (k >= 0 && other >= 0) {
      undecided("two edges have the generators of the flip", { t: claim.t, quad: claim.quad });
    }
    return { k: Math.max(k, other), isMirrored };
  }

  // Throws Stop (refuted) where a flip names no edge.
  apply(claim) {
    if (claim.kind === "flip") {
      const { k } = this.edgeOf(claim);
      if (k < 0) refute("wrong quadruple: the diagram has no such edge", { t: claim.t, quad: claim.quad });
      this.diagram.flip(k);
    }
    for (let k = claim.first; k < 2; ++k) ++this.legOf[claim.ids[k] + 1];
  }
}
