"use strict";
// The texts of the page: the scene, the verdict, the event that is looked at, the followed disk.

class Panel {
  constructor(data, replay, motion) {
    this.data = data;
    this.replay = replay;
    this.motion = motion;
    this.writeScene();
    this.writeVerdict();
  }

  writeScene() {
    const { facts, count } = this.data;
    text("title", facts.name || `${count} moving disk${count === 1 ? "" : "s"}`);
    const kinds = [0, 0, 0];
    for (const kind of this.data.kinds) ++kinds[kind];
    text("subtitle", `${count} disk${count === 1 ? "" : "s"}, ` +
      `${plural(kinds[FLIP], "flip")}, ${plural(kinds[COLLISION], "collision")}` +
      (kinds[MANEUVER] ? `, ${plural(kinds[MANEUVER], "maneuver")}` : "") +
      `, history by ${facts.historyBy}`);
    const notes = [...facts.remarks];
    if (this.replay.resolved > 0) {
      notes.push(`${plural(this.replay.resolved, "flip")} named without orientation.`);
    }
    if (facts.stop) notes.unshift(`The run stopped at t = ${facts.stop.t}: ${facts.stop.reason}`);
    if (facts.begin > 0) notes.unshift(`What happened up to t = ${facts.begin} is left out: ${plural(facts.leftOut, "event")}.`);
    if (facts.cut) notes.unshift(`The history goes on after t = ${this.data.end}.`);
    element("notes").replaceChildren(...notes.map((note) => {
      const line = document.createElement("p");
      line.textContent = note;
      return line;
    }));
  }

  writeVerdict() {
    const report = this.data.facts.report, badge = element("verdict");
    badge.hidden = !report;
    if (!report) return;
    badge.textContent = report.words.toLowerCase();
    badge.className = report.verdict.toLowerCase();
    badge.title = report.about;
    const words = element("finding"), judged = [report.about, ...report.reservations].join("; ");
    if (report.verdict === "CERTIFIED") {
      words.textContent = `Every event that was judged is right and none is missing: ${judged}.`;
      return;
    }
    words.textContent = `Judged: ${judged}. Proved up to t = ${report.prefixT} ` +
      `(${plural(report.prefixEvents, "event")}).` +
      (report.fault ? ` Line ${report.fault.line}, ${report.fault.kind}: ${report.fault.truth}.`
        : ` ${report.reason}`);
    element("to-fault").hidden = !report.fault;
  }

  update(state, irregular) {
    const { data, replay } = this;
    text("time", timeText(state.t));
    text("count", `${state.applied} / ${data.events}`);
    const follow = state.follow === null ? "" : `, disk ${state.follow} followed`;
    element("picture").setAttribute("aria-label",
      `${plural(data.count, "disk")} at t = ${timeText(state.t)}, after ${plural(state.applied, "event")}${follow}`);
    const broken = element("broken");
    broken.hidden = replay.whole && irregular === 0;
    if (!replay.whole) {
      broken.textContent = replay.fault ? `No diagram from here on: ${replay.fault}.` : `No diagram: ${data.facts.noDiagram}.`;
    } else if (irregular > 0) {
      broken.textContent = `${plural(irregular, "edge")} of the claimed diagram ` +
        `${irregular === 1 ? "is" : "are"} no Voronoi edge here (red).`;
    }
    this.updateEvent(state);
    this.updateFollowed(state);
  }

  // Writes what the colours of the cells mean.
  writeLegend(legend) {
    const box = element("legend");
    box.hidden = legend === null;
    if (!legend) return;
    const swatches = legend.colours.map((colour) => {
      const swatch = document.createElement("i");
      swatch.style.background = css(colour);
      return swatch;
    });
    box.replaceChildren(legend.ends[0], ...swatches, legend.ends[1]);
  }

  updateEvent(state) {
    const box = element("event-box"), event = state.selected;
    box.hidden = event === null;
    if (event === null || box.dataset.event === String(event)) return;
    box.dataset.event = event;
    const { data } = this, kind = data.kinds[event];
    text("event-name", data.nameOf(event));
    const exact = `t = ${data.times[event]}, event ${event + 1}`;
    const ids = Array.from(data.sitesOf(event), (site) => site - 1);
    text("event-words", kind === FLIP
      ? `${exact}. The edge between ${nameOf(ids[0])} and ${nameOf(ids[1])} gives way to one ` +
        `between ${nameOf(ids[2])} and ${nameOf(ids[3])}.`
      : kind === COLLISION ? `${exact}. Contact of ${nameOf(ids[0])} and ${nameOf(ids[1])}.`
        : `${exact}. ${capital(nameOf(ids[0]))} changes its velocity.`);
  }

  updateFollowed(state) {
    const box = element("disk-box");
    box.hidden = state.follow === null;
    if (state.follow === null) return;
    const site = state.follow + 1, { motion, replay } = this;
    const { x, y, radius: unit } = this.data.frame;
    text("disk-name", `disk ${state.follow}`);
    text("disk-words", `radius ${short(unit * motion.radius[site])}, at ` +
      `(${short(x + unit * motion.x[site])}, ${short(y + unit * motion.y[site])}), speed ` +
      short(unit * Math.hypot(motion.vx[site], motion.vy[site])));
    const around = replay.whole && this.data.count > 1 ? replay.diagram.neighbours(site) : [];
    const chips = element("neighbours"), key = around.join();
    if (chips.dataset.key === key) return;
    chips.dataset.key = key;
    chips.replaceChildren(...around.map((other) => {
      const chip = document.createElement(other === 0 ? "span" : "button");
      chip.textContent = other === 0 ? "wall" : other - 1;
      chip.className = "chip";
      if (other !== 0) chip.dataset.disk = other - 1;
      return chip;
    }));
  }
}

function element(id) {
  return document.getElementById(id);
}
function text(id, content) {
  const node = element(id);
  if (node.textContent !== content) node.textContent = content;
}
function plural(number, noun) {
  return `${number.toLocaleString("en")} ${noun}${number === 1 ? "" : "s"}`;
}
function nameOf(id) {
  return id < 0 ? "the wall" : `disk ${id}`;
}
function capital(words) {
  return words[0].toUpperCase() + words.slice(1);
}
function short(x) {
  return Number(x.toPrecision(5));
}
