"""Worlds of few disks that err once: an event-driven simulation in doubles, by all pairs.

A world has no diagram. It writes down collisions and maneuvers as a careless engine would, and goes on consistently after its
error, so that all its other lines fit the motion that it made.
"""
import math
from dataclasses import dataclass, field

WALL = -1


@dataclass
class Scene:
    """A scene file; all numbers are doubles. A disk is (x, y, r, vx, vy, m), a maneuver (t, disk, vx, vy)."""
    center: tuple
    radius: float
    horizon: float
    disks: list
    maneuvers: list = field(default_factory=list)
    restitution: float = 1.0
    wall_restitution: float = 1.0
    law: str = "normal"

    def text(self):
        return {
            "format": "voroproof-scene", "version": 1, "horizon": self.horizon, "container_law": self.law,
            "container": {"center": list(self.center), "radius": self.radius, "restitution": self.wall_restitution},
            "restitution": self.restitution,
            "disks": [{"center": [x, y], "radius": r, "velocity": [vx, vy], "mass": m} for x, y, r, vx, vy, m in self.disks],
            "maneuvers": [{"t": t, "disk": k, "velocity": [vx, vy]} for t, k, vx, vy in self.maneuvers]}


@dataclass
class Claim:
    """A collision of i and j, or a maneuver (i is j) of a disk; velocities and centres by generator."""
    t: float
    i: int
    j: int
    v: dict
    p: dict

    def text(self):
        time = self.t if isinstance(self.t, float) else str(self.t)
        if self.i == self.j:
            line = {"t": time, "maneuver": self.i}
            if self.v:
                line["v"] = list(self.v[self.i])
            if self.p:
                line["p"] = list(self.p[self.i])
            return line
        line = {"t": time, "collide": [self.i, self.j]}
        for name, of in (("v", self.v), ("p", self.p)):
            if of:
                line[name] = [None if g == WALL else list(of[g]) for g in (self.i, self.j)]
        return line


@dataclass
class Fault:
    """A fault of the world, at its `at`-th event of that kind, by the amount `by`."""
    kind: str = "none"
    at: int = 0
    by: float = 0.0


