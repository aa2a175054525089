"""Apollonius circles, exactly: coordinates are a + b sqrt(D) with rational a, b and D.

Generators are a dictionary from ids to (x, y, r). The container's r is minus its radius. So a
circle of radius rho touches a generator where the distance of the centres is |rho + r|. This
rho + r is positive for a disk, and negative for the container.
"""

CONTAINER = -1


class Surd:
    """The number a + b sqrt(square)."""
    __slots__ = ("a", "b", "square")

    def __init__(self, a, b, square):
        self.a, self.b, self.square = a, b, square

    def __add__(self, other):
        if isinstance(other, Surd):
            return Surd(self.a + other.a, self.b + other.b, self.square)
        return Surd(self.a + other, self.b, self.square)

    def __sub__(self, other):
        return self + other * -1

    def __mul__(self, other):
        if isinstance(other, Surd):
            return Surd(self.a * other.a + self.b * other.b * self.square,
                        self.a * other.b + self.b * other.a, self.square)
        return Surd(self.a * other, self.b * other, self.square)

    def sign(self):
        first, second = sign(self.a), sign(self.b) * sign(self.square)
        if first == second or second == 0:
            return first
        if first == 0:
            return second
        return first * sign(self.a ** 2 - self.b ** 2 * self.square)


def sign(x):
    return (x > 0) - (x < 0)


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def cross(u, v):
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def cone(u, v):
    """A circle touches g where the form is zero of u = v = (centre - centre of g, rho + r of g)."""
    return u[0] * v[0] + u[1] * v[1] - u[2] * v[2]


def circle(generators, i, j, k):
    """(x, y, rho) of the circle that touches the three, counterclockwise in this order; or None."""
    while i == CONTAINER:  # the first must be a disk
        i, j, k = j, k, i
    first = generators[i]
    for w in touching(*(tuple(a - b for a, b in zip(generators[g], first)) for g in (j, k))):
        found = w[0] + first[0], w[1] + first[1], w[2] - first[2]
        if w[2].sign() > 0 and touches(generators, found, j) and touches(generators, found, k) \
                and turns_left(generators, found, i, j, k):
            return found
    return None


def touching(m, n):
    """All circles w = (x, y, rho + r) that touch the first generator, and two others.

    m and n are the differences of the others from the first. Whether the circles touch from the
    right side is not asked. The equation of another less that of the first is linear, dot(w, m) =
    cone(m, m) / 2. So w lies on a line v + t d, and t solves a quadratic equation.
    """
    d = cross(m, n)
    square = dot(d, d)
    if square == 0:
        return []
    half_m, half_n = cone(m, m) / 2, cone(n, n) / 2
    p = (half_m * dot(n, n) - half_n * dot(m, n)) / square
    q = (half_n * dot(m, m) - half_m * dot(m, n)) / square
    v = tuple(p * a + q * b for a, b in zip(m, n))
    a, b, c = cone(d, d), cone(v, d), cone(v, v)
    if a == 0:
        roots = [Surd(-c / (2 * b), 0, 0)] if b != 0 else []
    else:
        under = b * b - a * c
        roots = [Surd(-b / a, s / a, under) for s in (1, -1)] if under >= 0 else []
    return [tuple(t * x + y for x, y in zip(d, v)) for t in roots]


def touches(generators, found, g):
    """A circle at the right distance from g, up to the sign, touches it from the right side."""
    return (found[2] + generators[g][2]).sign() == (-1 if g == CONTAINER else 1)


def turns_left(generators, found, i, j, k):
    """The three touch the circle counterclockwise in this order."""
    first = generators[i]
    normal = cross(*(tuple(a - b for a, b in zip(generators[g], first)) for g in (j, k)))
    w = found[0] * -1 + first[0], found[1] * -1 + first[1], found[2] + first[2]
    # The determinant of the rows (centre - centre of the circle, rho + r). A weight rho + r may be
    # negative, and the direction in which that generator touches is then the opposite one.
    determinant = w[0] * normal[0] + w[1] * normal[1] + w[2] * normal[2]
    weights = [(found[2] + generators[g][2]).sign() for g in (i, j, k)]
    return determinant.sign() * weights[0] * weights[1] * weights[2] > 0


def in_circle(generators, found, g):
    """The sign of the distance of g from the circle: less than 0 where a part of g is inside."""
    x, y, r = generators[g]
    dx, dy, reach = found[0] - x, found[1] - y, found[2] + r
    outside = (dx * dx + dy * dy - reach * reach).sign()
    if g == CONTAINER:
        return -1 if reach.sign() >= 0 else -outside
    return 1 if reach.sign() < 0 else outside
