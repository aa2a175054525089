"use strict";
// The law of collision (docs/formats.md, section 6), and whether claimed velocities obey it (docs/kernel.md, section 3).

class Law {
  constructor(problem) {
    this.problem = problem;
    this.tolerance = problem.lawTolerance;
  }

  mass(g) {
    return this.problem.scene.disks[g].mass;
  }

  // Velocities after the collision with centres p and velocities v.
  response(claim, p, v) {
    const { scene } = this.problem, [i, j] = claim.ids;
    const n = difference(p[1], i === CONTAINER ? scene.center : p[0]), n2 = norm2(n);
    if (n2.sign === 0) undecided("the centres of two that touch coincide: there is no normal");
    if (i === CONTAINER) {
      const e = scene.wallRestitution, q = dot(v[1], n).over(n2);
      if (!scene.wholeLaw) return [null, along(v[1], UNIT.plus(e).times(q).negative(), n)];
      return [null, stretched(e, along(v[1], q.plus(q).negative(), n))];
    }
    const mi = this.mass(i), mj = this.mass(j), approach = dot(difference(v[1], v[0]), n);
    const q = UNIT.plus(scene.restitution).times(approach).over(n2.times(mi.plus(mj)));
    return [along(v[0], mj.times(q), n), along(v[1], mi.times(q).negative(), n)];
  }

  speeds(claim, v) {
    const speed = lengthAbove(v[1]);
    return claim.first === 0 ? speed.plus(lengthAbove(v[0])) : speed;
  }

  // Whether the change d of velocity is -(k w.n) n for some unit vector n, where w is the velocity of approach:
  // iff |d|^2 = -k d.w. If d is off by no more than `off`, the two sides differ by off (3 k |w| + off) at most.
  reflects(d, w, k, off) {
    const most = off.times(Fraction.whole(3).times(k).times(lengthAbove(w)).plus(off));
    return !most.less(norm2(d).plus(k.times(dot(d, w))).abs());
  }

  hasSomeNormal(claim, before, speed) {
    const most = this.tolerance.times(speed), { scene } = this.problem, e = scene.wallRestitution;
    const after = claim.v[1], d = difference(after, before[1]);
    if (claim.first === 1 && scene.wholeLaw) {
      const elastic = difference(stretched(UNIT.over(e), after), before[1]);
      return this.reflects(elastic, before[1], Fraction.whole(2), most.over(e));
    }
    if (claim.first === 1) return this.reflects(d, before[1], UNIT.plus(e), most);
    const [mi, mj] = claim.ids.map((g) => this.mass(g)), masses = mi.plus(mj);
    const k = UNIT.plus(scene.restitution).over(masses);
    const di = difference(claim.v[0], before[0]), w = difference(before[1], before[0]);
    const lost = norm2(along(stretched(mi, di), mj, d));
    return this.reflects(d, w, k.times(mi), most)
      && this.reflects(di, difference([ZERO, ZERO], w), k.times(mj), most)
      && !Fraction.whole(2).times(masses).times(most).square().less(lost);
  }

  // Whether the claimed velocities are those after a collision at t with centres p and velocities `before`.
  // Rounding turns the normal by up to `rounding`; where that is much, the velocities must be those of some
  // normal, too.
  isObeyed(claim, p, before, t) {
    const speed = this.speeds(claim, before), away = lengthAbove(p[1]).plus(speed.times(t));
    const reach = this.problem.reach(...claim.ids);
    const rounding = away.times(new Fraction(16n, ONE, 53)).over(reach);
    if (this.tolerance.less(rounding) && !this.hasSomeNormal(claim, before, speed)) return false;
    if (!rounding.less(UNIT)) return true;
    const due = this.response(claim, p, before), most = this.tolerance.plus(rounding).times(speed).square();
    const isDue = (k) => !most.less(norm2(difference(claim.v[k], due[k])));
    return isDue(1) && (claim.first === 1 || isDue(0));
  }
}
