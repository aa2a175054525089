"use strict";
// The state of the player, its clock and its controls.
//
// The player stands at a time t, after `applied` events. Usually these are all up to t; stepping
// shows the events of one instant one after the other.

class Player {
  constructor() {
    this.data = new MovieData();
    this.motion = new Motion(this.data);
    this.replay = new Replay(this.data);
    this.view = new View(element("picture"));
    this.painter = new Painter(element("picture"), this.data, this.motion, this.replay, this.view);
    this.timeline = new Timeline(element("timeline"), this.data, this.replay);
    this.list = new EventList(element("events"), this.data, this.replay);
    this.panel = new Panel(this.data, this.replay, this.motion);
    this.plot = new DiskPlot(element("plot"), this.data, this.motion, this.replay);
    this.exporter = new Exporter(element("picture"), () => `t = ${timeText(this.state.t)}`);
    this.natural = this.naturalRate();
    this.state = {
      t: this.data.begin, applied: 0, playing: false,
      selected: null,  // the event that is looked at, just applied
      follow: null,    // the disk that is followed
      rate: this.natural,
      flash: 0.45 * this.natural,  // for how long an event is seen, in the scene's time
      colours: "disk", velocities: this.data.count <= 150, labels: this.data.count <= 60,
      dual: false,
      isStill: false,  // whether the viewer wants little motion
    };
    this.connect();
    if (this.data.facts.follow !== undefined) this.follow(this.data.facts.follow);
    this.seek(this.data.begin);
    this.readAddress();
    this.tick = this.tick.bind(this);
    this.drawn = false;
    this.listed = -Infinity;  // when the list was last brought up to date
    requestAnimationFrame(this.tick);
  }

  // Units of time in a second: disks pass a twelfth of their typical distance, and the whole takes
  // ten seconds at least.
  naturalRate() {
    const { data } = this, spacing = Math.sqrt(Math.PI / (data.count + 1));
    const rate = spacing / 12 / (this.motion.typicalSpeed() || Infinity);
    return Math.min(rate > 0 ? rate : Infinity, data.length / 10) || 1;
  }

  // ---- Moving

  seek(t) {
    const { state, data } = this;
    state.t = data.within(t);
    state.applied = state.t >= data.end ? data.events : data.happened(state.t);
    state.selected = null;
    this.changed();
  }

  // To just after the event, which is then looked at; -1 is the start.
  look(event) {
    const { state, data } = this;
    if (event < 0) {
      this.seek(data.begin);
      state.applied = 0;
      return;
    }
    state.playing = false;
    state.t = Math.min(data.end, data.times[event]);
    state.applied = event + 1;
    state.selected = event;
    this.changed();
  }

  step(direction) {
    const { state, data } = this;
    state.playing = false;
    if (direction > 0) {
      if (state.applied < data.events) this.look(state.applied);
      else this.seek(data.end);
      return;
    }
    // Back to before the last event: to just after the one before it.
    const last = state.applied - 1;
    this.look(state.selected === null && last >= 0 && data.times[last] < state.t ? last : last - 1);
  }

  toFault() {
    const report = this.data.facts.report;
    if (!report || !report.fault) return;
    this.state.playing = false;
    this.seek(report.evidence ? report.evidence.t : report.fault.t);
  }

  play(on = !this.state.playing) {
    const { state, data } = this;
    if (on && state.t >= data.end) this.seek(data.begin);
    state.playing = on && data.length > 0;
    if (on) state.selected = null;
    this.changed();
  }

  follow(disk) {
    this.state.follow = disk === this.state.follow ? null : disk;
    this.applyFilter();
    this.changed();
  }

  // One of the options of the page.
  colour(mode) {
    element("colours").value = this.state.colours = mode;
    this.panel.writeLegend(this.painter.colours.legend(mode));
    this.changed();
  }

  // `share` is of the natural rate.
  setRate(share) {
    this.state.rate = this.natural * share;
    this.state.flash = 0.45 * this.state.rate;
    element("speed").value = Math.log2(share);
    text("speed-words", `\u00d7${Number(share.toPrecision(2))}`);
    this.changed();
  }

