"""Random tables of paths, degenerate ones first, and exact transformations of them."""

import random
from fractions import Fraction

from judge import FlightTable

HALF = Fraction(1, 2)


class TableMaker:
    """One table from a seed."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.dimension = self.rng.choice((2, 2, 3))

    def number(self, most=3):
        """A small number; many are whole, so that much is equal."""
        r = self.rng
        return Fraction(r.randint(-most * 4, most * 4), r.choice((4, 4, 4, 2, 3, 10)))

    def whole(self, most=3):
        return Fraction(self.rng.randint(-most, most))

    def place(self, number):
        return [number() for _ in range(self.dimension)]

    def radius(self):
        return self.rng.choice((Fraction(0), HALF, HALF, Fraction(1), Fraction(1, 3), Fraction(1, 10)))

    def waypoints(self, number, begin, most):
        t, rows = begin, []
        for _ in range(self.rng.randint(1, most)):
            rows.append((t, self.place(number)))
            t += self.rng.choice((Fraction(1), HALF, Fraction(1, 3), Fraction(2)))
        return rows

    def curve(self, number, degree):
        """Coefficients of a piece; many are 0."""
        zero = Fraction(0)
        return [[number()] + [number() if self.rng.random() < 0.5 else zero for _ in range(self.rng.randint(0, degree))]
                for _ in range(self.dimension)]

    def chain(self, number, begin, most, degree, jumps):
        """Pieces; each begins where the one before ends, unless it jumps."""
        t, rows, end = begin, [], None
        for _ in range(self.rng.randint(1, most)):
            duration = self.rng.choice((Fraction(1), HALF, Fraction(2), Fraction(3, 4)))
            axes = self.curve(number, degree)
            if end and self.rng.random() >= jumps:
                axes = [[e, *p[1:]] for e, p in zip(end, axes)]
            rows.append((t, duration, axes))
            end = [sum(c * duration ** k for k, c in enumerate(p)) for p in axes]
            t += duration
        return rows

    def table(self, pieces, number, count=3, most=3, degree=3, jumps=0.0, begin=None):
        disks = []
        for k in range(self.rng.randint(2, count)):
            start = Fraction(0) if begin is None else self.rng.choice(begin)
            rows = self.chain(number, start, most, degree, jumps) if pieces else self.waypoints(number, start, most)
            disks.append((f"d{k}", self.radius(), rows))
        ends = {(rows[0][0], rows[-1][0] + (rows[-1][1] if pieces else 0)) for _, _, rows in disks}
        beyond = "" if len(ends) == 1 else self.rng.choice(("stay", "vanish"))
        return FlightTable(self.dimension, disks, pieces, beyond=beyond)


STARTS = (Fraction(0), Fraction(0), HALF, Fraction(1))


def straight(m):
    return m.table(False, m.rng.choice((m.whole, m.number)), begin=STARTS)


def short(m):
    """Disks of one waypoint, or of few, so that many are there together for an instant only."""
    return m.table(False, m.whole, count=5, most=2, begin=(Fraction(0), Fraction(1)))


def curved(m):
    return m.table(True, m.rng.choice((m.whole, m.number)), degree=m.rng.choice((0, 1, 2, 3)), most=2)


def steep(m):
    """Pieces of high degree. In the middle of its time, or near that, a disk is near the origin."""
    table = m.table(True, m.number, count=3, most=1, degree=7)
    disks = []
    for name, radius, rows in table.disks:
        duration = rows[0][1]
        axes = []
        for p in rows[0][2]:
            middle = sum(c * (duration / 2) ** k for k, c in enumerate(p))
            # Large terms that cancel each other there are tried, too.
            large = m.rng.choice((1, 1, 1, 10 ** 8))
            axes.append([(p[0] - middle) * large + m.number(1), *(c * large for c in p[1:])])
        disks.append((name, radius, [(rows[0][0], duration, axes)]))
    table.disks = disks
    return table


def tied(m):
    """Two disks, and two others that are as near, far from them; the curves are the same but for the place and time."""
    table = steep(m)
    a, b = (rows[0] for _, _, rows in table.disks[:2])
    later = m.rng.choice((Fraction(0), Fraction(1), HALF))
    away = [Fraction(m.rng.choice((100, 97))), *[Fraction(0)] * (m.dimension - 1)]
    disks = [("a", HALF, [a]), ("b", HALF, [b])]
    disks += [(name, HALF, moved(FlightTable(m.dimension, [(name, HALF, [row])], True), away, later).disks[0][2])
              for name, row in (("c", a), ("d", b))]
    return FlightTable(m.dimension, disks, True, beyond="vanish")


def swerving(m):
    """Curves that leave the box by many sides between their ends."""
    table = steep(m)
    big = Fraction(m.rng.choice((10, 30)))
    disks = []
    for name, radius, [(t, d, axes)] in table.disks[:2]:
        ways = [m.whole() * big for _ in axes[:2]] + [Fraction(0)] * len(axes[2:])
        disks.append((name, radius, [(t, d, [[m.number(), way, -way / d] for way in ways])]))
    table.disks = disks
    table.sides = [Fraction(1), None, None][:m.dimension]
    return table


def together(m):
    """Disks that jump at one time."""
    return m.table(True, m.whole, count=3, most=3, degree=0, jumps=0.8)


def jumping(m):
    """Pieces of small degree that begin elsewhere; no two jump at one time."""
    table = m.table(True, m.whole, degree=2, jumps=0.6)
    shift = Fraction(0)
    disks = []
    for name, radius, rows in table.disks:
        disks.append((name, radius, [(t + shift, duration, axes) for t, duration, axes in rows]))
        shift += Fraction(1, 7)
    table.disks, table.beyond = disks, m.rng.choice(("stay", "vanish"))
    return table


def periodic(m):
    table = m.rng.choice((straight, curved, short, jumping))(m)
    sides = [m.rng.choice((None, Fraction(4), Fraction(3), Fraction(5, 2))) for _ in range(table.dimension)]
    if not any(sides):
        sides[0] = Fraction(4)
    table.sides = sides
    return table


def crowded(m):
    """A box that is smaller than the disks in it."""
    table = straight(m)
    table.sides = [Fraction(m.rng.randint(1, 4), 2) for _ in range(table.dimension)]
    table.disks = [(name, radius + 1, rows) for name, radius, rows in table.disks[:2]]
    return table


def high(m):
    m.dimension = 3
    table = m.rng.choice((straight, straight, curved, jumping, short, periodic))(m)
    table.height = m.rng.choice((Fraction(1), Fraction(2), HALF, Fraction(5, 3), Fraction(7)))
    return table


def level(m):
    """A flight that meets the height of another just when it is nearest, or while it stays so."""
    m.dimension = 3
    size, limit = m.radius(), m.rng.choice((Fraction(1), Fraction(2)))
    x = [m.whole(1) for _ in range(3)]
    z = [m.rng.choice((limit, -limit, Fraction(0), m.number())) for _ in range(3)]
    a = [(Fraction(k), [Fraction(0)] * 3) for k in (0, 2)]
    y = m.whole(1) * size
    if m.rng.random() < 0.6:
        # They touch all the time, and at its ends they are not near in height.
        x, y, z = [Fraction(1)] * 3, Fraction(0), [limit, -limit, limit]
    b = [(Fraction(k), [x[k] * size * 2, y, z[k]]) for k in range(3)]
    table = FlightTable(3, [("a", size, a), ("b", size, b)])
    table.height = limit
    return table


def tower(m):
    """Images one upon the other, many of which are near enough in height."""
    m.dimension = 3
    table = m.rng.choice((straight, curved))(m)
    table.sides, table.height = [None, None, Fraction(1)], m.rng.choice((Fraction(5, 2), Fraction(8), Fraction(9)))
    return table


def grazing(m):
    """A disk that comes to another, to the last touch, at a time that is not rational."""
    # 1 + (s^2 - a)^2 up to the time 1.
    a, rest = m.rng.choice((HALF, Fraction(1, 3), Fraction(1, 5))), [[Fraction(0)]] * (m.dimension - 1)
    way = [1 + a * a, Fraction(0), -2 * a, Fraction(0), Fraction(1)]
    return FlightTable(m.dimension, [("a", HALF, [(Fraction(0), Fraction(1), [[Fraction(0)], *rest])]),
                                     ("b", HALF, [(Fraction(0), Fraction(1), [way, *rest])])], True)


def framed(m):
    table = m.rng.choice((straight, curved, periodic, short))(m)
    table.frames = True
    return table


def alike(m):
    """One curve, moved and cut elsewhere: all gaps are constant, though no two pieces are the same."""
    rows = m.chain(m.number, Fraction(0), 2, 3, 0)
    moved = [(t, d, [[p[0] + k, *p[1:]] for k, p in zip((1, 0, 0), axes)]) for t, d, axes in rows]
    return FlightTable(m.dimension, [("a", HALF, rows), ("b", m.rng.choice((HALF, Fraction(0))), split(moved))], True)


def touching(m):
    """A disk that comes to another, to the last touch or nearly so, with numbers far below those of doubles."""
    tiny = m.rng.choice((Fraction(0), Fraction(1, 2 ** 70), Fraction(1, 10 ** 60), -Fraction(1, 2 ** 90)))
    side = m.rng.choice((Fraction(0), Fraction(3, 5)))
    rest = [Fraction(0)] * (m.dimension - 2)
    a = [(Fraction(0), [Fraction(0), Fraction(0), *rest]), (Fraction(2), [Fraction(0), Fraction(0), *rest])]
    if m.rng.random() < 0.5:
        b = [(Fraction(k), [Fraction(4, 5) + tiny + abs(1 - k), side, *rest]) for k in range(3)]
    else:
        # It passes by: the square is least between the ends.
        b = [(Fraction(0), [Fraction(-3), 1 + tiny, *rest]), (Fraction(2), [m.number(), 1 + tiny, *rest])]
    return FlightTable(m.dimension, [("a", HALF, a), ("b", HALF, b)])


def far(m):
    """Far from the origin, in places and times."""
    table = m.rng.choice((straight, curved, jumping))(m)
    return moved(table, [Fraction(m.rng.choice((0, 10 ** 9, 10 ** 20))) for _ in range(m.dimension)],
                 Fraction(m.rng.choice((0, 10 ** 12, -10 ** 9))))


def unfolded(m):
    return folded(periodic(m), m.rng, m.rng.choice((1, 1000, 10 ** 7)))


def in_units(m):
    table = m.rng.choice((straight, periodic, touching, high, curved, framed))(m)
    length, time = (Fraction(m.rng.choice((1, 2 ** 300, 10 ** 60))) ** m.rng.choice((1, -1)) for _ in range(2))
    scaled_table = scaled(table, length, time)
    return scaled_table if in_limits(scaled_table) else table


KINDS = (touching, straight, alike, curved, jumping, periodic, high, level, tower, grazing,
         short, framed, steep, tied, swerving, together, crowded, far, unfolded, in_units)


def make(seed):
    maker = TableMaker(seed)
    kind = KINDS[seed % len(KINDS)]
    return kind.__name__, kind(maker)


def in_limits(table):
    least, most = Fraction(1, 10 ** 100), Fraction(10 ** 100)
    flat = [t for _, _, rows in table.disks for row in rows for t in numbers_of(row)]
    return all(x == 0 or least <= abs(x) <= most for x in flat)


def numbers_of(row):
    for item in row:
        if isinstance(item, list):
            yield from numbers_of(item)
        else:
            yield item


# Exact transformations.

def with_rows(table, change, sides=None, height=None):
    disks = [(name, radius, [change(row) for row in rows]) for name, radius, rows in table.disks]
    return FlightTable(table.dimension, disks, table.pieces, sides or table.sides, height or table.height,
                       table.frames, table.beyond)


def scaled(table, length, time):
    def change(row):
        if table.pieces:
            t, duration, axes = row
            return t * time, duration * time, [[c * length / time ** k for k, c in enumerate(p)] for p in axes]
        return row[0] * time, [x * length for x in row[1]]
    result = with_rows(table, change, [s and s * length for s in table.sides], table.height and table.height * length)
    result.disks = [(name, radius * length, rows) for name, radius, rows in result.disks]
    return result


def moved(table, by, later=Fraction(0)):
    def change(row):
        if table.pieces:
            return row[0] + later, row[1], [[p[0] + x, *p[1:]] for p, x in zip(row[2], by)]
        return row[0] + later, [x + y for x, y in zip(row[1], by)]
    return with_rows(table, change)


def folded(table, rng, most):
    """All of a disk is moved by as many sides."""
    disks = []
    for name, radius, rows in table.disks:
        by = [(s or 0) * Fraction(rng.randint(-most, most)) for s in table.sides]
        lone = FlightTable(table.dimension, [(name, radius, rows)], table.pieces)
        disks += moved(lone, by).disks
    return FlightTable(table.dimension, disks, table.pieces, table.sides, table.height, table.frames, table.beyond)


def mirrored(table):
    def change(row):
        last = row[-1]
        turned = [[-c for c in last[0]]] if table.pieces else [-last[0]]
        return (*row[:-1], turned + last[1:])
    return with_rows(table, change)


def exchanged(table):
    """The first two axes."""
    def change(row):
        last = row[-1]
        return (*row[:-1], [last[1], last[0], *last[2:]])
    return with_rows(table, change, [table.sides[1], table.sides[0], *table.sides[2:]])


def split(rows):
    """Each piece in two, at a third of it."""
    result = []
    for t, duration, axes in rows:
        first = duration / 3
        later = []
        for p in axes:
            shifted = []
            for c in reversed(p):
                # Horner's rule with s + first for the variable.
                shifted = [first * (shifted[k] if k < len(shifted) else 0) + (shifted[k - 1] if k else 0)
                           for k in range(len(shifted) + 1)] if shifted else [Fraction(0)]
                shifted[0] += c
            later.append(shifted)
        result += [(t, first, axes), (t + first, duration - first, later)]
    return result


def split_all(table):
    disks = []
    for name, radius, rows in table.disks:
        if table.pieces:
            disks.append((name, radius, split(rows)))
            continue
        parts = [rows[0]]
        for a, b in zip(rows, rows[1:]):
            parts += [((2 * a[0] + b[0]) / 3, [(2 * x + y) / 3 for x, y in zip(a[1], b[1])]), b]
        disks.append((name, radius, parts))
    return FlightTable(table.dimension, disks, table.pieces, table.sides, table.height, table.frames, table.beyond)


def as_pieces(table):
    """Straight ways, written as pieces of degree 3."""
    zero = Fraction(0)
    disks = []
    for name, radius, rows in table.disks:
        pieces = []
        for a, b in zip(rows, rows[1:]):
            duration = b[0] - a[0]
            pieces.append((a[0], duration, [[x, (y - x) / duration, zero, zero] for x, y in zip(a[1], b[1])]))
        disks.append((name, radius, pieces))
    return FlightTable(table.dimension, disks, True, table.sides, table.height, table.frames, table.beyond)


def relabelled(table):
    return FlightTable(table.dimension, table.disks[::-1], table.pieces, table.sides, table.height, table.frames,
                       table.beyond)
