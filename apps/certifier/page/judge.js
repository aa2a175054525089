"use strict";
// How the kernel's module (../module.cpp) is asked, by the page and by the npm package (packaging/npm).

const NO_SYSTEM = 52;  // the error of WASI for what is not there

// The kernel's answer on the bytes of both files. It tells `progress(rule, claim, of)` how far it is. Throws where
// there is no answer. Each call has a memory of its own.
function judge(module, scene, history, options, progress) {
  const memory = () => new Uint8Array(exports.memory.buffer);
  const words = (address) => {
    const at = address >>> 0;
    return new TextDecoder().decode(memory().subarray(at, memory().indexOf(0, at)));
  };
  const { exports } = new WebAssembly.Instance(module, {
    page: { progress: (rule, claim, of) => progress(words(rule), claim, of) },
    env: { emscripten_notify_memory_growth: () => {} },
    wasi_snapshot_preview1: {
      environ_get: () => NO_SYSTEM,
      environ_sizes_get: () => NO_SYSTEM,
      proc_exit: (code) => {
        throw new Error(`the kernel has ended by itself, with code ${code}`);
      },
    },
  });
  try {
    exports._initialize();
    [scene, history, new TextEncoder().encode(JSON.stringify(options))].forEach((bytes, k) => {
      const at = exports.text(k, bytes.length) >>> 0;
      memory().set(bytes, at);
    });
    return JSON.parse(words(exports.judge()));
  } catch (error) {
    throw error instanceof WebAssembly.Exception ? new Error("the kernel has no memory left") : error;
  }
}
