"use strict";
// Whether a diagram is right at one time: circles exist and are empty, and each cell winds once (docs/kernel.md,
// section 8).

// A direction (x + x' w, y + y' w) with w the root of gamma.
class Direction {
  // From generator g to its vertex [g,j,k]: n N; for the container 2 h (c - O) + n N.
  constructor(g, j, k, ofWall, withWall) {
    const circle = ofWall ? new Circle(j, k, g) : new Circle(g, j, k), eps = ofWall || withWall ? 1n : -1n;
    const [xp, yp, sp, xs, ys, xy] = ["xp", "yp", "sp", "xs", "ys", "xy"].map((name) => circle[name][0]);
    this.gamma = circle.gamma[0];
    this.x = [-sp * xp, eps * yp];
    this.y = [-sp * yp, -eps * xp];
    if (!ofWall) return;
    const h = [2n * (xp * xs + yp * ys), -2n * xy], dx = j[0][0] - g[0][0], dy = j[1][0] - g[1][0];
    this.x = this.x.map((c, i) => c + h[i] * dx);
    this.y = this.y.map((c, i) => c + h[i] * dy);
  }

  // Whether it is in the lower half plane, from the negative x axis to before the positive one.
  get isLower() {
    const sign = signWithRoot(...this.y, this.gamma);
    return sign < 0 || (sign === 0 && signWithRoot(...this.x, this.gamma) < 0);
  }

  // The sign of this x other: of p + q sqrt(c) with p and q of the form u + v sqrt(g).
  turnTo(other) {
    const g = this.gamma, c = other.gamma;
    const [p, q] = [0, 1].map((i) => [0, 1].map((n) => this.x[n] * other.y[i] - this.y[n] * other.x[i]));
    const a = signWithRoot(...p, g), b = c === 0n ? 0 : signWithRoot(...q, g);
    if (a === b || b === 0) return a;
    if (a === 0) return b;
    const norm = ([u, v]) => [u * u + v * v * g, 2n * u * v];
    const [first, second] = [norm(p), norm(q)];
    return a * signWithRoot(first[0] - c * second[0], first[1] - c * second[1], g);
  }
}

// Whether one disk lies inside the other, or outside the container. (Where they touch from inside, the vertices of a
// point coincide.)
function isHidden(i, j, a, b) {
  const sign = signOf(tangency(apart(a, b))[0]);
  return i === CONTAINER || j === CONTAINER ? sign > 0 : sign < 0;
}

// Around a generator the directions to its vertices turn once: one step falls back in angle. False where there are no
// vertices, as of it and those around it one lies inside another.
function checkCell(walk, g, t) {
  const { diagram } = walk, vertices = [], first = diagram.spokes[g + 1][0];
  let k = first;
  do {
    // The end vertex [g, r, e]; the next spoke counterclockwise is that of e.
    const [, r, , e] = diagram.leaving(k, g), sites = sitesOf([g, r, e].map((id) => walk.leg(id)), [t]);
    if (isHidden(g, r, sites[0], sites[1]) || isHidden(r, e, sites[1], sites[2])) return false;
    vertices.push(new Direction(...sites, g === CONTAINER, r === CONTAINER || e === CONTAINER));
    k = diagram.nextSpoke(k, g);
  } while (k !== first);
  if (g === CONTAINER) vertices.reverse();  // clockwise around the container
  let falls = 0, moves = false;
  vertices.forEach((a, n) => {
    const b = vertices[(n + 1) % vertices.length];
    // Angles from 0 to 2 pi: the lower half plane follows the upper.
    const step = a.isLower !== b.isLower ? (a.isLower ? -1 : 1) : a.turnTo(b);
    if (step < 0) ++falls;
    if (step !== 0) moves = true;
  });
  const cell = `the vertices around generator ${g}`, witness = { t, disks: [g] };
  if (!moves) undecided(`${cell} coincide`, witness);
  if (falls !== 1) refute(`wrong diagram: ${cell} turn ${falls} times`, witness);
  return true;
}

function checkInitial(walk) {
  walk.diagram.edges.forEach((quad, k) => {
    const now = walk.edge(k).at(ZERO), name = `edge ${quadName(quad)}`, witness = { t: ZERO, quad: [...quad] };
    for (const isStart of [true, false]) {
      const exists = now.exists(isStart);
      if (exists === 0) undecided("a point touches another generator at the start", witness);
      if (exists < 0) refute(`wrong initial diagram: a circle of ${name} does not exist`, witness);
      if (quad[2] !== quad[3] && now.incircle(isStart) < 0) {
        refute(`wrong initial diagram: ${name} is not legal`, witness);
      }
    }
  });
  for (let g = CONTAINER; g < walk.problem.disks; ++g) checkCell(walk, g, ZERO);
}
