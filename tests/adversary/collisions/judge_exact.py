"""The exact truth by brute force, as docs/claim.md, section 2, says: the true events of a scene by all pairs, in decimals
of 150 digits.

Events nearer than 1e-60 of the scale are taken for simultaneous. That is no proof, but ties are exact where the scenes
here have any.
"""
from decimal import Decimal as D, getcontext
from fractions import Fraction

from worlds import WALL

getcontext().prec = 150
TIE = D(10) ** -60


class Unclear(Exception):
    """A question that this judge cannot answer."""


class Wrong(Exception):
    """A statement of the theorem that does not hold."""


class Event:
    def __init__(self, t, i, j, before, after, p):
        self.t, self.i, self.j, self.before, self.after, self.p = t, i, j, before, after, p


def length(v):
    return (v[0] * v[0] + v[1] * v[1]).sqrt()


class Truth:
    """The true motion of a scene up to its horizon, as a list of events."""

    def __init__(self, scene, most):
        self.s, self.most = scene, most
        self.center = (D(scene.center[0]), D(scene.center[1]))
        self.R, self.T = D(scene.radius), D(scene.horizon)
        self.place = [(D(d[0]), D(d[1])) for d in scene.disks]
        self.speed = [(D(d[3]), D(d[4])) for d in scene.disks]
        self.start = list(self.speed)
        self.radius = [D(d[2]) for d in scene.disks]
        self.mass = [D(d[5]) for d in scene.disks]
        self.since = [D(0)] * len(scene.disks)
        self.last = [None] * len(scene.disks)
        self.due = sorted((D(m[0]), m[1], (D(m[2]), D(m[3]))) for m in scene.maneuvers)
        self.events, self.tied = [], False
        self.next = {}  # by pair: when they touch next, as they move now

    def at(self, g, t):
        if g == WALL:
            return self.center
        dt = t - self.since[g]
        return tuple(self.place[g][k] + self.speed[g][k] * dt for k in (0, 1))

    def relative(self, i, j, t):
        p, q = self.at(i, t), self.at(j, t)
        u = (D(0), D(0)) if i == WALL else self.speed[i]
        v = self.speed[j]
        return (q[0] - p[0], q[1] - p[1]), (v[0] - u[0], v[1] - u[1])

    def contact(self, i, j, now):
        """The time of the next contact from `now` on, or None."""
        if i != WALL and self.last[j] is not None and self.last[i] is self.last[j]:
            return None
        d, w = self.relative(i, j, now)
        reach = self.R - self.radius[j] if i == WALL else self.radius[i] + self.radius[j]
        a, b = w[0] * w[0] + w[1] * w[1], d[0] * w[0] + d[1] * w[1]
        c = d[0] * d[0] + d[1] * d[1] - reach * reach
        if a == 0:
            return None
        scale = reach * reach + self.R * reach
        slow = abs(b) <= TIE * a.sqrt() * reach
        if abs(c) <= TIE * scale:
            # They touch: approach is decided by the slope.
            if slow:
                if i == WALL:
                    raise Unclear("a disk moves along the wall")
                return None
            c = D(0)
        elif c * (1 if i != WALL else -1) < 0:
            raise Unclear("an overlap in the truth")
        inside = b * b - a * c
        if i == WALL:
            r = inside.sqrt()
            return now + (-c / (b + r) if b > 0 else (r - b) / a)
        if b >= 0 or slow:
            return None
        if abs(inside) <= TIE * (b * b + a * scale):
            self.tied = True  # a graze
            return None
        return now + c / (inside.sqrt() - b) if inside > 0 else None

    def law(self, i, j, d, speed):
        """The velocities after a contact with the offset d of the centres; `speed`: those before, by disk."""
        square = d[0] * d[0] + d[1] * d[1]
        u, v = (D(0), D(0)) if i == WALL else speed[i], speed[j]
        q = ((v[0] - u[0]) * d[0] + (v[1] - u[1]) * d[1]) / square
        if i == WALL:
            e = D(self.s.wall_restitution)
            if self.s.law == "whole":
                return {j: tuple(e * (v[k] - 2 * q * d[k]) for k in (0, 1))}
            return {j: tuple(v[k] - (1 + e) * q * d[k] for k in (0, 1))}
        e, m = D(self.s.restitution), self.mass[i] + self.mass[j]
        f, g = (1 + e) * self.mass[j] / m * q, (1 + e) * self.mass[i] / m * q
        return {i: tuple(u[k] + f * d[k] for k in (0, 1)), j: tuple(v[k] - g * d[k] for k in (0, 1))}

    def collide(self, t, i, j):
        d, _ = self.relative(i, j, t)
        if d[0] * d[0] + d[1] * d[1] <= TIE * TIE * self.R * self.R:
            raise Unclear("no normal")
        self.turn(t, i, j, self.law(i, j, d, self.speed))

    def turn(self, t, i, j, after):
        p = {g: self.at(g, t) for g in after}
        self.events.append(Event(t, i, j, {g: self.speed[g] for g in after}, after, p))
        if len(self.events) > self.most:
            raise Unclear("too many events")
        mark = object()
        for g, v in after.items():
            self.place[g], self.speed[g], self.since[g], self.last[g] = p[g], v, t, mark
        self.watch(after, t)

    def watch(self, disks, now):
        """The next contacts of these disks, which have turned; those of other pairs stay."""
        n = len(self.speed)
        for pair in {tuple(sorted((g, h))) for g in disks for h in range(WALL, n) if g != h}:
            t = self.contact(*pair, now)
            if t is None:
                self.next.pop(pair, None)
            else:
                self.next[pair] = t

    def tie(self, t):
        return TIE * (1 + abs(t))

    def collisions(self, t):
        """All collisions of the instant t, the smallest pair first."""
        count = 0
        while True:
            now = sorted(pair for pair, at in self.next.items() if at - t <= self.tie(t))
            if not now:
                return count
            if len(now) > 1:
                self.tied = True
            self.collide(t, *now[0])
            count += 1

    def run(self):
        self.watch(range(len(self.speed)), D(0))
        while True:
            times = list(self.next.values()) + [m[0] for m in self.due[:1]]
            if not times or min(times) > self.T + self.tie(self.T):
                return self
            t = min(times)
            if self.due and self.due[0][0] - t <= self.tie(t):
                t = self.due[0][0]
            count = self.collisions(t)
            while self.due and self.due[0][0] <= t:
                _, g, v = self.due.pop(0)
                self.turn(t, g, g, {g: v})
                count += 1
            count += self.collisions(t)
            if count > 1:
                self.tied = True