class World:
    """Runs a scene. `claims` is what it writes down, `erred` whether its fault found its place."""

    def __init__(self, scene, fault, rng, most_events=40):
        self.scene, self.fault, self.rng, self.most = scene, fault, rng, most_events
        self.n = len(scene.disks)
        self.since = [0.0] * self.n
        self.place = [(d[0], d[1]) for d in scene.disks]
        self.speed = [(d[3], d[4]) for d in scene.disks]
        self.radius = [d[2] for d in scene.disks]
        self.mass = [d[5] for d in scene.disks]
        self.last = [None] * self.n  # by disk: the mark of its last turn, an object of its own
        self.blind = set()  # pairs that pass through each other
        self.claims, self.erred, self.collisions = [], False, 0
        self.now = 0.0
        if fault.kind in ("radius", "mass") and self.n:
            of, k = {"radius": self.radius, "mass": self.mass}[fault.kind], rng.randrange(self.n)
            of[k] *= 1 + fault.by
            self.erred = of[k] != scene.disks[k][2 if fault.kind == "radius" else 5]

    # ---- Motion. ----
    def at(self, g, t):
        if g == WALL:
            return self.scene.center
        (x, y), (vx, vy), dt = self.place[g], self.speed[g], t - self.since[g]
        return (x + vx * dt, y + vy * dt)

    def velocity(self, g):
        return (0.0, 0.0) if g == WALL else self.speed[g]

    def relative(self, i, j, t):
        (x, y), (u, w) = self.at(i, t), self.at(j, t)
        (a, b), (c, d) = self.velocity(i), self.velocity(j)
        return u - x, w - y, c - a, d - b

    def reach(self, i, j):
        return self.scene.radius - self.radius[j] if i == WALL else self.radius[i] + self.radius[j]

    def partners(self, i, j):
        return i != WALL and self.last[j] is not None and self.last[i] is self.last[j]

    def contact(self, i, j):
        """The time of the next contact, or None."""
        if self.partners(i, j):
            return None
        dx, dy, wx, wy = self.relative(i, j, self.now)
        reach = self.reach(i, j)
        a, b, c = wx * wx + wy * wy, dx * wx + dy * wy, dx * dx + dy * dy - reach * reach
        if (i, j) in self.blind:
            side = -1 if i == WALL else 1
            if side * c <= 0 or side * b < 0:  # not yet through
                return None
            self.blind.discard((i, j))
        root = b * b - a * c
        if a == 0 or root <= 0:
            return None
        root = math.sqrt(root)
        if i == WALL:
            ahead = -c / (b + root) if b > 0 else (root - b) / a
        elif b < 0:
            ahead = c / (root - b)
        else:
            return None
        return self.now + max(0.0, ahead)

    # ---- The law. ----
    def response(self, i, j, t, restitution=None):
        s = self.scene
        dx, dy, wx, wy = self.relative(i, j, t)
        square = dx * dx + dy * dy
        if square == 0:
            return None
        q = (wx * dx + wy * dy) / square
        if i == WALL:
            e = s.wall_restitution if restitution is None else restitution
            (vx, vy) = self.speed[j]
            if s.law == "whole":
                return {j: (e * (vx - 2 * q * dx), e * (vy - 2 * q * dy))}
            return {j: (vx - (1 + e) * q * dx, vy - (1 + e) * q * dy)}
        e = s.restitution if restitution is None else restitution
        m, k = self.mass[i], self.mass[j]
        f, g = (1 + e) * k / (m + k) * q, (1 + e) * m / (m + k) * q
        (a, b), (c, d) = self.speed[i], self.speed[j]
        return {i: (a + f * dx, b + f * dy), j: (c - g * dx, d - g * dy)}

    def turn(self, t, i, j, velocities):
        p = {g: self.at(g, t) for g in velocities}
        mark = object()
        for g, v in velocities.items():
            self.place[g], self.speed[g], self.since[g], self.last[g] = p[g], v, t, mark
        return p

    def claim(self, t, i, j, velocities):
        p = self.turn(t, i, j, velocities)
        self.claims.append(Claim(t, i, j, dict(velocities), p))

    # ---- The run. ----
    def next(self):
        best = None
        for j in range(self.n):
            for i in range(WALL, j):
                t = self.contact(i, j)
                if t is not None and (best is None or (t, i, j) < best):
                    best = (t, i, j)
        return best

    def run(self):
        due = sorted(self.scene.maneuvers, key=lambda m: (m[0], m[1]))
        maneuvers = 0
        while len(self.claims) < self.most:
            best = self.next()
            if due and due[0][0] <= self.scene.horizon and (best is None or due[0][0] < best[0]):
                self.maneuver(due.pop(0), maneuvers)
                maneuvers += 1
                continue
            if best is None or best[0] > self.scene.horizon:
                return self
            self.collide(*best)
        self.scene.horizon = max(self.now, math.nextafter(self.claims[-1].t, math.inf), 1e-9)
        return self

    def strikes(self, kind, count):
        if self.fault.kind != kind or self.erred or count < self.fault.at:
            return False
        self.erred = True
        return True

    def maneuver(self, due, count):
        t, g, vx, vy = due
        v, self.now = (vx, vy), max(self.now, t)
        if self.strikes("maneuver missed", count):
            return
        if self.strikes("maneuver velocity", count):
            v = (vx * (1 + self.fault.by), vy + self.fault.by)
        if self.strikes("maneuver late", count):
            self.now = t = t + self.fault.by
        self.claim(max(t, self.now), g, g, {g: v})

    def collide(self, t, i, j):
        count, self.collisions = self.collisions, self.collisions + 1
        self.now = t
        if self.strikes("missed", count):
            self.blind.add((i, j))
            return
        if self.strikes("false", count):
            self.false_collision()
            return
        if self.strikes("late", count) or self.strikes("early", count):
            by = self.fault.by if self.fault.kind == "late" else -self.fault.by
            turned = [self.since[g] for g in (i, j) if g != WALL]
            t = max([t + by, 0.0, *turned] + [c.t for c in self.claims[-1:]])
            self.now = t
        e = self.fault.by if self.strikes("restitution", count) else None
        velocities = self.response(i, j, t, e)
        if velocities is None:
            self.blind.add((i, j))
            return
        if self.strikes("mirrored", count):
            velocities = {g: (v[1], v[0]) for g, v in velocities.items()}
        if self.strikes("perturbed", count):
            velocities = {g: (v[0] * (1 + self.fault.by), v[1]) for g, v in velocities.items()}
        self.claim(t, i, j, velocities)
        if self.strikes("doubled", count):
            again = t + self.fault.by
            self.now = again
            self.claim(again, i, j, self.response(i, j, again) or velocities)

    def false_collision(self):
        i, j = sorted(self.rng.sample(range(WALL, self.n), 2))
        since = max([self.since[g] for g in (i, j) if g != WALL] + [c.t for c in self.claims[-1:]] + [0.0])
        t = self.now = since + (self.now - since) * self.rng.random()
        velocities = self.response(i, j, t)
        if velocities is not None:
            self.claim(t, i, j, velocities)
