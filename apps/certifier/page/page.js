"use strict";
// The page: what is given, the work in a second thread, and what came out of it.

const element = (id) => document.getElementById(id);
const ROLES = ["scene", "history"];

class CertifierPage {
  constructor() {
    this.files = { scene: null, history: null };
    this.worker = null;
    this.timer = null;
    this.drawing = new FaultDrawing(element("picture"));
    const facts = JSON.parse(element("certifier-facts").textContent);
    element("producer").textContent = facts.producer;
    this.connect();
    this.update();
  }

  connect() {
    for (const role of ROLES) {
      element(role).addEventListener("change", ({ target }) => {
        const files = [...target.files];
        target.value = "";  // so that the same file, changed, can be chosen again
        this.take(files, role);
      });
    }
    const zone = document.body;
    zone.addEventListener("dragover", (event) => {
      event.preventDefault();
      zone.classList.add("dragging");
    });
    for (const end of ["dragleave", "drop"]) zone.addEventListener(end, () => zone.classList.remove("dragging"));
    zone.addEventListener("drop", (event) => {
      event.preventDefault();
      this.take([...event.dataTransfer.files], null);
    });
    element("options").addEventListener("submit", (event) => {
      event.preventDefault();
      this.start();
    });
    element("cancel").addEventListener("click", () => this.end("ended on request"));
    element("whole").addEventListener("click", () => {
      this.drawing.toggle();
      this.updatePicture();
    });
    element("save").addEventListener("click", () => this.savePicture());
    window.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.worker) this.end("ended on request");
    });
  }

  // Takes files for one role. Where the role is null, each file's content says its role.
  async take(files, role) {
    for (const file of files) {
      try {
        const given = await GivenFile.read(file);
        this.files[role ?? given.role] = given;
      } catch (error) {
        this.say(`${file.name} cannot be read: ${error.message}`);
        return;
      }
    }
    this.say("");
    this.update();
  }

  say(words) {
    element("note").textContent = words;
  }

  update() {
    for (const role of ROLES) {
      const file = this.files[role];
      element(`${role}-name`).textContent = file ? `${file.name} (${file.size})` : "none yet";
      element(`${role}-box`).classList.toggle("given", file !== null);
    }
    const isReady = this.files.scene !== null && this.files.history !== null;
    element("start").disabled = !isReady || this.worker !== null;
    element("cancel").hidden = this.worker === null;
    element("work").hidden = this.worker === null;
    document.body.classList.toggle("working", this.worker !== null);
  }

  get options() {
    const seconds = Number(element("seconds").value);
    return {
      truth: document.querySelector("input[name=truth]:checked").value,
      tolerance: element("tolerance").value.trim(), lawTolerance: element("law-tolerance").value.trim(),
      strict: element("strict").checked, unoriented: element("unoriented").checked,
      seconds: seconds > 0 ? seconds : 0,
    };
  }

  start() {
    const { scene, history } = this.files;
    if (this.worker !== null || !scene || !history) return;
    element("outcome").hidden = true;
    const code = [...element("core").content.querySelectorAll("script")].map((script) => script.textContent);
    const address = URL.createObjectURL(new Blob([code.join("\n")], { type: "text/javascript" }));
    this.worker = new Worker(address);
    this.address = address;
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = (event) => this.hear({ kind: "failure", reason: event.message });
    const { options } = this, { seconds } = options;
    this.worker.postMessage({ scene: scene.bytes, history: history.bytes, options });
    if (seconds > 0) this.timer = setTimeout(() => this.end("ended for the limit of time"), 1000 * seconds);
    this.showProgress("starting", 0, 1);
    this.update();
    element("cancel").focus();
  }

  stop() {
    this.worker.terminate();
    clearTimeout(this.timer);
    URL.revokeObjectURL(this.address);
    this.worker = null;
    this.update();
  }

  end(reason) {
    if (this.worker === null) return;
    this.stop();
    this.showOutcome({ verdict: "UNDECIDED", reason, lines: `c ${reason}\ns UNDECIDED` });
  }

  hear(message) {
    if (message.kind === "progress") {
      this.showProgress(message.rule, message.claim, message.of);
      return;
    }
    this.stop();
    if (message.kind === "result") this.showOutcome(message);
    else this.showOutcome({ verdict: "FAILED", reason: `no verdict: ${message.reason}`, lines: `c ${message.reason}` });
  }

  showProgress(rule, claim, of) {
    const share = Math.floor((100 * claim) / of);
    element("bar").value = share;
    element("phase").textContent = `${rule}, ${share}%`;
  }

  // ---- What came out

  showOutcome({ verdict, reason, isFirst, lines, about, counts, line, claim, seconds, drawing }) {
    const kind = verdict.toLowerCase();
    element("outcome").hidden = false;
    element("verdict").textContent = kind;
    element("verdict").className = kind;
    element("meaning").textContent = this.meaning(verdict, reason, about, line, isFirst);
    element("claim").textContent = claim ?? "";
    element("claim").hidden = !claim;
    element("lines").textContent = lines;
    element("took").textContent = seconds === undefined ? ""
      : `${counts.lives.toLocaleString("en")} lives of edges in ${seconds.toFixed(2)} s`;
    this.fillCounts(counts);
    element("picture-box").hidden = !drawing;
    if (drawing) {
      this.drawing.show(drawing);
      this.updatePicture();
    }
    element("outcome").focus();
  }

  // The options are those of the work, which need not be those that the form has by now.
  meaning(verdict, reason, about, line, isFirst) {
    if (verdict === "CERTIFIED") return `Every claim is proved, and none is missing: ${about}.`;
    const more = verdict === "REFUTED" && isFirst === false ? " An earlier fault may exist." : "";
    return `${line > 0 ? `line ${line}: ` : ""}${reason}.${more}${about ? ` Judged: ${about}.` : ""}`;
  }

  fillCounts(counts) {
    const rows = [["flips", "flips"], ["collisions", "collisions"], ["maneuvers", "maneuvers"],
      ["lives", "lives of edges"], ["pairLives", "lives of pairs"], ["freshProofs", "fresh proofs"]];
    const lenient = [["swaps", "claims out of order"], ["grazes", "grazes"], ["roundingOverlaps", "overlaps by rounding"],
      ["horizonEvents", "events at the horizon"], ["unoriented", "quadruplets without orientation"]];
    element("count-box").hidden = !counts;
    if (!counts) return;
    const fill = (id, list) => element(id).replaceChildren(...list.map(([name, words]) => {
      const row = document.createElement("tr"), head = document.createElement("th"), cell = document.createElement("td");
      head.scope = "row";
      head.textContent = words;
      cell.textContent = counts[name].toLocaleString("en");
      row.append(head, cell);
      return row;
    }));
    fill("counts", rows);
    fill("leniency", lenient);
  }

  updatePicture() {
    element("picture-words").textContent = this.drawing.words;
    element("whole").textContent = this.drawing.isWhole ? "Show the fault" : "Show the whole container";
  }

  // The picture as a file, with the colours that it has here.
  savePicture() {
    const copy = this.drawing.svg.cloneNode(true), originals = [...this.drawing.svg.querySelectorAll("*")];
    [...copy.querySelectorAll("*")].forEach((node, k) => {
      const style = getComputedStyle(originals[k]);
      for (const name of ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "font", "text-anchor"]) {
        node.style.setProperty(name, style.getPropertyValue(name));
      }
    });
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    copy.style.background = getComputedStyle(this.drawing.svg).backgroundColor;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([copy.outerHTML], { type: "image/svg+xml" }));
    link.download = "fault.svg";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }
}

const certifierPage = new CertifierPage();
