"use strict";
// The lives of edges (docs/kernel.md, section 7): each edge of the claimed diagram collapses just where a flip is claimed.

const LEAST_PART = 2000;  // claims

// Claims [first, end) and the time from `from` to `to` that they are checked for.
function partsOf({ history, tolerance }) {
  const { claims, horizon } = history, most = tolerance.scaled(2);
  const parts = [{ first: 0, end: claims.length, from: ZERO, to: horizon }];
  for (let k = 1; k < claims.length; ++k) {
    const last = parts[parts.length - 1];
    if (k - last.first < LEAST_PART || !most.less(claims[k].filed.minus(claims[k - 1].filed))) continue;
    const cut = claims[k].filed.plus(claims[k - 1].filed).half().reduced();
    last.end = k;
    last.to = cut;
    parts.push({ first: k, end: claims.length, from: cut, to: horizon });
  }
  return parts;
}

// Since when an edge has its quadruplet and its four their motion: `flip` is the edge that flipped then, if one
// did, `isOwn` whether it became this one, `owesProof` whether it ends a hidden moment.
class Birth {
  constructor(at, { flip = null, isOwn = false, owesProof = false } = {}) {
    this.at = at;
    this.flip = flip;
    this.isOwn = isOwn;
    this.owesProof = owesProof;
  }
}

class LifeCheck {
  constructor(problem, part, counts) {
    this.problem = problem;
    this.part = part;
    this.claims = problem.history.claims;
    this.counts = counts;
    this.line = 0;
    this.notes = new Notes();
    this.taken = new Uint8Array(part.end - part.first);
    this.firstOpen = part.first;  // no claim of the part before it waits
    this.lastFlip = null;
    this.leftOut = null;  // the first collapse that the horizon leaves out
  }

  run(progress) {
    const { part, problem, claims } = this;
    this.walk = new Walk(problem);
    for (let k = 0; k < part.first; ++k) {
      this.line = claims[k].line;
      this.walk.apply(claims[k]);
    }
    this.line = 1;
    if (part.first === 0) checkInitial(this.walk);
    this.latest = Instant.at(part.from);
    this.births = this.walk.diagram.edges.map(() => new Birth(this.latest));
    for (let k = part.first; k < part.end; ++k) {
      if ((k & 15) === 0) progress("lives of edges", k, claims.length);
      this.take(k);
      this.checkCells(k + 1 < part.end ? claims[k + 1].filed.minus(problem.tolerance) : part.to);
    }
    this.finish(progress);
    this.counts.freshProofs += this.notes.freshProofs;
  }

  finish(progress) {
    const { part, problem, claims, births } = this, end = Instant.at(part.to), isLast = part.end === claims.length;
    if (isLast) this.line = problem.history.lastLine;
    births.forEach((birth, k) => {
      if ((k & 15) === 0) progress("lives of edges", part.end, claims.length);
      // Claims of the recorded truth may lie beyond the horizon.
      if (birth.at.against(end) > 0) return;
      const missing = this.missed(k, end, isLast && problem.isExact);
      if (missing) this.unclaimed(k, missing);
    });
    if (this.leftOut && this.lastFlip && this.leftOut.against(this.lastFlip) < 0) {
      undecided("a flip is claimed after one that is left out", { t: this.leftOut.drawn() });
    }
    this.checkCells(part.to, true);
  }

  // ---- Taking claims

  isOpen(k) {
    return k >= this.part.first && k < this.part.end && this.taken[k - this.part.first] === 0;
  }

  take(k) {
    if (!this.isOpen(k)) return;
    const claim = this.claims[k];
    this.line = claim.line;
    this.taken[k - this.part.first] = 1;
    if (claim.kind === "flip") this.flip(k);
    else this.turn(k);
  }

  // A claim that is earlier in truth than the one at hand, and later in the file.
  takeBefore(k) {
    const { line } = this;
    this.countSwap();
    this.take(k);
    this.line = line;
  }

  countSwap() {
    if (this.problem.strict) refute("the claim is out of order");
    ++this.counts.swaps;
  }

