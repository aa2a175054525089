"use strict";
// Generators on lines, and the circles that touch three of them. A centre and a signed radius, -R for the
// container, are forms: [x, y, r], with one coefficient at a time and two over an interval.

// A generator's motion from `start` on. Its place at t is (place + velocity t) / scale in whole numbers, with
// scale = odd 2^twos.
class Leg {
  constructor(start, from, velocity, radius, claim) {
    this.start = start.reduced();
    this.from = from.map((x) => x.reduced());
    this.velocity = velocity.map((x) => x.reduced());
    this.radius = radius;
    this.claim = claim;  // that begins it
    const origin = this.at(ZERO), all = [...origin, ...this.velocity, radius].map((x) => x.reduced());
    this.odd = all.reduce((odd, x) => (x.m === ONE ? odd : (odd / divisor(odd, x.m)) * x.m), ONE);
    this.twos = Math.max(...all.map((x) => x.k));
    [this.x, this.y, this.vx, this.vy, this.r] = all.map((x) => {
      const n = this.odd === x.m ? x.n : x.n * (this.odd / x.m);
      return n << BigInt(this.twos - x.k);
    });
  }

  at(t) {
    return along(this.from, t.minus(this.start), this.velocity);
  }
}

function leastMultiple(x, y) {
  return x === y ? x : (x / divisor(x, y)) * y;
}

// The sites of generators at times, all on one scale: one form for each coordinate, with a coefficient for
// each time.
function sitesOf(legs, times) {
  let odd = ONE, twos = 0, oddTime = ONE, twosTime = 0;
  for (const leg of legs) {
    odd = leastMultiple(odd, leg.odd);
    twos = Math.max(twos, leg.twos);
  }
  const reduced = times.map((t) => t.reduced());
  for (const t of reduced) {
    oddTime = leastMultiple(oddTime, t.m);
    twosTime = Math.max(twosTime, t.k);
  }
  const numerators = reduced.map((t) => {
    const n = oddTime === t.m ? t.n : t.n * (oddTime / t.m);
    return t.k === twosTime ? n : n << BigInt(twosTime - t.k);
  });
  return legs.map((leg) => {
    const by = odd === leg.odd ? ONE : odd / leg.odd, shift = BigInt(twos - leg.twos);
    const lift = (c) => (by === ONE ? c : c * by) << shift;
    const still = BigInt(twosTime), fine = (c) => (oddTime === ONE ? c : c * oddTime) << still;
    const x = fine(lift(leg.x)), y = fine(lift(leg.y)), r = fine(lift(leg.r));
    const vx = lift(leg.vx), vy = lift(leg.vy);
    return [numerators.map((t) => x + vx * t), numerators.map((t) => y + vy * t), numerators.map(() => r)];
  });
}

function apart(a, b) {
  return [Form.difference(a[0], b[0]), Form.difference(a[1], b[1]), Form.difference(a[2], b[2])];
}

function tangency([x, y, r]) {
  return Form.difference(Form.inner(x, x, y, y), Form.product(r, r));
}

// f by Casey's theorem, of the tangencies of lr, ls, le, rs, re, se.
function casey([lr, ls, le, rs, re, se]) {
  const v = Form.product(ls, re), w = Form.product(le, rs);
  const d = Form.difference(Form.difference(Form.product(lr, se), v), w);
  return Form.difference(Form.square(d), Form.product(v, w).map((c) => 4n * c));
}

const PAIRS_OF_FOUR = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

// The circle that touches the disk i, j and k counterclockwise: D_uv = u_j v_k - v_j u_k of the differences
// to i (docs/design/predicates.md).
class Circle {
  constructor(i, j, k) {
    const u = apart(j, i), v = apart(k, i), p = tangency(u), o = tangency(v);
    this.base = i;
    this.xp = Form.cross(u[0], o, p, v[0]);
    this.yp = Form.cross(u[1], o, p, v[1]);
    this.sp = Form.cross(u[2], o, p, v[2]);
    this.xs = Form.cross(u[0], v[2], u[2], v[0]);
    this.ys = Form.cross(u[1], v[2], u[2], v[1]);
    this.xy = Form.cross(u[0], v[1], u[1], v[0]);
  }

  // That of a vertex of the edge [l,r,s,e] of sites: [l,s,r] or [l,r,e], with a disk as its base.
  static ofEdge(sites, quad, isStart) {
    const j = sites[isStart ? 2 : 1], k = sites[isStart ? 1 : 3];
    return quad[0] === CONTAINER ? new Circle(j, k, sites[0]) : new Circle(sites[0], j, k);
  }

  get gamma() {
    return Form.difference(Form.inner(this.xp, this.xp, this.yp, this.yp), Form.square(this.sp));
  }

  // G and C of a fourth generator: its in-circle function is G - eps sqrt(gamma) C.
  g(fourth) {
    const [x, y, r] = apart(fourth, this.base), p = tangency([x, y, r]), { xp, yp, sp, xs, ys } = this;
    const a = Form.sum(Form.cross(x, sp, r, xp), Form.product(p, xs));
    const b = Form.sum(Form.cross(y, sp, r, yp), Form.product(p, ys));
    return Form.inner(xp, a, yp, b);
  }

  c(fourth) {
    const [x, y, r] = apart(fourth, this.base);
    return Form.sum(Form.cross(x, this.yp, y, this.xp), Form.product(tangency([x, y, r]), this.xy));
  }
}
