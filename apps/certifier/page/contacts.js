"use strict";
// Contacts (docs/kernel.md, section 4): every overlap of the paths is answered by a collision, and every collision
// answers one.

// An instant: the smaller (-1) or the larger (1) root of a gap, or a time.
class GapRoot {
  constructor(gap, which) {
    this.gap = gap;
    this.which = which;
  }

  // The sign of this - t. Between its roots a gap is negative.
  against(t) {
    const value = this.gap.value(t).sign, slope = this.gap.slope(t).sign;
    if (value < 0) return this.which;
    return slope === this.which && value === 0 ? 0 : -slope;
  }
}

class ContactCheck {
  constructor(problem, counts) {
    const { center, radius } = problem.scene;
    this.problem = problem;
    this.counts = counts;
    this.line = 0;
    this.slack = problem.isExact ? ZERO : problem.tolerance;  // exact times have none
    this.grain = center[0].abs().plus(center[1].abs()).plus(radius).times(TWO_ULPS);
    this.turns = new Array(problem.disks).fill(0);  // by disk: claims so far that turned it
    this.by = new Array(problem.disks).fill(-1);    // the collision that turned it last, or -1
    this.open = new Map();      // overlaps in progress: { from, extreme, answer, two }
    this.followed = new Map();  // to where the lines of some that are no neighbours were
    this.order = [];            // Turns of instants that other claims may be of, the first first
    this.atEnd = false;
    this.continues = false;     // the claim answers an overlap begun on earlier legs
  }

  run(progress) {
    const { problem } = this, { claims } = problem.history;
    this.walk = new Walk(problem);
    claims.forEach((claim, number) => {
      if ((number & 31) === 0) progress("contacts", number, claims.length);
      this.line = claim.line;
      if (claim.kind === "flip") this.flip(claim);
      else this.turn(claim, number);
    });
    this.requireOrderUntil(null);
    this.line = problem.history.lastLine;
    this.atEnd = true;
    const end = problem.history.horizon;
    for (let j = 0; j < problem.disks; ++j) this.endPairs(j, end, null);
    const rest = [...this.open.values()].sort((a, b) => a.two[0] - b.two[0] || a.two[1] - b.two[1]);
    for (const overlap of rest) this.close(overlap, end);
  }

  turn(claim, number) {
    const isCollision = claim.kind === "collision", disks = claim.ids.slice(claim.first);
    const order = this.problem.isExact ? this.orderAt(claim) : null;
    order?.begin(claim, disks.flatMap((g) => this.pairs(g)), this.walk);
    if (isCollision) this.judge(claim);
    for (const g of disks) this.endPairs(g, claim.t, isCollision ? claim : null);
    for (const g of disks) {
      ++this.turns[g];
      this.by[g] = isCollision ? number : -1;
    }
    this.walk.apply(claim);
    order?.end(claim, this.walk);
  }

  // The turns of the claim's instant so far. The file's times are within the tolerance of the true ones.
  orderAt({ t }) {
    this.requireOrderUntil(t.minus(this.problem.tolerance.scaled(2)));
    let k = this.order.length;
    while (k > 0 && t.less(this.order[k - 1].t)) --k;
    if (k > 0 && !this.order[k - 1].t.less(t)) return this.order[k - 1];
    this.order.splice(k, 0, new Turns(t));
    return this.order[k];
  }

  // Judges the order at the instants before t, all of whose claims have been read; where t is null, at all instants.
  requireOrderUntil(t) {
    while (this.order.length > 0 && (t === null || this.order[0].t.less(t))) {
      const { fault } = this.order.shift();
      if (fault === null) continue;
      this.line = fault.line;
      refute(fault.why, fault.witness);
    }
  }

  // ---- Of a pair

  static name([i, j]) {
    return `generators ${i} and ${j}`;
  }

  key([i, j]) {
    return (i + 1) * (this.problem.disks + 1) + j;
  }

  // The sign of the gap where the two overlap.
  out(two) {
    return Turns.inwards(two);
  }

  gap(two) {
    return new Gap(this.walk.leg(two[0]), this.walk.leg(two[1]));
  }

  // Bounds how far roundings of the numbers on the lines so far can have moved the two.
  delta(two) {
    const n = this.turns[two[1]] + (two[0] === CONTAINER ? 0 : this.turns[two[0]]);
    return this.grain.times(Fraction.whole(Math.max(1, n)));
  }

