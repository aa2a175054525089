"""Circles of three generators at rest, in integers and one square root.

Let the first disk, of radius r0, be at the origin, and s = rho + r0. It is touched where
x^2 + y^2 = s^2. For another disk at c with e = r - r0, the difference of the two equations is
linear, 2 (c.z + e s) = |c|^2 - e^2; for a container r stands for -R; a wall's equation is linear
itself. With Y = 2 (x, y, s) each of the other two is a plane N.Y = K, and the circle's place is on the
line where the planes meet, in direction Q = N1 x N2, and on the cone.

The two roots differ in the turn of the contacts. The direction from the centre to the contact with a
disk is (c - z) / (r + rho), so the turn is the sign of the determinant of the rows (c - z, r + rho),
divided by the signs of the last entries, here those of a container, -, and +. A wall's row is
-(a, b, -1). The first row is (-x, -y, s), the others are it plus N, so the determinant is
-(x Qx + y Qy - s Qs), which is the square root in the formula of the roots, up to the sign of the
pivot: the turn selects the root.
"""
from fields import Wrong


def sign(value):
    return (value > 0) - (value < 0)


def sign_of_sum(a, b, square):
    """The sign of a + b sqrt(square), square >= 0."""
    if not b or not square:
        return sign(a)
    if not a or (a > 0) == (b > 0):
        return sign(b)
    return sign(a) * sign(a * a - b * b * square)


def lorentz(v, w):
    return v[0] * w[0] + v[1] * w[1] - v[2] * w[2]


def cross(v, w):
    return (v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0])


def plane(reference, generator):
    """(N, K) of a generator, as seen from a disk."""
    _, x0, y0, r0 = reference
    letter, x, y, r = generator
    if letter == "w":
        return (x, y, -1), 2 * (r - x * x0 - y * y0 - r0)
    normal = (x - x0, y - y0, (r if letter == "d" else -r) - r0)
    return normal, lorentz(normal, normal)


def clearance(g, h):
    """Has the sign of the room between two generators: -1 where they overlap, 0 where they touch."""
    if "d" not in (g[0], h[0]):
        return 1
    if g[0] != "d":
        g, h = h, g
    _, x, y, r = g
    letter, a, b, c = h
    if letter == "w":
        return sign(a * x + b * y - c - r)
    distance = (x - a) ** 2 + (y - b) ** 2
    if letter == "d":
        return sign(distance - (r + c) ** 2)
    return sign((c - r) ** 2 - distance) if c >= r else -1


def require_no_overlap(generators):
    for i, g in enumerate(generators):
        for j in range(i):
            if clearance(generators[j], g) < 0:
                raise Wrong(f"generators {j + 1} and {i + 1} overlap")


def turned(three):
    """The three, turned so that the first is a disk."""
    first = next((i for i, g in enumerate(three) if g[0] == "d"), None)
    if first is None:
        raise Wrong("no disk among the first three")
    return three[first:] + three[:first]


class Circle:
    """Y = (alpha + beta sqrt(square)) / gamma, gamma > 0, as seen from the disk `reference`."""

    def __init__(self, reference, alpha, beta, gamma, square):
        if gamma < 0:
            alpha, beta, gamma = [-v for v in alpha], [-v for v in beta], -gamma
        self.reference = reference
        self.alpha, self.beta, self.gamma, self.square = alpha, beta, gamma, square

    def sign_of(self, normal, constant):
        """The sign of normal.Y + constant."""
        a, b = self.alpha, self.beta
        return sign_of_sum(
            normal[0] * a[0] + normal[1] * a[1] + normal[2] * a[2] + constant * self.gamma,
            normal[0] * b[0] + normal[1] * b[1] + normal[2] * b[2], self.square)

    def fits_into(self, container):
        """The sign of R - rho."""
        return self.sign_of((0, 0, -1), 2 * (container[3] + self.reference[3]))

    def gap(self, generator):
        normal, constant = plane(self.reference, generator)
        # This is |z-c|^2 - (r+rho)^2 for a disk, the same with r = -R for a container, whose own gap
        # falls with it, and minus twice the gap of a wall.
        difference = -self.sign_of(normal, -constant)
        if generator[0] == "d":
            return difference
        if generator[0] == "c" and self.fits_into(generator) < 0:
            return -1
        return -difference


def circle(three):
    """The circle [1, 2, 3], or None where there is none."""
    reference, second, third = turned(three)
    (n1, k1), (n2, k2) = plane(reference, second), plane(reference, third)
    q = cross(n1, n2)
    i = max(range(3), key=lambda axis: abs(q[axis]))
    if not q[i]:
        return None
    j, k = (i + 1) % 3, (i + 2) % 3
    # The line is (p + tau q) / q_i, where tau is the coordinate i of Y.
    p = [0, 0, 0]
    p[j] = k1 * n2[k] - n1[k] * k2
    p[k] = n1[j] * k2 - k1 * n2[j]
    qq, pq, pp = lorentz(q, q), lorentz(p, q), lorentz(p, p)
    square = pq * pq - qq * pp
    if square <= 0:
        return None  # a double root has contacts that do not turn
    root = -sign(q[i]) * (-1) ** ((second[0] != "d") + (third[0] != "d"))
    if qq:
        found = Circle(reference, [qq * p[c] - pq * q[c] for c in range(3)], [root * c for c in q],
                       qq * q[i], square)
    elif sign(pq) == root:
        found = Circle(reference, [2 * pq * p[c] - pp * q[c] for c in range(3)], [0, 0, 0],
                       2 * pq * q[i], square)
    else:
        return None  # the root is at infinity
    if found.sign_of((0, 0, 1), -2 * reference[3]) <= 0:
        return None
    if any(g[0] == "c" and found.fits_into(g) <= 0 for g in three):
        return None
    return found


def in_cyclic_order(a, b, c):
    return (a < b) + (b < c) + (c < a) == 2 and a != b and b != c and c != a


def is_line(three):
    """Whether a line with the free side on its left meets the three in their cyclic order.

    With its unit normal n, (n, 1) is orthogonal to N1 and N2. Only one wall can be among the three: it
    is parallel to the line, and its contact is infinitely far.
    """
    three = turned(three)
    letters = [g[0] for g in three]
    if "c" in letters or letters.count("w") > 1:
        return False
    n1, n2 = plane(three[0], three[1])[0], plane(three[0], three[2])[0]
    q = cross(n1, n2)
    if not any(q):
        # Collinear centres, and radii linear along them: there is a line on either side, and one of
        # the two has the right order if the contacts differ.
        spacelike = lorentz(n1, n1) > 0 and lorentz(n2, n2) > 0
        return "w" not in letters and spacelike and n1 != n2
    if lorentz(q, q):
        return False
    along = [sign(q[2]) * (q[1] * g[1] - q[0] * g[2]) for g in three]
    if "w" not in letters:
        return in_cyclic_order(*along)
    wall = letters.index("w")
    return along[(wall + 1) % 3] < along[(wall + 2) % 3]
