// SPDX-License-Identifier: CC0-1.0
//
// An engine in plain floating point, wrong where numbers are close: it shows how. judge_plain.h
// says what the formulas mean. Here, there and in judge_plain.py the operations have the same
// order, so that all three make the same mistakes in double. Therefore there are only + - * / and
// the square root, which IEEE 754 rounds in one way; no hypot, and no sines.

const STEPS = 64;
const GOLDEN = 0.6180339887498949;
const { sqrt } = Math;

// A generator seen from a base disk: x, y, s, their rates, and the coefficients of p.
function rowOf(b, g) {
  if (g.letter === "w") {
    const p0 = 2 * (g.x * b.x + g.y * b.y - g.r + b.r);
    const p1 = 2 * (g.x * b.vx + g.y * b.vy + b.vr);
    return { x: -g.x, y: -g.y, s: 1, vx: 0, vy: 0, vs: 0, p0, p1, p2: 0 };
  }
  const x = g.x - b.x, y = g.y - b.y, s = (g.letter === "c" ? -g.r : g.r) - b.r;
  const vx = g.vx - b.vx, vy = g.vy - b.vy, vs = g.vr - b.vr;
  const p0 = x * x + y * y - s * s;
  const p1 = 2 * (x * vx + y * vy - s * vs);
  const p2 = vx * vx + vy * vy - vs * vs;
  if (g.letter !== "c") return { x, y, s, vx, vy, vs, p0, p1, p2 };
  return { x: -x, y: -y, s: -s, vx: -vx, vy: -vy, vs: -vs, p0: -p0, p1: -p1, p2: -p2 };
}

const rowAt = (w, t) => ({
  x: w.x + w.vx * t,
  y: w.y + w.vy * t,
  s: w.s + w.vs * t,
  p: w.p0 + t * (w.p1 + t * w.p2),
});

// The rows of the others after the first three are rotated so that a disk is the base.
function rowsOf(g) {
  const base = g.findIndex((one) => one.letter === "d");
  return g.slice(1).map((_, k) => rowOf(g[base], g[k < 2 ? (base + k + 1) % 3 : k + 1]));
}

// null for what is not a number.
const sign = (x) => (x !== x ? null : Number(x > 0) - Number(x < 0));

// The gap between the circle and the last generator, times something positive.
function gap(rows, t) {
  const j = rowAt(rows[0], t), k = rowAt(rows[1], t), e = rowAt(rows[2], t);
  const xp = j.x * k.p - j.p * k.x, yp = j.y * k.p - j.p * k.y, sp = j.s * k.p - j.p * k.s;
  const xs = j.x * k.s - j.s * k.x, ys = j.y * k.s - j.s * k.y, xy = j.x * k.y - j.y * k.x;
  const square = xp * xp + yp * yp - sp * sp;
  const root = square > 0 ? sqrt(square) : 0;
  const a = e.x * sp - e.s * xp + e.p * xs, b = e.y * sp - e.s * yp + e.p * ys;
  const c = e.x * yp - e.y * xp + e.p * xy;
  return xp * a + yp * b + root * c;
}

// The first time t >= 0 at which a t^2 + 2 b t + c, not negative at 0, becomes so.
function firstFall(a, b, c) {
  if (c <= 0 && (b < 0 || (b === 0 && a < 0))) return { kind: "hit", time: 0 };
  const d = b * b - a * c;
  if (d !== d) return { kind: "none", time: d };
  if (a >= 0 && (b >= 0 || d < 0)) return { kind: "none", time: 0 };
  const root = d > 0 ? sqrt(d) : 0;
  const time = b < 0 ? c / (root - b) : (b + root) / -a;
  return { kind: a > 0 && d === 0 ? "graze" : "hit", time };
}

