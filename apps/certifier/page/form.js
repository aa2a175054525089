"use strict";
// Polynomials over an interval (docs/kernel.md, section 5): over [a, b] time is t = (a + z b)/(1 + z). A form is the list
// of the whole coefficients in z; its first has the sign at a, its last that at b. At one time a form has one.

// The greatest prime below 2^26: products of remainders are exact as numbers.
const PRIME = 67108859;

// The inverse of x modulo PRIME, by Fermat.
function inverseModulo(x) {
  let result = 1;
  for (let e = PRIME - 2; e > 0; e = Math.floor(e / 2)) {
    if (e % 2 === 1) result = (result * x) % PRIME;
    x = (x * x) % PRIME;
  }
  return result;
}

const Form = {
  sum(p, q) {
    return p.map((c, k) => c + q[k]);
  },

  difference(p, q) {
    return p.map((c, k) => c - q[k]);
  },

  product(p, q) {
    if (p.length === 1 && q.length === 1) return [p[0] * q[0]];
    const r = new Array(p.length + q.length - 1).fill(0n);
    for (let i = 0; i < p.length; ++i) {
      for (let j = 0; j < q.length; ++j) r[i + j] += p[i] * q[j];
    }
    return r;
  },

  square(p) {
    const r = new Array(2 * p.length - 1).fill(0n);
    for (let i = 0; i < p.length; ++i) {
      for (let j = 0; j < i; ++j) r[i + j] += p[i] * p[j];
    }
    return r.map((c, k) => (k % 2 === 0 ? c + c + p[k / 2] ** 2n : c + c));
  },

  // p u - q v
  cross(p, u, q, v) {
    return Form.difference(Form.product(p, u), Form.product(q, v));
  },

  // p u + q v
  inner(p, u, q, v) {
    return Form.sum(Form.product(p, u), Form.product(q, v));
  },

  // Those over the two halves of the interval. The right half is z = 1 + 2 w, the left its mirror image.
  halves(p) {
    return [[...p].reverse(), p].map((side, k) => {
      const q = [...side], { length } = q;
      for (let i = 0; i + 1 < length; ++i) {
        for (let j = length - 2; j >= i; --j) q[j] += q[j + 1];
      }
      for (let j = 1; j < length; ++j) q[j] <<= BigInt(j);
      return k === 0 ? q.reverse() : q;
    });
  },

  isZero(p) {
    return p.every((c) => c === 0n);
  },

  // V: at most so many roots in (a, b), with multiplicity, and as many modulo 2.
  variations(p) {
    let changes = 0, last = 0;
    for (const c of p) {
      if (c === 0n) continue;
      const sign = c > 0n ? 1 : -1;
      if (sign === -last) ++changes;
      last = sign;
    }
    return changes;
  },

  // Without zeros at its ends and without a common factor: roots at a and b are dropped.
  primitive(p) {
    const q = Form.trimmed(p), content = q.reduce((g, c) => (g === ONE ? g : divisor(g, c)), 0n);
    return content > ONE ? q.map((c) => c / content) : q;
  },

  // p modulo q and p / q, each up to a constant.
  divided(p, q) {
    const rest = [...p], quotient = new Array(Math.max(0, p.length - q.length + 1)).fill(0n);
    const lead = q[q.length - 1];
    for (; rest.length >= q.length; rest.pop()) {
      const last = rest[rest.length - 1], g = divisor(last, lead);
      const up = lead / g, by = last / g, shift = rest.length - q.length;
      for (let k = 0; k < rest.length; ++k) rest[k] *= up;
      for (let k = 0; k < quotient.length; ++k) quotient[k] *= up;
      for (let k = 0; k < q.length; ++k) rest[k + shift] -= by * q[k];
      quotient[shift] = by;
    }
    return { rest, quotient };
  },

  // Without the zeros at its ends.
  trimmed(p) {
    let first = 0, end = p.length;
    while (end > first && p[end - 1] === 0n) --end;
    while (first < end && p[first] === 0n) ++first;
    return first === 0 && end === p.length ? p : p.slice(first, end);
  },

  // Whether p and q are seen to have no common divisor: they have none modulo a prime that divides neither's
  // last coefficient, and a divisor of whole coefficients would be one there, of the same degree.
  areSeenCoprime(p, q) {
    let [a, b] = [p, q].map((form) => form.map((c) => Number(((c % BigInt(PRIME)) + BigInt(PRIME)) % BigInt(PRIME))));
    if (a.length === 0 || b.length === 0 || a[a.length - 1] === 0 || b[b.length - 1] === 0) return false;
    while (b.length > 1) {
      if (a.length < b.length) [a, b] = [b, a];
      const lead = inverseModulo(b[b.length - 1]);
      while (a.length >= b.length) {
        const by = (a[a.length - 1] * lead) % PRIME, shift = a.length - b.length;
        for (let k = 0; k < b.length; ++k) a[k + shift] = (a[k + shift] + PRIME - ((by * b[k]) % PRIME)) % PRIME;
        while (a.length > 0 && a[a.length - 1] === 0) a.pop();
      }
      [a, b] = [b, a];
    }
    return b.length === 1;
  },

  // The roots in (a, b) that both have. Neither is zero.
  common(p, q) {
    if (Form.areSeenCoprime(Form.trimmed(p), Form.trimmed(q))) return [1n];
    p = Form.primitive(p);
    q = Form.primitive(q);
    while (q.length > 0) {
      if (p.length < q.length) [p, q] = [q, p];
      [p, q] = [q, Form.primitive(Form.divided(p, q).rest)];
    }
    return p;
  },

  // Returns a form with the same roots in (a, b), each of them once. p is not zero.
  squarefree(p) {
    const derivativeOf = (q) => q.slice(1).map((c, k) => BigInt(k + 1) * c), trimmed = Form.trimmed(p);
    if (Form.areSeenCoprime(trimmed, derivativeOf(trimmed))) return trimmed;
    const whole = Form.primitive(p), derivative = derivativeOf(whole);
    return Form.divided(whole, Form.common(whole, derivative)).quotient;
  },
};

// The sign of u + v sqrt(gamma), gamma >= 0.
function signWithRoot(u, v, gamma) {
  const a = signOf(u), b = gamma === 0n ? 0 : signOf(v);
  if (a === b || b === 0) return a;
  return a === 0 ? b : a * signOf(u * u - gamma * v * v);
}