  // Takes a claim near the one at hand that is before `now` in truth, if there is one: a turn, or a flip that
  // changes an edge of `ending`, or any; of several the first in truth.
  takeEarlier(number, now, ending = null) {
    const most = this.claims[number].filed.plus(this.problem.tolerance.scaled(1));
    while (this.firstOpen < this.part.end && !this.isOpen(this.firstOpen)) ++this.firstOpen;
    let first = null;
    for (let m = this.firstOpen; m < this.part.end && !most.less(this.claims[m].filed); ++m) {
      if (!this.isOpen(m)) continue;
      const end = first ? first.at.copy() : now.copy();
      const at = this.claims[m].kind === "flip" ? this.flipBefore(m, end, ending)
        : this.canTurn(m) && end.againstTime(this.claims[m].t) > 0 ? Instant.at(this.claims[m].t) : null;
      if (at) first = { at, m };
    }
    if (first) this.takeBefore(first.m);
    return first !== null;
  }

  // When the claimed flip is, if that is before `now` and it changes an edge of `ending`, or any; else null.
  flipBefore(m, now, ending) {
    const { k } = this.walk.edgeOf(this.claims[m]);
    if (k < 0 || (ending && ![k, ...this.walk.diagram.around(k)].some((e) => ending.has(e)))) return null;
    const found = this.collapse(k, now.hi);
    return found !== null && found.at.against(now) < 0 ? found.at : null;
  }

  // The turn that has to come first for this one to be next of all its disks: itself, or another.
  nextTurn(number) {
    const { ids, first } = this.claims[number];
    for (const g of ids.slice(first)) {
      const { claim } = this.problem.legs[g + 1][this.walk.legOf[g + 1] + 1];
      if (claim !== number) return this.nextTurn(claim);
    }
    return number;
  }

  canTurn(number) {
    return this.nextTurn(number) === number;
  }

  // ---- Lives

  // The first collapse of edge k since its birth, before `end`.
  collapse(k, end) {
    const { at, isOwn, owesProof } = this.births[k], edge = this.walk.edge(k), { notes } = this;
    if (at.isPoint || isOwn) return firstCollapse(edge, at.hi, end, notes, owesProof);
    // A bracket that reaches to the end would leave nothing of this life to be looked at.
    if (!at.hi.less(end) && at.againstTime(end) >= 0) return null;
    while (!at.isPoint && !at.hi.less(end)) at.halve();
    let found = firstCollapse(edge, at.lo, end, notes);
    // The birth is a root in a bracket in which this edge has a root or is illegal: either its root is the
    // same, or the bracket can be made so small that it holds none of this edge. Nor may it hold one of a
    // tangency, after which q tells nothing; a tangency may have the same root.
    for (let round = 0; found && found.at.lo.less(at.hi); ++round) {
      if (at.isPoint) return firstCollapse(edge, at.lo, end, notes);
      const form = edge.over(at.lo, at.hi).polynomial(), isZero = Form.isZero(form);
      const hasEnds = !isZero && form[0] !== 0n && form[form.length - 1] !== 0n;
      if (hasEnds && Form.variations(form) === 0) return firstCollapse(edge, at.lo, end, notes);
      const isSame = isZero || (hasEnds && this.sharesRoot(form, at));
      if (isSame && (round === 64 || edge.over(at.lo, at.hi).apartness(new Set()) === "throughout")) {
        found = firstCollapse(edge, at.hi, end, notes);
        if (found && found.at.isPoint && found.at.lo.equals(at.hi)) found.at = at.copy();
        return found;
      }
      for (let n = 0; n < 8 && !at.isPoint; ++n) at.halve();
    }
    return found;
  }

  // Whether a form over the bracket of an instant has one root there, and that is the instant.
  sharesRoot(form, at) {
    const once = Form.squarefree(form);
    if (Form.variations(once) !== 1) return false;
    return Form.variations(Form.common(once, at.form(at.lo, at.hi))) % 2 === 1;
  }

  // The collapse of edge k between its birth and an instant at which it does not flip, or null. `isLast`: at the
  // horizon under the exact truth, where a collapse is due.
  missed(k, end, isLast = false) {
    const birth = this.births[k].at, { problem, walk } = this, { horizon } = problem.history;
    const none = () => {
      if (this.births[k].owesProof) undecided("a generator leaves another by two turns of one instant", { t: end.lo });
      return null;
    };
    if (birth === end) return none();
    if (end.lo.less(birth.hi) || birth.isPoint) {
      const order = birth.against(end);
      if (order === 0 && !isLast) return none();
      const quad = [...walk.diagram.edges[k]];
      if (order > 0) undecided(`what changes edge ${quadName(quad)}: the order`, { t: end.lo, quad });
    }
    ++this.counts.lives;
    let found = this.collapse(k, end.hi);
    // An event after the horizon counts only where the edge is on the verge of it at the horizon.
    if (!found && isLast && walk.edge(k).at(end.hi).incircle(true) <= 0) {
      found = this.collapse(k, end.hi.plus(problem.tolerance));
    }
    if (!found || found.at.against(end) >= (isLast ? 1 : 0)) return null;
    if (problem.isExact || found.at.againstTime(horizon.minus(problem.tolerance)) < 0) return found;
    ++this.counts.horizonEvents;
    if (!this.leftOut || found.at.against(this.leftOut) < 0) this.leftOut = found.at;
    return null;
  }

