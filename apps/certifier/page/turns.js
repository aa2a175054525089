"use strict";
// The order of the turns of one instant under the exact truth (docs/kernel.md, section 4): the smallest pair that touches
// and approaches collides, again and again; then the maneuvers; then once more collisions.

// The turns claimed of one instant. They are right where that order, followed from the legs before the instant, makes the
// same happen to each disk, one after the other.
class Turns {
  constructor(t) {
    this.t = t;
    this.all = [];             // { two, line }; `two` is twice the disk of a maneuver
    this.chains = new Map();   // by disk that turns: its turns, and its legs before the first and after each
    this.standing = new Map(); // by other generator: its leg at the instant
    this.touching = new Map(); // by generator: pairs by their names
  }

  static name([i, j]) {
    return i === j ? `the maneuver of disk ${i}` : `generators ${i} and ${j}`;
  }

  // The sign of the gap where the two overlap; that of its slope where two that touch approach each other.
  static inwards([i]) {
    return i === CONTAINER ? 1 : -1;
  }

  // The claim is about to turn its disks; `pairs` are those of these.
  begin(claim, pairs, walk) {
    for (const two of pairs) {
      const legs = two.map((g) => walk.leg(g));
      two.forEach((g, k) => this.standing.has(g) || this.standing.set(g, legs[k]));
      if (new Gap(...legs).value(this.t).sign !== 0) continue;
      for (const g of two) {
        if (!this.touching.has(g)) this.touching.set(g, new Map());
        this.touching.get(g).set(String(two), two);
      }
    }
    for (const g of claim.ids.slice(claim.first)) {
      if (!this.chains.has(g)) this.chains.set(g, { turns: [], legs: [walk.leg(g)] });
    }
  }

  // It has turned them.
  end(claim, walk) {
    const turn = { two: claim.kind === "collision" ? claim.ids : [claim.ids[1], claim.ids[1]], line: claim.line };
    for (const g of claim.ids.slice(claim.first)) {
      const chain = this.chains.get(g);
      chain.turns.push(turn);
      chain.legs.push(walk.leg(g));
    }
    this.all.push(turn);
  }

  // Tells what is wrong with the order of the turns, or null.
  get fault() {
    const taken = new Map(), due = new Map();
    const count = (g) => taken.get(g) ?? 0;
    const head = (g) => this.chains.get(g)?.turns[count(g)];
    const leg = (g) => this.chains.get(g)?.legs[count(g)] ?? this.standing.get(g);
    const pass = (g) => taken.set(g, count(g) + 1);
    const wrong = (line, why, two) => ({ line, why, witness: { t: this.t, pair: two } });
    const lookAt = (g) => {
      if (g === CONTAINER) return;
      for (const [key, two] of this.touching.get(g) ?? []) {
        if (new Gap(leg(two[0]), leg(two[1])).slope(this.t).sign === Turns.inwards(two)) due.set(key, two);
        else due.delete(key);
      }
    };
    const collide = () => {
      while (due.size > 0) {
        const two = [...due.values()].reduce((a, b) => ((a[0] - b[0] || a[1] - b[1]) < 0 ? a : b));
        const next = head(two[1]), disks = two.filter((g) => g !== CONTAINER);
        if (!next || String(next.two) !== String(two) || disks.some((g) => head(g) !== next)) {
          const at = head(two[0]) ?? next ?? this.all[this.all.length - 1];
          return wrong(at.line, `${Turns.name(two)} collide before that at the same instant`, two);
        }
        disks.forEach(pass);
        disks.forEach(lookAt);
      }
      return null;
    };
    for (const g of this.touching.keys()) lookAt(g);
    const early = collide();
    if (early !== null) return early;
    const maneuvers = this.all.filter(({ two: [i, j] }) => i === j);
    for (const turn of maneuvers) if (head(turn.two[0]) === turn) pass(turn.two[0]);
    maneuvers.forEach(({ two: [g] }) => lookAt(g));
    const late = collide();
    if (late !== null) return late;
    const left = this.all.find((turn) => head(turn.two[1]) === turn);
    if (left) return wrong(left.line, `${Turns.name(left.two)} belongs earlier in that instant`, left.two);
    return null;
  }
}
