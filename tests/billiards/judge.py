"""A brute force judge for histories of hard-ball billiards: every pair, every image, every sign exact.

Command: judge.py SCENE HISTORY [--tolerance T] [--law-tolerance L] prints CERTIFIED or REFUTED line N: reason."""
import argparse
import math
import sys
from collections import defaultdict
from fractions import Fraction

from billiard import Malformed, dot, read_history, read_scene, record_paths
from roots import Root, evaluate, integral, negative, plus, roots, sign, slope, times

TIME_TOLERANCE = Fraction(1, 10 ** 6)
LAW_TOLERANCE = Fraction(1, 10 ** 9)
ROOT_BITS = 300    # square roots are taken to this many binary places


def sqrt(x):
    """The square root of a rational, far more exactly than any tolerance here."""
    return Fraction(math.isqrt((x.numerator << 2 * ROOT_BITS) // x.denominator), 1 << ROOT_BITS)


def norm(v):
    return sqrt(Fraction(dot(v, v)))


def sign_of(a, b, square):
    """The sign of a + b * sqrt(square), exactly."""
    sa, sb = (a > 0) - (a < 0), ((b > 0) - (b < 0)) if square else 0
    if sa * sb >= 0:
        return sa or sb
    return sa * ((a * a > b * b * square) - (a * a < b * b * square))


class Episode:
    """A maximal time interval in which a pair overlaps on the recorded paths."""

    def __init__(self, entry):
        self.entry, self.end = entry, None
        self.deep = False      # deeper than the roundings explain
        self.answer = None     # the claim that answers its entry


class Motion:
    """Two disks (or a wall and a disk) on one line each: their vector, or the wall's gap, as polynomials in time."""

    def __init__(self, judge, pair, image, lines):
        scene, (i, j) = judge.scene, pair
        b = scene.disks[j]
        at_b = [list(axis) for axis in judge.paths[j].lines[lines[1]]]
        self.count = lines[1] + (lines[0] if i >= 0 else 0)
        on = [(judge.paths[k], n) for k, n in zip(pair, lines) if k >= 0]
        self.begin = max(path.starts[n] for path, n in on)
        self.speeds = sum(norm(path.velocity(n, path.starts[n])) for path, n in on)
        self.wall = scene.walls[-1 - i] if i < 0 and not scene.circle else None
        self.inside = i < 0 and self.wall is None
        if self.wall:
            gap = [-self.wall.offset - b.radius, -self.wall.speed - b.growth]
            for n, axis in zip(self.wall.normal, at_b):
                gap = plus(gap, axis, n)
            self.gap = gap
        elif self.inside:
            self.vector = [plus(axis, [x], -1) for axis, x in zip(at_b, scene.circle.center)]
            self.reach = [scene.circle.radius - b.radius, -b.growth]
        else:
            a = scene.disks[i]
            self.vector = [plus(y, x, -1) for x, y in zip(judge.paths[i].lines[lines[0]], at_b)]
            for axis, (k, side) in enumerate(zip(image, scene.sides)):
                self.vector[axis] = plus(self.vector[axis], [k * side if side else 0])
            if scene.shear:
                self.vector[0] = plus(self.vector[0], [0, image[1] * scene.shear * scene.sides[1]])
            self.reach = [a.radius + b.radius, a.growth + b.growth]

    def below(self, shift=0):
        """A polynomial that is below 0 exactly where the gap is below -shift."""
        if self.wall:
            return plus(self.gap, [shift])
        reach = plus(self.reach, [shift if self.inside else -shift])
        result = times(reach, reach) if self.inside else [-c for c in times(reach, reach)]
        for axis in self.vector:
            result = plus(result, times(axis, axis), -1 if self.inside else 1)
        return result

    def state(self, t):
        """Vector, its velocity, and reach (radii together, or the circle's radius less the disk's) at t."""
        return ([evaluate(axis, t) for axis in self.vector], [evaluate(slope(axis), t) for axis in self.vector],
                evaluate(self.reach, t))

    def trend(self, t):
        """The sign of the gap's derivative at t."""
        if self.wall:
            return sign(integral(slope(self.gap)), t)
        d, w, _ = self.state(t)
        towards = -1 if self.inside else 1
        return sign_of(towards * dot(d, w), -towards * self.reach[1], dot(d, d))

    def approaching(self, t):
        """Whether the law, applied at t, would drive the two apart."""
        if self.wall:
            return self.trend(t) < 0
        d, w, rho = self.state(t)
        rate = dot(d, w) - self.reach[1] * rho
        return rate > 0 if self.inside else rate < 0


class Judge:
    def __init__(self, scene, history, tolerance=TIME_TOLERANCE, law_tolerance=LAW_TOLERANCE):
        self.scene, self.history = scene, history
        self.tau, self.law_tolerance = tolerance, law_tolerance
        self.paths = record_paths(scene, history)
        self.extent = scene.extent
        self.faults = []
        self.episodes = defaultdict(list)      # (pair, image) -> episodes in order

    def fault(self, line, reason):
        self.faults.append((line, reason))

    def verdict(self):
        """None if the history is right, else the fault of the smallest line, as (line, reason)."""
        for pair in self.pairs():
            self.find_episodes(pair)
        for claim in self.history.claims:
            if claim.pair:
                self.check_collision(claim)
            self.check_centres(claim)
        self.check_maneuvers()
        self.check_episodes()
        found = tuple(sum((c.pair is None) == kind for c in self.history.claims) for kind in (False, True))
        if self.history.counts != found:
            self.fault(self.history.end_line, "wrong counts")
        return min(self.faults, key=lambda fault: fault[0], default=None)

    # Overlaps on the recorded paths.

    def pairs(self):
        walls = 1 if self.scene.circle else len(self.scene.walls)
        return [(i, j) for j in range(len(self.scene.disks)) for i in range(-walls, j)]

    def pieces(self, pair):
        """(start, end, lines) of the stretches in which neither of the pair turns."""
        i, j = pair
        starts = [self.paths[i].starts if i >= 0 else [Fraction(0)], self.paths[j].starts]
        lines, start, horizon = [0, 0], Fraction(0), self.scene.horizon
        while True:
            following = [s[n + 1] if n + 1 < len(s) else None for s, n in zip(starts, lines)]
            end = min((t for t in following if t is not None), default=horizon)
            if start < end:
                yield start, end, tuple(lines)
            if following == [None, None]:
                return
            lines = [n + (t == end) for n, t in zip(lines, following)]
            start = end

    def images(self, pair, start, end, lines):
        """The images of a piece that can come near: on each axis the vector stays in a box around its ends."""
        (i, j), scene = pair, self.scene
        ends = [[y - x for x, y in zip(self.paths[i].centre(lines[0], t), self.paths[j].centre(lines[1], t))]
                for t in (start, end)]
        bend = [abs(x - y) * (end - start) ** 2 / 8
                for x, y in zip(self.paths[i].acceleration, self.paths[j].acceleration)]
        reach = max(sum(scene.disks[n].radius + scene.disks[n].growth * t for n in pair) for t in (start, end))
        reach += sum(scene.disks[n].radius for n in pair) / 8      # generous
        low = [min(xs) - b for *xs, b in zip(*ends, bend)]
        high = [max(xs) + b for *xs, b in zip(*ends, bend)]
        drift = [scene.shear * (scene.sides[1] or 0) * t for t in (start, end)]
        return scene.images(low, high, reach, drift)

    def find_episodes(self, pair):
        none = (0,) * self.scene.dimension
        for start, end, lines in self.pieces(pair):
            for image in self.images(pair, start, end, lines) if pair[0] >= 0 else [none]:
                motion = Motion(self, pair, image, lines)
                found = negative(motion.below(), start, end)
                if found:
                    self.add_episodes(self.episodes[pair, image], motion, found, start, end)

    def add_episodes(self, known, motion, found, start, end):
        """Adds the overlaps found on one piece; the first may go on from the piece before."""
        below = integral(motion.below())
        deep = [inside for a, b, delta in self.depths(motion, start, end)
                for _, _, inside in negative(motion.below(delta), a, b)]
        for first, last, _ in found:
            goes_on = known and first.compare(start) == 0 and sign(below, start) < 0
            if not goes_on:
                known.append(Episode(first))
            episode = known[-1]
            episode.end = last
            episode.deep |= any(first.compare(x) < 0 < last.compare(x) for x in deep)

    def delta(self, motion, t):
        """The depth that roundings explain, at time t."""
        delta = (self.extent * max(1, motion.count) + motion.speeds * motion.begin) / 2 ** 51
        return delta if motion.wall or evaluate(motion.reach, t) >= 4 * delta else Fraction(0)

    def depths(self, motion, start, end):
        """The piece, cut where the rounding delta begins or ceases to apply: (start, end, delta)."""
        at = [self.delta(motion, t) for t in (start, end)]
        if at[0] == at[1]:
            return [(start, end, at[0])]
        x = (4 * max(at) - motion.reach[0]) / motion.reach[1]
        return [(start, x, at[0]), (x, end, at[1])]

    def check_episodes(self):
        for (pair, image), episodes in self.episodes.items():
            for episode in episodes:
                if not episode.deep or episode.entry.compare(self.scene.horizon - self.tau) >= 0:
                    continue
                if episode.answer:
                    t = episode.answer.t
                    if episode.entry.compare(t - self.tau) >= 0 and episode.end.compare(t + self.tau) <= 0:
                        continue
                names = f"{pair} image {image}" if self.scene.periodic else pair
                self.fault(self.line_after(episode.entry),
                           f"{names} overlap from {float(episode.entry)} to {float(episode.end)}")

    def line_after(self, x):
        """The line of the first event later than x, or of the end."""
        return next((c.line for c in self.history.claims if x.compare(c.t) < 0), self.history.end_line)

    # Claims.

    def check_collision(self, claim):
        i, j = claim.pair
        disks = [n for n in claim.pair if n >= 0]
        if all(self.scene.disks[n].fixed for n in disks):
            return self.fault(claim.line, "none of the two can turn")
        lines = (claim.before.get(i, 0), claim.before[j])
        motion = Motion(self, claim.pair, claim.image, lines)
        start = max(self.paths[n].starts[claim.before[n]] for n in disks)
        if not self.answers(claim, motion, start):
            self.fault(claim.line, "no such contact at this time")
        self.check_law(claim, motion)

    def answers(self, claim, motion, start):
        """Whether the claim answers an entry or a graze; marks the episode it answers."""
        t, tau = claim.t, self.tau
        episodes = self.episodes.get((claim.pair, claim.image), [])
        for entry, _, _ in negative(motion.below(), start, t + tau + 1):
            # On the first stretch below 0 from the start the entry is there only if the gap is 0 there.
            if entry.compare(start) == 0 and evaluate(motion.below(), start) < 0:
                continue
            if entry.compare(t - tau) >= 0 >= entry.compare(t + tau):
                if entry.compare(t) < 0:
                    return self.mark(claim, [e for e in episodes if self.starts_at(e, entry, start, t)])
                return True
        if self.just_met(claim):
            return False
        for e in episodes:
            if e.entry.compare(start) < 0 < e.end.compare(start) and e.end.compare(t) >= 0:
                if not motion.approaching(t):
                    return False
                in_time = e.entry.compare(t - tau) >= 0
                return not e.deep or (in_time and self.mark(claim, [e]))
        return self.grazes(motion, start, t)

    @staticmethod
    def starts_at(episode, entry, start, t):
        return episode.entry.compare(start) >= 0 >= episode.entry.compare(t) and episode.entry.same(entry)

    @staticmethod
    def mark(claim, episodes):
        for episode in episodes:
            if episode.answer:
                return False
            episode.answer = claim
        return True

    def just_met(self, claim):
        """Whether the last turn of both disks was this very contact."""
        i, j = claim.pair
        if i < 0:
            return False
        last = {self.paths[n].turned_by[claim.before[n]] for n in claim.pair if not self.scene.disks[n].fixed}
        if len(last) != 1 or None in last:
            return False
        before = last.pop()
        return before.pair == claim.pair and before.image == claim.image

    def grazes(self, motion, start, t):
        """Whether the two come nearest within tau of t, to a gap that roundings explain."""
        lo, hi = max(start, t - self.tau), t + self.tau
        falls, rises = motion.trend(lo), motion.trend(hi)
        if not (falls < 0 <= rises or (falls == 0 < rises and lo > start)):
            return False
        within = motion.below(-self.delta(motion, t))
        return any(evaluate(within, x) <= 0 for x in (lo, hi)) or bool(roots(within, lo, hi))

    def check_law(self, claim, motion):
        (i, j), t, scene = claim.pair, claim.t, self.scene
        before = {n: self.paths[n].velocity(claim.before[n], t) for n in claim.before}
        b, mu = scene.disks[j], Fraction(0)
        seen = list(before[j])                       # the velocity of the image
        if scene.shear and i >= 0:
            seen[0] += claim.image[1] * scene.shear * scene.sides[1]
        if motion.wall:
            wall = motion.wall
            n, rate = wall.normal, dot(seen, wall.normal) - wall.speed - b.growth
            change = {j: -(1 + wall.restitution) * rate}
            speeds = norm(seen) + abs(wall.speed) + abs(b.growth)
        else:
            n, w, rho = motion.state(t)
            if not any(n) or rho <= 0:
                return self.fault(claim.line, "no normal at this contact")
            rate = (dot(w, n) - motion.reach[1] * rho) / dot(n, n)
            speeds = norm(seen) + abs(b.growth)
            if motion.inside:
                change = {j: -(1 + scene.circle.restitution) * rate}
            else:
                a, q = scene.disks[i], (1 + scene.restitution) * rate
                of_a = 0 if a.fixed else 1 if b.fixed else b.mass / (a.mass + b.mass)
                change = {i: q * of_a, j: -q * (1 - of_a)}
                speeds += norm(before[i]) + abs(a.growth)
            mu = 16 * (self.extent + speeds * t) / rho / 2 ** 53
        fall = norm(scene.gravity) * t / 2 ** 51
        for disk, claimed in claim.velocities.items():
            off = [x - (v + change[disk] * y) for x, v, y in zip(claimed, before[disk], n)]
            if norm(off) > (self.law_tolerance + mu) * speeds + fall:
                self.fault(claim.line, f"disk {disk} does not leave as the law says")

    def check_centres(self, claim):
        for disk, claimed in claim.centres.items():
            line, t = claim.before[disk], claim.t
            before = self.paths[disk].velocity(line, t)
            slack = self.tau * (norm(before) + norm(claim.velocities.get(disk, before)))
            for x, y in zip(claimed, self.paths[disk].centre(line, t)):
                if abs(x - y) > slack + 4 * Fraction(math.ulp(float(max(abs(x), abs(y))))):
                    return self.fault(claim.line, f"disk {disk} is not there")

    def check_maneuvers(self):
        claimed = set()
        for claim in self.history.claims:
            if claim.maneuver is None:
                continue
            plan, velocity = self.scene.maneuvers[claim.maneuver], claim.velocities
            if claim.maneuver in claimed:
                self.fault(claim.line, "this maneuver was claimed before")
            claimed.add(claim.maneuver)
            if abs(claim.t - plan.t) > self.tau or plan.t > self.scene.horizon:
                self.fault(claim.line, "not the time of this maneuver")
            off = [x - y for x, y in zip(velocity[plan.disk], plan.velocity)]
            if dot(off, off) > self.law_tolerance ** 2 * dot(plan.velocity, plan.velocity):
                self.fault(claim.line, "not the velocity of this maneuver")
        for n, plan in enumerate(self.scene.maneuvers):
            if n not in claimed and plan.t <= self.scene.horizon:
                self.fault(self.line_after(Root(plan.t)), f"maneuver {n} is missing")


def judge(scene, history, tolerance=TIME_TOLERANCE, law_tolerance=LAW_TOLERANCE):
    """None, or the (line, reason) of the first fault."""
    return Judge(scene, history, tolerance, law_tolerance).verdict()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scene")
    parser.add_argument("history")
    parser.add_argument("--tolerance", type=Fraction, default=TIME_TOLERANCE)
    parser.add_argument("--law-tolerance", type=Fraction, default=LAW_TOLERANCE)
    args = parser.parse_args()
    try:
        scene = read_scene(args.scene)
    except Malformed as fault:
        sys.exit(f"{args.scene}: {fault.reason}")
    try:
        fault = judge(scene, read_history(args.history, scene), args.tolerance, args.law_tolerance)
    except Malformed as malformed:
        fault = (malformed.line, malformed.reason)
    print("REFUTED line {}: {}".format(*fault) if fault else "CERTIFIED")
    return 1 if fault else 0


if __name__ == "__main__":
    sys.exit(main())
