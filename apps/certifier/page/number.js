"use strict";
// Whole numbers and fractions. Nothing here rounds unless its name says so.

const ONE = 1n;

function absolute(x) {
  return x < 0n ? -x : x;
}

function signOf(x) {
  return x > 0n ? 1 : x < 0n ? -1 : 0;
}

function bitLength(x) {
  const digits = absolute(x).toString(16);
  return 4 * digits.length - (Math.clz32(parseInt(digits[0], 16)) - 28);
}

// Several of Euclid's steps for x >= y at once, found from their first bits (Lehmer): [a, b, c, d] with
// gcd(a x + b y, c x + d y) = gcd(x, y), as the determinant is 1 or -1. So a quotient that a number rounds
// would cost time, and nothing else.
function euclidSteps(x, y) {
  const shift = BigInt(bitLength(x) - 50);
  let u = Number(x >> shift), v = Number(y >> shift), a = 1, b = 0, c = 0, d = 1;
  while (v + c !== 0 && v + d !== 0) {
    const q = Math.floor((u + a) / (v + c));
    if (q !== Math.floor((u + b) / (v + d))) break;
    [a, b, c, d] = [c, d, a - q * c, b - q * d];
    [u, v] = [v, u - q * v];
  }
  return [a, b, c, d].map(BigInt);
}

function divisor(x, y) {
  x = absolute(x);
  y = absolute(y);
  if (x < y) [x, y] = [y, x];
  while (y >> 64n !== 0n) {
    const [a, b, c, d] = euclidSteps(x, y), next = absolute(c * x + d * y);
    if (b === 0n || next >= y) {
      [x, y] = [y, x % y];
      continue;
    }
    [x, y] = [absolute(a * x + b * y), next];
    if (x < y) [x, y] = [y, x];
  }
  while (y !== 0n) [x, y] = [y, x % y];
  return x;
}

// How often 2 divides x, which is not 0.
function twosIn(x) {
  let count = 0, low = Number(BigInt.asUintN(32, x));
  while (low === 0) {
    x >>= 32n;
    count += 32;
    low = Number(BigInt.asUintN(32, x));
  }
  return count + 31 - Math.clz32(low & -low);
}

// The whole part of the root of x >= 0.
function wholeRoot(x) {
  if (x < 4503599627370496n) return BigInt(Math.floor(Math.sqrt(Number(x))));
  const shift = BigInt(bitLength(x) >> 2);
  // Newton's steps come down from above, and stop at the root.
  let root = (wholeRoot(x >> (2n * shift)) + 1n) << shift;
  for (;;) {
    const next = (root + x / root) >> 1n;
    if (next >= root) return root;
    root = next;
  }
}

// The fraction n / (m 2^k) with m odd and positive. Binary numbers, which most are, have m = 1. Others come into lowest
// terms by reduced() alone: who keeps the result of a computation reduces it.
class Fraction {
  constructor(n, m, k) {
    this.n = n;
    this.m = m;
    this.k = k;
  }

  static whole(n) {
    return new Fraction(BigInt(n), ONE, 0);
  }

  static ratio(n, d) {
    if (d < 0n) [n, d] = [-n, -d];
    const k = twosIn(d);
    return Fraction.of(n, d >> BigInt(k), k);
  }

  // m odd and positive; k may be negative.
  static of(n, m, k) {
    return k < 0 ? new Fraction(n << BigInt(-k), m, 0) : new Fraction(n, m, k);
  }

  // In lowest terms.
  reduced() {
    if (this.n === 0n) return ZERO;
    const g = this.m === ONE ? ONE : divisor(this.n, this.m);
    const twos = this.k === 0 ? 0 : Math.min(this.k, twosIn(this.n));
    if (g === ONE && twos === 0) return this;
    const n = g === ONE ? this.n : this.n / g, m = g === ONE ? this.m : this.m / g;
    return new Fraction(n >> BigInt(twos), m, this.k - twos);
  }

  plus(o) {
    const k = Math.max(this.k, o.k);
    const a = this.k === k ? this.n : this.n << BigInt(k - this.k);
    const b = o.k === k ? o.n : o.n << BigInt(k - o.k);
    if (this.m === o.m) return new Fraction(a + b, this.m, k);
    return new Fraction(a * o.m + b * this.m, this.m * o.m, k);
  }

  minus(o) {
    return this.plus(o.negative());
  }

  negative() {
    return new Fraction(-this.n, this.m, this.k);
  }

  times(o) {
    return new Fraction(this.n * o.n, this.m * o.m, this.k + o.k);
  }

