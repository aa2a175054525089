"use strict";
// Over the diagram: flashes of what has just happened, the event that is looked at, the path of
// the followed disk, and the evidence of a refutation.

class Overlays {
  constructor(painter) {
    this.painter = painter;
    const report = painter.data.facts.report;
    this.evidence = report && report.evidence ? report.evidence : null;
    if (this.evidence) this.chooseCircles();
  }

  // The triples of the evidence whose circles are shown: those that touch all its sites at its
  // time; where none does, all.
  chooseCircles() {
    const sites = this.evidenceSites(this.evidence.t), all = [], common = [];
    const first = sites.container ? 0 : 1, last = sites.x.length;
    for (let i = first; i < last; ++i) {
      for (let j = i + 1; j < last; ++j) {
        for (let k = j + 1; k < last; ++k) {
          for (const triple of [[i, j, k], [i, k, j]]) {
            const { x, y, radius } = tangentCircle(sites, ...triple);
            if (!(radius >= 0)) continue;
            all.push(triple);
            let off = 0;
            for (let g = first; g < last; ++g) {
              off = Math.max(off, Math.abs(gap(sites, g, x, y) - radius));
            }
            if (off < 1e-4 * radius) common.push(triple);
          }
        }
      }
    }
    this.triples = common.length > 0 ? common : all;
  }

  paint(state) {
    this.context = this.painter.context;
    this.unit = this.painter.unit;
    this.theme = this.painter.theme;
    this.reach = Math.min(14, Math.max(4, 0.3 * this.painter.spacing));  // reach of rings, in pixels
    if (state.follow !== null) this.paintPath(state.follow + 1, state);
    this.paintFlashes(state);
    if (state.selected !== null) this.paintSelected(state.selected);
    this.paintEvidence(state);
    this.context.globalAlpha = 1;
  }

  stroke(colour, width, alpha = 1) {
    this.context.globalAlpha = alpha;
    this.context.strokeStyle = colour;
    this.context.lineWidth = width * this.unit;
    this.context.stroke();
  }

  ring(x, y, radius) {
    this.context.beginPath();
    this.painter.circle(x, y, radius);
  }

  // Draws the events of the last moments, fading; moments are of the viewer's time.
  paintFlashes(state) {
    if (state.isStill) return;
    const { data } = this.painter;
    const most = 150;
    for (let event = state.applied - 1, k = 0; event >= 0 && k < most; --event, ++k) {
      const age = (state.t - data.times[event]) / state.flash;
      if (!(age < 1)) break;
      if (event === state.selected) continue;
      if (data.kinds[event] === FLIP) this.flashFlip(event, age);
      else this.flashTurn(event, age);
    }
  }

  flashFlip(event, age) {
    const { replay, curves, vertices } = this.painter;
    if (!replay.whole) return;
    const h = replay.halfOf[event], edge = h >> 1;
    if (curves.state[edge] === ABSENT) return;
    this.context.beginPath();
    curves.trace(this.context, h & ~1, false);
    this.stroke(this.theme.flip, 1.5 + 3 * (1 - age), 1 - age);
    if (this.painter.spacing < 16) return;  // too many rings
    this.ring((vertices.x[h] + vertices.x[h ^ 1]) / 2, (vertices.y[h] + vertices.y[h ^ 1]) / 2,
      (3 + this.reach * age) * this.unit);
    this.stroke(this.theme.flip, 1.6, 0.8 * (1 - age));
  }

  flashTurn(event, age) {
    const { motion, data } = this.painter;
    const colour = data.kinds[event] === COLLISION ? this.theme.hit : this.theme.turn;
    for (const site of data.sitesOf(event)) {
      if (site === 0) continue;
      this.ring(motion.x[site], motion.y[site], this.painter.drawnRadius(site));
      this.stroke(colour, 3 * (1 - age) + 0.5, 1 - age);
    }
    const [x, y] = this.contact(data.sitesOf(event));
    this.ring(x, y, (2 + 1.5 * this.reach * age) * this.unit);
    this.stroke(colour, 2.2 * (1 - age) + 0.4, 1 - age);
  }

  // Where two sites touch, or nearly; of one site its centre.
  contact(sites) {
    const { x, y, radius } = this.painter.motion;
    const [i, j] = sites;
    if (sites.length === 1) return [x[i], y[i]];
    const dx = x[j] - x[i], dy = y[j] - y[i], distance = Math.hypot(dx, dy) || 1;
    const from = i === 0 ? -radius[0] : radius[i];
    return [x[i] + from * dx / distance, y[i] + from * dy / distance];
  }

