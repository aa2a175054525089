"use strict";
// The diagram as incidences, kept as its dual: a triangulation of the sphere by the sites. Edge e
// owns the half-edges 2e and 2e + 1. Half-edge h runs in the dual from site org[h] to the org of
// its twin h ^ 1 and has a triangle, a vertex of the diagram, on its left, whose third site is its
// apex. As a quadruplet it is [l, r, s, e] = [org(h), dest(h), apex(twin), apex(h)].

class Diagram {
  // Throws an Error with the reason where the quadruplets are not those of a diagram.
  constructor(count, quads) {
    this.sites = count + 1;
    const halves = quads.length / 2;
    this.halves = halves;
    this.org = new Uint16Array(halves);
    this.next = new Int32Array(halves).fill(-1);
    this.anchor = new Int32Array(this.sites).fill(-1);  // some half-edge from each site
    const corners = new Map();  // half-edges by org, dest and apex
    const put = (a, b, c, h) => {
      const key = this.key(a, b, c);
      if (corners.has(key)) throw new Error(`the vertex ${names(a, b, c)} has an edge twice`);
      corners.set(key, h);
    };
    for (let k = 0; k < quads.length; k += 4) {
      const l = quads[k], r = quads[k + 1], s = quads[k + 2], e = quads[k + 3], h = k / 2;
      this.org[h] = l;
      this.org[h + 1] = r;
      this.anchor[l] = h;
      this.anchor[r] = h + 1;
      put(l, r, e, h);
      put(r, l, s, h + 1);
    }
    for (let k = 0; k < quads.length; k += 4) {
      this.next[k / 2] = this.following(corners, quads[k], quads[k + 1], quads[k + 3]);
      this.next[k / 2 + 1] = this.following(corners, quads[k + 1], quads[k], quads[k + 2]);
    }
    if (count >= 2 && halves !== 6 * count - 6) throw new Error("a wrong number of edges");
    if (count >= 2 && this.anchor.includes(-1)) throw new Error("a disk without a cell");
  }

  key(a, b, c) {
    return (a * this.sites + b) * this.sites + c;
  }

  // The half-edge after (a, b, c) in its triangle.
  following(corners, a, b, c) {
    const h = corners.get(this.key(b, c, a));
    if (h === undefined) throw new Error(`the vertex ${names(a, b, c)} lacks an edge`);
    return h;
  }

  dest(h) {
    return this.org[h ^ 1];
  }
  apex(h) {
    return this.org[this.next[this.next[h]]];
  }
  // The next half-edge counterclockwise around the same site.
  rotate(h) {
    return this.next[this.next[h]] ^ 1;
  }
  quad(h) {
    return [this.org[h], this.dest(h), this.apex(h ^ 1), this.apex(h)];
  }

  // The half-edge of this name, or -1. Looks around a disk: the container has many neighbours.
  find(l, r, s, e) {
    if (this.halves === 0) return -1;
    if (l === 0) {
      const twin = this.find(r, l, e, s);
      return twin < 0 ? -1 : twin ^ 1;
    }
    const first = this.anchor[l];
    let h = first;
    do {
      if (this.dest(h) === r && this.apex(h) === e && this.apex(h ^ 1) === s) return h;
      h = this.rotate(h);
    } while (h !== first);
    return -1;
  }

  // [l, r, s, e] becomes [s, e, r, l].
  flip(h) {
    const t = h ^ 1, next = this.next, org = this.org, anchor = this.anchor;
    const re = next[h], el = next[re], ls = next[t], sr = next[ls];
    const l = org[h], r = org[t], e = org[el], s = org[sr];
    if (anchor[l] === h) anchor[l] = ls;
    if (anchor[r] === t) anchor[r] = re;
    org[h] = s;
    org[t] = e;
    next[h] = el; next[el] = ls; next[ls] = h;
    next[t] = sr; next[sr] = re; next[re] = t;
  }

  // Takes the flip back.
  unflip(h) {
    this.flip(h);  // [s, e, r, l] becomes [r, l, e, s]: the old edge, walked backwards
    this.swap(h);
  }

  // Exchanges the names of a half-edge and its twin.
  swap(h) {
    const t = h ^ 1, next = this.next, org = this.org;
    const before = next[next[h]], beforeTwin = next[next[t]];
    [org[h], org[t]] = [org[t], org[h]];
    [next[h], next[t]] = [next[t], next[h]];
    next[before] = t;
    next[beforeTwin] = h;
    this.anchor[org[h]] = h;
    this.anchor[org[t]] = t;
  }

  // The sites with which `site` shares edges, in counterclockwise order; one for each edge.
  neighbours(site) {
    const around = [], first = this.anchor[site];
    if (this.halves === 0) return around;
    let h = first;
    do {
      around.push(this.dest(h));
      h = this.rotate(h);
    } while (h !== first);
    return around;
  }
}

function names(...sites) {
  return `[${sites.map((site) => site - 1).join(", ")}]`;
}