  // o is not 0.
  over(o) {
    const twos = twosIn(o.n), below = o.n >> BigInt(twos);
    const n = this.n * o.m, m = this.m * absolute(below);
    return Fraction.of(below < 0n ? -n : n, m, this.k + twos - o.k);
  }

  // Times 2^k.
  scaled(k) {
    return this.k >= k ? new Fraction(this.n, this.m, this.k - k)
      : new Fraction(this.n << BigInt(k - this.k), this.m, 0);
  }

  half() {
    return new Fraction(this.n, this.m, this.k + 1);
  }

  square() {
    return this.times(this);
  }

  abs() {
    return this.n < 0n ? this.negative() : this;
  }

  get sign() {
    return signOf(this.n);
  }

  // The sign of this - o.
  against(o) {
    let a = this.n, b = o.n;
    if (this.m !== o.m) [a, b] = [a * o.m, b * this.m];
    if (this.k < o.k) a <<= BigInt(o.k - this.k);
    if (o.k < this.k) b <<= BigInt(this.k - o.k);
    return a < b ? -1 : a > b ? 1 : 0;
  }

  less(o) {
    return this.against(o) < 0;
  }

  equals(o) {
    return this.against(o) === 0;
  }

  // Numerator and denominator in lowest terms.
  get terms() {
    const { n, m, k } = this.reduced();
    return [n, m << BigInt(k)];
  }

  toString() {
    const [n, d] = this.terms;
    return d === 1n ? String(n) : `${n}/${d}`;
  }

  // For messages: nine digits after the point, the rest cut off.
  about() {
    const digits = String((absolute(this.n) * 1000000000n) / (this.m << BigInt(this.k))).padStart(10, "0");
    return `${this.n < 0n ? "-" : ""}${digits.slice(0, -9)}.${digits.slice(-9)}`;
  }

  // Near it, for drawing and messages only.
  near() {
    const excess = Math.max(0, bitLength(this.n) - 1000, bitLength(this.m) + this.k - 1000);
    const n = this.n >> BigInt(excess), d = (this.m << BigInt(this.k)) >> BigInt(excess);
    return d === 0n ? 0 : Number(n) / Number(d);
  }
}

const ZERO = Fraction.whole(0);
const UNIT = Fraction.whole(1);

function greater(a, b) {
  return a.less(b) ? b : a;
}

function lesser(a, b) {
  return b.less(a) ? b : a;
}

function power(base, exponent) {
  if (exponent >= 0) return Fraction.whole(BigInt(base) ** BigInt(exponent));
  return Fraction.ratio(1n, BigInt(base) ** BigInt(-exponent));
}

// The binary64 nearest to x, ties to even; null beyond the greatest.
function nearestBinary64(x) {
  if (x.n === 0n) return ZERO;
  const n = absolute(x.n), d = x.m;
  // With n / d = y, 2^e is the unit in the last place of 53 bits of y.
  let e = bitLength(n) - bitLength(d) - 53;
  if (e >= -53 ? n >= d << BigInt(e + 53) : n << BigInt(-e - 53) >= d) ++e;
  e = Math.max(e - x.k, -1074);
  const shift = e + x.k;
  const [a, b] = shift >= 0 ? [n, d << BigInt(shift)] : [n << BigInt(-shift), d];
  let whole = a / b;
  const twice = 2n * (a - whole * b);
  if (twice > b || (twice === b && (whole & 1n) === 1n)) ++whole;
  if (whole !== 0n && bitLength(whole) + e > 1024) return null;
  const nearest = new Fraction(x.n < 0n ? -whole : whole, ONE, 0);
  return (e >= 0 ? new Fraction(nearest.n << BigInt(e), ONE, 0) : new Fraction(nearest.n, ONE, -e)).reduced();
}

// An upper bound of the length of the vector, less than 2^-60 of it too great.
function lengthAbove(v) {
  const [n, d] = norm2(v).terms;
  if (n === 0n) return ZERO;
  return Fraction.ratio(wholeRoot((n * d) << 124n) + 1n, d << 62n);
}

// ---- Vectors: [x, y]

function dot(a, b) {
  return a[0].times(b[0]).plus(a[1].times(b[1]));
}

function norm2(v) {
  return dot(v, v);
}

// v + k n
function along(v, k, n) {
  return [v[0].plus(k.times(n[0])), v[1].plus(k.times(n[1]))];
}

function difference(a, b) {
  return [a[0].minus(b[0]), a[1].minus(b[1])];
}

function stretched(k, v) {
  return [k.times(v[0]), k.times(v[1])];
}
