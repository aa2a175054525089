"use strict";
// The diagram at one instant on the canvas. What it says of events is in overlays.js.

class Painter {
  constructor(canvas, data, motion, replay, view) {
    this.context = canvas.getContext("2d");
    this.data = data;
    this.motion = motion;
    this.replay = replay;
    this.view = view;
    this.vertices = new Vertices(motion);
    this.curves = new EdgeCurves(motion);
    this.colours = new Colours(data, replay, motion);
    this.overlays = new Overlays(this);
    this.readTheme();
  }

  readTheme() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    this.theme = {
      room: colour("room"), ink: colour("edge"), rim: colour("rim"), arrow: colour("arrow"),
      flip: colour("flip"), hit: colour("hit"), turn: colour("turn"), refuted: colour("refuted"),
      label: colour("label"), halo: colour("card"),
      cell: Number(colour("cell-share")),
    };
  }

  // `state` is the player's.
  paint(state) {
    const { context, view, motion, replay } = this;
    view.fit();
    this.unit = 1 / view.scale;  // a CSS pixel in the plane
    motion.moveTo(state.t);
    replay.moveTo(state.applied);
    this.computeEdges();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, view.canvas.width, view.canvas.height);
    view.apply(context);
    context.lineJoin = context.lineCap = "round";
    this.spacing = -motion.radius[0] / Math.sqrt(motion.sites) * view.scale;
    this.stroke = Math.min(1.6, Math.max(0.5, 0.03 * this.spacing)) * this.unit;
    this.paintRoom();
    const colours = this.colours.choose(state.colours);
    const near = this.nearFollowed(state.follow);
    if (this.hasEdges && state.colours !== "none") this.paintCells(colours, near, state.follow);
    if (state.dual) this.paintDual();
    this.paintEdges();
    this.paintDisks(colours, near);
    if (state.velocities) this.paintVelocities();
    this.overlays.paint(state);
    if (state.labels && this.spacing > 26) this.paintLabels();
  }

  computeEdges() {
    const { curves, replay, data } = this;
    this.hasEdges = replay.whole && data.count > 0;
    curves.irregular = 0;
    if (!this.hasEdges) return;
    const tolerance = 0.2 * this.unit;
    curves.tolerance = tolerance;
    if (data.count === 1) {
      curves.computeOnly();
      return;
    }
    this.vertices.compute(replay.diagram);
    curves.compute(replay.diagram, this.vertices, tolerance);
  }

  // The followed site and its neighbours; null where none is followed.
  nearFollowed(follow) {
    if (follow === null || !this.replay.whole) return null;
    return new Set([follow + 1, ...this.replay.diagram.neighbours(follow + 1)]);
  }

  circle(x, y, radius) {
    this.context.moveTo(x + radius, y);
    this.context.arc(x, y, radius, 0, 2 * Math.PI);
  }

  paintRoom() {
    const { context, motion } = this;
    context.beginPath();
    this.circle(motion.x[0], motion.y[0], -motion.radius[0]);
    context.fillStyle = this.theme.room;
    context.fill();
  }

  // Adds the boundary of the site's cell to the path.
  traceCell(site) {
    const { context, curves, replay } = this;
    if (this.data.count === 1) {
      curves.trace(context, 0, false);
      return;
    }
    const diagram = replay.diagram, first = diagram.anchor[site];
    let h = first, joined = false;
    do {
      curves.trace(context, h, joined);
      joined = joined || curves.state[h >> 1] !== ABSENT;
      h = diagram.rotate(h);
    } while (h !== first);
    context.closePath();
  }

  paintCells(colours, near, follow) {
    const { context, theme } = this;
    const index = this.colours.index;
    const share = (site) =>
      !near ? 1 : site === follow + 1 ? 2.1 : near.has(site) ? 1.3 : 0.4;
    // One path a colour and share: filling is what costs.
    const groups = new Map();
    for (let site = 1; site < index.length; ++site) {
      const key = `${index[site]} ${share(site)}`;
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(site);
    }
    for (const members of groups.values()) {
      context.beginPath();
      for (const site of members) this.traceCell(site);
      context.fillStyle = css(colours[index[members[0]]],
        Math.min(0.95, theme.cell * share(members[0])));
      context.fill();
    }
  }

  paintDual() {
    const { context, motion, replay } = this;
    if (!replay.whole || this.data.count < 2) return;
    const diagram = replay.diagram;
    context.beginPath();
    for (let h = 0; h < diagram.halves; h += 2) {
      const a = diagram.org[h], b = diagram.org[h + 1];
      if (a === 0 || b === 0) continue;
      context.moveTo(motion.x[a], motion.y[a]);
      context.lineTo(motion.x[b], motion.y[b]);
    }
    context.strokeStyle = this.theme.turn;
    context.globalAlpha = 0.55;
    context.lineWidth = 0.8 * this.unit;
    context.stroke();
    context.globalAlpha = 1;
  }

  paintEdges() {
    const { context, curves, motion, theme } = this;
    if (this.hasEdges) {
      this.strokeEdges(REGULAR, theme.ink, this.stroke);
      if (curves.irregular > 0) this.strokeEdges(ILLEGAL, theme.refuted, 2 * this.stroke);
    }
    context.beginPath();
    this.circle(motion.x[0], motion.y[0], -motion.radius[0]);
    context.strokeStyle = theme.ink;
    context.lineWidth = 2 * this.unit;
    context.stroke();
  }

  strokeEdges(state, colour, width) {
    const { context, curves } = this;
    context.beginPath();
    for (let e = 0; e < curves.state.length; ++e) {
      if (curves.state[e] === state) curves.trace(context, 2 * e, false);
    }
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke();
  }

  // The radius that a disk is drawn with: points are dots.
  drawnRadius(site) {
    return Math.max(this.motion.radius[site], 1.6 * this.unit);
  }

  paintDisks(colours, near) {
    const { context, motion } = this;
    const index = this.colours.index;
    context.strokeStyle = this.theme.rim;
    context.lineWidth = 0.8 * this.stroke;
    for (const faded of near ? [true, false] : [false]) {
      context.globalAlpha = faded ? 0.45 : 1;
      for (let colour = 0; colour < colours.length; ++colour) {
        context.beginPath();
        for (let site = 1; site < index.length; ++site) {
          if (index[site] !== colour || (near && near.has(site) === faded)) continue;
          this.circle(motion.x[site], motion.y[site], this.drawnRadius(site));
        }
        context.fillStyle = css(colours[colour]);
        context.fill();
        context.stroke();
      }
    }
    context.globalAlpha = 1;
  }

  // From the rims outwards, all to one scale: twice the typical speed is most of the typical
  // distance.
  paintVelocities() {
    const { context, motion, unit } = this;
    const reach = 0.42 * this.spacing * unit / this.colours.speed;
    const head = Math.min(6, 0.12 * this.spacing) * unit;
    context.beginPath();
    for (let site = 1; site < motion.sites; ++site) {
      const speed = Math.hypot(motion.vx[site], motion.vy[site]);
      if (speed === 0) continue;
      const ux = motion.vx[site] / speed, uy = motion.vy[site] / speed;
      const from = this.drawnRadius(site), to = from + reach * speed;
      const x = motion.x[site] + to * ux, y = motion.y[site] + to * uy;
      context.moveTo(motion.x[site] + from * ux, motion.y[site] + from * uy);
      context.lineTo(x, y);
      for (const side of [0.45, -0.45]) {
        context.moveTo(x - head * (ux - side * uy), y - head * (uy + side * ux));
        context.lineTo(x, y);
      }
    }
    context.strokeStyle = this.theme.arrow;
    context.lineWidth = Math.min(1.4, 0.04 * this.spacing) * unit;
    context.stroke();
  }

  paintLabels() {
    const { context, motion, view, theme } = this;
    context.setTransform(view.pixels, 0, 0, view.pixels, 0, 0);
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (let site = 1; site < motion.sites; ++site) {
      const [x, y] = view.canvasPoint(motion.x[site], motion.y[site]);
      const radius = this.drawnRadius(site) * view.scale;
      const inside = radius > 9, size = inside ? Math.min(16, Math.max(10, 0.8 * radius)) : 10;
      context.font = `600 ${size}px system-ui, "DejaVu Sans", sans-serif`;
      context.lineWidth = 3;
      context.strokeStyle = theme.halo;
      context.fillStyle = inside ? "#fff" : theme.label;
      const at = inside ? y : y + radius + 8;
      if (!inside) context.strokeText(site - 1, x, at);
      context.fillText(site - 1, x, at);
    }
    view.apply(context);
  }

  // The disk at a point of the plane or, failing that, the one whose cell has it; null without.
  diskAt(x, y) {
    let best = null, least = Infinity;
    for (let site = 1; site < this.motion.sites; ++site) {
      const distance = gap(this.motion, site, x, y);
      if (distance < least) {
        least = distance;
        best = site - 1;
      }
    }
    return gap(this.motion, 0, x, y) < Math.min(0, least) ? null : best;
  }
}
