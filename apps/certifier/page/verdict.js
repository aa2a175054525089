"use strict";
// How a verdict ends the work.

// `line` is that of the history, from 1, or 0; `file`, `fileLine` and `field` say where a file is not of its
// format; `witness` says what a drawing of the fault shows; `isLast` says that no rule holds after it, so that no
// later line is refuted.
class Stop extends Error {
  constructor(verdict, reason, more = {}) {
    super(reason);
    this.verdict = verdict;
    this.reason = reason;
    this.line = 0;
    this.isLast = false;
    Object.assign(this, more);
  }
}

// The witness is { t, pair } or { t, quad } or { t, disks }.
function refute(reason, witness) {
  throw new Stop("REFUTED", reason, { witness });
}

function undecided(reason, witness) {
  throw new Stop("UNDECIDED", reason, { witness });
}

function invalid(reason, more) {
  throw new Stop("INVALID", reason, more);
}