  // Whether the two disks of a claimed collision, which are both to turn next, have lain one inside the other before
  // that time: then nothing is claimed of them from there up to the collision. Two disks overlap once on their legs,
  // so this is the overlap that the claim answers, and it was entered within the tolerance before. A disk may lie
  // outside the container twice, at both ends of its way across: there this would excuse the way.
  hides({ first, ids, t }, at) {
    const x = at.copy();
    if (this.problem.isExact || first !== 0 || x.againstTime(t.minus(this.problem.tolerance)) < 0) return false;
    const [i, j] = ids.map((g) => this.walk.leg(g)), gap = new Gap(i, j);
    const inside = i.radius.times(j.radius).scaled(2).negative();  // where one touches the other from inside
    if (!gap.start.less(x.lo) || !x.lo.less(t)) return false;
    const nearest = gap.a.sign > 0 ? gap.nearest : gap.start;
    return gap.value(nearest.less(gap.start) ? gap.start : x.lo.less(nearest) ? x.lo : nearest).less(inside);
  }

  unclaimed(k, { at }) {
    const quad = [...this.walk.diagram.edges[k]];
    const witness = { t: at.drawn(), quad };
    for (const g of quad) {
      for (const h of quad) {
        if (!this.births[k].owesProof || g >= h) continue;
        const gap = new Gap(this.walk.leg(g), this.walk.leg(h)).value(at.lo).sign;
        if (g < 0 ? gap > 0 : gap < 0) undecided("a generator lies inside another twice", witness);
      }
      const leg = this.problem.legs[g + 1][this.walk.legOf[g + 1] + 1];
      if (leg !== undefined && this.canTurn(leg.claim) && this.hides(this.claims[leg.claim], at)) {
        undecided(`edge ${quadName(quad)} changes while a generator lies inside another`, witness);
      }
    }
    refute(`edge ${quadName(quad)} collapses at ${at.lo.about()}, and no flip is claimed`, witness);
  }

  // Whether a claim that the flip missing at `now` may wait for was taken; without one the history is refuted, but
  // for edges of two that have been hidden until now, which go to `hidden`.
  takesFirst(number, now, edges, hidden = null) {
    const claim = this.claims[number];
    for (const k of edges) {
      const missing = this.missed(k, now);
      if (!missing) continue;
      if (this.takeEarlier(number, now)) return true;
      const joins = hidden && claim.ids.every((g) => this.walk.diagram.edges[k].includes(g));
      if (!joins || !this.hides(claim, missing.at)) this.unclaimed(k, missing);
      hidden.add(k);
    }
    return false;
  }

  flip(number) {
    const { t } = this.claims[number], { tolerance } = this.problem, hi = t.plus(tolerance);
    const { k } = this.walk.edgeOf(this.claims[number]);
    if (k < 0) refute("wrong quadruple: the diagram has no such edge", { t, quad: this.claims[number].quad });
    const birth = this.births[k], edge = this.walk.edge(k), witness = { t, quad: edge.quad };
    ++this.counts.lives;
    const isPast = birth.at.isPoint || birth.isOwn;
    let found = birth.owesProof ? null : collapseNear(edge, isPast ? birth.at.hi : birth.at.lo, t);
    if (found && !birth.at.hi.less(found.at.lo)) found = null;
    const isSimple = found !== null;
    if (!found) found = this.collapse(k, hi.plus(tolerance));
    if (!found) {
      const turn = this.turnBefore(edge.quad, hi);
      if (turn < 0) refute(`edge ${quadName(edge.quad)} does not collapse by then`, witness);
      this.takeBefore(turn);
      return this.flip(number);
    }
    const near = this.walk.diagram.around(k);
    if (this.takeEarlier(number, found.at, new Set(near))) return this.flip(number);
    const now = found.at.copy();
    this.checkFlip(this.walk.edge(k), found, now, isSimple, witness);
    if (this.takesFirst(number, now, near)) return this.flip(number);
    this.noteOrder(now);
    if (!this.lastFlip || now.against(this.lastFlip) > 0) this.lastFlip = now;
    this.walk.diagram.flip(k);
    for (const e of near) this.births[e] = new Birth(now, { flip: edge.quad });
    this.births[k] = new Birth(now, { flip: edge.quad, isOwn: true });
  }

