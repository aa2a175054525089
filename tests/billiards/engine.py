"""An event-driven engine in doubles, and random scenes for it.

Command: engine.py SEED OUT_PREFIX writes OUT_PREFIX.scene.json and OUT_PREFIX.history.jsonl."""
import itertools
import json
import math
import sys

from billiard import Malformed, Scene, dot
from scenes import random_scene

CLOSEST = 1e-9     # events nearer than this in time make a scene degenerate


class Degenerate(Exception):
    pass


def value(p, x):
    result = 0.0
    for c in reversed(p):
        result = result * x + c
    return result


def bisect(p, a, b):
    """The place in [a,b] where p changes sign."""
    above = value(p, a) > 0
    for _ in range(200):
        middle = (a + b) / 2
        if not a < middle < b:
            break
        if (value(p, middle) > 0) == above:
            a = middle
        else:
            b = middle
    return b


def turning_points(p, end):
    """The roots of the derivative of p in (0,end): between them p is monotone."""
    slope = [n * c for n, c in enumerate(p)][1:]
    while slope and slope[-1] == 0:
        slope.pop()
    if len(slope) < 2:
        return []
    if len(slope) == 2:
        x = -slope[0] / slope[1]
        return [x] if 0 < x < end else []
    points = [0.0] + turning_points(slope, end) + [end]
    return [bisect(slope, a, b) for a, b in itertools.pairwise(points)
            if (value(slope, a) > 0) != (value(slope, b) > 0)]


def first_entry(p, end):
    """The first time in [0,end] at which p goes below 0, or None; touching at 0 counts if it goes down there."""
    if p[0] <= 0 and p[1] < 0:
        return 0.0
    if p[0] > sum(abs(c) * end ** n for n, c in enumerate(p) if n):
        return None
    for a, b in itertools.pairwise([0.0] + turning_points(p, end) + [end]):
        if value(p, a) > 0 >= value(p, b):
            return bisect(p, a, b)
    return None


class Body:
    def __init__(self, disk, gravity):
        self.t, self.c, self.v = 0.0, [float(x) for x in disk.center], [float(x) for x in disk.velocity]
        self.a = [0.0] * len(gravity) if disk.fixed else gravity
        self.r, self.g = float(disk.radius), float(disk.growth)
        self.m, self.fixed = float(disk.mass), disk.fixed

    def centre(self, t):
        u = t - self.t
        return [c + u * (v + u * a / 2) for c, v, a in zip(self.c, self.v, self.a)]

    def velocity(self, t):
        return [v + (t - self.t) * a for v, a in zip(self.v, self.a)]

    def radius(self, t):
        return self.r + self.g * t

    def turn(self, t, v):
        self.c, self.v, self.t = self.centre(t), v, t


