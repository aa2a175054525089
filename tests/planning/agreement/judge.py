"""How near disks come to each other on given paths, judged anew: exactly, and by brute force.

All pairs and images are looked at on all pieces of their common time. Nothing is rounded but for the ends of spells.
"""

from fractions import Fraction
from math import ceil, floor

from polynomials import bounds, negative_parts, plus, reaches, roots, times, trimmed, value

ZERO, ONE = Fraction(0), Fraction(1)


class FlightTable:
    """A table: `disks` are (name, radius, rows).

    A row is (t, place), or where `pieces` (t, duration, coefficients of each axis). `sides` has None for an axis
    without images; `beyond` is "stay", "vanish" or "".
    """

    def __init__(self, dimension, disks, pieces=False, sides=None, height=None, frames=False, beyond=""):
        self.dimension, self.disks, self.pieces = dimension, disks, pieces
        self.sides = sides or [None] * dimension
        self.height, self.frames, self.beyond = height, frames, beyond


class Way:
    """The way of a disk from u to v: a polynomial of s from 0 to 1 for each axis. A jump takes no time."""

    def __init__(self, u, v, axes):
        self.u, self.v, self.axes = u, v, axes

    def part(self, u, v):
        if self.u == self.v:
            return self.axes
        begin, size = (u - self.u) / (self.v - self.u), (v - u) / (self.v - self.u)
        result = []
        for p in self.axes:
            # Horner's rule with begin + size s for the variable.
            shifted = []
            for c in reversed(p):
                shifted = plus(times(shifted, [begin, size]), [c])
            result.append(shifted)
        return result


def still(u, v, place):
    return Way(u, v, [trimmed([x]) for x in place])


def ways(table, rows):
    """Those of a disk in order of time, without what it does beyond its rows."""
    result = []
    if not table.pieces:
        if len(rows) == 1:
            return [still(rows[0][0], rows[0][0], rows[0][1])]
        return [Way(a[0], b[0], [trimmed([x, y - x]) for x, y in zip(a[1], b[1])]) for a, b in zip(rows, rows[1:])]
    for t, duration, axes in rows:
        way = Way(t, t + duration, [trimmed(c * duration ** k for k, c in enumerate(p)) for p in axes])
        place = [value(p, ZERO) for p in way.axes]
        if result:
            end = [value(p, ONE) for p in result[-1].axes]
            if end != place:
                result.append(Way(t, t, [trimmed([x, y - x]) for x, y in zip(end, place)]))
        result.append(way)
    return result


def all_ways(table):
    """Those of all disks, with what they do beyond their rows; of --frames-only the instants of their rows."""
    of_rows = [ways(table, rows) for _, _, rows in table.disks]
    result = [list(own) for own in of_rows]
    frames = {t for own in result for way in own for t in (way.u, way.v)}
    begin, end = min(w[0].u for w in result), max(w[-1].v for w in result)
    for own in result if table.beyond == "stay" else []:
        first, last = own[0], own[-1]
        lone = first.u == first.v
        if begin < first.u:
            own.insert(0, still(begin, first.u, [value(p, ZERO) for p in first.axes]))
        if last.v < end:
            own.append(still(last.v, end, [value(p, ONE) for p in last.axes]))
        if lone and len(own) > 1:
            own.remove(first)
    if table.frames:
        return [instants(own, rows, frames) for own, rows in zip(result, of_rows)]
    return result


def instants(own, of_rows, frames):
    """A disk is where its rows say, and before and after them at all instants of the file."""
    first, last = of_rows[0].u, of_rows[-1].v
    places = []
    for way in own:
        ends = {way.u: ZERO, way.v: ONE} if first <= way.u and way.v <= last else {t: ZERO for t in frames}
        for t in sorted(t for t in ends if way.u <= t <= way.v):
            place = (t, [value(p, ends[t]) for p in way.axes])
            if place not in places:
                places.append(place)
    return [still(t, t, place) for t, place in places]


def lacks_frames(table):
    """Whether a disk has no row at an instant of others between its first row and its last."""
    own = [{t for way in ways(table, rows) for t in (way.u, way.v)} for _, _, rows in table.disks]
    frames = set.union(*own)
    return any(t not in times for times in own for t in frames if min(times) <= t <= max(times))


class CommonWay:
    """Two disks from u to v; `offset`: of the second from the first."""

    def __init__(self, i, j, u, v, offset, reach):
        self.i, self.j, self.u, self.v, self.offset, self.reach = i, j, u, v, offset, reach
        self.bounds = [bounds(p) for p in offset]

    def time(self, s):
        return self.u + s * (self.v - self.u)


