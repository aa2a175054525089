"use strict";
// The colours of the drawing.

// A number of a colour for each site, different for disks that are neighbours in the diagram as
// far as eight colours do.
function colouring(diagram) {
  const colours = new Uint8Array(diagram.sites);
  const done = new Uint8Array(diagram.sites);
  for (let site = 1; site < diagram.sites; ++site) {
    const used = new Set();
    for (const other of diagram.neighbours(site)) if (done[other]) used.add(colours[other]);
    let colour = (site - 1) % 8;
    for (let tries = 0; used.has(colour) && tries < 8; ++tries) colour = (colour + 1) % 8;
    colours[site] = colour;
    done[site] = 1;
  }
  return colours;
}

// The ways of colouring cells; each gives every site an index into its list of colours.
class Colours {
  constructor(data, replay, motion) {
    this.replay = replay;
    this.motion = motion;
    this.palette = data.facts.palette;
    this.unit = data.frame.radius;
    this.own = replay.colouring || Uint8Array.from({ length: data.count + 1 }, (_, k) => k % 8);
    this.index = new Uint8Array(data.count + 1);
    this.speed = motion.typicalSpeed() || 1;
    this.scale = Array.from({ length: 12 }, (_, k) => blend([[68, 92, 160], [104, 178, 178],
      [236, 214, 130], [214, 96, 77]], k / 11));
    // From few neighbours to many; six is the mean in a large diagram.
    this.degrees = [[122, 89, 160], [94, 113, 181], [104, 160, 200], [150, 200, 190],
      [228, 231, 226], [243, 205, 140], [230, 150, 98], [205, 94, 84], [160, 60, 80]];
  }

  // The meaning of a mode's colours: a list of colours and the words at its ends; null where they mean nothing.
  legend(mode) {
    if (mode === "speed") return { colours: this.scale, ends: ["at rest", short(2 * this.speed * this.unit)] };
    if (mode === "neighbours") return { colours: this.degrees, ends: ["2", "10 or more"] };
    return null;
  }

  // Fills `index` and returns the list of colours.
  choose(mode) {
    if (mode === "speed") return this.bySpeed();
    if (mode === "neighbours" && this.replay.whole) return this.byNeighbours();
    this.index.set(this.own);
    return this.palette;
  }

  bySpeed() {
    const { vx, vy } = this.motion;
    for (let site = 1; site < this.index.length; ++site) {
      const ratio = Math.hypot(vx[site], vy[site]) / (2 * this.speed);
      this.index[site] = Math.min(11, Math.floor(12 * ratio));
    }
    return this.scale;
  }

  byNeighbours() {
    const diagram = this.replay.diagram, count = new Uint16Array(this.index.length);
    for (let h = 0; h < diagram.halves; ++h) ++count[diagram.org[h]];
    for (let site = 1; site < count.length; ++site) {
      this.index[site] = Math.max(0, Math.min(8, count[site] - 2));
    }
    return this.degrees;
  }
}

// The colour at `share` of the way through the stops.
function blend(stops, share) {
  const at = share * (stops.length - 1), k = Math.min(stops.length - 2, Math.floor(at));
  return stops[k].map((from, i) => Math.round(from + (at - k) * (stops[k + 1][i] - from)));
}

function css(colour, alpha = 1) {
  return `rgba(${colour[0]}, ${colour[1]}, ${colour[2]}, ${alpha})`;
}
