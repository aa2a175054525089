"use strict";
// An edge [l,r,s,e] while its four generators are on their lines (docs/kernel.md, section 6).

// +1 if the container is one of the vertex's two besides the base, else -1.
function epsilonOf(quad, isStart) {
  return quad[0] === CONTAINER || quad[1] === CONTAINER || quad[isStart ? 2 : 3] === CONTAINER ? 1 : -1;
}

// The edge at one time.
class EdgeNow {
  constructor(quad, sites) {
    this.quad = quad;
    this.sites = sites;
  }

  signOfF() {
    return signOf(casey(PAIRS_OF_FOUR.map(([i, j]) => tangency(apart(this.sites[i], this.sites[j]))))[0]);
  }

  // The sign of the in-circle function of the start or of the end; `f` is the sign of f, or null where it is
  // not known.
  incircle(isStart, f = null) {
    const { quad } = this, circle = Circle.ofEdge(this.sites, quad, isStart);
    const fourth = this.sites[isStart ? 3 : 2];
    const g = f === -1 ? 0 : signOf(circle.g(fourth)[0]);
    const c = f === 1 ? 0 : -epsilonOf(quad, isStart) * signOf(circle.c(fourth)[0]);
    if (f === null && g !== c) f = this.signOfF();
    // Where f vanishes, one factor of N f does: q is the one that does not vanish, or 0.
    let q = g;
    if (g !== c && f <= 0) q = f < 0 ? c : g === 0 ? c : c === 0 ? g : 0;
    return quad[isStart ? 3 : 2] === CONTAINER ? -q : q;
  }

  // The sign of q; where both vanish throughout an interval, the rule of the largest id: the edge is there
  // iff its dual joins the largest of the four to its opposite.
  legal(f, always) {
    let q = this.incircle(true, f);
    if (q === 0 && always) q = this.incircle(false, f);
    if (q !== 0 || !always) return q;
    const [l, r, s, e] = this.quad;
    return Math.max(l, r) > Math.max(s, e) ? 1 : -1;
  }

  // Positive iff the circle exists, 0 where two of its three touch.
  exists(isStart) {
    const circle = Circle.ofEdge(this.sites, this.quad, isStart), [gamma] = circle.gamma;
    if (gamma <= 0n) return 0;
    const [u] = Form.inner(circle.xp, circle.xs, circle.yp, circle.ys);
    return signWithRoot(u, -BigInt(epsilonOf(this.quad, isStart)) * circle.xy[0], gamma);
  }
}

// The edge over [a, b].
class EdgeSpan {
  constructor(edge, a, b) {
    this.quad = edge.quad;
    this.sites = sitesOf(edge.legs, [a, b]);
    this.tangencies = PAIRS_OF_FOUR.map(([i, j]) => tangency(apart(this.sites[i], this.sites[j])));
    this.always = false;  // whether f vanishes throughout
  }

  // The edge at a + (b - a) k / 2^depth.
  at(k, depth) {
    const rest = (ONE << BigInt(depth)) - k;
    const between = ([u, v]) => [rest * u + k * v];
    return new EdgeNow(this.quad, this.sites.map((site) => site.map(between)));
  }

  // Where tangencies have their right signs: "throughout" [a, b], "inside", "nowhere", or "unclear". Adds the
  // generators of the others to `touched`.
  apartness(touched) {
    const { quad } = this, count = quad[2] === quad[3] ? 5 : 6;
    let all = true, inside = true, never = false;
    for (let n = 0; n < count; ++n) {
      const [i, j] = PAIRS_OF_FOUR[n].map((k) => quad[k]), right = i < 0 || j < 0 ? -1 : 1;
      const p = this.tangencies[n], roots = Form.variations(p);
      const endsRight = signOf(p[0]) === right && signOf(p[2]) === right;
      if (endsRight && (roots === 0 || p[1] * p[1] < 4n * p[0] * p[2])) continue;
      touched.add(i).add(j);
      all = false;
      if (roots > 0) inside = false;
      else if (!p.some((c) => signOf(c) === right)) never = true;
    }
    return all ? "throughout" : never ? "nowhere" : inside ? "inside" : "unclear";
  }

  // The form at whose roots the four may touch one circle: f, for equal radii C, and where f vanishes
  // throughout G.
  polynomial() {
    const { sites } = this, equal = sites.every((site) => site[2][0] === sites[0][2][0]);
    const f = equal ? Circle.ofEdge(sites, this.quad, true).c(sites[3]) : casey(this.tangencies);
    this.always = Form.isZero(f);
    return this.always && !equal ? Circle.ofEdge(sites, this.quad, true).g(sites[3]) : f;
  }
}

// An edge and the legs of l, r, s, e.
class MovingEdge {
  constructor(quad, legs) {
    this.quad = quad;
    this.legs = legs;
  }

  over(a, b) {
    return new EdgeSpan(this, a, b);
  }

  at(t) {
    return new EdgeNow(this.quad, sitesOf(this.legs, [t]));
  }
}

// A time lo = hi, or the only root, one of odd order, of the form of an edge in (lo, hi).
class Instant {
  constructor(lo, hi, edge = null, multiple = false) {
    this.lo = lo;
    this.hi = hi;
    this.edge = edge;
    this.multiple = multiple;  // the root need not be simple
  }

  static at(t) {
    return new Instant(t, t);
  }

  copy() {
    return new Instant(this.lo, this.hi, this.edge, this.multiple);
  }

  get isPoint() {
    return this.lo.equals(this.hi);
  }

  form(a, b) {
    const f = this.edge.over(a, b).polynomial();
    return this.multiple ? Form.squarefree(f) : f;
  }

  // Finds on which side of t it is.
  split(t) {
    if (Form.variations(this.form(this.lo, t)) % 2 === 1) this.hi = t;
    else if (Form.variations(this.form(t, this.hi)) % 2 === 1) this.lo = t;
    else this.lo = this.hi = t;
  }

  halve() {
    this.split(this.lo.plus(this.hi).half().reduced());
  }

  // A time near it, for a drawing.
  drawn() {
    const copy = this.copy(), grain = new Fraction(ONE, ONE, 30);
    while (!copy.isPoint && grain.less(copy.hi.minus(copy.lo))) copy.halve();
    return copy.lo;
  }

  // The sign of this - t.
  againstTime(t) {
    if (this.lo.less(t) && t.less(this.hi)) this.split(t);
    if (this.isPoint) return this.lo.against(t);
    return this.lo.less(t) ? -1 : 1;
  }

  // The sign of this - other, narrowing both. It ends: equal roots are roots of a common divisor.
  against(other) {
    for (let round = 0; ; ++round) {
      if (other.isPoint) return this.againstTime(other.lo);
      if (this.isPoint) return -other.againstTime(this.lo);
      if (!other.lo.less(this.hi)) return -1;
      if (!this.lo.less(other.hi)) return 1;
      const lo = greater(this.lo, other.lo), hi = lesser(this.hi, other.hi);
      if (round % 16 === 8) {
        const both = Form.common(this.form(lo, hi), other.form(lo, hi));
        if (Form.variations(both) % 2 === 1) return 0;
      }
      this.halve();
      if (!other.isPoint) other.halve();
    }
  }
}
