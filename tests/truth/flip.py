"""Four generators in motion: the cotangency f, and the gap of the circle of three and the fourth.

The gap comes from the two linear equations and the cone of circle.py, now with coefficients that are
polynomials of the time. Let J be the form diag(1, 1, -1), q_ij = N_i.J N_j, Q = N1 x N2, and
b = Y.J Q, a square root of which the turn of the contacts selects the sign. Three linear equations,
N1.Y = K1, N2.Y = K2, (J Q).Y = b, of determinant A = Q.J Q, have the solution

    A Y = (K2 q12 - K1 q22) J N1 + (K1 q12 - K2 q11) J N2 + b Q,

and Y.J Y = 0 gives b^2 = D = K1^2 q22 - 2 K1 K2 q12 + K2^2 q11. So coordinates of the circle and
the gap are (U + side V sqrt(D)) / A, up to factors that do not vanish, and D > 0 where no two
generators touch. Zeros are decided at the roots of polynomials that vanish wherever they can be: the
orders of U, V and U^2 - V^2 D there are integers that gcds find.
"""
from circle import circle, turned
from fields import Wrong
from polynomial import (add, derivative, multiply, order_at, positive_between, roots_between, sign_at,
                        squarefree, trimmed, value_at)


def moving(generator):
    """(letter, x, y, r) with polynomials of the time; of a wall (letter, a, b, h)."""
    letter, x, y, r, vx, vy, vr = generator
    return (letter, trimmed([x, vx]), trimmed([y, vy]), trimmed([r, vr]))


def at(generators, place):
    """Moving generators of integers, at a dyadic time, larger by a power of two."""
    m, e = place
    result = []
    for letter, x, y, r, vx, vy, vr in generators:
        if letter == "w":
            result.append((letter, x, y, r << e))
        else:
            result.append((letter, (x << e) + m * vx, (y << e) + m * vy, (r << e) + m * vr))
    return result


def square(p):
    return multiply(p, p)


def minus(p, q):
    return add(p, q, -1)


def tangency(g, h):
    """The p of two moving generators, as the format says."""
    letters = {g[0], h[0]}
    if letters == {"w", "c"}:
        raise Wrong("a container beside a wall")
    if letters == {"d", "w"}:
        (_, x, y, r), (_, a, b, height) = (g, h) if g[0] == "d" else (h, g)
        distance = add(add(multiply(a, x), multiply(b, y)), minus(r, height))
        return [2 * c for c in distance]
    distance = add(square(minus(g[1], h[1])), square(minus(g[2], h[2])))
    if letters == {"w"}:
        return distance
    return minus(distance, square(add(g[3], h[3], -1 if letters == {"d"} else 1)))


def cotangency(generators):
    """f of four moving generators."""
    g = [moving(one) for one in generators]
    u = multiply(tangency(g[0], g[1]), tangency(g[2], g[3]))
    v = multiply(tangency(g[0], g[2]), tangency(g[1], g[3]))
    w = multiply(tangency(g[0], g[3]), tangency(g[1], g[2]))
    return minus(square(minus(minus(u, v), w)), multiply(v, w, [4]))


def clearances(g, h):
    """Polynomials that are positive exactly while two moving generators, one of them a disk, are apart."""
    if g[0] != "d":
        g, h = h, g
    (_, x, y, r), (letter, a, b, c) = g, h
    if letter == "w":
        return [minus(add(multiply(a, x), multiply(b, y)), add(c, r))]
    distance = add(square(minus(x, a)), square(minus(y, b)))
    if letter == "d":
        return [minus(distance, square(add(r, c)))]
    return [minus(c, r), minus(square(minus(c, r)), distance)]


def plane(reference, g):
    """circle.plane of moving generators."""
    _, x0, y0, r0 = reference
    letter, x, y, r = g
    if letter == "w":
        height = minus(minus(r, r0), add(multiply(x, x0), multiply(y, y0)))
        return (x, y, [-1]), [2 * c for c in height]
    normal = (minus(x, x0), minus(y, y0), minus(r if letter == "d" else [-c for c in r], r0))
    return normal, form(normal, normal)


def form(v, w):
    return minus(add(multiply(v[0], w[0]), multiply(v[1], w[1])), multiply(v[2], w[2]))


def dot(v, w):
    return add(add(multiply(v[0], w[0]), multiply(v[1], w[1])), multiply(v[2], w[2]))


def cross(v, w):
    return tuple(minus(multiply(v[i], w[j]), multiply(v[j], w[i])) for i, j in ((1, 2), (2, 0), (0, 1)))