// Where f, positive at lo or not, has changed its sign.
function bisect(f, lo, hi, positive) {
  for (;;) {
    const mid = (lo + hi) / 2;
    if (!(lo < mid && mid < hi)) return hi;
    const value = f(mid);
    if (positive ? value > 0 : value < 0) lo = mid;
    else hi = mid;
  }
}

// The tangency of two generators as a polynomial in time.
function tangency(i, j) {
  if (i.letter === "w" && j.letter === "w") {
    const x = i.x - j.x, y = i.y - j.y;
    return { p0: x * x + y * y, p1: 0, p2: 0 };
  }
  return i.letter === "d" ? rowOf(i, j) : rowOf(j, i);
}

function cotangency(i, j, k, l) {
  const p = [[i, j], [k, l], [i, k], [j, l], [i, l], [j, k]].map(([a, b]) => tangency(a, b));
  return (t) => {
    const at = p.map((q) => q.p0 + t * (q.p1 + t * q.p2));
    const u = at[0] * at[1], v = at[2] * at[3], w = at[4] * at[5], d = u - v - w;
    return d * d - 4 * v * w;
  };
}

// The one root between lo and hi: where the sign changes, else where the value is least.
function rootOf(f, lo, hi) {
  const first = f(lo), last = f(hi);
  if (first === 0) return lo;
  if (last === 0) return hi;
  if (first < 0 !== last < 0) return bisect(f, lo, hi, first > 0);
  const turn = first < 0 ? -1 : 1;
  let a = hi - GOLDEN * (hi - lo), b = lo + GOLDEN * (hi - lo);
  let atA = turn * f(a), atB = turn * f(b);
  for (let i = 0; i < 48; ++i) {
    if (atA < atB) {
      hi = b, b = a, atB = atA;
      a = hi - GOLDEN * (hi - lo);
      atA = turn * f(a);
    } else {
      lo = a, a = b, atA = atB;
      b = lo + GOLDEN * (hi - lo);
      atB = turn * f(b);
    }
  }
  return (lo + hi) / 2;
}

// Whether disk i lies in another one, or outside of the container.
function isHidden(frame, disks, i) {
  const d = disks[i];
  const p = (x, y, s) => x * x + y * y - s * s;
  if (frame && p(frame.x - d.x, frame.y - d.y, -frame.r - d.r) >= 0) return true;
  return disks.some((o, j) => {
    const s = o.r - d.r;
    return j !== i && p(o.x - d.x, o.y - d.y, s) <= 0 && (s > 0 || (s === 0 && j < i));
  });
}

// Grows with the angle of (x, y), from 0 to 4.
function turn(x, y) {
  if (x === 0 && y === 0) return 0;
  if (y >= 0) return x >= 0 ? y / (x + y) : 1 - x / (y - x);
  return x < 0 ? 2 + y / (x + y) : 3 + x / (x - y);
}

// Whether wave j is above all others on more than points.
function isNeighbour(waves, j) {
  let pieces = [[0, 4]];
  for (const k of waves) {
    if (k === j) continue;
    const a = j.a - k.a, b = j.b - k.b, c = j.c - k.c;
    const d = a * a + b * b - c * c, root = d > 0 ? sqrt(d) : 0;
    const u = turn(root * b - c * a, -(root * a) - c * b);
    const v = turn(-(root * b) - c * a, root * a - c * b);
    if (!(d > 0) || !(u < v || v < u)) {
      if (!(c > 0)) return false;
      continue;
    }
    const ends = u < v ? [[u, v]] : [[0, v], [u, 4]];
    const kept = [];
    for (const [lo, hi] of pieces) {
      for (const [from, to] of ends) {
        const piece = [lo > from ? lo : from, hi < to ? hi : to];
        if (piece[0] < piece[1]) kept.push(piece);
      }
    }
    if (kept.length === 0) return false;
    pieces = kept;
  }
  return true;
}

