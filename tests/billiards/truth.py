"""A brute force judge for histories of billiards under the exact truth: the true motion in numbers of 500 bits.

Command: truth.py SCENE HISTORY prints CERTIFIED or REFUTED line N: reason."""
import math
import sys
from collections import defaultdict
from fractions import Fraction

from billiard import dot, read_history, read_scene
from judge import LAW_TOLERANCE, TIME_TOLERANCE, norm
from roots import negative

BITS = 500
MOST_EVENTS = 2000


class Tie(Exception):
    """Two events of one disk cannot be told apart in time."""


def rounded(x):
    return Fraction(round(x * (1 << BITS)), 1 << BITS)


def first_negative(form, lo, hi, halvings=5):
    """Where the form falls below 0 first in [lo, hi]; None where it does not. It is positive just after lo."""
    at, power, least, factor = list(form), Fraction(1), Fraction(0), 1
    for n in range(len(form)):
        value = sum((c * lo ** k for k, c in enumerate(at)), Fraction(0)) / factor
        least += value if n == 0 else min(value * power, 0)
        power *= hi - lo
        at = [k * c for k, c in enumerate(at)][1:]
        factor *= n + 1
    if least > 0:
        return None
    if halvings:
        middle = Fraction(float((lo + hi) / 2))
        if lo < middle < hi:
            found = first_negative(form, lo, middle, halvings - 1)
            return first_negative(form, middle, hi, halvings - 1) if found is None else found
    found = negative(form, lo, hi)
    if not found:
        return None
    root = found[0][0]
    while root.hi - root.lo > Fraction(1, 1 << BITS):
        root.halve()
    return (root.lo + root.hi) / 2


class TrueBody:
    def __init__(self, disk, gravity):
        self.disk, self.t = disk, Fraction(0)
        self.c, self.v = list(disk.center), list(disk.velocity)
        self.a = [Fraction(0)] * len(gravity) if disk.fixed else gravity
        self.chain = []        # the events that turned it

    def centre(self, t):
        u = t - self.t
        return [c + u * (v + u * a / 2) for c, v, a in zip(self.c, self.v, self.a)]

    def velocity(self, t):
        return [v + (t - self.t) * a for v, a in zip(self.v, self.a)]

    def radius(self, t):
        return self.disk.radius + self.disk.growth * t

    def turn(self, t, v, event):
        self.c, self.v, self.t = [rounded(x) for x in self.centre(t)], [rounded(x) for x in v], t
        self.chain.append(event)


class TrueEvent:
    def __init__(self, t, pair, image, maneuver=None):
        self.t, self.pair, self.image, self.maneuver = t, pair, image, maneuver
        self.centres, self.before, self.after, self.reach, self.speeds = {}, {}, {}, None, Fraction(0)

    def name(self):
        return (self.pair, self.image) if self.pair else ("maneuver", self.maneuver)


