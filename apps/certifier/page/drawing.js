"use strict";
// The disks at the time of a fault, as SVG: all of them, or what is near the generators that the fault names.

const MOST_DRAWN = 4000;

// The circle that touches i, a disk, j and k counterclockwise; null where there is none.
function nearCircle(i, j, k) {
  const to = (o) => ({ x: o.x - i.x, y: o.y - i.y, r: o.r - i.r });
  const u = to(j), v = to(k), p = u.x * u.x + u.y * u.y - u.r * u.r, o = v.x * v.x + v.y * v.y - v.r * v.r;
  const xp = u.x * o - p * v.x, yp = u.y * o - p * v.y, sp = u.r * o - p * v.r, below = xp * xp + yp * yp;
  const eps = j.id < 0 || k.id < 0 ? 1 : -1, root = eps * Math.sqrt(Math.max(0, below - sp * sp));
  const nx = (-sp * xp + root * yp) / below, ny = (-sp * yp - root * xp) / below;
  const [d, power] = Math.abs(p) > Math.abs(o) ? [u, p] : [v, o];
  const away = power / (2 * (d.x * nx + d.y * ny + d.r)), radius = away - i.r;
  return radius >= 0 && Number.isFinite(radius) ? { x: i.x + away * nx, y: i.y + away * ny, radius } : null;
}

// Those of the two ends of the edge that is named, if one is.
function circlesOf({ generators, named }) {
  if (named.length !== 4) return [];
  const [l, r, s, e] = named.map((g) => generators[g + 1]), disk = (g) => g.id >= 0;
  const circle = (j, k) => (disk(l) ? nearCircle(l, j, k) : nearCircle(j, k, l));
  return [circle(s, r), circle(r, e)].filter((one) => one !== null);
}

class FaultDrawing {
  constructor(svg) {
    this.svg = svg;
    this.data = null;
    this.isWhole = false;
  }

  show(data) {
    this.data = { ...data, named: [...new Set(data.named)], circles: circlesOf(data) };
    this.isWhole = false;
    this.draw();
  }

  toggle() {
    this.isWhole = !this.isWhole;
    this.draw();
  }

  // { x, y, half }: a square around what is looked at.
  get view() {
    const { generators, named, circles } = this.data, [wall] = generators;
    const all = { x: wall.x, y: wall.y, half: -1.04 * wall.r };
    const near = named.filter((g) => g >= 0).map((g) => generators[g + 1]).map((d) => ({ x: d.x, y: d.y, radius: d.r }));
    const boxes = [...near, ...circles.filter((c) => c.radius < -wall.r)];
    if (this.isWhole || boxes.length === 0) return all;
    const ends = (name) => [Math.min(...boxes.map((b) => b[name] - b.radius)), Math.max(...boxes.map((b) => b[name] + b.radius))];
    const [left, right] = ends("x"), [low, high] = ends("y");
    const half = Math.max(0.62 * Math.max(right - left, high - low), -0.01 * wall.r);
    return half < all.half ? { x: (left + right) / 2, y: (low + high) / 2, half } : all;
  }

  element(name, attributes, parent = this.svg) {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    parent.append(node);
    return node;
  }

  // In units of the view, which are 1000 across; up is positive y.
  place({ x, y }) {
    const { view } = this;
    return { cx: (500 * (x - view.x)) / view.half + 500, cy: 500 - (500 * (y - view.y)) / view.half };
  }

  circle(of, radius, kind, title) {
    const node = this.element("circle", { ...this.place(of), r: (500 * radius) / this.view.half, class: kind });
    if (title) this.element("title", {}, node).textContent = title;
    return node;
  }

  draw() {
    const { generators, named, circles } = this.data, { half, x, y } = this.view, [wall, ...disks] = generators;
    this.svg.replaceChildren();
    this.circle(wall, -wall.r, named.includes(-1) ? "wall named" : "wall", "the container");
    const seen = disks.filter((d) => Math.max(Math.abs(d.x - x), Math.abs(d.y - y)) - d.r < half);
    const isNamed = (d) => named.includes(d.id);
    const others = seen.filter((d) => !isNamed(d)).slice(0, MOST_DRAWN);
    for (const d of others) this.disk(d, "disk");
    for (const c of circles) this.circle(c, c.radius, "tangent", "a circle that touches three of the generators");
    for (const d of disks.filter(isNamed)) this.disk(d, "disk named");
    if (this.isWhole ? disks.length <= 60 : others.length <= 60) for (const d of others) this.label(d, "label");
    for (const d of disks.filter(isNamed)) this.label(d, "label named");
    this.describe(seen.length, others.length + disks.filter(isNamed).length);
  }

  disk(d, kind) {
    const { half } = this.view, { cx, cy } = this.place(d);
    this.circle(d, Math.max(d.r, half / 160), kind, `disk ${d.id}`);
    if (!kind.includes("named")) return;
    // The way of the next moment: as long as a sixth of the picture for the fastest of the four.
    const fastest = Math.max(...this.data.named.map((g) => Math.hypot(this.data.generators[g + 1].vx, this.data.generators[g + 1].vy)));
    const u = (160 * d.vx) / fastest, v = (-160 * d.vy) / fastest, length = Math.hypot(u, v);
    if (!(length > 1)) return;
    const x = cx + u, y = cy + v, back = 22 / length, side = 9 / length;
    const head = [[x, y], [x - back * u + side * v, y - back * v - side * u], [x - back * u - side * v, y - back * v + side * u]];
    this.element("line", { x1: cx, y1: cy, x2: x - back * u, y2: y - back * v, class: "arrow" });
    this.element("polygon", { points: head.join(" "), class: "tip" });
  }

  label(d, kind) {
    const { cx, cy } = this.place(d);
    this.element("text", { x: cx, y: cy, class: kind }).textContent = d.id;
  }

  describe(seen, drawn) {
    const { t, named, circles } = this.data, names = named.map((g) => (g < 0 ? "the container" : `disk ${g}`));
    const list = names.length > 1 ? `${names.slice(0, -1).join(", ")} and ${names[names.length - 1]}` : names[0];
    const note = circles.length > 0 ? " Dashed: the circles of the edge's two ends." : "";
    const left = seen > drawn ? ` ${drawn} of ${seen} disks are drawn.` : "";
    this.words = `At t = ${Number(t.toPrecision(12))}: ${list}, with their velocities.${note}${left}`;
    this.svg.setAttribute("aria-label", this.words);
  }
}