class PairJudge:
    """All pairs of a table."""

    def __init__(self, table):
        self.table = table
        self.ways = all_ways(table)
        self.radii = [radius for _, radius, _ in table.disks]
        self.is_straight = all(len(p) <= 2 for own in self.ways for w in own for p in w.axes)
        self.common = []
        for j in range(len(self.ways)):
            for i in range(j):
                self.common += self._common(i, j)
            for axis, side in enumerate(table.sides):
                if side is not None:
                    u, v = self.ways[j][0].u, self.ways[j][-1].v
                    offset = [[] for _ in table.sides]
                    self.common.append(CommonWay(j, j, u, v, offset, 2 * self.radii[j]))
                    break

    def _common(self, i, j):
        a, b = self.ways[i], self.ways[j]
        reach = self.radii[i] + self.radii[j]
        found = []

        def take(p, q, u, v):
            offset = [plus(y, [-c for c in x]) for x, y in zip(p.part(u, v), q.part(u, v))]
            found.append(CommonWay(i, j, u, v, offset, reach))
        if self.table.frames:
            for p in a:
                for q in b:
                    if p.u == q.u:
                        take(p, q, p.u, p.u)
            return found
        u, v = max(a[0].u, b[0].u), min(a[-1].v, b[-1].v)
        times_of = sorted({t for own in (a, b) for w in own for t in (w.u, w.v) if u <= t <= v})
        for k, t in enumerate(times_of):
            jumps = [[w for w in own if w.u == w.v == t and len(own) > 1] for own in (a, b)]
            if any(jumps) or len(times_of) == 1:
                at = [[w for w in own if w.u <= t <= w.v] for own in (a, b)]
                first, second = (j[0] if j else standing(w, t) for j, w in zip(jumps, at))
                take(first, second, t, t)
            if k + 1 < len(times_of):
                e = times_of[k + 1]
                p, q = (next(w for w in own if w.u <= t and e <= w.v and w.u < w.v) for own in (a, b))
                take(p, q, t, e)
        return found

    def images(self, way, distance):
        """All images of the second disk that may be nearer than that, or as near."""
        heights = self.table.height if self.table.height is not None else None
        choices = [()]
        for axis, side in enumerate(self.table.sides):
            low, high = way.bounds[axis]
            limit = heights if heights is not None and axis == 2 else distance
            if side is None:
                if low > limit or high < -limit:
                    return
                choices = [c + (0,) for c in choices]
            else:
                span = range(ceil((-limit - high) / side), floor((limit - low) / side) + 1)
                choices = [c + (k,) for c in choices for k in span]
        for image in choices:
            # A disk itself: the next image along each axis is told.
            if way.i < way.j or sum(map(abs, image)) == sum(image) == 1:
                yield image

    def square(self, way, image):
        """The square of the distance, and where heights count z^2 - height^2."""
        axes = [plus(p, [k * (side or 0)]) for p, k, side in zip(way.offset, image, self.table.sides)]
        heights = None
        if self.table.height is not None:
            z = axes.pop()
            heights = plus(times(z, z), [-self.table.height ** 2])
        total = []
        for p in axes:
            total = plus(total, times(p, p))
        return total, heights

    def within(self, gap, strict):
        """Pieces and images that come as near as that: (way, image, square less that of the distance, heights)."""
        for way in self.common:
            if way.reach + gap >= 0:
                yield from self.nearer(way, (way.reach + gap) ** 2, way.reach + gap, strict)

    def nearer(self, way, square, distance, strict):
        """The same for one piece and the square of a distance, which is at most `distance`."""
        for image in self.images(way, distance):
            own, heights = self.square(way, image)
            excess = plus(own, [-square])
            low = bounds(excess)[0]
            if low > 0 or strict and low >= 0:
                continue
            if reaches(excess, heights, strict):
                yield way, image, excess, heights

    def keeps(self, gap, strict):
        """Whether all gaps are at least that, or greater unless strict."""
        return next(self.within(gap, strict), None) is None

    def spells(self, gap):
        """(i, j, image) to the list of all spells, in order of time, each from one (way, root) to another."""
        parts = {}
        for way, image, excess, heights in self.within(gap, True):
            for first, last in negative_parts(excess, heights):
                at_begin, at_end = first is None, last is None
                parts.setdefault((way.i, way.j, image), []).append((way, first, last, at_begin, at_end))
        result = {}
        for pair, all_parts in parts.items():
            spells, last = [], None
            for part in all_parts:
                way = part[0]
                if last and last[4] and part[3] and last[0].v == way.u and self._follows(last[0], way):
                    spells[-1] = (spells[-1][0], (way, part[2]))
                else:
                    spells.append(((way, part[1]), (way, part[2])))
                last = part
            result[pair] = spells
        return result

    def _follows(self, a, b):
        return self.common.index(b) - self.common.index(a) == 1


def standing(own, t):
    """One of the ways that has t, as it is at that time."""
    way = own[0]
    return Way(t, t, way.part(t, t))


def end_time(end, is_first):
    """Bounds of the time of an end of a spell, 2^-200 of the way apart."""
    way, root = end
    if root is None:
        t = way.u if is_first else way.v
        return t, t
    root.narrow(Fraction(1, 2 ** 200))
    return way.time(root.lo), way.time(root.hi)


def encloses(end, is_first, lo, hi):
    """Whether the end of a spell is from lo to hi, exactly."""
    way, root = end
    if root is None or way.u == way.v:
        t = way.u if is_first else way.v
        return lo <= t <= hi
    length = way.v - way.u
    return root.against((lo - way.u) / length) >= 0 >= root.against((hi - way.u) / length)


def first_times(way, excess, before):
    """Whether the square falls to that of the distance at a time before one."""
    if way.u >= before:
        return False
    if not excess:
        return True
    if way.u == way.v:
        return bool(roots(excess))
    x = (before - way.u) / (way.v - way.u)
    return any(r.against(x) < 0 for r in roots(excess))
