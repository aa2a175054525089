"use strict";
// The edges of the diagram as curves: arcs of hyperbolas between disks of different radii, of
// ellipses at the container, segments between disks of equal radii; as cubic Bezier curves.
//
// The bisector of a disk, the base, and another site is in polar coordinates about the base, with
// n a unit vector, d and s the differences of centres and of radii and p = d.d - s^2,
//
//   rho(n) = p / (2 (d.n + s))   where that is positive.
//
// Its tangents at the directions n -+ delta/2 meet in direction n at the distance
// tau = p / (2 (d.n + s cos(delta/2))); the arc between is the rational quadratic curve of the
// weight sqrt(rho rho') / tau over these three points (apps/draw/render.cpp does the same).

const REGULAR = 0;
const ILLEGAL = 1;  // its start vertex's circle contains a point of its end's third site
const ABSENT = 2;   // one of its vertices does not exist

class EdgeCurves {
  constructor(motion) {
    this.motion = motion;
    this.points = new Float64Array(1 << 12);
    this.used = 0;
    this.start = new Uint32Array(1);  // by edge, its begin in `points`: x, y, then triples of points
    this.state = new Uint8Array(0);
    this.irregular = 0;  // edges that are not regular
  }

  // The curves of all edges, within about `tolerance` of the true ones.
  compute(diagram, vertices, tolerance) {
    const edges = diagram.halves / 2;
    if (this.state.length !== edges) {
      this.state = new Uint8Array(edges);
      this.start = new Uint32Array(edges + 1);
    }
    this.used = 0;
    this.irregular = 0;
    this.tolerance = tolerance;
    for (let e = 0; e < edges; ++e) {
      this.start[e] = this.used;
      this.state[e] = this.append(diagram, vertices, 2 * e);
      if (this.state[e] !== REGULAR) ++this.irregular;
    }
    this.start[edges] = this.used;
  }

  append(diagram, vertices, h) {
    const t = h ^ 1;
    if (Number.isNaN(vertices.radius[h]) || Number.isNaN(vertices.radius[t])) return ABSENT;
    const x0 = vertices.x[t], y0 = vertices.y[t], x1 = vertices.x[h], y1 = vertices.y[h];
    this.put(x0, y0);
    const slack = 1e-7 * -this.motion.radius[0];
    if (gap(this.motion, diagram.apex(h), x0, y0) < vertices.radius[t] - slack) {
      this.line(x0, y0, x1, y1);
      return ILLEGAL;
    }
    // It runs counterclockwise around the site on its left, clockwise around that on its right.
    const l = diagram.org[h], r = diagram.org[t];
    const base = l !== 0 ? l : r, turn = l !== 0 ? 1 : -1;
    this.frame(base, l !== 0 ? r : l);
    const from = Math.atan2(y0 - this.cy, x0 - this.cx);
    let sweep = turn * (Math.atan2(y1 - this.cy, x1 - this.cx) - from);
    if (sweep < 0) sweep += 2 * Math.PI;
    // Ends closer than this coincide: rounding, not the edge, makes the rest of a turn.
    if (sweep > 2 * Math.PI - 1e-6) sweep -= 2 * Math.PI;
    this.arc(x0, y0, x1, y1, from, turn * sweep, 12);
    return REGULAR;
  }

  // The closed curve between the container and a disk that is alone.
  computeOnly() {
    this.used = 0;
    this.frame(1, 0);
    const at = (quarter) => {
      const angle = quarter * Math.PI / 2, rho = this.rho(Math.cos(angle), Math.sin(angle));
      return [this.cx + rho * Math.cos(angle), this.cy + rho * Math.sin(angle)];
    };
    this.put(...at(0));
    for (let quarter = 0; quarter < 4; ++quarter) {
      this.arc(...at(quarter), ...at((quarter + 1) % 4), quarter * Math.PI / 2, Math.PI / 2, 12);
    }
    this.state = new Uint8Array(1);
    this.start = Uint32Array.of(0, this.used);
  }