  paintSelected(event) {
    const { data, motion, replay } = this.painter;
    const sites = data.sitesOf(event), kind = data.kinds[event];
    const colour = kind === FLIP ? this.theme.flip : kind === COLLISION ? this.theme.hit
      : this.theme.turn;
    sites.forEach((site, k) => {
      this.ring(motion.x[site], motion.y[site],
        Math.abs(site === 0 ? motion.radius[0] : this.painter.drawnRadius(site)));
      this.stroke(kind === FLIP && k >= 2 ? this.theme.turn : colour, 2.6);
    });
    if (kind !== FLIP) {
      const [x, y] = this.contact(sites);
      this.ring(x, y, 7 * this.unit);
      this.stroke(colour, 2.4);
      return;
    }
    if (!replay.whole) return;
    // The circles of the two vertices of the new edge: one at the time of the flip.
    const half = replay.halfOf[event], { x, y, radius } = this.painter.vertices;
    this.context.setLineDash([5 * this.unit, 4 * this.unit]);
    for (const h of [half, half ^ 1]) {
      if (!(radius[h] >= 0)) continue;
      this.ring(x[h], y[h], radius[h]);
      this.stroke(this.theme.flip, 1.2, 0.9);
    }
    this.context.setLineDash([]);
    this.context.beginPath();
    this.painter.curves.trace(this.context, half & ~1, false);
    this.stroke(this.theme.flip, 3.5);
    this.ring((x[half] + x[half ^ 1]) / 2, (y[half] + y[half ^ 1]) / 2, 4.5 * this.unit);
    this.stroke(this.theme.flip, 2);
  }

  // Where the disk has been, fading, and where it will be, dotted.
  paintPath(site, state) {
    const { motion, data } = this.painter;
    const pieces = 24, length = Math.min(data.length, 60 * state.flash);
    for (let k = 0; k < pieces; ++k) {
      const from = state.t - length * (k + 1) / pieces, to = state.t - length * k / pieces;
      if (to <= data.begin) break;
      this.polyline(motion.path(site, Math.max(data.begin, from), to));
      this.stroke(this.theme.arrow, 2.4, 0.75 * (1 - k / pieces));
    }
    this.context.setLineDash([0.1 * this.unit, 5 * this.unit]);
    this.polyline(motion.path(site, state.t, Math.min(data.end, state.t + length / 2)));
    this.stroke(this.theme.arrow, 1.8, 0.75);
    this.context.setLineDash([]);
    this.ring(motion.x[site], motion.y[site], this.painter.drawnRadius(site));
    this.stroke(this.theme.arrow, 3);
  }

  polyline(points) {
    this.context.beginPath();
    this.context.moveTo(points[0], points[1]);
    for (let k = 2; k < points.length; k += 2) this.context.lineTo(points[k], points[k + 1]);
  }

  // The sites of the evidence on their true lines, and the circles that touch three of them: shown
  // around the time of the evidence.
  paintEvidence(state) {
    if (!this.evidence) return;
    const away = Math.abs(state.t - this.evidence.t) / (2 * state.flash);
    if (away >= 1) return;
    const alpha = 1 - away * away;
    const sites = this.evidenceSites(state.t);
    const first = sites.container ? 0 : 1, last = sites.x.length;
    for (let site = first; site < last; ++site) {
      this.ring(sites.x[site], sites.y[site],
        Math.max(3 * this.unit, Math.abs(sites.radius[site])));
      this.stroke(this.theme.refuted, 2.8, alpha);
    }
    this.context.setLineDash([6 * this.unit, 4 * this.unit]);
    const most = 2 * -this.painter.motion.radius[0];
    for (const triple of this.triples) {
      const { x, y, radius } = tangentCircle(sites, ...triple);
      if (!(radius >= 0 && radius < most)) continue;
      this.ring(x, y, radius);
      this.stroke(this.theme.refuted, 1.4, 0.9 * alpha);
    }
    this.context.setLineDash([]);
  }

  // In the form that tangentCircle() takes.
  evidenceSites(t) {
    const dt = t - this.evidence.t;
    const sites = { x: [0], y: [0], radius: [0], container: false };
    for (const g of this.evidence.generators) {
      const at = g.id < 0 ? 0 : sites.x.length;
      sites.x[at] = g.x + dt * g.vx;
      sites.y[at] = g.y + dt * g.vy;
      sites.radius[at] = g.radius;
      if (g.id < 0) sites.container = true;
    }
    return sites;
  }
}
