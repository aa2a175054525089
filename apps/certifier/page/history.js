"use strict";
// A history as its file says (docs/formats.md, section 5).

// Vectors v or p of a claim by its ids; null where none are given.
function readVectors(value, name, ids) {
  const field = value.get(name);
  if (field === undefined) return [null, null];
  if (value.has("maneuver")) return [null, readVector(field, readHistoryNumber)];
  const two = readList(field, 2, 2);
  if ((two[0].kind === "null") !== (ids[0] === CONTAINER)) refuseField(two[0], "null stands for the container");
  return two.map((one, k) => (ids[k] === CONTAINER ? null : readVector(one, readHistoryNumber)));
}

// A claim: `kind` is "flip", "collision" or "maneuver". Of a collision `ids` are the two, of a maneuver the
// second is the disk; the ids from `first` on are the disks that turn. `t` is the time at which it takes
// place, `filed` that of the file.
function readClaim(json, n) {
  const claim = { kind: "flip", first: 2, ids: [CONTAINER, CONTAINER], quad: null, v: [null, null], p: [null, null] };
  if (json.has("flip")) {
    expectFields(json, ["t", "flip"]);
    claim.quad = readQuad(json.get("flip"), n);
  } else if (json.has("collide")) {
    expectFields(json, ["t", "collide"], ["v", "p"]);
    const [i, j] = readList(json.get("collide"), 2, 2);
    claim.kind = "collision";
    claim.ids[1] = readWhole(j, 0, n - 1);
    claim.ids[0] = readWhole(i, CONTAINER, claim.ids[1] - 1);
    claim.first = claim.ids[0] === CONTAINER ? 1 : 0;
  } else {
    expectFields(json, ["t", "maneuver"], ["v", "p"]);
    claim.kind = "maneuver";
    claim.ids[1] = readWhole(json.get("maneuver"), 0, n - 1);
    claim.first = 1;
  }
  if (claim.kind !== "flip") {
    claim.v = readVectors(json, "v", claim.ids);
    claim.p = readVectors(json, "p", claim.ids);
  }
  claim.t = claim.filed = readHistoryNumber(json.get("t"));
  return claim;
}

class HistoryReader {
  constructor(bytes, n) {
    this.bytes = bytes;
    this.n = n;
    this.at = 0;
    this.line = 0;
    this.history = { claims: [], initial: null, lastLine: 0, stopped: false, ended: [0, 0, 0] };
  }

  read(progress) {
    try {
      while (this.history.lastLine === 0) {
        if ((this.line & 255) === 0) progress("reading the history", this.at, this.bytes.length);
        this.readLine();
      }
    } catch (stop) {
      if (!(stop instanceof Stop)) throw stop;
      if (stop.verdict === "INVALID") {
        stop.file = "history";
        stop.line = stop.fileLine = this.line;
      }
      throw stop;
    }
    return this.history;
  }

  readLine() {
    const { bytes, at, history } = this;
    ++this.line;
    if (at >= bytes.length) invalid("the file ends without its last line");
    let end = bytes.indexOf(10, at);
    if (end < 0) end = bytes.length;
    if (end - at > 2 ** (this.line === 1 ? 28 : 20)) invalid("a line too long");
    const json = new JsonReader(textOf(bytes.subarray(at, end))).read();
    this.at = Math.min(end + 1, bytes.length);
    if (json.kind !== "object") invalid("not a JSON object");
    if (this.line === 1) {
      this.readHeader(json);
    } else if (json.has("end") || json.has("stopped")) {
      this.readLast(json);
      if (this.at < bytes.length) invalid("something follows the last line");
      history.lastLine = this.line;
    } else {
      this.addClaim(json);
    }
  }

  readHeader(json) {
    const { history } = this;
    expectFormat(json, "voroproof-history");
    expectFields(json, ["format", "version", "scene_sha256", "horizon", "producer"], ["initial"]);
    readTextField(json.get("producer"));
    history.hash = readTextField(json.get("scene_sha256"));
    history.horizon = readHistoryNumber(json.get("horizon"));
    if (history.horizon.sign < 0) refuseField(json.get("horizon"), "a negative horizon");
    const nearest = nearestBinary64(history.horizon);
    this.latest = greater(history.horizon, nearest);
    if (json.has("initial")) {
      history.initial = readList(json.get("initial"), 0, Infinity).map((quad) => readQuad(quad, this.n));
    }
  }

  addClaim(json) {
    const { claims } = this.history, claim = readClaim(json, this.n), time = json.get("t");
    claim.line = this.line;
    const before = claims.length === 0 ? ZERO : claims[claims.length - 1].t;
    if (claim.t.less(before)) refuseField(time, "the times decrease");
    if (this.latest.less(claim.t)) refuseField(time, "an event after the horizon");
    claims.push(claim);
  }

  readLast(json) {
    const { history } = this;
    history.stopped = json.has("stopped");
    expectFields(json, [history.stopped ? "stopped" : "end"]);
    if (history.stopped) {
      const last = json.get("stopped");
      expectFields(last, ["t", "reason"], ["events"], false);
      readHistoryNumber(last.get("t"));
      readTextField(last.get("reason"));
      return;
    }
    const last = json.get("end"), names = ["flips", "collisions", "maneuvers"];
    expectFields(last, ["t", ...names], [], false);
    const t = readHistoryNumber(last.get("t"));
    if (!t.equals(history.horizon) && !t.equals(nearestBinary64(history.horizon))) {
      refuseField(last.get("t"), "the last line has another time than the horizon");
    }
    history.ended = names.map((name) => readWhole(last.get(name), 0, 2n ** 63n - 1n));
  }
}

// The history of the bytes of a file, of n disks.
function readHistory(bytes, n, progress) {
  return new HistoryReader(bytes, n).read(progress);
}