class TrueMotion:
    """All events of a scene up to its horizon, in their order."""

    def __init__(self, scene):
        self.scene = scene
        self.bodies = [TrueBody(d, scene.gravity) for d in scene.disks]
        self.walls = 1 if scene.circle else len(scene.walls)
        self.met = {}          # (pair, image) -> when they met, and how many turns both had then
        self.events = []
        self.run()

    def turns(self, pair):
        return tuple(len(self.bodies[i].chain) if i >= 0 else 0 for i in pair)

    def vector(self, pair, image, t):
        """Where the second one is, seen from the first or the circle's centre, with velocity and acceleration."""
        (i, j), scene = pair, self.scene
        b = self.bodies[j]
        d, w, a = b.centre(t), b.velocity(t), list(b.a)
        if i < 0:
            return [x - o for x, o in zip(d, scene.circle.center)], w, a
        for axis, (k, side) in enumerate(zip(image, scene.sides)):
            d[axis] += k * side if side else 0
        if scene.shear:
            drift = image[1] * scene.shear * scene.sides[1]
            d[0] += drift * t
            w[0] += drift
        other = self.bodies[i]
        return ([x - y for x, y in zip(d, other.centre(t))], [x - y for x, y in zip(w, other.velocity(t))],
                [x - y for x, y in zip(a, other.a)])

    def reach(self, pair, t):
        """The reach and how it grows."""
        (i, j), scene = pair, self.scene
        b = self.bodies[j]
        if i < 0:
            return scene.circle.radius - b.radius(t), -b.disk.growth
        a = self.bodies[i]
        return a.radius(t) + b.radius(t), a.disk.growth + b.disk.growth

    def gap(self, pair, image, t):
        """A polynomial in the time since t that is below 0 where the two overlap."""
        (i, j), scene = pair, self.scene
        if i < 0 and not scene.circle:
            wall, b = scene.walls[-1 - i], self.bodies[j]
            return [dot(wall.normal, b.centre(t)) - wall.offset - wall.speed * t - b.radius(t),
                    dot(wall.normal, b.velocity(t)) - wall.speed - b.disk.growth, dot(wall.normal, b.a) / 2]
        d, w, a = self.vector(pair, image, t)
        rho, rate = self.reach(pair, t)
        form = [dot(d, d) - rho * rho, 2 * (dot(d, w) - rho * rate), dot(w, w) + dot(d, a) - rate * rate, dot(w, a),
                dot(a, a) / 4]
        return [-c for c in form] if i < 0 else form

    def first_fall(self, pair, image, t, span):
        """The first time after t, by no more than span, at which the gap falls below 0; None if it does not."""
        form = self.gap(pair, image, t)
        if self.met.get((pair, image)) == (t, self.turns(pair)):
            form[0] = Fraction(0)
        root = first_negative(form, Fraction(0), span)
        return None if root is None else rounded(t + root)

    def images(self, pair, t, span):
        (i, j), scene = pair, self.scene
        if i < 0:
            return [(0,) * scene.dimension]
        ends = []
        for time in (t, t + span):
            ends.append([y - x for x, y in zip(self.bodies[i].centre(time), self.bodies[j].centre(time))])
        bend = [abs(x - y) * span * span / 8 for x, y in zip(self.bodies[i].a, self.bodies[j].a)]
        low = [min(xs) - b for *xs, b in zip(*ends, bend)]
        high = [max(xs) + b for *xs, b in zip(*ends, bend)]
        reach = max(self.reach(pair, time)[0] for time in (t, t + span))
        drift = [scene.shear * (scene.sides[1] or 0) * time for time in (t, t + span)]
        return scene.images(low, high, reach, drift)

    def next_collision(self, t, limit):
        """The first collisions in [t, limit], as (time, pair, image): several where they are at about one time."""
        while t <= limit:
            span = limit - t
            lengths = [side for side in self.scene.sides if side] or [self.scene.extent]
            speed = max(math.hypot(*map(float, b.velocity(t))) for b in self.bodies)
            speed += abs(float(self.scene.shear * (self.scene.sides[1] or 0))) + 0.1
            span = min(span, Fraction(float(min(lengths)) / speed))
            best, end = [], span
            for pair in [(i, j) for j in range(len(self.bodies)) for i in range(-self.walls, j)]:
                if all(i < 0 or self.bodies[i].disk.fixed for i in pair):
                    continue
                for image in self.images(pair, t, end):
                    u = self.first_fall(pair, image, t, end)
                    if u is not None:
                        best.append((u, pair, image))
                        end = min(end, u - t + Fraction(1, 1 << 400))
            if best:
                first = min(best)[0]
                return [b for b in best if b[0] - first < Fraction(1, 1 << 400)]
            if span == limit - t:
                return []
            t += span
        return []

    def run(self):
        t, scene, upcoming = Fraction(0), self.scene, 0
        maneuvers = [n for n, m in enumerate(scene.maneuvers) if m.t <= scene.horizon]
        while len(self.events) < MOST_EVENTS:
            limit = scene.maneuvers[maneuvers[upcoming]].t if upcoming < len(maneuvers) else scene.horizon
            hits = self.next_collision(t, limit)
            disks = [i for _, pair, _ in hits for i in pair if i >= 0 and not self.bodies[i].disk.fixed]
            if len(set(disks)) < len(disks):
                raise Tie()
            if not hits and upcoming == len(maneuvers):
                return
            if not hits:
                t = limit
                self.maneuver(maneuvers[upcoming])
                upcoming += 1
                continue
            t = hits[0][0]
            self.collide(*hits[0])
        raise Tie()

    def maneuver(self, number):
        plan = self.scene.maneuvers[number]
        body = self.bodies[plan.disk]
        event = TrueEvent(plan.t, None, None, number)
        event.centres[plan.disk] = body.centre(plan.t)
        event.before[plan.disk] = body.velocity(plan.t)
        event.after[plan.disk] = list(plan.velocity)
        body.turn(plan.t, plan.velocity, event)
        self.events.append(event)

    def collide(self, t, pair, image):
        (i, j), scene = pair, self.scene
        event = TrueEvent(t, pair, image)
        b = self.bodies[j]
        for k in pair:
            if k >= 0:
                event.centres[k], event.before[k] = self.bodies[k].centre(t), self.bodies[k].velocity(t)
        seen = list(event.before[j])
        if i < 0 and not scene.circle:
            wall = scene.walls[-1 - i]
            n, q = wall.normal, (1 + wall.restitution) * (dot(seen, wall.normal) - wall.speed - b.disk.growth)
            change = {j: -q}
            event.speeds = norm(seen) + abs(b.disk.growth) + abs(wall.speed)
        else:
            n, w, _ = self.vector(pair, image, t)
            rho, rate = self.reach(pair, t)
            event.reach = rho
            q = (dot(w, n) - rate * rho) / dot(n, n)
            if i < 0:
                change = {j: -(1 + scene.circle.restitution) * q}
                event.speeds = norm(seen) + abs(b.disk.growth)
            else:
                a, q = self.bodies[i], (1 + scene.restitution) * q
                of_a = 0 if a.disk.fixed else 1 if b.disk.fixed else b.disk.mass / (a.disk.mass + b.disk.mass)
                change = {i: q * of_a, j: -q * (1 - of_a)}
                drift = image[1] * scene.shear * scene.sides[1] if scene.shear else 0
                event.speeds = norm(seen) + abs(drift) + norm(event.before[i]) + abs(a.disk.growth) + abs(b.disk.growth)
        for k, factor in change.items():
            event.after[k] = [v + factor * x for v, x in zip(event.before[k], n)]
            if not self.bodies[k].disk.fixed:
                self.bodies[k].turn(t, event.after[k], event)
        self.met[pair, image] = t, self.turns(pair)
        self.events.append(event)


