"use strict";
// A disk over the whole time: its gaps to its neighbours, the least of them as a line, and how many it has.

const PLOT_SAMPLES = 240;

class DiskPlot {
  constructor(canvas, data, motion, replay) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.data = data;
    this.motion = motion;
    this.replay = replay;
    this.disk = null;
  }

  listen(seek) {
    this.canvas.addEventListener("pointerdown", (event) => {
      const share = (event.offsetX - this.left) / Math.max(1, this.canvas.clientWidth - this.left - 6);
      seek(this.data.timeAt(share));
    });
  }

  get left() {
    return 40;
  }

  // Samples [t, gaps] of the disk, at instants spread over the whole time. The replay stands afterwards where it stood.
  compute(disk) {
    const { data, replay, motion } = this, { applied } = replay, samples = [];
    for (let k = 0; k <= PLOT_SAMPLES; ++k) {
      const t = data.timeAt(k / PLOT_SAMPLES);
      replay.moveTo(data.happened(t));
      if (!replay.whole) break;
      motion.moveTo(t);
      const around = data.count > 1 ? new Set(replay.diagram.neighbours(disk + 1)) : new Set([0]);
      samples.push({ t, gaps: Array.from(around, (other) => this.gap(disk + 1, other)) });
    }
    replay.moveTo(applied);
    this.disk = disk;
    this.samples = samples;
  }

  // In the scene's units.
  gap(site, other) {
    const { x, y, radius } = this.motion, unit = this.data.frame.radius;
    const distance = Math.hypot(x[site] - x[other], y[site] - y[other]);
    return unit * (other === 0 ? -radius[0] - radius[site] - distance : distance - radius[site] - radius[other]);
  }

  // Draws the plot of the disk, at the time t, in the colours of the theme.
  paint(disk, t, theme) {
    if (this.disk !== disk) this.compute(disk);
    const { canvas, context, samples } = this, pixels = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    canvas.width = Math.round(width * pixels);
    canvas.height = Math.round(height * pixels);
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    if (samples.length === 0) return;
    const least = samples.map(({ gaps }) => Math.max(0, Math.min(...gaps)));
    const counts = samples.map(({ gaps }) => gaps.length);
    const mostGap = Math.max(...least, 1e-300) * 1.6, mostCount = Math.max(...counts);
    const x = (at) => this.left + this.data.shareOf(at) * (width - this.left - 6);
    const split = Math.round(0.66 * height), gapY = (gap) => split - 6 - (gap / mostGap) * (split - 14);
    const countY = (count) => height - 5 - (count / mostCount) * (height - split - 14);
    this.paintAxes(theme, width, split, height, mostGap, mostCount, gapY, countY);
    context.fillStyle = theme.label;
    context.globalAlpha = 0.45;
    for (const { t: at, gaps } of samples) {
      for (const gap of gaps) if (gap <= mostGap) context.fillRect(x(at) - 0.6, gapY(Math.max(0, gap)) - 0.6, 1.2, 1.2);
    }
    context.globalAlpha = 1;
    this.line(samples.map(({ t: at }, k) => [x(at), gapY(least[k])]), theme.hit);
    this.line(samples.flatMap(({ t: at }, k) => [[x(at), countY(counts[Math.max(0, k - 1)])], [x(at), countY(counts[k])]]), theme.flip);
    context.fillStyle = theme.label;
    context.fillRect(x(t) - 0.5, 4, 1, height - 6);
    this.describe(least, counts);
  }

  line(points, colour) {
    const { context } = this;
    context.strokeStyle = colour;
    context.lineWidth = 1.6;
    context.lineJoin = "round";
    context.beginPath();
    points.forEach(([x, y], k) => (k === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
    context.stroke();
  }

  paintAxes(theme, width, split, height, mostGap, mostCount, gapY, countY) {
    const { context } = this;
    context.clearRect(0, 0, width, height);
    context.font = '10px system-ui, "DejaVu Sans", sans-serif';
    context.textAlign = "right";
    context.textBaseline = "middle";
    const step = roundStep(mostGap / 2.2), ticks = [0, step, 2 * step].filter((gap) => gap < mostGap);
    for (const gap of ticks) this.tick(theme, width, gapY(gap), String(short(gap)));
    for (const count of new Set([0, mostCount])) this.tick(theme, width, countY(count), String(count));
  }

  tick(theme, width, y, words) {
    const { context } = this;
    context.fillStyle = theme.label;
    context.globalAlpha = 0.2;
    context.fillRect(this.left, y, width - this.left - 6, 1);
    context.globalAlpha = 1;
    context.fillText(words, this.left - 5, y);
  }

  describe(least, counts) {
    const at = least.indexOf(Math.min(...least)), few = Math.min(...counts), many = Math.max(...counts);
    const words = `Above: its least gap (line) and those to all neighbours, at ${least.length} times; the least of all, `
      + `${short(least[at])}, at t = ${short(this.samples[at].t)}. Below: its neighbours, ${few === many ? few : `${few} to ${many}`}.`;
    text("plot-words", words);
    this.canvas.setAttribute("aria-label", words);
  }
}
