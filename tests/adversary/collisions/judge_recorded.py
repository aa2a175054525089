"""The recorded truth by brute force: every pair, in rationals, as docs/claim.md, section 3, says.

Square roots alone are not rational: they are taken to 300 bits, exactly where they are rational. The judge says "right", "wrong"
or, where it is lenient because the claim has more than one reading, "unclear".
"""
from fractions import Fraction as Q
from math import isqrt

from worlds import WALL

BITS = 300


def root(x):
    """The square root of a rational, exact where it is one."""
    p, q = x.numerator, x.denominator
    shift = BITS + max(0, q.bit_length() - p.bit_length())
    return Q(isqrt((p * q) << (2 * shift)), q << shift)


def length(v):
    return root(v[0] * v[0] + v[1] * v[1])


class Unclear(Exception):
    """Raised where the claim does not say enough."""


class Wrong(Exception):
    """A statement of the theorem that does not hold."""


class Leg:
    """A disk on a line from `since` on."""

    def __init__(self, since, place, velocity):
        self.since, self.place, self.velocity = since, place, velocity

    def at(self, t):
        dt = t - self.since
        return tuple(self.place[k] + self.velocity[k] * dt for k in (0, 1))


class Lines:
    """A pair on its lines from `since` on, and the roots of its gap."""

    def __init__(self, wall, a, b, reach, since, rounding):
        self.wall, self.reach, self.since, self.rounding = wall, reach, since, rounding
        p, q = a.at(since), b.at(since)
        d = (q[0] - p[0], q[1] - p[1])
        w = (b.velocity[0] - a.velocity[0], b.velocity[1] - a.velocity[1])
        self.a = w[0] * w[0] + w[1] * w[1]
        self.b = d[0] * w[0] + d[1] * w[1]
        self.square = d[0] * d[0] + d[1] * d[1]
        self.c = self.square - reach * reach
        self.roots = None
        inside = self.b * self.b - self.a * self.c
        if self.a > 0 and inside > 0:
            r = root(inside)
            self.roots = (since + (-self.b - r) / self.a, since + (-self.b + r) / self.a)

    def distance2(self, t):
        s = t - self.since
        return (self.a * s + 2 * self.b) * s + self.square

    def overlaps_at(self, t):
        over = self.distance2(t) - self.reach * self.reach
        return over > 0 if self.wall else over < 0

    def approaches_at(self, t):
        slope = self.b + self.a * (t - self.since)
        return slope > 0 if self.wall else slope < 0

    def entry(self):
        """The entry on these lines, or None."""
        if self.roots is None:
            return None
        x = self.roots[1 if self.wall else 0]
        return x if x >= self.since else None

    def overlaps(self, end):
        """Open intervals of (since, end) in which the two overlap."""
        start = self.since
        if self.roots is None:
            middle = (start + end) / 2
            return [(start, end)] if end > start and self.overlaps_at(middle) else []
        low, high = self.roots
        pieces = [(start, min(low, end)), (max(high, start), end)] if self.wall else [(max(low, start), min(high, end))]
        return [(x, y) for x, y in pieces if x < y]

    def shallow(self, x, y):
        """Whether the overlap of [x, y] is no deeper than the rounding."""
        if 4 * self.rounding > self.reach:
            return False
        if self.wall:
            return max(self.distance2(x), self.distance2(y)) <= (self.reach + self.rounding) ** 2
        nearest = x if self.a == 0 else min(max(self.since - self.b / self.a, x), y)
        return self.distance2(nearest) >= (self.reach - self.rounding) ** 2

    def meet(self, end):
        """Whether two points are at one place in [since, end]."""
        if self.wall or self.reach > 0:
            return False
        nearest = self.since if self.a == 0 else min(max(self.nearest(), self.since), end)
        return self.distance2(nearest) == 0

    def nearest(self):
        return self.since - self.b / self.a if self.a > 0 else None


