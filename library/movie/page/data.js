"use strict";
// The data of the page. Generators are numbered as sites here: 0 is the container, disk i is site i + 1. Lengths are in
// units of the container's radius, from its centre: canvases compute in binary32 and the formulas take sixth powers.

const FLIP = 0, COLLISION = 1, MANEUVER = 2;

class MovieData {
  // Decodes the elements that the program wrote into the document.
  constructor() {
    this.facts = JSON.parse(document.getElementById("movie-facts").textContent);
    this.frame = this.facts.container;  // the centre and the radius in the scene's units
    this.disks = new Float64Array(decoded("disks"));  // x, y, radius, vx, vy of each at the begin
    this.count = this.disks.length / 5;
    this.times = new Float64Array(decoded("times"));
    this.kinds = new Uint8Array(decoded("kinds"));
    this.velocities = new Float64Array(decoded("velocities"));
    this.initial = sites(decoded("initial"));  // l, r, s, e of each edge
    this.sites = sites(decoded("ids"));
    this.events = this.times.length;
    this.begin = this.facts.begin;
    this.end = this.facts.end;
    this.length = this.end - this.begin;
    this.normalize();
    this.index();
  }

  normalize() {
    const { x, y, radius } = this.frame;
    for (let k = 0; k < this.disks.length; k += 5) {
      this.disks[k] -= x;
      this.disks[k + 1] -= y;
    }
    for (const values of [this.disks, this.velocities]) {
      for (let k = 0; k < values.length; ++k) values[k] /= radius;
    }
    const report = this.facts.report;
    for (const g of report && report.evidence ? report.evidence.generators : []) {
      g.x = (g.x - x) / radius;
      g.y = (g.y - y) / radius;
      for (const name of ["vx", "vy", "radius"]) g[name] /= radius;
    }
  }

  // Where the sites and the velocities of each event begin.
  index() {
    this.siteStart = new Uint32Array(this.events + 1);
    this.velocityStart = new Uint32Array(this.events + 1);
    for (let k = 0; k < this.events; ++k) {
      const kind = this.kinds[k], at = this.siteStart[k];
      const length = kind === FLIP ? 4 : kind === COLLISION ? 2 : 1;
      const moved = kind === FLIP ? 0 : kind === COLLISION && this.sites[at] !== 0 ? 2 : 1;
      this.siteStart[k + 1] = at + length;
      this.velocityStart[k + 1] = this.velocityStart[k] + 2 * moved;
    }
  }

  sitesOf(event) {
    return this.sites.subarray(this.siteStart[event], this.siteStart[event + 1]);
  }

  // The number of events that have happened at time t, those at t included.
  happened(t) {
    return upperBound(this.times, t, 0, this.events);
  }

  // Which part of the time is over at t, from 0 to 1, and when such a part is.
  shareOf(t) {
    return this.length > 0 ? (t - this.begin) / this.length : 0;
  }
  timeAt(share) {
    return share >= 1 ? this.end : this.begin + Math.max(0, share) * this.length;
  }

  // The nearest time that is shown.
  within(t) {
    return Math.min(this.end, Math.max(this.begin, t));
  }

  // The event in words, with the program's names: the container is -1.
  nameOf(event) {
    const ids = Array.from(this.sitesOf(event), (site) => site - 1);
    if (this.kinds[event] === FLIP) return `flip [${ids.join(", ")}]`;
    if (this.kinds[event] === MANEUVER) return `maneuver of ${ids[0]}`;
    return ids[0] < 0 ? `${ids[1]} meets the wall` : `${ids[0]} meets ${ids[1]}`;
  }
}

// The bytes of one of the arrays; the text is given up afterwards.
function decoded(name) {
  const element = document.getElementById(`movie-${name}`);
  const text = atob(element.textContent);
  element.remove();
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes.buffer;
}

// Ids as sites: the container's 65535 wraps around to 0.
function sites(buffer) {
  const ids = new Uint16Array(buffer);
  for (let k = 0; k < ids.length; ++k) ++ids[k];
  return ids;
}

// The first index in [from, to) whose value is greater than x, or `to`.
function upperBound(values, x, from, to) {
  while (from < to) {
    const middle = (from + to) >> 1;
    if (values[middle] <= x) from = middle + 1;
    else to = middle;
  }
  return from;
}