  // The first turn that one of the four waits for, which turns not later than `hi`, or -1.
  turnBefore(quad, hi) {
    let first = -1;
    for (const g of quad) {
      const leg = this.problem.legs[g + 1][this.walk.legOf[g + 1] + 1];
      if (leg === undefined || !this.isOpen(leg.claim) || hi.less(leg.start)) continue;
      const turn = this.nextTurn(leg.claim), { t } = this.claims[turn];
      if (!this.isOpen(turn)) continue;  // it waits for this flip
      const order = first < 0 ? -1 : t.against(this.claims[first].t) || turn - first;
      if (order < 0) first = turn;
    }
    return first;
  }

  checkFlip(edge, found, now, isSimple, witness) {
    const { problem } = this, { t, quad } = witness, name = `edge ${quadName(quad)}`;
    // Both vanish where the rule of the largest id decides.
    const after = isSimple ? null : edge.at(found.after), end = isSimple ? -1 : after.incircle(false);
    if (end > 0 || (end === 0 && after.incircle(true) !== 0)) {
      refute(`only one end of ${name} touches its fourth generator`, witness);
    }
    if (!isSimple && !isOneCircle(edge, now)) {
      refute(`${name} leads from one circle to another and stays`, witness);
    }
    if (now.againstTime(t.minus(problem.tolerance)) < 0 || now.againstTime(t.plus(problem.tolerance)) > 0) {
      refute(`${name} collapses at ${now.lo.about()}`, { t: now.drawn(), quad });
    }
    if (problem.isExact && now.againstTime(problem.history.horizon) > 0) refute("it is after the horizon", witness);
    if (now.againstTime(ZERO) <= 0) refute("the diagram at 0+ is that after all flips at 0", witness);
  }

  // The edges that have a turning disk among their four.
  edgesAbout({ ids, first }) {
    const all = new Set();
    for (const g of ids.slice(first)) {
      for (const k of this.walk.diagram.spokes[g + 1]) {
        for (const e of this.walk.diagram.around(k)) all.add(e);
        all.add(k);
      }
    }
    return new Set([...all].sort((a, b) => a - b));
  }

  turn(number) {
    const claim = this.claims[number], witness = { t: claim.t, pair: claim.ids };
    if (!this.canTurn(number)) refute("two turns of one disk are out of order", witness);
    const now = Instant.at(claim.t), all = this.edgesAbout(claim);
    if (this.takeEarlier(number, now, all)) return this.turn(number);
    const hidden = new Set();
    if (this.takesFirst(number, now, all, hidden)) return this.turn(number);
    this.noteOrder(now);
    for (const k of all) {
      const { at, flip } = this.births[k];
      if (!flip || at.hi.less(claim.t) || at.againstTime(claim.t) !== 0) continue;
      const g = flip.find((id) => claim.ids.slice(claim.first).includes(id));
      if (g !== undefined) refute(`disk ${g} turns at the instant of a flip before it`, witness);
    }
    this.walk.apply(claim);
    for (const k of all) this.births[k] = new Birth(now, { owesProof: hidden.has(k) });
  }

  // Checks anew the cells of generators that were so near that circles between them ceased to exist, where
  // there is time before the next claim and they exist again.
  checkCells(next, isLast = false) {
    const { notes, latest, problem } = this;
    if (notes.touched.size === 0 || !latest.hi.less(next)) return;
    const t = latest.hi.plus(next).half().reduced();
    // Where events may be left out at the horizon no diagram is claimed.
    if (!problem.isExact && !t.less(problem.history.horizon.minus(problem.tolerance))) return;
    for (const g of [...notes.touched].sort((a, b) => a - b)) {
      if (checkCell(this.walk, g, t)) notes.touched.delete(g);
    }
    if (isLast && notes.touched.size > 0) undecided("a generator lies inside another for long", { t });
  }

  // Claims may be out of order within the tolerance, as the times of each edge are in order.
  noteOrder(now) {
    if (now.lo.less(this.latest.hi) && now.against(this.latest) < 0) this.countSwap();
    else this.latest = now;
  }
}
