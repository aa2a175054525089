"use strict";
// The strip below the picture: how much happens when, what of it is proved, and where the player
// stands. Dragging on it seeks.

class Timeline {
  constructor(canvas, data, replay) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.data = data;
    this.replay = replay;
    this.bins = null;
  }

  listen(seek, hint) {
    const at = (event) => {
      const share = (event.offsetX - this.left) / Math.max(1, this.width - 2 * this.left);
      return this.data.timeAt(share);
    };
    this.canvas.addEventListener("pointerdown", (event) => {
      if (event.isTrusted) this.canvas.setPointerCapture(event.pointerId);
      seek(at(event));
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) seek(at(event));
      hint(at(event));
    });
    this.canvas.addEventListener("pointerleave", () => hint(null));
    this.canvas.addEventListener("keydown", (event) => {
      const steps = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (steps === undefined) return;
      event.preventDefault();
      seek(this.data.timeAt(this.data.shareOf(Number(this.canvas.getAttribute("aria-valuenow"))) + steps / 100));
    });
  }

  // Room at both ends, so that the head is seen there.
  get left() {
    return 10;
  }

  place(t) {
    return this.left + this.data.shareOf(t) * (this.width - 2 * this.left);
  }

  fit() {
    const pixels = window.devicePixelRatio || 1;
    const width = Math.max(1, this.canvas.clientWidth), height = this.canvas.clientHeight;
    if (this.width === width && this.pixels === pixels && this.bins) return;
    this.width = width;
    this.height = height;
    this.pixels = pixels;
    this.canvas.width = Math.round(width * pixels);
    this.canvas.height = Math.round(height * pixels);
    this.count();
  }

  // Events by their kinds in bins of three pixels.
  count() {
    const { data } = this;
    const bins = Math.max(1, Math.floor((this.width - 2 * this.left) / 3));
    this.bins = [FLIP, COLLISION, MANEUVER].map(() => new Uint32Array(bins));
    for (let k = 0; k < data.events; ++k) {
      const bin = Math.min(bins - 1, Math.floor(data.shareOf(data.times[k]) * bins));
      ++this.bins[data.kinds[k]][bin];
    }
    this.most = this.bins.reduce((most, values) => values.reduce((a, b) => Math.max(a, b), most), 1);
  }

  // The canvas is a slider to who does not see it.
  describe(t) {
    const { canvas, data } = this;
    canvas.setAttribute("aria-valuemin", data.begin);
    canvas.setAttribute("aria-valuemax", data.end);
    canvas.setAttribute("aria-valuenow", t);
    canvas.setAttribute("aria-valuetext", `t = ${Number(t.toPrecision(6))} of ${data.end}`);
  }

  paint(t, theme) {
    this.fit();
    const { context } = this;
    context.setTransform(this.pixels, 0, 0, this.pixels, 0, 0);
    context.clearRect(0, 0, this.width, this.height);
    this.paintBins(theme, t);
    this.paintVerdict(theme);
    this.paintTicks(theme);
    const x = this.place(t);
    context.fillStyle = theme.ink;
    context.fillRect(x - 1, 0, 2, this.height - 12);
    context.beginPath();
    context.arc(x, this.band + 3, 6, 0, 2 * Math.PI);
    context.fill();
    context.fillStyle = theme.halo;
    context.beginPath();
    context.arc(x, this.band + 3, 2.5, 0, 2 * Math.PI);
    context.fill();
  }

  // The height at which the band of verdicts lies: flips are above it, all else below.
  get band() {
    return Math.round(0.55 * (this.height - 14));
  }

  // Heights are square roots of numbers: few events are seen beside many.
  paintBins(theme, t) {
    const { context, band } = this;
    const step = (this.width - 2 * this.left) / this.bins[FLIP].length;
    const below = this.height - 14 - band - 8;
    const now = this.place(t);
    for (const kind of [FLIP, MANEUVER, COLLISION]) {
      const values = this.bins[kind], up = kind === FLIP;
      context.fillStyle = [theme.flip, theme.hit, theme.turn][kind];
      for (let bin = 0; bin < values.length; ++bin) {
        if (values[bin] === 0) continue;
        const share = Math.sqrt(values[bin] / this.most), x = this.left + bin * step;
        const height = Math.max(2, share * ((up ? band : below) - 2));
        context.globalAlpha = x <= now ? 0.85 : 0.35;
        context.fillRect(x, up ? band - 1 - height : band + 7, step - 0.7, height);
      }
    }
    context.globalAlpha = 1;
  }

  paintVerdict(theme) {
    const { context, band, data } = this;
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    const stretch = (from, to, fill) => {
      context.fillStyle = fill;
      context.fillRect(this.place(from), band, this.place(to) - this.place(from), 6);
    };
    const report = data.facts.report;
    stretch(data.begin, data.end, report ? colour("undecided") : colour("line"));
    if (report) {
      const proved = data.within(report.prefixT);
      if (report.verdict === "REFUTED") stretch(proved, data.end, theme.refuted);
      stretch(data.begin, proved, colour("certified"));
      if (report.fault) this.mark(data.within(report.fault.t), theme.refuted);
    }
    if (!this.replay.fault) return;
    const event = this.replay.broken - 1;
    this.mark(event < 0 ? data.begin : data.times[event], theme.refuted);
  }

  // A small flag.
  mark(t, colour) {
    const { context } = this, x = this.place(t);
    context.fillStyle = colour;
    context.fillRect(x - 1, 0, 2, this.height - 14);
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x + 9, 4.5);
    context.lineTo(x, 9);
    context.fill();
  }

  paintTicks(theme) {
    const { context, data } = this;
    if (!(data.length > 0)) return;
    const step = roundStep(data.length * 90 / this.width);
    context.fillStyle = theme.label;
    context.font = '10px system-ui, "DejaVu Sans", sans-serif';
    context.textAlign = "center";
    context.textBaseline = "bottom";
    for (let k = Math.ceil(data.begin / step - 1e-9); k * step <= data.end + 1e-9 * data.length; ++k) {
      const x = this.place(k * step);
      context.globalAlpha = 0.35;
      context.fillRect(x - 0.5, this.height - 14, 1, 3);
      context.globalAlpha = 0.75;
      const label = String(Number((k * step).toPrecision(6)));
      const half = context.measureText(label).width / 2;
      context.fillText(label, Math.min(x, this.width - half - 1), this.height);
    }
    context.globalAlpha = 1;
  }
}

// The least of 1, 2, 5, 10, ... times a power of ten that is at least x.
function roundStep(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  return [1, 2, 5, 10].map((digit) => digit * power).find((step) => step >= x * (1 - 1e-9));
}
