"use strict";
// Where the disks are: each on a line from one of its turns to the next.

class Motion {
  constructor(data) {
    const count = data.count, sites = count + 1;
    // At the time of the last moveTo(), by site; the container's radius is negative.
    this.x = new Float64Array(sites);
    this.y = new Float64Array(sites);
    this.vx = new Float64Array(sites);
    this.vy = new Float64Array(sites);
    this.radius = new Float64Array(sites).fill(-1);
    this.sites = sites;
    this.countTurns(data);
    for (let disk = 0; disk < count; ++disk) {
      const [cx, cy, r, vx, vy] = data.disks.subarray(5 * disk, 5 * disk + 5);
      this.radius[disk + 1] = r;
      this.addTurn(disk + 1, data.begin, cx, cy, vx, vy);
    }
    this.follow(data);
  }

  // The turns of a site are those from start[site] on, the first one at the begin.
  countTurns(data) {
    this.start = new Uint32Array(this.sites + 1);
    const turns = new Uint32Array(this.sites).fill(1);
    turns[0] = 0;
    for (let k = 0; k < data.events; ++k) {
      if (data.kinds[k] === FLIP) continue;
      for (const site of data.sitesOf(k)) if (site !== 0) ++turns[site];
    }
    for (let site = 0; site < this.sites; ++site) {
      this.start[site + 1] = this.start[site] + turns[site];
    }
    const all = this.start[this.sites];
    this.filled = this.start.slice(0, this.sites);
    this.turnT = new Float64Array(all);
    this.turnX = new Float64Array(all);
    this.turnY = new Float64Array(all);
    this.turnVx = new Float64Array(all);
    this.turnVy = new Float64Array(all);
    this.current = this.start.slice(0, this.sites);  // the turn last looked up
  }

  addTurn(site, t, x, y, vx, vy) {
    const k = this.filled[site]++;
    this.turnT[k] = t;
    this.turnX[k] = x;
    this.turnY[k] = y;
    this.turnVx[k] = vx;
    this.turnVy[k] = vy;
  }

  follow(data) {
    for (let event = 0; event < data.events; ++event) {
      if (data.kinds[event] === FLIP) continue;
      const t = data.times[event];
      let v = data.velocityStart[event];
      for (const site of data.sitesOf(event)) {
        if (site === 0) continue;
        const last = this.filled[site] - 1, dt = t - this.turnT[last];
        this.addTurn(site, t, this.turnX[last] + dt * this.turnVx[last],
          this.turnY[last] + dt * this.turnVy[last], data.velocities[v], data.velocities[v + 1]);
        v += 2;
      }
    }
  }

  // The turn that is in force at t.
  turnAt(site, t) {
    const first = this.start[site], end = this.start[site + 1];
    let k = this.current[site];
    if (this.turnT[k] > t || (k + 1 < end && this.turnT[k + 1] <= t)) {
      k = Math.max(first, upperBound(this.turnT, t, first, end) - 1);
      this.current[site] = k;
    }
    return k;
  }

  moveTo(t) {
    for (let site = 1; site < this.sites; ++site) {
      const k = this.turnAt(site, t), dt = t - this.turnT[k];
      this.vx[site] = this.turnVx[k];
      this.vy[site] = this.turnVy[k];
      this.x[site] = this.turnX[k] + dt * this.vx[site];
      this.y[site] = this.turnY[k] + dt * this.vy[site];
    }
  }

  // The path of the disk over [from, to] as points x, y, x, y, ...
  path(site, from, to) {
    const points = [];
    const add = (k, t) => {
      const dt = t - this.turnT[k];
      points.push(this.turnX[k] + dt * this.turnVx[k], this.turnY[k] + dt * this.turnVy[k]);
    };
    let k = this.turnAt(site, from);
    add(k, from);
    while (k + 1 < this.start[site + 1] && this.turnT[k + 1] < to) {
      ++k;
      add(k, this.turnT[k]);
    }
    add(k, to);
    return points;
  }

  // A quadratic mean over the disks at the begin; 0 where none moves.
  typicalSpeed() {
    let sum = 0;
    for (let site = 1; site < this.sites; ++site) {
      const k = this.start[site];
      sum += this.turnVx[k] ** 2 + this.turnVy[k] ** 2;
    }
    return this.sites > 1 ? Math.sqrt(sum / (this.sites - 1)) : 0;
  }
}
