"use strict";
// The first collapse of an edge (docs/kernel.md, section 6): { at: Instant, after }, where its first in-circle function is
// negative from `at` to `after`;
// null where there is none.

const SQUAREFREE_DEPTH = 30;
const DEEPEST_PIECE = 2000;
const DEEP_TANGENCY = 64;
const DEEPEST_TANGENCY = 512;  // f and a tangency may have one root

// Notes of the searches: proofs made anew after tangencies of the wrong sign, and the pairs of these tangencies.
class Notes {
  constructor() {
    this.freshProofs = 0;
    this.touched = new Set();
  }
}

// A stretch of an edge's life in which tangencies have their right signs, cut into pieces [k, k + 1] / 2^depth.
class Stretch {
  constructor(edge, span, a, b) {
    this.edge = edge;
    this.span = span;
    this.a = a;
    this.length = b.minus(a);
  }

  time(k, depth) {
    return this.a.plus(this.length.times(new Fraction(k, ONE, depth))).reduced();
  }

  first(f, k = 0n, depth = 0) {
    if (depth === SQUAREFREE_DEPTH) f = Form.squarefree(f);
    const roots = Form.variations(f), isDeep = depth >= SQUAREFREE_DEPTH;
    if (roots === 0) return this.withoutRoots(f, k, depth);
    if (roots === 1) {
      // A collapse makes q negative until the end of the piece.
      const { always } = this.span;
      const from = this.span.at(k, depth).legal(null, always);
      const to = from > 0 ? this.span.at(k + 1n, depth).legal(null, always) : 0;
      if (from > 0 && to > 0) return null;
      if (from > 0 && to < 0) {
        const hi = this.time(k + 1n, depth);
        return { at: new Instant(this.time(k, depth), hi, this.edge, isDeep), after: hi };
      }
    }
    if (depth > DEEPEST_PIECE) undecided("an edge's polynomial cannot be divided further");
    const [left, right] = Form.halves(f);
    return this.first(left, 2n * k, depth + 1) ?? this.first(right, 2n * k + 1n, depth + 1);
  }

  // q does not vanish inside: one time decides.
  withoutRoots(f, k, depth) {
    const { always } = this.span, isF = !always && depth < SQUAREFREE_DEPTH;
    // Where C stands for f, f is negative.
    const sign = !isF ? null : f.length < 9 ? -1 : signOf(f.find((c) => c !== 0n));
    const q = this.span.at(2n * k + 1n, depth + 1).legal(sign, always);
    if (q === 0) undecided("an in-circle function vanishes where it cannot");
    if (q > 0) return null;
    return { at: Instant.at(this.time(k, depth)), after: this.time(2n * k + 1n, depth + 1) };
  }
}

class CollapseSearch {
  constructor(edge, notes, owesProof) {
    this.edge = edge;
    this.notes = notes;
    this.owesProof = owesProof;  // since an interval with a wrong tangency
  }

  first(a, b, depth = 0) {
    const span = this.edge.over(a, b), apartness = span.apartness(this.notes.touched);
    const isLeftOut = apartness === "nowhere" ||
      (apartness === "unclear" && depth >= DEEP_TANGENCY &&
        (depth >= DEEPEST_TANGENCY || !this.mayCollapse(span, a)));
    if (isLeftOut || apartness === "inside") this.owesProof = true;
    if (isLeftOut) return null;
    if (apartness === "unclear") {
      const middle = a.plus(b).half().reduced();
      return this.first(a, middle, depth + 1) ?? this.first(middle, b, depth + 1);
    }
    const f = span.polynomial(), found = new Stretch(this.edge, span, a, b).first(f);
    return this.owesProof ? this.provedAnew(a, b, found) : found;
  }

  // However short the piece from a on is, the edge may collapse in it where f has a root, or at a.
  mayCollapse(span, a) {
    if (Form.variations(span.polynomial()) !== 0) return true;
    return this.edge.over(a, a).apartness(new Set()) === "throughout" &&
      this.edge.at(a).legal(null, span.always) <= 0;
  }

  // Both circles must exist and be empty somewhere before the collapse: soon, as the life may end long before b, which
  // is the upper end of a bracket. Where they are not, it is at a.
  provedAnew(a, b, found) {
    this.owesProof = false;
    ++this.notes.freshProofs;
    const t = a.plus((found ? found.at.lo : b).minus(a).scaled(-20)).reduced();
    if (t.equals(a)) return found;
    const now = this.edge.at(t);
    const isRight = [true, false].every((start) => now.exists(start) > 0 && now.incircle(start) >= 0);
    return isRight ? found : { at: Instant.at(a), after: found ? found.after : t };
  }
}

// The first collapse just after a or in (a, b). `owesProof`: it begins with a fresh proof.
function firstCollapse(edge, a, b, notes, owesProof = false) {
  if (edge.quad[2] === edge.quad[3] || !a.less(b)) return null;
  const search = new CollapseSearch(edge, notes, owesProof), found = search.first(a, b);
  // The next life sees wrong tangencies at its beginning, but not those that end just before it.
  if (search.owesProof && edge.over(b, b).apartness(notes.touched) === "throughout") {
    undecided(`a generator lies inside another until just before ${b.about()}`, { t: b, quad: edge.quad });
  }
  return found;
}

// The collapse if it is the only root since a, and within 2^-37 of t: the quick way of most flips.
function collapseNear(edge, a, t) {
  const grain = new Fraction(ONE, ONE, 40);
  const scaled = t.scaled(40), middle = scaled.n / (scaled.m << BigInt(scaled.k));
  const lo = Fraction.whole(middle - 4n).times(grain), hi = Fraction.whole(middle + 5n).times(grain);
  if (!a.less(lo)) return null;
  const span = edge.over(a, hi);
  if (span.apartness(new Set()) !== "throughout") return null;
  const f = span.polynomial(), last = f[f.length - 1];
  if (Form.variations(f) !== 1 || span.always || last === 0n) return null;
  const end = span.at(1n, 0), sign = f.length < 9 ? -1 : signOf(last);
  if (end.incircle(true, sign) >= 0 || end.incircle(false, sign) >= 0) return null;
  if (edge.at(lo).incircle(true) <= 0) return null;
  return { at: new Instant(lo.reduced(), hi.reduced(), edge), after: hi };
}

// Whether both vertices' circles, which touch all four at the instant, are one circle. With w = (D_xp, D_yp) of the
// end, the circles of both orientations lie on either side of w, the end's on the side of -eps. Both vertices need
// one base, l, or r where l is the container.
function isOneCircle(edge, instant) {
  const { quad } = edge;
  for (let round = 0; round < 200; ++round) {
    const { sites } = edge.over(instant.lo, instant.hi);
    const [base, j] = quad[0] === CONTAINER ? [1, [0, 2]] : [0, [2, 1]];
    const start = new Circle(sites[base], sites[j[0]], sites[j[1]]), end = Circle.ofEdge(sites, quad, false);
    const u = Form.product(start.sp, Form.cross(start.xp, end.yp, start.yp, end.xp));
    const v = Form.inner(end.xp, start.xp, end.yp, start.yp), { gamma } = start;
    const norm = Form.difference(Form.square(u), Form.product(gamma, Form.square(v)));
    if (norm[0] !== 0n && norm[norm.length - 1] !== 0n && Form.variations(norm) === 0) {
      const side = signWithRoot(u[0], -BigInt(epsilonOf(quad, true)) * v[0], gamma[0]);
      return side === -epsilonOf(quad, false);
    }
    if (instant.isPoint) break;
    instant.halve();
  }
  return undecided("whether two circles touch the same four", { t: instant.lo, quad });
}
