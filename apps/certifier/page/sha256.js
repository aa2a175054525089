"use strict";
// SHA-256 (FIPS 180-4): which scene a history is of. No proof uses it.

const SHA256_ROUNDS = 64;

// The first 32 bits of the fractional parts of the roots of the first primes: square roots of 8 of them make the
// state, cube roots of 64 the constants. Found by whole numbers.
function sha256Constants() {
  const primes = [];
  for (let n = 2; primes.length < SHA256_ROUNDS; ++n) {
    if (primes.every((p) => n % p !== 0)) primes.push(n);
  }
  const low = (x) => Number(BigInt.asUintN(32, x)) | 0;
  const cubeRoot = (x) => {
    let root = 0n;
    for (let bit = 1n << 40n; bit > 0n; bit >>= 1n) {
      if ((root + bit) ** 3n <= x) root += bit;
    }
    return root;
  };
  return {
    state: primes.slice(0, 8).map((p) => low(wholeRoot(BigInt(p) << 64n))),
    constants: primes.map((p) => low(cubeRoot(BigInt(p) << 96n))),
  };
}

// Returns the hash of the bytes as 64 hexadecimal digits.
function sha256(bytes) {
  const { state, constants } = sha256Constants();
  const padded = new Uint8Array(Math.ceil((bytes.length + 9) / 64) * 64);
  padded.set(bytes);
  padded[bytes.length] = 0x80;
  const view = new DataView(padded.buffer);
  view.setUint32(padded.length - 8, Math.floor(bytes.length / 2 ** 29));
  view.setUint32(padded.length - 4, (bytes.length * 8) >>> 0);
  const w = new Int32Array(SHA256_ROUNDS), turned = (x, n) => (x >>> n) | (x << (32 - n));
  for (let block = 0; block < padded.length; block += 64) {
    for (let i = 0; i < 16; ++i) w[i] = view.getInt32(block + 4 * i);
    for (let i = 16; i < SHA256_ROUNDS; ++i) {
      const x = w[i - 15], y = w[i - 2];
      w[i] = w[i - 16] + (turned(x, 7) ^ turned(x, 18) ^ (x >>> 3)) + w[i - 7]
        + (turned(y, 17) ^ turned(y, 19) ^ (y >>> 10));
    }
    let [a, b, c, d, e, f, g, h] = state;
    for (let i = 0; i < SHA256_ROUNDS; ++i) {
      const first = (h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & f) ^ (~e & g)) + constants[i] + w[i]) | 0;
      const second = ((turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [h, g, f, e, d, c, b, a] = [g, f, e, (d + first) | 0, c, b, a, (first + second) | 0];
    }
    [a, b, c, d, e, f, g, h].forEach((x, i) => (state[i] = (state[i] + x) | 0));
  }
  return state.map((x) => (x >>> 0).toString(16).padStart(8, "0")).join("");
}