def require_values(scene, e, c, tau, law):
    """Points 6, 7 and 8."""
    for g, v in c.v.items():
        error = length([D(v[k]) - e.after[g][k] for k in (0, 1)])
        if e.i == e.j:
            bound = law * length(e.after[g])
        else:
            speeds = sum(length(x) for x in e.before.values())
            reach = D(scene.radius) - D(scene.disks[e.j][2]) if e.i == WALL else D(scene.disks[e.i][2]) + D(scene.disks[e.j][2])
            turned = speeds / 1024 if reach == 0 else min(4 * tau * speeds * speeds / reach, speeds / 1024)
            bound = law * speeds + turned + length(e.after[g]) * D(2) ** -51
        if error > bound:
            raise Wrong(f"the velocity of {g} at {c.t} is off by {float(error)}")
        if error * 2 > bound and error > length(e.after[g]) * D(2) ** -52:
            raise Unclear("a velocity near its bound")
    for g, p in c.p.items():
        error = length([D(p[k]) - e.p[g][k] for k in (0, 1)])
        bound = tau * (length(e.before[g]) + length(e.after[g])) + 4 * length(e.p[g]) * D(2) ** -53
        if error > bound * D("1.000001"):
            raise Wrong(f"the centre of {g} at {c.t} is off by {float(error)}")
        if error * D("1.000001") > bound:
            raise Unclear("a centre near its bound")


def require_law(truth, c, before, law):
    """Point 6, the law between the claimed values: velocities before, centres and velocities after."""
    s, disks = truth.s, [g for g in (c.i, c.j) if g != WALL]
    p = {WALL: truth.center, **{g: tuple(map(D, c.p[g])) for g in disks}}
    n = tuple(p[c.j][k] - p[c.i][k] for k in (0, 1))
    speeds = sum(length(before[g]) for g in disks)
    reach = truth.R - truth.radius[c.j] if c.i == WALL else truth.radius[c.i] + truth.radius[c.j]
    mu = 16 * length(p[c.j]) * D(2) ** -53 / reach if reach else D(1)
    if mu >= 1 or n == (0, 0):
        raise Unclear("the normal is hidden")
    after = truth.law(c.i, c.j, n, before)
    for g in disks:
        error = length([D(c.v[g][k]) - after[g][k] for k in (0, 1)])
        if error > (law + mu) * speeds:
            raise Wrong(f"the velocity of {g} at {c.t} does not obey the law with the centres: off by {float(error)}")
        if error * D("1.000001") > law * speeds:
            raise Unclear("a response beyond the tolerance, within what roundings do")


def require_laws(truth, claims, partner, law):
    before = list(truth.start)
    for m, c in enumerate(claims):
        e = truth.events[partner[m]]
        if c.i != c.j and c.v and c.p:
            require_law(truth, c, before, law)
        for g, v in e.after.items():
            before[g] = tuple(map(D, c.v[g])) if c.v and c.i != c.j else v


def match(truth, claims, tau, law):
    def by_disk(events):
        of = {}
        for k, e in enumerate(events):
            for g in {e.i, e.j} - {WALL}:
                of.setdefault(g, []).append((k, e.i, e.j))
        return of

    true, claimed = by_disk(truth.events), by_disk(claims)
    order_differs = False
    partner = {}
    for g in sorted(true.keys() | claimed.keys()):
        a, b = true.get(g, []), claimed.get(g, [])
        if [x[1:] for x in a] != [x[1:] for x in b]:
            if sorted(x[1:] for x in a) == sorted(x[1:] for x in b) and truth.tied:
                raise Unclear("another order of an instant")
            raise Wrong(f"disk {g} has other events")
        for (k, _, _), (m, _, _) in zip(a, b):
            if partner.setdefault(m, k) != k:
                raise Wrong("another order of the events of two disks")
    for m, k in sorted(partner.items()):
        e, c = truth.events[k], claims[m]
        late = abs(D(c.t.numerator) / D(c.t.denominator) - e.t) if isinstance(c.t, Fraction) else abs(D(c.t) - e.t)
        if abs(late - tau) < TIE:
            raise Unclear("a time at its bound")
        if late > tau:
            raise Wrong(f"the event of {c.i, c.j} claimed at {c.t} is at {float(e.t)}")
        require_values(truth.s, e, c, tau, law)
        order_differs = order_differs or m != k
    require_laws(truth, claims, partner, law)
    if order_differs and truth.tied:
        raise Unclear("another order of an instant")


def judge(scene, claims, tau, law):
    """The verdict on the claims under the exact truth, and why."""
    try:
        truth = Truth(scene, 3 * len(claims) + 60).run()
        match(truth, claims, D(tau.numerator) / D(tau.denominator), D(law.numerator) / D(law.denominator))
    except Wrong as why:
        return "wrong", str(why)
    except Unclear as why:
        return "unclear", str(why)
    return "right", ""
