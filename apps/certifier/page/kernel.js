"use strict";
// How the page unpacks the kernel, a WebAssembly module (../module.cpp).

async function kernelModule() {
  const packed = Uint8Array.from(atob(KERNEL_MODULE), (c) => c.charCodeAt(0));
  const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}