class TrueJudge:
    """Holds the claims of a history against the true events; `ratios` has how near to each bound a claim is."""

    def __init__(self, scene, motion, tolerance=TIME_TOLERANCE, law_tolerance=LAW_TOLERANCE):
        self.scene, self.motion = scene, motion
        self.tau, self.law_tolerance = tolerance, law_tolerance
        self.ratios = []

    def within(self, off, allowed):
        if off:
            self.ratios.append(float(off / allowed) if allowed else math.inf)
        return off <= allowed

    def verdict(self, history):
        """None, or the (line, reason) of the first claim that is wrong, or of the end."""
        self.ratios = []
        told, used = defaultdict(int), set()
        for claim in history.claims:
            disks = claim.pair or claim.velocities
            movers = [k for k in disks if k >= 0 and not self.scene.disks[k].fixed]
            nexts = {self.next_of(k, told) for k in movers}
            event = next(iter(nexts)) if len(nexts) == 1 else None
            name = (claim.pair, claim.image) if claim.pair else ("maneuver", claim.maneuver)
            if event is None or event.name() != name:
                return claim.line, f"{name} is not next"
            if not self.within(abs(event.t - claim.t), self.tau):
                return claim.line, f"{name} is at another time, {float(event.t)}"
            reason = self.fault(claim, event)
            if reason:
                return claim.line, reason
            used.add(event)
            for k in movers:
                told[k] += 1
        if len(used) < len(self.motion.events):
            return history.end_line, "events are missing"
        counts = tuple(sum((c.pair is None) == kind for c in history.claims) for kind in (False, True))
        return (history.end_line, "wrong counts") if history.counts != counts else None

    def next_of(self, disk, told):
        chain = self.motion.bodies[disk].chain
        return chain[told[disk]] if told[disk] < len(chain) else None

    def fault(self, claim, event):
        scene = self.scene
        allowed = self.law_tolerance * event.speeds + 4 * self.tau * norm(scene.gravity)
        if event.reach:
            allowed += min(4 * self.tau * event.speeds ** 2 / event.reach, event.speeds / 1024)
        for disk, claimed in claim.velocities.items():
            true = event.after[disk]
            most = allowed + norm(true) / 2 ** 51 if event.pair else self.law_tolerance * norm(true)
            if not self.within(norm([x - y for x, y in zip(claimed, true)]), most):
                return f"disk {disk} does not leave as the law says"
        for disk, claimed in claim.centres.items():
            most = self.tau * (norm(event.before[disk]) + norm(event.after.get(disk, event.before[disk])))
            most += max(map(abs, claimed)) / 2 ** 50
            if not self.within(norm([x - y for x, y in zip(claimed, event.centres[disk])]), most):
                return f"disk {disk} is not there"
        return None


def main():
    scene = read_scene(sys.argv[1])
    fault = TrueJudge(scene, TrueMotion(scene)).verdict(read_history(sys.argv[2], scene))
    print("REFUTED line {}: {}".format(*fault) if fault else "CERTIFIED")
    return 1 if fault else 0


if __name__ == "__main__":
    sys.exit(main())