  applyFilter() {
    const { data, state } = this, chosen = element("filter").value;
    const wanted = { flips: FLIP, collisions: COLLISION, maneuvers: MANEUVER }[chosen];
    if (chosen === "followed" && state.follow !== null) {
      this.list.filter((event) => data.sitesOf(event).includes(state.follow + 1));
    } else {
      this.list.filter(wanted === undefined ? null : (event) => data.kinds[event] === wanted);
    }
  }

  // A movie can be opened at a place: #t=12.5, #event=17 (the 17th), &follow=3, &colours=speed,
  // &bare for the picture alone.
  readAddress() {
    const wish = new URLSearchParams(location.hash.slice(1));
    const number = (name) => (wish.has(name) ? Number(wish.get(name)) : NaN);
    if (number("follow") >= 0 && number("follow") < this.data.count) {
      this.state.follow = null;
      this.follow(Math.floor(number("follow")));
    }
    if (["disk", "speed", "neighbours", "none"].includes(wish.get("colours"))) {
      this.colour(wish.get("colours"));
    }
    if (wish.has("bare")) this.showBare(true);
    if (Number.isFinite(number("t"))) this.seek(number("t"));
    if (number("event") >= 1 && number("event") <= this.data.events) {
      this.look(Math.floor(number("event")) - 1);
    }
  }

  // ---- Drawing

  changed() {
    this.drawn = false;
  }

  tick(now) {
    const { state, data } = this;
    const seconds = Math.min(0.1, (now - (this.last ?? now)) / 1000);
    this.last = now;
    this.waited = (this.waited ?? 0) + seconds;
    // With little motion a picture each half second, and no flashes.
    if (state.playing && (!state.isStill || this.waited >= 0.5)) {
      const t = state.t + (state.isStill ? this.waited : seconds) * state.rate;
      this.waited = 0;
      if (t >= data.end) state.playing = false;
      this.seek(t);
    }
    if (!this.drawn) this.draw();
    requestAnimationFrame(this.tick);
  }

  draw() {
    const { state } = this;
    this.drawn = true;
    document.body.classList.toggle("playing", state.playing);
    this.painter.paint(state);
    this.timeline.paint(state.t, this.painter.theme);
    this.timeline.describe(state.t);
    // The list's layout costs more than the picture: while playing a few times a second do.
    if (!state.playing || this.last - this.listed > 150) {
      this.list.setCurrent(state.applied - 1);
      this.listed = this.last;
    }
    this.panel.update(state, this.painter.curves.irregular);
    if (state.follow !== null && !document.body.classList.contains("bare")) {
      this.plot.paint(state.follow, state.t, this.painter.theme);
    }
    if (this.exporter.isRecording) this.exporter.compose();
  }

  // ---- Saving

  async savePicture() {
    this.draw();
    Exporter.save(await this.exporter.picture(), "voroproof.png");
    text("saved", "picture saved");
  }

  // Begins a film from here, or ends it.
  async saveFilm() {
    if (this.exporter.isRecording) {
      this.exporter.stop();
      return;
    }
    const button = element("save-film");
    try {
      this.play(true);
      const film = this.exporter.film();
      button.textContent = "Stop";
      button.classList.add("recording");
      text("saved", "a film of ten seconds is being recorded");
      Exporter.save(await film, "voroproof.webm");
      text("saved", "film saved");
    } catch (error) {
      text("saved", error.message);
    }
    button.textContent = "Film";
    button.classList.remove("recording");
    this.play(false);
  }

  // ---- Controls

