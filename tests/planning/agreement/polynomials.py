"""Signs and roots of rational polynomials on [0, 1], exactly, by Sturm's theorem.

A polynomial is the list of its coefficients, that of the power 0 first, with none of 0 at the end; [] is zero.
"""

from fractions import Fraction
from functools import reduce
from math import gcd, lcm


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def plus(p, q):
    longest = max(len(p), len(q))
    return trimmed((p[k] if k < len(p) else 0) + (q[k] if k < len(q) else 0) for k in range(longest))


def times(p, q):
    product = [Fraction(0)] * (len(p) + len(q))
    for i, a in enumerate(p):
        for k, b in enumerate(q):
            product[i + k] += a * b
    return trimmed(product)


def whole(p):
    """A positive multiple, of whole numbers without a common divisor."""
    scale = lcm(*(Fraction(c).denominator for c in p)) if p else 1
    scaled = [int(c * scale) for c in p]
    divisor = reduce(gcd, scaled, 0) or 1
    return [c // divisor for c in scaled]


def value(p, x):
    result = Fraction(0)
    for c in reversed(p):
        result = result * x + c
    return result


def sign(p, x):
    """The sign of a polynomial of whole numbers at a fraction."""
    n, d = x.numerator, x.denominator
    result, power = 0, 1
    for c in reversed(p):
        result = result * n + c * power
        power *= d
    return (result > 0) - (result < 0)


def derivative(p):
    return [k * c for k, c in enumerate(p)][1:]


def remainder(p, q):
    """A positive multiple of the rest of p by q, of whole numbers."""
    p = list(p)
    while len(p) >= len(q):
        factor, shift = p[-1], len(p) - len(q)
        size = abs(q[-1])
        turned = factor if q[-1] > 0 else -factor
        p = [c * size for c in p]
        for k, c in enumerate(q):
            p[k + shift] -= turned * c
        p = trimmed(p)
    return whole(p)


def quotient(p, q):
    """Where q divides p."""
    p, result = [Fraction(c) for c in p], [Fraction(0)] * (len(p) - len(q) + 1)
    while len(p) >= len(q):
        factor, shift = p[-1] / q[-1], len(p) - len(q)
        result[shift] = factor
        for k, c in enumerate(q):
            p[k + shift] -= factor * c
        p = trimmed(p)
    return result


def sturm(p):
    sequence = [p, whole(derivative(p))]
    while sequence[-1]:
        sequence.append([-c for c in remainder(sequence[-2], sequence[-1])])
    return sequence[:-1]


class PolynomialRoot:
    """A root between lo and hi, or equal to both."""

    def __init__(self, p, lo, hi):
        self.p, self.lo, self.hi = p, lo, hi
        self.sign_at_lo = sign(p, lo)

    def halve(self):
        if self.lo < self.hi:
            self._look_at((self.lo + self.hi) / 2)

    def narrow(self, width):
        while self.hi - self.lo > width:
            self.halve()

    def against(self, x):
        """-1, 0 or 1: whether the root is less than x, x or greater."""
        if self.lo < x < self.hi:
            self._look_at(x)
        if self.lo == self.hi:
            return (self.lo > x) - (self.lo < x)
        return 1 if self.lo >= x else -1

    def _look_at(self, x):
        here = sign(self.p, x)
        if here == 0:
            self.lo = self.hi = x
        elif here == self.sign_at_lo:
            self.lo = x
        else:
            self.hi = x


def common_part(p, q):
    """The greatest common divisor."""
    while q:
        p, q = q, remainder(p, q) if len(p) >= len(q) else p
    return p


def square_free(p):
    p = whole(p)
    common = sturm(p)[-1]
    return whole(quotient(p, common)) if len(common) > 1 else p


def roots(p):
    """The distinct roots in [0, 1], in order. No two have a common place between lo and hi; an end they may share."""
    if len(p) < 2:
        return []
    p = square_free(p)
    sequence = sturm(p)

    def variations(x):
        signs = [s for s in (sign(q, x) for q in sequence) if s]
        return sum(a != b for a, b in zip(signs, signs[1:]))

    found, zero, one = [], Fraction(0), Fraction(1)
    if sign(p, zero) == 0:
        found.append(PolynomialRoot(p, zero, zero))
    todo = [(zero, one, variations(zero), variations(one))]
    while todo:
        lo, hi, at_lo, at_hi = todo.pop()
        if at_lo == at_hi:
            continue
        if at_lo - at_hi == 1 and sign(p, hi) == 0:
            found.append(PolynomialRoot(p, hi, hi))
        elif at_lo - at_hi == 1 and sign(p, lo) != 0:
            found.append(PolynomialRoot(p, lo, hi))
        else:
            middle = (lo + hi) / 2
            at_middle = variations(middle)
            todo += [(middle, hi, at_middle, at_hi), (lo, middle, at_lo, at_middle)]
    return found


def bounds(p):
    """Bounds of the values on [0, 1]: the least and the greatest Bernstein coefficient."""
    row, n = [], len(p) - 1
    scaled, choose = [], 1
    for k, c in enumerate(p):
        scaled.append(Fraction(c) / choose)
        choose = choose * (n - k) // (k + 1)
    for i in range(n + 1):
        total, choose = Fraction(0), 1
        for k in range(i + 1):
            total += choose * scaled[k]
            choose = choose * (i - k) // (k + 1)
        row.append(total)
    return (min(row), max(row)) if row else (Fraction(0), Fraction(0))


def between(places):
    """0 and 1 where they are no roots, and a place between any two neighbours of 0, the roots and 1."""
    zero, one = Fraction(0), Fraction(1)
    ends = [(zero, zero)] + [(r.lo, r.hi) for r in places] + [(one, one)]
    return [(a[1] + b[0]) / 2 for a, b in zip(ends, ends[1:])]


def negative_parts(p, h):
    """The longest intervals with p < 0, and h < 0 unless h is None: the root where each begins, and where it ends.

    None stands for 0 at the begin and 1 at the end, which belong to the interval; roots do not.
    """
    kinds = [whole(f) for f in ([p] if h is None else [p, h])]
    if any(not f for f in kinds):
        return []
    product = kinds[0] if h is None else whole(times(*kinds))
    places = roots(product)
    parts = []
    for k, x in enumerate(between(places)):
        first, last = places[k - 1] if k else None, places[k] if k < len(places) else None
        if first and not first.lo < first.hi and first.lo == 1 or last and last.lo == last.hi == 0:
            continue
        if all(sign(f, x) < 0 for f in kinds):
            parts.append((first, last))
    return parts


def is_negative_at(h, root):
    """Whether a polynomial of whole numbers is negative at a root of another one."""
    if not h:
        return False
    if root.lo < root.hi:
        common = common_part(root.p, h)
        if sign(common, root.lo) != sign(common, root.hi):
            return False
        while any(r.against(root.lo) >= 0 >= r.against(root.hi) for r in roots(h)):
            root.halve()
    return sign(h, root.lo) < 0


def reaches(p, h, strict):
    """Whether somewhere in [0, 1] p < 0, or p <= 0 unless strict, and h < 0 unless h is None."""
    if negative_parts(p, h):
        return True
    if strict:
        return False
    if not whole(p):
        return h is None or bool(negative_parts(h, None))
    return any(h is None or is_negative_at(whole(h), root) for root in roots(p))
