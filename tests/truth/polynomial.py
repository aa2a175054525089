"""Polynomials with integer coefficients, and their real roots at dyadic places.

A polynomial is a list of coefficients, the constant first and the last one not 0; [] is 0. A dyadic number is
a pair (m, e), that is m / 2^e, e >= 0.
"""
from math import comb, gcd

from circle import sign

PRIMES = ((1 << 61) - 1, (1 << 31) - 1)


def trimmed(p):
    while p and not p[-1]:
        p.pop()
    return p


def add(p, q, factor=1):
    """p + factor q."""
    size = max(len(p), len(q))
    return trimmed([(p[i] if i < len(p) else 0) + factor * (q[i] if i < len(q) else 0)
                    for i in range(size)])


def multiply(p, *others):
    for q in others:
        result = [0] * (len(p) + len(q) - 1) if p and q else []
        for i, a in enumerate(p):
            if a:
                for j, b in enumerate(q):
                    result[i + j] += a * b
        p = result
    return p


def derivative(p):
    return [k * p[k] for k in range(1, len(p))]


def primitive(p):
    content = gcd(*p)
    return [c // content for c in p] if content > 1 else list(p)


def remainder(p, q):
    """A multiple of the remainder of p by q."""
    p = list(p)
    while len(p) >= len(q):
        common = gcd(p[-1], q[-1])
        a, b, shift = q[-1] // common, p[-1] // common, len(p) - len(q)
        p = [a * c for c in p]
        for i, c in enumerate(q):
            p[i + shift] -= b * c
        trimmed(p)
    return p


def coprime_by_prime(p, q):
    """True only if p and q have no common divisor: one would remain one modulo a prime that
    does not divide both leading coefficients."""
    for prime in PRIMES:
        if not p[-1] % prime or not q[-1] % prime:
            continue
        a, b = trimmed([c % prime for c in p]), trimmed([c % prime for c in q])
        while b:
            inverse = pow(b[-1], -1, prime)
            while len(a) >= len(b):
                factor, shift = a[-1] * inverse % prime, len(a) - len(b)
                for i, c in enumerate(b):
                    a[i + shift] = (a[i + shift] - factor * c) % prime
                trimmed(a)
            a, b = b, a
        if len(a) == 1:
            return True
    return False


def common_divisor(p, q):
    """The greatest common divisor, primitive. Neither is 0."""
    if len(p) == 1 or len(q) == 1 or coprime_by_prime(p, q):
        return [1]
    p, q = primitive(p), primitive(q)
    while q:
        p, q = q, remainder(p, q)
        q = primitive(q) if q else q
    return p


def quotient(p, q):
    """p / q, where q is primitive and divides p."""
    p, result = list(p), [0] * (len(p) - len(q) + 1)
    for shift in range(len(result) - 1, -1, -1):
        factor, rest = divmod(p[shift + len(q) - 1], q[-1])
        assert not rest
        result[shift] = factor
        for i, c in enumerate(q):
            p[i + shift] -= factor * c
    assert not any(p)
    return result


def squarefree(p):
    """A polynomial with the same roots, each once."""
    if len(p) < 3:
        return primitive(p)
    return primitive(quotient(p, common_divisor(p, derivative(p))))


# Dyadic places.

def dyadic(value):
    numerator, denominator = value.as_integer_ratio()
    return numerator, denominator.bit_length() - 1


def aligned(a, b):
    """(m, n, e) with a = m / 2^e and b = n / 2^e."""
    e = max(a[1], b[1])
    return a[0] << (e - a[1]), b[0] << (e - b[1]), e


def before(a, b):
    m, n, _ = aligned(a, b)
    return m < n


def middle(a, b):
    m, n, e = aligned(a, b)
    return m + n, e + 1


def value_at(p, place):
    """p(place) times a power of two."""
    m, e = place
    result, shift = 0, 0
    for c in reversed(p):
        result = result * m + (c << shift)
        shift += e
    return result


# Roots in an interval, by Descartes' rule of signs.

def shifted(p):
    """p(x + 1)."""
    p = list(p)
    for i in range(len(p) - 1):
        for j in range(len(p) - 2, i - 1, -1):
            p[j] += p[j + 1]
    return p


def on_unit(p, a, b):
    """A positive multiple of p(a + (b - a) x)."""
    m, n, e = aligned(a, b)
    width, degree = n - m, len(p) - 1
    p = [c << (e * (degree - k)) for k, c in enumerate(p)]
    powers = [1]
    for _ in range(degree):
        powers.append(powers[-1] * m)
    result, scale = [], 1
    for k in range(degree + 1):
        result.append(scale * sum(comb(i, k) * p[i] * powers[i - k] for i in range(k, degree + 1)))
        scale *= width
    return result


def variations(p):
    """No fewer than the roots of p in the open unit interval, and as many where it is 0 or 1."""
    signs = [c > 0 for c in shifted(p[::-1]) if c]
    return sum(a != b for a, b in zip(signs, signs[1:]))


def first_sign(p):
    return next((sign(c) for c in p if c), 0)


class Root:
    """The only root of a squarefree polynomial between low and high, or the place low = high.

    `left` is the sign of the polynomial right after low.
    """

    def __init__(self, p, low, high, left):
        self.p, self.low, self.high, self.left = p, low, high, left
        self.step = 1

    @property
    def exact(self):
        return self.low == self.high

    def side(self, place):
        """The sign of root - place; what it learns, it keeps."""
        if self.exact:
            m, n, _ = aligned(self.low, place)
            return sign(m - n)
        if not before(self.low, place):
            return 1
        if not before(place, self.high):
            return -1
        now = sign(value_at(self.p, place))
        if now == 0:
            self.low = self.high = place
        elif now == self.left:
            self.low = place
        else:
            self.high = place
        return now * self.left

    def refine(self):
        """Narrows the interval: to one of 2^step parts where the chord's zero is near the root, else to a half."""
        if self.exact:
            return
        m, n, e = aligned(self.low, self.high)
        at_low, at_high = value_at(self.p, (m, e)), value_at(self.p, (n, e))
        if self.step == 1 or not at_low or not at_high:
            self.side(middle(self.low, self.high))
            self.step = 2
            return
        guess = (2 * (at_low << self.step) // (at_low - at_high) + 1) // 2
        for part in (guess, guess - 1, guess + 1):
            if 0 < part < 1 << self.step:
                self.side(((m << self.step) + part * (n - m), e + self.step))
        u, v, k = aligned(self.low, self.high)
        narrow = (v - u) << (e + self.step) <= (n - m) << k
        self.step = 2 * self.step if narrow else self.step // 2


def roots_between(p, a, b):
    """The roots of a squarefree p in the open interval (a, b), in increasing order."""
    found = []
    # An interval as (its polynomial on the unit interval, k, j): from a + (b - a) k / 2^j to k + 1.
    m, n, e = aligned(a, b)

    def place(k, j):
        return (m << j) + k * (n - m), e + j

    stack = [(on_unit(p, a, b), 0, 0)]
    while stack:
        q, k, j = stack.pop()
        if q is None:
            found.append(Root(p, place(k, j), place(k, j), 0))
            continue
        count = variations(q)
        if count == 1:
            found.append(Root(p, place(k, j), place(k + 1, j), first_sign(q)))
        if count < 2:
            continue
        left = [c << (len(q) - 1 - i) for i, c in enumerate(q)]
        right = shifted(left)
        stack.append((right, 2 * k + 1, j + 1))
        if not right[0]:
            stack.append((None, 2 * k + 1, j + 1))
        stack.append((left, 2 * k, j + 1))
    return found


def vanishes(p, root):
    """Whether p is 0 at the root of another polynomial."""
    if not p:
        return True
    if root.exact:
        return value_at(p, root.low) == 0
    divisor = common_divisor(p, root.p)
    if len(divisor) == 1:
        return False
    # It divides the other polynomial, so it has that root or none between low and high.
    local = on_unit(divisor, root.low, root.high)
    at_high = shifted(local)
    last = next(i for i, c in enumerate(at_high) if c)
    return first_sign(local) != sign(at_high[last]) * (-1) ** last


def order_at(p, root):
    """The order of the zero of p at the root, p not 0."""
    order = 0
    while vanishes(p, root):
        p, order = derivative(p), order + 1
    return order


def sign_at(p, root):
    """The sign of p at the root, where p is not 0."""
    while not root.exact:
        local = on_unit(p, root.low, root.high)
        if variations(local) == 0:
            return first_sign(local)
        root.refine()
    return sign(value_at(p, root.low))


def positive_between(p, a, b):
    """Whether p > 0 in all of the closed interval."""
    if value_at(p, a) <= 0 or value_at(p, b) <= 0:
        return False
    return variations(on_unit(p, a, b)) == 0 or not roots_between(squarefree(p), a, b)