export const plain = {
  name: "double",

  incircle: (g) => sign(gap(rowsOf(g), 0)),

  exists(g) {
    const [j, k] = rowsOf(g);
    const xp = j.x * k.p0 - j.p0 * k.x, yp = j.y * k.p0 - j.p0 * k.y, sp = j.s * k.p0 - j.p0 * k.s;
    const xs = j.x * k.s - j.s * k.x, ys = j.y * k.s - j.s * k.y, xy = j.x * k.y - j.y * k.x;
    const square = xp * xp + yp * yp - sp * sp;
    const root = square > 0 ? sqrt(square) : 0;
    return sign(xp * xs + yp * ys + root * xy);
  },

  contact(g) {
    const [i, j] = g[0].letter === "d" ? g : [g[1], g[0]];
    if (i.letter !== "d") return { kind: "none", time: 0 };
    if (j.letter === "w") {
      const c = j.x * i.x + j.y * i.y - j.r - i.r;
      const b = j.x * i.vx + j.y * i.vy - i.vr;
      const fall = firstFall(0, b / 2, c);
      return fall.time === fall.time ? fall : null;
    }
    const inside = j.letter === "c";
    const x = j.x - i.x, y = j.y - i.y, vx = j.vx - i.vx, vy = j.vy - i.vy;
    const s = inside ? j.r - i.r : j.r + i.r, vs = inside ? -i.vr : j.vr + i.vr;
    const a = vx * vx + vy * vy - vs * vs;
    const b = x * vx + y * vy - s * vs;
    const c = x * x + y * y - s * s;
    let answer = inside ? firstFall(-a, -b, -c) : firstFall(a, b, c);
    if (inside && answer.kind !== "hit" && answer.time === answer.time) {
      // A disk never grazes its container from inside. It may fill it as it touches.
      answer = vs < 0 ? { kind: "hit", time: s / -vs } : { kind: "none", time: 0 };
    }
    return answer.time === answer.time ? answer : null;
  },

  // Looks at steps for changes of the sign. It misses zeros of even order, and pairs of zeros
  // between two steps; more steps take longer, and miss them, too.
  collapse(g, t0, t1) {
    const rows = rowsOf(g), at = (t) => gap(rows, t);
    const s0 = sign(at(t0)), zeros = [];
    let was = s0, touching = false, before = t0;
    if (!s0) return null;
    for (let i = 1; i <= STEPS; ++i) {
      const t = i === STEPS ? t1 : t0 + ((t1 - t0) * i) / STEPS;
      const now = sign(at(t));
      if (now === null) return null;
      if (now !== was) {
        const time = () => (now === 0 ? t : bisect(at, before, t, was > 0));
        if (!touching) zeros.push({ time: time(), sign: was });
        was = now || was;
        zeros[zeros.length - 1].sign = was;
      }
      touching = now === 0;
      before = t;
    }
    return { s0, zeros };
  },

  rootorder({ windows, ids, g }) {
    const [a, b] = windows.map(([lo, hi], i) => {
      return rootOf(cotangency(...ids[i].map((id) => g[id])), lo, hi);
    });
    return Number(a > b) - Number(a < b);
  },

  static(frame, disks) {
    const hidden = [], seen = [], pairs = [];
    disks.forEach((_, i) => (isHidden(frame, disks, i) ? hidden : seen).push(i));
    for (const i of seen) {
      const waves = [];
      for (const k of [...seen, -1]) {
        if (k === i) continue;
        const w = k >= 0 ? rowOf(disks[i], disks[k]) : frame ? rowOf(disks[i], frame) : null;
        if (w) waves.push({ k, a: w.x / w.p0, b: w.y / w.p0, c: w.s / w.p0 });
        else waves.push({ k, a: 0, b: 0, c: 0 });
      }
      for (const j of waves) {
        if (j.k < 0 ? !frame : j.k < i) continue;
        if (isNeighbour(waves, j)) pairs.push(j.k < 0 ? [-1, i] : [i, j.k]);
      }
    }
    return { pairs, hidden };
  },
};
