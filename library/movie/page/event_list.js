"use strict";
// The list of events beside the picture: only the rows that are seen exist.

class EventList {
  constructor(element, data, replay) {
    this.element = element;
    this.data = data;
    this.replay = replay;
    this.rowHeight = 24;
    this.shown = null;  // the events that pass the filter; null: all
    this.current = null;  // until the player says where it stands
    this.frame = element.querySelector(".rows");
    this.sizer = element.querySelector(".sizer");
    this.resize();
  }

  listen(chosen) {
    this.element.addEventListener("scroll", () => this.fill());
    this.frame.addEventListener("click", (event) => {
      const row = event.target.closest(".row");
      if (row) chosen(Number(row.dataset.event));
    });
    this.element.addEventListener("keydown", (event) => {
      const page = Math.max(1, this.room - 3);
      const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page }[event.key];
      if (steps === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      if (this.length === 0) return;
      const to = this.away(steps);
      chosen(to);
      this.setCurrent(to);  // at once, for the next key
    });
  }

  // The event so many rows from the current one, of those that are shown; -1 for the start.
  away(steps) {
    const at = this.shown ? upperBound(this.shown, this.current, 0, this.length) - 1 : this.current;
    const isBetween = this.shown && at >= 0 && this.shown[at] !== this.current && steps < 0;
    const to = Math.min(this.length - 1, at + steps + (isBetween ? 1 : 0));
    return to < 0 ? -1 : this.shown ? this.shown[to] : to;
  }

  get length() {
    return this.shown ? this.shown.length : this.data.events;
  }

  // `keep` says of an event whether it is shown; null shows all.
  filter(keep) {
    this.shown = null;
    if (keep) {
      const events = [];
      for (let k = 0; k < this.data.events; ++k) if (keep(k)) events.push(k);
      this.shown = Int32Array.from(events);
    }
    this.resize();
    this.reveal();
    this.fill();
  }

  // Browsers limit the height of an element: a long list is scrolled to another scale.
  resize() {
    this.sizer.style.height = `${Math.min(8e6, this.length * this.rowHeight)}px`;
  }

  // The number of rows that have room.
  get room() {
    return Math.ceil(this.element.clientHeight / this.rowHeight) + 1;
  }

  get span() {
    return Math.max(1, this.sizer.offsetHeight - this.element.clientHeight);
  }

  get hidden() {
    return Math.max(0, this.length - Math.floor(this.element.clientHeight / this.rowHeight));
  }

  // The event last applied is marked and kept in sight.
  setCurrent(event) {
    if (event === this.current) return;
    this.current = event;
    this.reveal();
    this.fill();
  }

  reveal() {
    const at = this.shown ? upperBound(this.shown, this.current, 0, this.length) - 1
      : this.current;
    const rows = Math.floor(this.element.clientHeight / this.rowHeight);
    if (at >= this.top + 2 && at < this.top + rows - 2) return;
    const top = Math.max(0, Math.min(this.hidden, at - Math.floor(rows / 2)));
    this.element.scrollTop = this.hidden > 0 ? top / this.hidden * this.span : 0;
  }

  get top() {
    return Math.round(Math.min(1, this.element.scrollTop / this.span) * this.hidden);
  }

  fill() {
    const top = this.top, rows = Math.min(this.room, this.length - top);
    while (this.frame.children.length < rows) {
      const row = document.createElement("div");
      row.setAttribute("role", "option");
      row.append(...["i", "span", "b"].map((name) => document.createElement(name)));
      this.frame.append(row);
    }
    while (this.frame.children.length > Math.max(0, rows)) this.frame.lastChild.remove();
    for (let k = 0; k < rows; ++k) {
      this.fillRow(this.frame.children[k], this.shown ? this.shown[top + k] : top + k);
    }
    const active = this.frame.querySelector(".current");
    if (active) this.element.setAttribute("aria-activedescendant", active.id);
    else this.element.removeAttribute("aria-activedescendant");
  }

  fillRow(row, event) {
    const { data } = this;
    const kind = ["flip", "hit", "turn"][data.kinds[event]];
    row.className = `row ${kind} ${this.standing(event)}` +
      (event === this.current ? " current" : event < this.current ? " past" : "");
    row.setAttribute("aria-selected", event === this.current);
    if (row.dataset.event === String(event)) return;
    row.dataset.event = event;
    row.id = `event-${event}`;
    row.setAttribute("aria-posinset", event + 1);
    row.setAttribute("aria-setsize", data.events);
    row.children[1].textContent = timeText(data.times[event]);
    row.children[2].textContent = data.nameOf(event);
  }

  // The report's statement on the event.
  standing(event) {
    const report = this.data.facts.report;
    if (this.replay.fault && event + 1 >= this.replay.broken) return "refuted";
    if (!report) return "";
    if (report.fault && event === report.fault.event) {
      return report.fault.kind === "missing event" ? "refuted missing" : "refuted fault";
    }
    if (event + this.data.facts.leftOut < report.prefixEvents) return "certified";
    return report.verdict === "REFUTED" ? "refuted" : "undecided";
  }
}

// Enough digits to tell events apart by eye.
function timeText(t) {
  return t === 0 ? "0" : Math.abs(t) >= 1e-4 && Math.abs(t) < 1e9 ? t.toFixed(6)
    : t.toExponential(6);
}