class Recorded:
    """Follows the paths of a history, and holds what it claims against them."""

    def __init__(self, scene, claims, tau, law):
        self.s, self.claims, self.tau, self.law = scene, claims, tau, law
        self.center = (Q(scene.center[0]), Q(scene.center[1]))
        self.R, self.T = Q(scene.radius), Q(scene.horizon)
        self.extent = abs(self.center[0]) + abs(self.center[1]) + self.R
        self.radius = [Q(d[2]) for d in scene.disks]
        self.mass = [Q(d[5]) for d in scene.disks]
        self.legs = [Leg(Q(0), (Q(d[0]), Q(d[1])), (Q(d[3]), Q(d[4]))) for d in scene.disks]
        self.turns = [0] * len(scene.disks)
        self.last = [None] * len(scene.disks)
        self.answers = {}  # by pair: the times of its claims
        self.progress = {}  # by pair: the overlap in progress when its lines began
        self.done = []  # overlaps that are over: [pair, entries, shallow, end]
        self.unclear = None
        self.used = set()  # claims that answer an overlap, with their pairs
        self.unclaimed = sorted((Q(m[0]), m[1], (Q(m[2]), Q(m[3]))) for m in scene.maneuvers)

    def pairs_of(self, g):
        return [tuple(sorted((g, h))) for h in range(WALL, len(self.legs)) if h != g]

    def leg(self, g):
        return Leg(Q(0), self.center, (Q(0), Q(0))) if g == WALL else self.legs[g]

    def lines(self, pair):
        i, j = pair
        wall = i == WALL
        reach = self.R - self.radius[j] if wall else self.radius[i] + self.radius[j]
        turns = self.turns[j] + (0 if wall else self.turns[i])
        since = max(self.leg(i).since, self.leg(j).since)
        return Lines(wall, self.leg(i), self.leg(j), reach, since, self.extent / 2**51 * max(1, turns))

    def end_lines(self, pair, end):
        """The lines of the pair end: their overlaps are joined to those before."""
        lines = self.lines(pair)
        if lines.meet(end):
            raise Wrong(f"{pair} are points and meet, which has no law")
        before = self.progress.pop(pair, None)
        if end == lines.since:
            if before is not None:
                self.progress[pair] = before
            return
        for x, y in lines.overlaps(end):
            shallow = lines.shallow(x, y)
            if before is not None and x == lines.since and lines.overlaps_at(x):
                entries = before[1] + ([x] if before[2] else [])
                overlap = [pair, entries, before[2] and shallow, y]
            else:
                overlap = [pair, [x], shallow, y]
                if before is not None:
                    self.done.append(before)
            before = None
            if y == end and lines.overlaps_at(y):
                before = overlap
            else:
                self.done.append(overlap)
        if before is not None:
            if before[3] == end:
                self.progress[pair] = before
            else:
                self.done.append(before)

    # ---- Claims. ----
    def require_contact(self, c, t, lines):
        """Point 2: the claim answers an entry of its lines, which have been followed up to t, or is a graze."""
        entry = lines.entry()
        if entry is not None and abs(entry - t) <= self.tau:
            return
        before = self.progress.get((c.i, c.j))
        if before is not None and lines.approaches_at(t) and any(abs(x - t) <= self.tau for x in before[1]):
            return
        nearest = lines.nearest()
        if c.i != WALL and nearest is not None and nearest >= lines.since and abs(nearest - t) <= self.tau:
            if lines.reach**2 <= lines.distance2(nearest) <= (lines.reach + lines.rounding) ** 2:
                return
        raise Wrong(f"point 2: the claim of {c.i, c.j} at {c.t} answers nothing")

    def response(self, c, p):
        """The law with centres p: velocities after, and the sum of the speeds before."""
        i, j = c.i, c.j
        u, v = self.leg(i).velocity, self.leg(j).velocity
        n = (p[j][0] - p[i][0], p[j][1] - p[i][1])
        square = n[0] * n[0] + n[1] * n[1]
        if square == 0:
            raise Unclear("no normal")
        w = (v[0] - u[0], v[1] - u[1])
        q = (w[0] * n[0] + w[1] * n[1]) / square
        if i == WALL:
            e = Q(self.s.wall_restitution)
            if self.s.law == "whole":
                return {j: tuple(e * (v[k] - 2 * q * n[k]) for k in (0, 1))}
            return {j: tuple(v[k] - (1 + e) * q * n[k] for k in (0, 1))}
        e, m = Q(self.s.restitution), self.mass[i] + self.mass[j]
        f, g = (1 + e) * self.mass[j] / m * q, (1 + e) * self.mass[i] / m * q
        return {i: tuple(u[k] + f * n[k] for k in (0, 1)), j: tuple(v[k] - g * n[k] for k in (0, 1))}

    def require_law(self, c, t, p, reach):
        """Point 5. Gives the velocities after the collision."""
        disks = [g for g in (c.i, c.j) if g != WALL]
        if not c.v:
            filed = {g: tuple(Q(x) for x in c.p[g]) for g in disks} if c.p else p
            law = self.response(c, {WALL: self.center, **filed})
            return {g: tuple(Q(float(x)) for x in law[g]) for g in disks}
        claimed = {g: tuple(Q(x) for x in c.v[g]) for g in disks}
        speeds = sum(length(self.leg(g).velocity) for g in disks)
        if reach == 0:
            raise Unclear("no normal")
        mu = 16 * (length(p[c.j]) + speeds * t) / 2**53 / reach
        if mu >= 1:
            self.unclear = "the normal is hidden"
            return claimed
        law = self.response(c, p)
        for g in disks:
            error = length([claimed[g][k] - law[g][k] for k in (0, 1)])
            if error > (self.law + mu) * speeds:
                raise Wrong(f"point 5: the response of {g} at {c.t} is off by {float(error)}")
            if error > self.law * speeds:
                self.unclear = "a response beyond the tolerance, within what roundings do"
        return claimed

    def require_centers(self, c, p, after):
        """Point 9."""
        for g, claimed in c.p.items():
            error = length([Q(claimed[k]) - p[g][k] for k in (0, 1)])
            speeds = length(self.leg(g).velocity) + length(after[g])
            if error > self.tau * speeds + 4 * length(p[g]) / 2**53:
                raise Wrong(f"point 9: the centre of {g} at {c.t} is off by {float(error)}")

    def scheduled(self, c, t):
        """Point 6: the velocity of the maneuver claimed."""
        fits = [m for m in self.unclaimed if m[1] == c.i and abs(m[0] - t) <= self.tau and m[0] <= self.T]
        if not fits:
            raise Wrong(f"point 6: no maneuver of {c.i} is scheduled at {c.t}")
        if len(fits) > 1:
            raise Unclear("two maneuvers of one disk within the tolerance")
        self.unclaimed.remove(fits[0])
        due = fits[0][2]
        claimed = tuple(Q(x) for x in c.v[c.i]) if c.v else due
        if length([claimed[k] - due[k] for k in (0, 1)]) > self.law * length(due):
            raise Wrong(f"point 6: the velocity of {c.i} at {c.t} is not the scheduled one")
        return due

    def take(self, c):
        t = Q(c.t)
        disks = sorted({c.i, c.j} - {WALL})
        p = {g: self.leg(g).at(t) for g in {c.i, c.j}}
        lines = self.lines((c.i, c.j)) if c.i != c.j else None
        for pair in sorted({pair for g in disks for pair in self.pairs_of(g)}):
            self.end_lines(pair, t)
        if lines is None:
            after = {c.i: self.scheduled(c, t)}
        else:
            if c.i != WALL and self.last[c.i] is not None and self.last[c.i] is self.last[c.j]:
                raise Wrong(f"point 3: {c.i, c.j} have collided and not turned since")
            self.require_contact(c, t, lines)
            after = self.require_law(c, t, p, lines.reach)
            self.answers.setdefault((c.i, c.j), []).append(t)
        self.require_centers(c, p, after)
        mark = object()
        for g in disks:
            self.legs[g] = Leg(t, p[g], after[g])
            self.turns[g] += 1
            self.last[g] = mark

    def require_answered(self, overlap):
        """Point 4."""
        pair, entries, shallow, end = overlap
        if shallow or entries[0] >= self.T - self.tau:
            return
        for x in entries:
            answers = [t for t in self.answers.get(pair, []) if abs(x - t) <= self.tau and end <= t + self.tau]
            if answers:
                if x != entries[0]:
                    self.unclear = "an overlap that was within the rounding at first"
                # Each claim answers one entry; which one is not looked for.
                if any((pair, t) in self.used for t in answers):
                    self.unclear = "two overlaps that one claim may answer"
                self.used.update((pair, t) for t in answers)
                return
        raise Wrong(f"point 4: {pair} overlap from {float(entries[0])} to {float(end)}")

    def judge(self):
        for c in self.claims:
            self.take(c)
        n = len(self.legs)
        for pair in [(i, j) for j in range(n) for i in range(WALL, j)]:
            self.end_lines(pair, self.T)
        for overlap in self.done + list(self.progress.values()):
            self.require_answered(overlap)
        for t, g, _ in self.unclaimed:
            if t <= self.T:
                raise Wrong(f"point 6: the maneuver of {g} at {float(t)} is not claimed")


def judge(scene, claims, tau, law):
    """The verdict on the claims under the recorded truth, and why."""
    judge_of = Recorded(scene, claims, tau, law)
    try:
        judge_of.judge()
    except Wrong as why:
        return "wrong", str(why)
    except Unclear as why:
        return "unclear", str(why)
    return ("unclear", judge_of.unclear) if judge_of.unclear else ("right", "")
