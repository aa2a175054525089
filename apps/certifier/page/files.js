"use strict";
// The two files that the page is given: by choice or by drop, as they are or packed by gzip.

class GivenFile {
  constructor(name, bytes) {
    this.name = name;
    this.bytes = bytes;
  }

  static async read(file) {
    let bytes = new Uint8Array(await file.arrayBuffer());
    if (bytes[0] === 0x1f && bytes[1] === 0x8b) {
      const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
      bytes = new Uint8Array(await new Response(unpacked).arrayBuffer());
    }
    return new GivenFile(file.name, bytes);
  }

  // "scene" or "history": by what its beginning says, else by its name.
  get role() {
    const start = new TextDecoder().decode(this.bytes.subarray(0, 4096));
    const format = /"format"\s*:\s*"voroproof-(scene|history)"/.exec(start);
    if (format) return format[1];
    return /\.jsonl(\.gz)?$/.test(this.name) ? "history" : "scene";
  }

  get size() {
    const n = this.bytes.length;
    return n < 1000 ? `${n} bytes` : n < 1e6 ? `${(n / 1000).toFixed(1)} kB` : `${(n / 1e6).toFixed(1)} MB`;
  }
}
