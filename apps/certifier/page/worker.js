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

self.onmessage = ({ data: { scene, history, options } }) => {
  const started = performance.now();
  let told = started;
  const certification = new Certification(options, (phase, done, of) => {
    const now = performance.now();
    if (now - told > PROGRESS_INTERVAL) {
      told = now;
      self.postMessage({ kind: "progress", phase, done, of });
    }
    return !(options.seconds > 0 && now - started > 1000 * options.seconds);
  });
  try {
    const result = certification.run(scene, history);
    self.postMessage({
      kind: "result", verdict: result.verdict, reason: result.reason, line: result.line,
      place: { file: result.file, line: result.fileLine, field: result.field },
      isFirst: result.isFirst, counts: result.counts, lines: linesOf(result), about: result.about, seconds: (performance.now() - started) / 1000,
      claim: lineOf(result.file === "scene" ? scene : history, result.fileLine || result.line),
      drawing: drawingOf(certification.problem, result.witness),
    });
  } catch (error) {
    self.postMessage({ kind: "failure", reason: String(error?.message ?? error) });
  }
};
