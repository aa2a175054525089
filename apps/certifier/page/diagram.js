"use strict";
// The claimed diagram: its edges, and what is next to what.

class Diagram {
  // Refuted where the edges are not those of a triangulation of the sphere by n disks and the container.
  constructor(edges, n) {
    this.edges = edges.map((quad) => [...quad]);
    this.size = n + 1;
    this.sides = new Map();  // by triple [a,b,c]: the edge between a and b at this vertex
    this.spokes = Array.from({ length: n + 1 }, () => []);  // the edges of generator g, at g + 1
    this.build();
  }

  build() {
    const { edges, size } = this, wrong = "wrong initial diagram: ";
    if (edges.length !== 3 * size - 6) refute(`${wrong}not 3 (n + 1) - 6 edges`);
    edges.forEach(([l, r, s, e], k) => {
      this.put(l, r, e, k);
      this.put(r, l, s, k);
      this.spokes[l + 1].push(k);
      this.spokes[r + 1].push(k);
    });
    for (let k = 0; k < edges.length; ++k) {
      if (this.around(k).includes(-1)) refute(`${wrong}a vertex without an edge`);
    }
    // One ring around each generator, and all connected: by Euler's count a sphere.
    const reached = [CONTAINER], seen = new Set(reached);
    for (const g of reached) {
      const spokes = this.spokes[g + 1];
      if (spokes.length === 0) refute(`${wrong}a generator without edges`);
      let steps = 0, k = spokes[0];
      do {
        const other = edges[k][0] === g ? edges[k][1] : edges[k][0];
        if (!seen.has(other)) reached.push(other);
        seen.add(other);
        k = this.nextSpoke(k, g);
        ++steps;
      } while (steps <= spokes.length && k !== spokes[0]);
      if (steps !== spokes.length) refute(`${wrong}the edges of a generator are not one ring`);
    }
    if (reached.length !== size) refute(`${wrong}not connected`);
  }

  // Below 2^63 for two million disks: a number is exact up to 2^53, so a text.
  key(a, b, c) {
    return this.size < 200000 ? ((a + 1) * this.size + b + 1) * this.size + c + 1 : `${a},${b},${c}`;
  }

  side(a, b, c) {
    return this.sides.get(this.key(a, b, c)) ?? -1;
  }

  put(a, b, c, k) {
    const key = this.key(a, b, c), edge = this.edges[k];
    if (this.sides.has(key)) refute("vertices would be there twice");
    this.sides.set(key, k);
    edge[edge[0] === a ? 3 : 2] = c;
  }

  // The edge of this name, which may be read either way, or -1.
  find([l, r, s, e]) {
    const k = this.side(l, r, e);
    if (k < 0) return -1;
    const [a, b, c, d] = this.edges[k];
    const isIt = a === l && b === r && c === s && d === e, isReversed = a === r && b === l && c === e && d === s;
    return isIt || isReversed ? k : -1;
  }

  // The edges that meet edge k: between l and s, s and r, r and e, e and l.
  around(k) {
    const [l, r, s, e] = this.edges[k];
    return [this.side(l, s, r), this.side(s, r, l), this.side(r, e, l), this.side(e, l, r)];
  }

  // Edge k with g on its left.
  leaving(k, g) {
    const [l, r, s, e] = this.edges[k];
    return l === g ? [l, r, s, e] : [r, l, e, s];
  }

  // The edge after k counterclockwise around g, one of its two.
  nextSpoke(k, g) {
    const [l, r, , e] = this.leaving(k, g);
    return this.side(e, l, r);
  }

  adjacent(i, j) {
    return this.spokes[j + 1].some((k) => this.edges[k][0] === i || this.edges[k][1] === i);
  }

  // Refuted where no diagram has the vertices that the flip makes.
  flip(k) {
    const [l, r, s, e] = this.edges[k];
    if (s === e) refute("an edge whose two ends have the same generators does not flip");
    const [ls, sr, re, el] = this.around(k);
    for (const [a, b, c] of [[l, s, r], [l, r, e]]) {
      for (const gone of [this.key(a, b, c), this.key(b, c, a), this.key(c, a, b)]) this.sides.delete(gone);
    }
    this.edges[k] = [s, e, r, l];
    this.put(l, s, e, ls);
    this.put(s, r, e, sr);
    this.put(r, e, s, re);
    this.put(e, l, s, el);
    this.put(s, e, l, k);
    this.put(e, s, r, k);
    for (const g of [l, r]) this.spokes[g + 1].splice(this.spokes[g + 1].indexOf(k), 1);
    for (const g of [s, e]) this.spokes[g + 1].push(k);
  }
}
