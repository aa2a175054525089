"use strict";
// Runs beside the page: takes { scene, history, options } and answers with progress and the result.

const PROGRESS_INTERVAL = 80;  // milliseconds

function lineOf(bytes, line) {
  let at = 0;
  for (let k = 1; k < line; ++k) {
    at = bytes.indexOf(10, at) + 1;
    if (at === 0) return "";
  }
  const end = bytes.indexOf(10, at), text = bytes.subarray(at, Math.min(at + 2000, end < 0 ? bytes.length : end));
  return new TextDecoder().decode(text);
}

// States what the verdict is about, in the words of `certify`. Empty where a file could not be read.
function aboutOf({ truth, tolerance, lawTolerance, strict }, { horizon, horizonNote }) {
  if (horizon === null) return "";
  return [`all events, ${truth} truth, up to t = ${horizon}`, `times within ${tolerance}`, `velocities within ${lawTolerance}`,
    ...(strict ? ["strict"] : []), ...(horizonNote ? [horizonNote] : [])].join(", ");
}

self.onmessage = async ({ data: { scene, history, options } }) => {
  const started = performance.now();
  let told = started;
  const progress = (rule, claim, of) => {
    const now = performance.now();
    if (now - told < PROGRESS_INTERVAL) return;
    told = now;
    self.postMessage({ kind: "progress", rule, claim, of });
  };
  try {
    const answer = judge(await kernelModule(), scene, history, options, progress);
    self.postMessage({
      kind: "result", ...answer, about: aboutOf(options, answer), seconds: (performance.now() - started) / 1000,
      claim: answer.line > 0 ? lineOf(history, answer.line) : "",
    });
  } catch (error) {
    self.postMessage({ kind: "failure", reason: String(error?.message ?? error) });
  }
};