class World:
    """A scene in doubles. ignore(pair, image) tells which contacts this world does not know.

    Every collision happens `lag` later (below 0: earlier) than it should."""

    def __init__(self, scene, ignore=lambda pair, image: False, lag=0.0):
        self.scene, self.ignore, self.lag = scene, ignore, lag
        self.gravity = [float(x) for x in scene.gravity]
        self.bodies = [Body(d, self.gravity) for d in scene.disks]
        self.walls = [([float(x) for x in w.normal], float(w.offset), float(w.speed), float(w.restitution))
                      for w in scene.walls]
        if scene.circle:
            self.circle = ([float(x) for x in scene.circle.center], float(scene.circle.radius))
        self.sides = [None if side is None else float(side) for side in scene.sides]
        self.slide = float(scene.shear) * (self.sides[1] or 0) if scene.periodic and len(self.sides) > 1 else 0.0
        self.sigma = float(scene.restitution)

    # The motion of a pair, seen from its first disk.

    def relative(self, i, j, k, t):
        """Vector, velocity and acceleration from i to the image k of j at time t."""
        a, b = self.bodies[i], self.bodies[j]
        d = [y - x for x, y in zip(a.centre(t), b.centre(t))]
        w = [y - x for x, y in zip(a.velocity(t), b.velocity(t))]
        for axis, n in enumerate(k):
            if n:
                d[axis] += n * self.sides[axis]
        d[0] += k[1] * self.slide * t
        w[0] += k[1] * self.slide
        return d, w, [y - x for x, y in zip(a.a, b.a)]

    def pair_gap(self, i, j, k, t):
        """Coefficients of a polynomial in the time from t on that is below 0 while the two overlap."""
        d, w, a = self.relative(i, j, k, t)
        rho = self.bodies[i].radius(t) + self.bodies[j].radius(t)
        growth = self.bodies[i].g + self.bodies[j].g
        return [dot(d, d) - rho * rho, 2 * (dot(d, w) - rho * growth), dot(w, w) + dot(d, a) - growth * growth,
                dot(w, a), dot(a, a) / 4]

    def wall_gap(self, n, i, t):
        normal, offset, speed, _ = self.walls[n]
        body = self.bodies[i]
        return [dot(normal, body.centre(t)) - offset - speed * t - body.radius(t),
                dot(normal, body.velocity(t)) - speed - body.g, dot(normal, body.a) / 2]

    def circle_gap(self, i, t):
        origin, radius = self.circle
        body = self.bodies[i]
        d = [x - o for x, o in zip(body.centre(t), origin)]
        v, a, room = body.velocity(t), body.a, radius - body.radius(t)
        return [room * room - dot(d, d), -2 * (room * body.g + dot(d, v)), body.g ** 2 - dot(v, v) - dot(d, a),
                -dot(v, a), -dot(a, a) / 4]

    def images(self, i, j, t, span):
        """All images that may touch in [t, t+span], from a generous bound of the way."""
        d, w, a = self.relative(i, j, [0] * len(self.sides), t)
        rho = max(b.radius(s) for b in (self.bodies[i], self.bodies[j]) for s in (t, t + span)) * 2
        found = [()]
        for axis in reversed(range(len(d))):
            longer = []
            for tail in found:
                x, way = d[axis], abs(w[axis]) * span + abs(a[axis]) * span * span / 2
                if axis == 0 and self.slide:
                    x += tail[0] * self.slide * t
                    way += abs(tail[0] * self.slide) * span
                side, reach = self.sides[axis], rho + way + 1e-6
                span_k = (0,) if side is None else range(math.ceil((-reach - x) / side),
                                                         math.floor((reach - x) / side) + 1)
                longer += [(n,) + tail for n in span_k]
            found = longer
        return found

    def contacts(self, t, span):
        """Every (pair, image, gap polynomial from t on)."""
        for j in range(len(self.bodies)):
            if self.scene.circle and not self.ignore((-1, j), None):
                yield (-1, j), None, self.circle_gap(j, t)
            for n in range(len(self.walls)):
                if not self.ignore((-1 - n, j), None):
                    yield (-1 - n, j), None, self.wall_gap(n, j, t)
            for i in range(j):
                for k in self.images(i, j, t, span):
                    if not self.ignore((i, j), k):
                        yield (i, j), k, self.pair_gap(i, j, k, t)

    def next_collision(self, t, limit):
        """The first collision in [t, limit] as (time, pair, image), or None."""
        while t < limit:
            span = limit - t
            if any(self.sides):
                # Short steps keep the images few.
                speed = max(math.hypot(*b.velocity(t)) for b in self.bodies) + abs(self.slide) + 0.1
                span = min(span, min(side for side in self.sides if side) / speed)
            best = None
            for pair, image, gap in self.contacts(t, span):
                u = first_entry(gap, span if best is None else best[0])
                if u is not None and (best is None or u < best[0]):
                    best = (u, pair, image)
            if best:
                return (self.polish(t + best[0], *best[1:]) + self.lag, *best[1:])
            t += span
        return None

    def polish(self, t, pair, image):
        """Newton steps on the gap at the time itself: less rounding than in the polynomial from an earlier time."""
        i, j = pair
        for _ in range(3):
            p = self.pair_gap(i, j, image, t) if i >= 0 else \
                self.circle_gap(j, t) if self.scene.circle else self.wall_gap(-1 - i, j, t)
            if p[1] < 0 and abs(p[0] / p[1]) < 1e-9:
                t -= p[0] / p[1]
        return t

    def collide(self, t, pair, image):
        i, j = pair
        b = self.bodies[j]
        if i >= 0:
            self.bounce_pair(t, self.bodies[i], b, *self.relative(i, j, image, t)[:2])
            return
        if b.fixed:
            raise Degenerate("a fixed disk meets the frame")
        v = b.velocity(t)
        if self.scene.circle:
            normal = [x - o for x, o in zip(b.centre(t), self.circle[0])]
            room = self.circle[1] - b.radius(t)
            q = (1 + float(self.scene.circle.restitution)) * (dot(v, normal) + b.g * room) / dot(normal, normal)
        else:
            normal, _, speed, restitution = self.walls[-1 - i]
            q = (1 + restitution) * (dot(v, normal) - speed - b.g)
        b.turn(t, [x - q * n for x, n in zip(v, normal)])

    def bounce_pair(self, t, a, b, n, w):
        if a.fixed and b.fixed:
            raise Degenerate("two fixed disks meet")
        q = (1 + self.sigma) * (dot(w, n) - (a.g + b.g) * (a.radius(t) + b.radius(t))) / dot(n, n)
        of_a = 0.0 if a.fixed else 1.0 if b.fixed else b.m / (a.m + b.m)
        if not a.fixed:
            a.turn(t, [x + q * of_a * y for x, y in zip(a.velocity(t), n)])
        if not b.fixed:
            b.turn(t, [x - q * (1 - of_a) * y for x, y in zip(b.velocity(t), n)])

    def run(self, horizon, most=10 ** 9):
        """Events as they stand in a history, up to the horizon or `most` of them."""
        t, events, upcoming = 0.0, [], 0
        maneuvers = [m for m in self.scene.maneuvers if m.t <= horizon]
        while len(events) < most:
            limit = float(maneuvers[upcoming].t) if upcoming < len(maneuvers) else horizon
            hit = self.next_collision(t, limit)
            if hit is None and upcoming == len(maneuvers):
                break
            now = hit[0] if hit else limit
            if now > horizon:
                break
            if now - t < CLOSEST:
                raise Degenerate("two events at about the same time")
            t = now
            if hit:
                self.collide(*hit)
                events.append(self.collision_event(*hit))
            else:
                body, v = self.bodies[maneuvers[upcoming].disk], [float(x) for x in maneuvers[upcoming].velocity]
                body.turn(t, v)
                events.append({"t": t, "maneuver": maneuvers[upcoming].disk, "v": v})
                upcoming += 1
        return events

    def collision_event(self, t, pair, image):
        event = {"t": t, "collide": list(pair)}
        if image is not None and any(self.sides):
            event["image"] = list(image)
        bodies = [self.bodies[i] if i >= 0 else None for i in pair]
        event["v"] = [None if b is None or b.fixed else b.velocity(t) for b in bodies]
        event["p"] = [b and b.centre(t) for b in bodies]
        return event


