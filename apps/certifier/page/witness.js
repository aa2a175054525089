"use strict";
// The drawing of a fault, in doubles. No verdict uses it.

// The leg of generator g at t: the last that has begun.
function legAt(problem, g, t) {
  const legs = problem.legs[g + 1];
  let low = 0, high = legs.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t.less(legs[middle].start)) high = middle;
    else low = middle;
  }
  return legs[low];
}

// The circle that touches i, a disk, j and k counterclockwise; null where there is none.
function nearCircle(i, j, k) {
  const to = (o) => ({ x: o.x - i.x, y: o.y - i.y, r: o.r - i.r });
  const u = to(j), v = to(k), p = u.x * u.x + u.y * u.y - u.r * u.r, o = v.x * v.x + v.y * v.y - v.r * v.r;
  const xp = u.x * o - p * v.x, yp = u.y * o - p * v.y, sp = u.r * o - p * v.r, below = xp * xp + yp * yp;
  const eps = j.id === CONTAINER || k.id === CONTAINER ? 1 : -1, root = eps * Math.sqrt(Math.max(0, below - sp * sp));
  const nx = (-sp * xp + root * yp) / below, ny = (-sp * yp - root * xp) / below;
  const [d, power] = Math.abs(p) > Math.abs(o) ? [u, p] : [v, o];
  const away = power / (2 * (d.x * nx + d.y * ny + d.r)), radius = away - i.r;
  return radius >= 0 && Number.isFinite(radius) ? { x: i.x + away * nx, y: i.y + away * ny, radius } : null;
}

// { t, exactT, generators, named, circles }: all generators at the time of the witness, the ids that it names,
// and the circles of the vertices of its edge. Null where there is nothing to be drawn.
function drawingOf(problem, witness) {
  if (!witness || !problem || problem.legs.length === 0) return null;
  const { t } = witness, generators = [];
  for (let g = CONTAINER; g < problem.disks; ++g) {
    const leg = legAt(problem, g, t), [x, y] = leg.at(t).map((c) => c.near()), [vx, vy] = leg.velocity.map((c) => c.near());
    generators.push({ id: g, x, y, r: problem.radius(g).near(), vx, vy });
  }
  const { quad } = witness, at = (g) => generators[g + 1], circles = [];
  if (quad) {
    const [l, r, s, e] = quad;
    for (const triple of [[l, s, r], [l, r, e]]) {
      const ids = triple[0] === CONTAINER ? [triple[1], triple[2], triple[0]] : triple;
      const circle = nearCircle(...ids.map(at));
      if (circle) circles.push(circle);
    }
  }
  return { t: t.near(), exactT: t.toString(), generators, circles, named: [...new Set(quad ?? witness.pair ?? witness.disks)] };
}