class Expression:
    """(U + side V sqrt(D)) / W, a function of the time that may have poles where W is 0."""

    def __init__(self, u, v, d, side, w):
        self.u, self.v, self.d, self.side, self.w = u, v, d, side, w

    def order(self, root):
        """The order of the zero at a root of another polynomial where D > 0, negative at a pole, None where
        it is 0 for all times."""
        above = self.numerator_order(root)
        return None if above is None else above - order_at(self.w, root)

    def numerator_order(self, root):
        orders = [order_at(p, root) if p else None for p in (self.u, self.v)]
        known = [order for order in orders if order is not None]
        if len(known) < 2 or known[0] != known[1]:
            return min(known, default=None)
        u, v = self.u, self.v
        for _ in range(known[0]):
            u, v = derivative(u), derivative(v)
        if sign_at(u, root) == self.side * sign_at(v, root):
            return known[0]
        # The parts cancel, so they do not in the conjugate, and the norm has the orders of both.
        norm = minus(square(self.u), multiply(self.v, self.v, self.d))
        return order_at(norm, root) - known[0] if norm else None


class Three:
    """The circle of three moving generators as a function of the time."""

    def __init__(self, three):
        three = turned(three)
        self.reference, second, third = [moving(g) for g in three]
        self.side = -(-1) ** ((second[0] != "d") + (third[0] != "d"))
        (self.n1, self.k1), (self.n2, self.k2) = (plane(self.reference, g) for g in (second, third))
        self.q = cross(self.n1, self.n2)
        self.a = form(self.q, self.q)
        q11, q12, q22 = form(self.n1, self.n1), form(self.n1, self.n2), form(self.n2, self.n2)
        self.first = minus(multiply(self.k2, q12), multiply(self.k1, q22))
        self.second = minus(multiply(self.k1, q12), multiply(self.k2, q11))
        self.d = minus(add(multiply(self.k1, self.k1, q22), multiply(self.k2, self.k2, q11)),
                       multiply(self.k1, self.k2, q12, [2]))

    def linear(self, normal, constant):
        """normal.Y + constant as an Expression."""
        if not self.a:
            return self.linear_beside_line(normal, constant)
        u = add(multiply(self.first, form(normal, self.n1)), multiply(self.second, form(normal, self.n2)))
        return Expression(add(u, multiply(constant, self.a)), dot(normal, self.q), self.d, self.side, self.a)

    def linear_beside_line(self, normal, constant):
        """The same where the other root is at infinity all the time: with the line (p + tau q) / q_i of
        circle.py, Y = (2 pq p - pp q) / (2 pq q_i)."""
        i = max(range(3), key=lambda axis: len(self.q[axis]))
        if not self.q[i]:
            raise Wrong("the circle of the first three does not exist")
        j, k = (i + 1) % 3, (i + 2) % 3
        p = [[], [], []]
        p[j] = minus(multiply(self.k1, self.n2[k]), multiply(self.n1[k], self.k2))
        p[k] = minus(multiply(self.n1[j], self.k2), multiply(self.k1, self.n2[j]))
        pq, pp = form(p, self.q), form(p, p)
        y = [minus(multiply(pq, p[c], [2]), multiply(pp, self.q[c])) for c in range(3)]
        below = multiply(pq, self.q[i], [2])
        return Expression(add(dot(normal, y), multiply(constant, below)), [], [1], 1, below)

    def require_finite(self, t0, t1):
        """Raises Wrong where the circle, which exists at t0, becomes a line before t1.

        Its radius cannot become 0, nor the turn of its contacts, while no two of the three touch.
        """
        radius = self.linear(([], [], [1]), [])
        for root in roots_between(squarefree(radius.w), t0, t1):
            order = radius.order(root)
            if order is not None and order < 0:
                raise Wrong("the circle of the first three becomes a line in the window")

    def gap(self, generator):
        """The gap, but for a factor that is never 0."""
        normal, constant = plane(self.reference, moving(generator))
        return self.linear(normal, [-c for c in constant])


def gap_at(generators, place):
    """The sign of the gap at a dyadic time; raises Wrong where the circle does not exist."""
    now = at(generators, place)
    found = circle(now[:3])
    if found is None:
        raise Wrong("the circle of the first three does not exist in all of the window")
    return found.gap(now[3])


def require_apart(generators, t0, t1):
    g = [moving(one) for one in generators]
    for i, one in enumerate(g):
        if one[0] == "d" and any(value_at(one[3], t) < 0 for t in (t0, t1)):
            raise Wrong(f"generator {i + 1} has a negative radius")
        for j in range(i):
            if "d" in (one[0], g[j][0]):
                if not all(positive_between(p, t0, t1) for p in clearances(g[j], one)):
                    raise Wrong(f"generators {j + 1} and {i + 1} touch or overlap in the window")
