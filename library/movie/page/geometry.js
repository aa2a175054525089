"use strict";
// Vertices of the diagram: the circles that touch three sites, from the formulas of
// exact/predicates.h in doubles. For drawing only: nothing rests on them.

class Vertices {
  constructor(motion) {
    this.motion = motion;
    this.x = new Float64Array(0);  // by half-edge: the vertex of the triangle on its left
    this.y = new Float64Array(0);
    this.radius = new Float64Array(0);  // NaN where there is no such circle
  }

  // All vertices of the diagram, the disks being where `motion` has them.
  compute(diagram) {
    const halves = diagram.halves, next = diagram.next, org = diagram.org;
    if (this.x.length !== halves) {
      this.x = new Float64Array(halves);
      this.y = new Float64Array(halves);
      this.radius = new Float64Array(halves);
    }
    for (let a = 0; a < halves; ++a) {
      const b = next[a], c = next[b];
      if (a > b || a > c) continue;
      const circle = tangentCircle(this.motion, org[a], org[b], org[c]);
      for (const h of [a, b, c]) {
        this.x[h] = circle.x;
        this.y[h] = circle.y;
        this.radius[h] = circle.radius;
      }
    }
  }
}

// The circle that the sites touch counterclockwise in this order; its radius is NaN where there is
// none. The container, site 0, may be one of them. Returns the same object each time.
const tangentCircle = (() => {
  const circle = { x: 0, y: 0, radius: 0 };
  return (motion, i, j, k) => {
    if (i === 0) [i, j, k] = [j, k, i];
    const { x, y, radius } = motion;
    const jx = x[j] - x[i], jy = y[j] - y[i], js = radius[j] - radius[i];
    const kx = x[k] - x[i], ky = y[k] - y[i], ks = radius[k] - radius[i];
    const jp = jx * jx + jy * jy - js * js, kp = kx * kx + ky * ky - ks * ks;
    const xp = jx * kp - jp * kx, yp = jy * kp - jp * ky, sp = js * kp - jp * ks;
    const xs = jx * ks - js * kx, ys = jy * ks - js * ky, xy = jx * ky - jy * kx;
    const norm = xp * xp + yp * yp;
    const root = Math.sqrt(Math.max(0, norm - sp * sp)) * (j === 0 || k === 0 ? -1 : 1);
    const kappa = 2 * (xp * xs + yp * ys + root * xy);
    circle.x = x[i] + (-yp * root - sp * xp) / kappa;
    circle.y = y[i] + (xp * root - sp * yp) / kappa;
    circle.radius = kappa > 0 ? norm / kappa - radius[i] : NaN;
    return circle;
  };
})();

// Distance of a point to a site: to the container from inside.
function gap(motion, site, px, py) {
  const distance = Math.hypot(px - motion.x[site], py - motion.y[site]);
  return site === 0 ? -motion.radius[0] - distance : distance - motion.radius[site];
}