  frame(base, other) {
    const { x, y, radius } = this.motion;
    this.cx = x[base];
    this.cy = y[base];
    this.dx = x[other] - this.cx;
    this.dy = y[other] - this.cy;
    this.s = radius[other] - radius[base];
    this.p = this.dx * this.dx + this.dy * this.dy - this.s * this.s;
  }

  rho(nx, ny) {
    return this.p / (2 * (this.dx * nx + this.dy * ny + this.s));
  }

  arc(x0, y0, x1, y1, from, sweep, halvings) {
    const nx = Math.cos(from + sweep / 2), ny = Math.sin(from + sweep / 2);
    const rho = this.rho(nx, ny);
    if (halvings === 0 || !(rho > 0 && rho < Infinity)) {
      this.line(x0, y0, x1, y1);
      return;
    }
    const mx = this.cx + rho * nx, my = this.cy + rho * ny;  // on the arc
    if (Math.abs(sweep) < Math.PI / 2) {
      const ax = (x0 + x1) / 2, ay = (y0 + y1) / 2;
      if (Math.hypot(mx - ax, my - ay) < this.tolerance) {
        this.line(x0, y0, x1, y1);
        return;
      }
      const tau = this.p / (2 * (this.dx * nx + this.dy * ny + this.s * Math.cos(sweep / 2)));
      const weight = Math.sqrt(Math.hypot(x0 - this.cx, y0 - this.cy) *
        Math.hypot(x1 - this.cx, y1 - this.cy)) / tau;
      if (tau > 0 && Math.abs(sweep) < 1.2 && weight < Infinity) {
        const tx = this.cx + tau * nx, ty = this.cy + tau * ny;
        const pull = 4 * weight / (3 * (1 + weight));
        this.cubic(x0 + pull * (tx - x0), y0 + pull * (ty - y0),
          x1 + pull * (tx - x1), y1 + pull * (ty - y1), x1, y1);
        return;
      }
    }
    this.arc(x0, y0, mx, my, from, sweep / 2, halvings - 1);
    this.arc(mx, my, x1, y1, from + sweep / 2, sweep / 2, halvings - 1);
  }

  put(x, y) {
    if (this.used + 8 > this.points.length) {
      const larger = new Float64Array(2 * this.points.length);
      larger.set(this.points);
      this.points = larger;
    }
    this.points[this.used++] = x;
    this.points[this.used++] = y;
  }

  // A line is a cubic whose control points are its ends.
  line(x0, y0, x1, y1) {
    this.cubic(x0, y0, x1, y1, x1, y1);
  }

  cubic(ax, ay, bx, by, x1, y1) {
    this.put(ax, ay);
    this.put(bx, by);
    this.put(x1, y1);
  }

  // Adds the edge to a path, forwards for its half-edge 2e and backwards for its twin; `joined`
  // where the path already ends at its first point.
  trace(path, h, joined) {
    const points = this.points, from = this.start[h >> 1], to = this.start[(h >> 1) + 1];
    if (to === from) return;
    if ((h & 1) === 0) {
      if (!joined) path.moveTo(points[from], points[from + 1]);
      for (let k = from + 2; k < to; k += 6) {
        if (points[k] === points[k - 2] && points[k + 1] === points[k - 1]) {
          path.lineTo(points[k + 4], points[k + 5]);
        } else {
          path.bezierCurveTo(points[k], points[k + 1], points[k + 2], points[k + 3],
            points[k + 4], points[k + 5]);
        }
      }
      return;
    }
    if (!joined) path.moveTo(points[to - 2], points[to - 1]);
    for (let k = to - 6; k > from; k -= 6) {
      if (points[k] === points[k - 2] && points[k + 1] === points[k - 1]) {
        path.lineTo(points[k - 2], points[k - 1]);
      } else {
        path.bezierCurveTo(points[k + 2], points[k + 3], points[k], points[k + 1],
          points[k - 2], points[k - 1]);
      }
    }
  }
}