  connect() {
    const { state, data } = this;
    this.view.listen(() => this.changed(), (x, y) => {
      const disk = this.painter.diskAt(x, y);
      if (disk !== null) this.follow(disk);
    });
    this.timeline.listen((t) => this.seek(t), (t) =>
      text("hint", t === null ? "" : `t = ${Number(t.toPrecision(6))}`));
    this.list.listen((event) => this.look(event));
    const click = (id, action) => element(id).addEventListener("click", action);
    click("play", () => this.play());
    click("back", () => this.step(-1));
    click("forward", () => this.step(1));
    click("to-start", () => this.look(-1));
    click("to-end", () => this.seek(data.end));
    click("to-fault", () => this.toFault());
    click("unfollow", () => this.follow(state.follow));
    click("help", () => element("keys").showModal());
    click("save-picture", () => this.savePicture());
    click("save-film", () => this.saveFilm());
    this.plot.listen((t) => this.seek(t));
    click("neighbours", (event) => {
      if (event.target.dataset.disk) this.follow(Number(event.target.dataset.disk));
    });
    element("speed").addEventListener("input", (event) => this.setRate(2 ** event.target.value));
    element("filter").addEventListener("change", () => this.applyFilter());
    element("colours").addEventListener("change", (event) => this.colour(event.target.value));
    for (const name of ["velocities", "labels", "dual"]) {
      const box = element(name);
      box.checked = state[name];
      box.addEventListener("change", () => {
        state[name] = box.checked;
        this.changed();
      });
    }
    // The keys are the player's again when a control has been used with the pointer; with keys it keeps the focus.
    let byPointer = false;
    window.addEventListener("pointerdown", () => { byPointer = true; }, true);
    window.addEventListener("keydown", () => { byPointer = false; }, true);
    document.addEventListener("change", (event) => byPointer && event.target.blur());
    document.addEventListener("click", (event) => byPointer && event.target.closest("button")?.blur());
    window.addEventListener("keydown", (event) => this.key(event));
    window.addEventListener("resize", () => this.resized());
    window.addEventListener("hashchange", () => this.readAddress());
    this.watchMedia();
  }

  watchMedia() {
    window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.painter.readTheme();
      this.changed();
    });
    const still = window.matchMedia("(prefers-reduced-motion: reduce)");
    const read = () => {
      this.state.isStill = still.matches;
      this.changed();
    };
    still.addEventListener("change", read);
    read();
  }

  resized() {
    this.list.fill();
    this.changed();
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || element("keys").open) return;
    if (["SELECT", "INPUT"].includes(event.target.tagName) && event.key !== "Escape") return;
    if (event.target.tagName === "BUTTON" && [" ", "Enter"].includes(event.key)) return;
    const { state, data } = this;
    const jump = data.length / 100;
    const rate = (factor) => () =>
      this.setRate(Math.min(64, Math.max(1 / 64, factor * state.rate / this.natural)));
    const toggle = (name) => () => element(name).click();
    const actions = {
      " ": () => this.play(),
      ArrowRight: () => (event.shiftKey ? this.seek(state.t + jump) : this.step(1)),
      ArrowLeft: () => (event.shiftKey ? this.seek(state.t - jump) : this.step(-1)),
      Home: () => this.look(-1),
      End: () => this.seek(data.end),
      "+": rate(2), "=": rate(2), "-": rate(0.5),
      v: toggle("velocities"), i: toggle("labels"), d: toggle("dual"),
      c: () => this.nextColours(),
      f: () => this.showBare(!document.body.classList.contains("bare")),
      e: () => this.toFault(),
      0: () => { this.view.reset(); this.changed(); },
      z: () => this.zoom(1.5), x: () => this.zoom(1 / 1.5),
      n: () => this.followNext(1), b: () => this.followNext(-1),
      p: () => this.savePicture(), r: () => this.saveFilm(),
      Escape: () => state.follow !== null && this.follow(state.follow),
      "?": () => element("keys").showModal(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

  // About the followed disk, or the middle.
  zoom(factor) {
    const { view, motion, state } = this, site = state.follow === null ? 0 : state.follow + 1;
    const [x, y] = site === 0 ? [view.width / 2, view.height / 2] : view.canvasPoint(motion.x[site], motion.y[site]);
    view.zoomAt(x, y, factor);
    this.changed();
  }

  followNext(direction) {
    const { count } = this.data, { follow } = this.state;
    if (count === 0) return;
    const from = follow ?? (direction > 0 ? -1 : 0);
    const next = (from + direction + count) % count;
    if (next !== follow) this.follow(next);
  }

  // The picture alone, or all.
  showBare(bare) {
    document.body.classList.toggle("bare", bare);
    this.resized();
  }

  nextColours() {
    const choice = element("colours");
    this.colour(choice.options[(choice.selectedIndex + 1) % choice.options.length].value);
  }
}

const player = new Player();
