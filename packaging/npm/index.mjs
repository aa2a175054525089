// The kernel of voroproof for Node.js and browsers; index.d.ts says what it takes and gives.
import { judge } from "./judge.mjs";

const DEFAULTS = { truth: "recorded", tolerance: "1e-6", lawTolerance: "1e-9", strict: false, unoriented: false };

let loaded;  // the compiled module, once somebody has asked

async function compiled() {
  const file = new URL("./kernel.wasm", import.meta.url);
  if (file.protocol !== "file:") return WebAssembly.compileStreaming(fetch(file));
  const { readFile } = await import("node:fs/promises");
  return WebAssembly.compile(await readFile(file));
}

function bytesOf(file) {
  return typeof file === "string" ? new TextEncoder().encode(file) : file;
}

export async function certify(scene, history, { progress = () => {}, ...options } = {}) {
  for (const name of Object.keys(options)) {
    if (!(name in DEFAULTS)) throw new TypeError(`${name}: no such option`);
  }
  const asked = { ...DEFAULTS, ...options };
  if (asked.truth !== "recorded" && asked.truth !== "exact") throw new TypeError("truth: neither recorded nor exact");
  for (const name of ["tolerance", "lawTolerance"]) asked[name] = String(asked[name]);
  loaded ??= compiled();
  return judge(await loaded, bytesOf(scene), bytesOf(history), asked, progress);
}
