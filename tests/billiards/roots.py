"""Exact real roots of polynomials with rational coefficients, given low to high."""
import math
from fractions import Fraction


def times(p, q):
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def plus(p, q, factor=1):
    longer = max(len(p), len(q))
    p, q = list(p) + [0] * (longer - len(p)), list(q) + [0] * (longer - len(q))
    return [a + factor * b for a, b in zip(p, q)]


def trim(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def slope(p):
    return [n * c for n, c in enumerate(p)][1:]


def evaluate(p, x):
    result = Fraction(0)
    for c in reversed(p):
        result = result * x + c
    return result


def integral(p):
    """p times a positive number, with integer coefficients."""
    p = [Fraction(c) for c in trim(p)]
    scale = math.lcm(*(c.denominator for c in p))
    return [c.numerator * (scale // c.denominator) for c in p]


def sign(p, x):
    """The sign at x of a polynomial with integer coefficients."""
    a, b = x.numerator, x.denominator
    result, power = 0, 1
    for c in reversed(p):
        result = result * a + c * power
        power *= b
    return (result > 0) - (result < 0)


class Root:
    """A real number: x itself where lo = hi = x, else the only root of p between lo and hi, and a simple one."""

    def __init__(self, lo, hi=None, p=None, sign_lo=0):
        self.lo, self.hi = lo, lo if hi is None else hi
        self.p, self.sign_lo = p, sign_lo

    def compare(self, x):
        """The sign of this number minus the rational x."""
        if x <= self.lo:
            return 0 if self.hi == x else 1
        if x >= self.hi:
            return -1
        at = sign(self.p, x)
        if at == 0:
            self.lo = self.hi = x
        elif at == self.sign_lo:
            self.lo = x
        else:
            self.hi = x
        return (self.lo >= x) - (self.hi <= x) if at else 0

    def halve(self):
        self.compare((self.lo + self.hi) / 2)

    def same(self, other):
        """Whether both are one number, if both are rational or roots of one polynomial."""
        lo, hi = max(self.lo, other.lo), min(self.hi, other.hi)
        if lo > hi:
            return False
        return all(x.compare(lo) >= 0 >= x.compare(hi) for x in (self, other))

    def __float__(self):
        while self.hi - self.lo > Fraction(1, 1 << 60):
            self.halve()
        return float((self.lo + self.hi) / 2)


def remainder(p, q):
    p = trim(p)
    while len(p) >= len(q):
        factor = Fraction(p[-1]) / q[-1]
        for n, c in enumerate(q, len(p) - len(q)):
            p[n] -= factor * c
        p.pop()
        p = trim(p)
    return p


def quotient(p, q):
    p, result = trim(p), []
    while len(p) >= len(q):
        factor = Fraction(p[-1]) / q[-1]
        result.append(factor)
        for n, c in enumerate(q, len(p) - len(q)):
            p[n] -= factor * c
        p.pop()
    return result[::-1]


def squarefree(p):
    if len(p) <= 2 or (len(p) == 3 and p[1] ** 2 != 4 * p[0] * p[2]):
        return p
    a, b = p, trim(slope(p))
    while b:
        a, b = b, integral(remainder(a, b))
    return integral(quotient(p, a))


def cells(p, a, b):
    """Rationals from a to b; strictly between neighbours the squarefree p has at most one root."""
    if len(p) <= 2:
        return [a, b]
    if len(p) == 3:
        vertex = Fraction(-p[1], 2 * p[2])
        return [a, vertex, b] if a < vertex < b else [a, b]
    chain = [p, trim(slope(p))]
    while len(chain[-1]) > 1:
        chain.append([-c for c in integral(remainder(chain[-2], chain[-1]))])

    def changes(x):
        signs = [s for s in (sign(q, x) for q in chain) if s]
        return sum(s != t for s, t in zip(signs, signs[1:]))

    points, todo = [a], [(a, b, changes(a), changes(b))]
    while todo:
        lo, hi, at_lo, at_hi = todo.pop()
        if at_lo - at_hi <= 1:
            points.append(hi)
        else:
            middle = (lo + hi) / 2
            at_middle = changes(middle)
            todo += [(middle, hi, at_middle, at_hi), (lo, middle, at_lo, at_middle)]
    return points


def roots(p, a, b):
    """The distinct roots in [a,b], in order, of a polynomial that is not zero everywhere."""
    p = squarefree(integral(p))
    if len(p) <= 1 or a > b:
        return []
    if len(p) == 2:
        x = Fraction(-p[0], p[1])
        return [Root(x)] if a <= x <= b else []
    found, points, rising = [], cells(p, a, b) if a < b else [a], slope(p)
    for n, point in enumerate(points):
        if sign(p, point) == 0:
            found.append(Root(point))
        if n + 1 < len(points) and point < points[n + 1]:
            after = sign(p, point) or sign(rising, point)
            before = sign(p, points[n + 1]) or -sign(rising, points[n + 1])
            if after != before:
                found.append(Root(point, points[n + 1], p, after))
    return found


def negative(p, a, b):
    """The maximal intervals within [a,b], of some length, on which p < 0: (start, end, a rational strictly inside).

    An interval of length 0 counts for nothing. A polynomial that is zero everywhere is nowhere negative."""
    p = integral(p)
    if not p or a >= b:
        return []
    marks = [Root(a)] + [x for x in roots(p, a, b) if not x.lo == x.hi or a < x.lo < b] + [Root(b)]
    found = []
    for x, y in zip(marks, marks[1:]):
        while x.hi == y.lo:
            (x if x.lo < x.hi else y).halve()
        inside = (x.hi + y.lo) / 2
        if sign(p, inside) < 0:
            found.append((x, y, inside))
    return found