  isShallow(two, extreme) {
    const reach = this.problem.reach(...two), delta = this.delta(two);
    if (this.problem.isExact || reach.less(delta.scaled(2))) return false;
    if (this.out(two) > 0) return !reach.plus(delta).square().less(extreme);
    return !extreme.less(reach.minus(delta).square());
  }

  isNear(instant, t) {
    return instant.against(t.minus(this.slack)) >= 0 && instant.against(t.plus(this.slack)) <= 0;
  }

  // The pairs of neighbours with the disk, smaller ones first.
  pairs(disk) {
    if (this.walk.diagram === null) return [[CONTAINER, disk]];
    const others = new Set();
    for (const k of this.walk.diagram.spokes[disk + 1]) {
      const [l, r] = this.walk.diagram.edges[k];
      others.add(l === disk ? r : l);
    }
    const all = [...others].map((g) => (g < disk ? [g, disk] : [disk, g]));
    return all.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  }

  // ---- Claims

  flip(claim) {
    const { k, isMirrored } = this.walk.edgeOf(claim);
    if (k < 0) refute("wrong quadruple: the diagram has no such edge", { t: claim.t, quad: claim.quad });
    const [l, r] = this.walk.diagram.edges[k], two = l < r ? [l, r] : [r, l];
    ++this.counts.flips;
    if (isMirrored) ++this.counts.unoriented;
    this.walk.apply(claim);
    if (this.walk.diagram.adjacent(l, r)) return;
    this.requireNoMeeting(two, claim.t.plus(this.slack));
    this.endLines(two, claim.t, null);
    const key = this.key(two), overlap = this.open.get(key);
    this.followed.set(key, claim.t);
    if (overlap === undefined) return;
    this.close(overlap, claim.t);
    this.open.delete(key);
  }

  // Whether the claimed collision answers an entry; how is kept for endPairs.
  judge(claim) {
    const two = claim.ids, [i, j] = two, name = ContactCheck.name(two), witness = { t: claim.t, pair: two };
    if (this.walk.diagram && !this.walk.diagram.adjacent(i, j)) refute(`${name} are not adjacent`, witness);
    if (claim.first === 0 && this.by[i] >= 0 && this.by[i] === this.by[j]) {
      refute(`${name} have just collided and part since`, witness);
    }
    this.requireNoMeeting(two, claim.t);
    const gap = this.gap(two), entry = new GapRoot(gap, this.out(two));
    const enters = gap.hasRoots && entry.against(gap.start) >= 0;
    this.continues = false;
    if (enters && this.isNear(entry, claim.t)) return;
    this.continues = this.isInProgress(claim, gap);
    if (this.continues || (!enters && this.isGraze(claim, gap))) return;
    refute(`${name} do not come into contact then`, witness);
  }

  isInProgress(claim, gap) {
    const two = claim.ids, overlap = this.open.get(this.key(two)), early = claim.t.minus(this.slack);
    if (overlap === undefined) return false;
    if (gap.value(claim.t).sign !== this.out(two) || gap.slope(claim.t).sign !== this.out(two)) return false;
    if (overlap.from.against(early) >= 0) return true;
    return !gap.start.less(early) && this.isShallow(two, overlap.extreme);
  }

  isGraze(claim, gap) {
    if (this.problem.isExact || claim.first !== 0 || gap.a.sign <= 0) return false;
    const { nearest } = gap, reach = this.problem.reach(...claim.ids);
    if (nearest.less(gap.start) || this.slack.less(nearest.minus(claim.t).abs())) return false;
    const value = gap.value(nearest), most = reach.plus(this.delta(claim.ids)).square();
    if (value.sign < 0 || most.less(value.plus(reach.square()))) return false;
    ++this.counts.grazes;
    return true;
  }

  // ---- Lines

  // Ends the present lines of all pairs of a disk. `claim`: that in which one of them collides.
  endPairs(disk, t, claim) {
    for (const two of this.pairs(disk)) {
      const isOwn = claim !== null && claim.ids[0] === two[0] && claim.ids[1] === two[1];
      // Each pair is looked at once: its larger disk does it.
      if ((isOwn || this.atEnd) && disk === two[0]) continue;
      this.requireNoMeeting(two, t);
      this.endLines(two, t, isOwn ? claim : null);
    }
  }