def history_rows(scene, events):
    """The rows (objects) of a history file."""
    header = {"format": "voroproof-history", "version": 2, "scene_sha256": scene.sha256,
              "horizon": float(scene.horizon), "producer": "python test engine"}
    maneuvers = sum("maneuver" in event for event in events)
    end = {"t": float(scene.horizon), "collisions": len(events) - maneuvers, "maneuvers": maneuvers}
    return [header, *events, {"end": end}]


def history_bytes(rows):
    return "".join(json.dumps(row) + "\n" for row in rows).encode()


def choose_horizon(data, wanted):
    """Cuts the scene off after the wanted number of events, well between two of them; None if degenerate."""
    try:
        scene = Scene(json.dumps(data).encode())
        events = World(scene).run(float(scene.horizon), wanted + 1)
    except (Degenerate, Malformed):
        return None
    if len(events) > wanted:
        before = events[wanted - 1]["t"] if wanted else 0.0
        if events[wanted]["t"] - before < 1e-5:
            return None
        data["horizon"] = (before + events[wanted]["t"]) / 2
    return data


def make(seed):
    """A scene (bytes) and a history of it (rows), from a seed; degenerate ones are replaced by further tries."""
    for attempt in itertools.count():
        data, wanted = random_scene(seed, attempt)
        if data is None or choose_horizon(data, wanted) is None:
            continue
        raw = json.dumps(data).encode() + b"\n"
        scene = Scene(raw)
        try:
            events = World(scene).run(float(scene.horizon))
        except Degenerate:
            continue
        return raw, history_rows(scene, events)


def main():
    raw, rows = make(int(sys.argv[1]))
    with open(sys.argv[2] + ".scene.json", "wb") as file:
        file.write(raw)
    with open(sys.argv[2] + ".history.jsonl", "wb") as file:
        file.write(history_bytes(rows))


if __name__ == "__main__":
    main()