  // Two points that meet have no law, and change places at a disk by no flip. Before that both are neighbours of that
  // disk, or of each other and so of a third.
  requireNoMeeting([i, j], t) {
    for (const [point, other] of [[i, j], [j, i]]) {
      if (this.problem.radius(point).sign !== 0) continue;
      for (const [a, b] of this.pairs(other)) this.requireApart(point, a === other ? b : a, t);
    }
  }

  requireApart(i, j, t) {
    if (i === j || this.problem.radius(j).sign !== 0) return;
    const time = this.gap([i, j]).meeting(t);
    if (time === null) return;
    throw new Stop("UNDECIDED", `points ${i} and ${j} meet`, { witness: { t: time, pair: [i, j] }, isLast: true });
  }

  // The overlaps on the whole lines, as pairs of instants.
  overlapsOf(two, gap, t) {
    const before = gap.start.minus(UNIT), after = t.plus(UNIT);
    const lower = new GapRoot(gap, -1), upper = new GapRoot(gap, 1);
    if (gap.hasRoots) return this.out(two) > 0 ? [[before, lower], [upper, after]] : [[lower, upper]];
    const isThroughout = this.out(two) > 0 ? gap.c.sign > 0 : gap.c.sign < 0 && gap.a.sign === 0;
    return isThroughout ? [[before, after]] : [];
  }

  // Follows the overlaps of two along their present lines up to t.
  endLines(two, t, claim) {
    ++this.counts.pairLives;
    const gap = this.gap(two), key = this.key(two);
    // Only the exact truth has other times than the file.
    if (t.less(gap.start)) {
      undecided(`${ContactCheck.name(two)} turn in another order than the file has`, { t, pair: two });
    }
    const start = greater(gap.start, this.followed.get(key) ?? gap.start);
    let last = this.open.get(key) ?? null;
    this.open.delete(key);
    for (const [from, to] of this.overlapsOf(two, gap, t)) {
      const isOld = from.against(start) < 0, late = from.against(t);
      // Under the exact truth an entry at the horizon is due.
      if (to.against(start) <= 0 || late > 0 || (late === 0 && !(this.problem.isExact && this.atEnd))) continue;
      const reach = this.problem.reach(...two).square();
      const overlap = isOld && last ? last : { two, from: isOld ? start : from, extreme: reach, answer: null };
      if (isOld) last = null;
      this.deepen(overlap, gap, [start, t], [from, to]);
      if (claim !== null && isOld === this.continues) overlap.answer = claim.t;
      if (to.against(t) <= 0) this.close(overlap, to);
      else this.open.set(key, overlap);
    }
    if (last !== null) this.close(last, start);
  }

  // The square of the distance where the two overlap most.
  deepen(overlap, gap, [start, t], [from, to]) {
    const out = this.out(overlap.two), reach = this.problem.reach(...overlap.two).square();
    for (const s of gap.a.sign > 0 ? [start, t, gap.nearest] : [start, t]) {
      if (s.less(start) || t.less(s)) continue;
      const value = gap.value(s);
      if (value.sign !== out || from.against(s) > 0 || to.against(s) < 0) continue;
      const distance = value.plus(reach);
      if (distance.against(overlap.extreme) === out) overlap.extreme = distance;
    }
  }

  // An overlap is over at an instant: a rounding, answered in time, or the horizon's.
  close({ two, from, extreme, answer }, end) {
    const { problem } = this, { horizon } = problem.history;
    if (this.isShallow(two, extreme)) {
      ++this.counts.roundingOverlaps;
    } else if (answer !== null && this.isNear(from, answer) && this.isNear(end, answer)) {
      return;
    } else if (!problem.isExact && from.against(horizon.minus(this.slack)) >= 0) {
      ++this.counts.horizonEvents;
    } else {
      const turn = this.walk.leg(two[1]).start, t = turn.sign > 0 ? turn : horizon;
      refute(`overlap: ${ContactCheck.name(two)} overlap before ${t.about()} and no collision in time answers it`,
        { t: from instanceof GapRoot ? this.within(from, end) : from, pair: two });
    }
  }

  // A time in an overlap, for the drawing: when the two are nearest, or the claim at hand.
  within({ gap }, end) {
    const t = gap.a.sign > 0 ? gap.nearest : gap.start;
    return end.against(t) > 0 && gap.start.less(t) ? t : gap.start;
  }
}
