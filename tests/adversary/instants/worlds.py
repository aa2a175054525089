"""Worlds of one instant: disks that touch then, in rows and clusters, and the orders that their turns can have.

All numbers are fractions, by the law of docs/formats.md, section 6. Centres of disks that touch differ by whole
vectors.
"""
from fractions import Fraction

CONTAINER = -1
RADIUS = Fraction(5, 2)  # radius of all disks
FAR = 80                 # the container's radius
# The whole vectors of length 5.
FIVES = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5), (3, -4), (4, -3)]
MOST_TURNS = 40
WITHIN = 9e-7            # distance of the claimed time from the true one: less than the tolerance
DELAY = Fraction(1, 2 ** 24)


class Impossible(Exception):
    """More collisions than MOST_TURNS, for they need not end; or a disk slides along the container, without a law."""


def minus(a, b):
    return a[0] - b[0], a[1] - b[1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


class World:
    """Disks at an instant `t`: `contacts` are the pairs that touch then, the smaller generator first.

    In some worlds what happens to the `late` disks, which are far from the others, happens a little later.
    """

    def __init__(self, rng, t, horizon):
        self.t, self.horizon = t, horizon
        self.restitution = rng.choice([Fraction(1), Fraction(1), Fraction(1, 2), Fraction(0)])
        self.wall_restitution = rng.choice([Fraction(1), Fraction(1, 2)])
        self.whole = rng.random() < 0.2  # the container's law
        in_a_row = rng.random() < 0.4
        ways = FIVES[:1] if in_a_row else FIVES
        x, y = rng.choice(FIVES if len(ways) > 1 else [(-5, 0)])
        far = (FAR - RADIUS) / 5 if rng.random() < 0.4 else Fraction(rng.randint(0, 4))
        places = self.cluster(rng, rng.choice([1, 2, 2, 3, 3, 4, 5]), ways, (x * far, y * far))
        late = self.cluster(rng, rng.randint(2, 3), ways, (-10 * x, -10 * y)) if rng.random() < 0.2 else []
        self.at = places + late  # by disk, its centre when it turns
        rng.shuffle(self.at)
        self.late = {g for g, place in enumerate(self.at) if place in late}
        if self.late:
            self.horizon += DELAY
        disks = range(len(self.at))
        heavy = 1 if rng.random() < 0.5 else 4
        self.mass = [Fraction(rng.randint(1, heavy)) for _ in disks]
        self.contacts = [(CONTAINER, g) for g in disks if dot(self.at[g], self.at[g]) == (FAR - RADIUS) ** 2]
        self.contacts += [(g, h) for h in disks for g in range(h)
                          if dot(self.apart(g, h), self.apart(g, h)) == 4 * RADIUS ** 2]
        self.velocity = [self.some_velocity(rng, in_a_row) for _ in disks]
        self.maneuvers = {g: self.some_velocity(rng, in_a_row) for g in disks if rng.random() < 0.4}

    @staticmethod
    def some_velocity(rng, in_a_row):
        return Fraction(rng.randint(-2, 2)), Fraction(0 if in_a_row else rng.randint(-2, 2))

    @staticmethod
    def cluster(rng, count, ways, first):
        """The places of so many disks, or fewer: each but the first touches one before it."""
        places = [first]
        for _ in range(50):
            if len(places) == count:
                break
            (x, y), (dx, dy) = rng.choice(places), rng.choice(ways)
            place = x + dx, y + dy
            if dot(place, place) <= (FAR - RADIUS) ** 2 and all(
                    dot(minus(place, p), minus(place, p)) >= 4 * RADIUS ** 2 for p in places):
                places.append(place)
        return places

    def time(self, g):
        return self.t + (DELAY if g in self.late else 0)

    def apart(self, i, j):
        return minus(self.at[j], (0, 0) if i == CONTAINER else self.at[i])

    def approach(self, i, j, velocity):
        """Less than 0 where two that touch approach."""
        w = minus(velocity[j], (0, 0) if i == CONTAINER else velocity[i])
        return dot(self.apart(i, j), w) * (-1 if i == CONTAINER else 1)

    def is_worth_asking(self):
        """There are several turns, nobody overlaps before them, and nobody collides after them up to the horizon."""
        pairs = [(i, j) for j in range(len(self.at)) for i in range(CONTAINER, j)]
        near = [(i, j) for i, j in pairs if i == CONTAINER or (i in self.late) == (j in self.late)]
        if not all(self.are_far(*pair) for pair in set(pairs) - set(near)):
            return False
        if not all(self.is_clear(i, j, self.velocity, -self.time(j)) for i, j in near):
            return False
        right = self.right_order()
        after = self.velocities(right)[-1]
        return len(right) >= 2 and all(self.is_clear(i, j, after, self.horizon - self.time(j)) for i, j in near)

    def are_far(self, i, j):
        return dot(self.apart(i, j), self.apart(i, j)) > 20 ** 2

    def is_clear(self, i, j, velocity, until):
        """The two keep their distance from t to t + until, either of which may be the earlier time."""
        d, w = self.apart(i, j), minus(velocity[j], (0, 0) if i == CONTAINER else velocity[i])
        reach = (FAR - RADIUS if i == CONTAINER else 2 * RADIUS) ** 2
        times = [Fraction(0), Fraction(until)]
        if i != CONTAINER and dot(w, w) > 0:
            nearest = -dot(d, w) / dot(w, w)
            if min(times) < nearest < max(times):
                times.append(nearest)
        gaps = [dot(p, p) - reach for p in ((d[0] + w[0] * s, d[1] + w[1] * s) for s in times)]
        if i == CONTAINER:
            gaps = [-gap for gap in gaps]
        return all(gap >= 0 for gap in gaps) and (until <= 0 or all(gap > 0 for gap in gaps[1:]) or w == (0, 0))

    def scene(self):
        disks = [{"center": [float(p - v * self.time(g)) for p, v in zip(self.at[g], velocity)],
                  "radius": float(RADIUS), "velocity": [float(v) for v in velocity], "mass": float(self.mass[g])}
                 for g, velocity in enumerate(self.velocity)]
        container = {"center": [0, 0], "radius": FAR, "restitution": float(self.wall_restitution)}
        maneuvers = [{"t": float(self.time(g)), "disk": g, "velocity": [float(x) for x in v]}
                     for g, v in sorted(self.maneuvers.items(), key=lambda m: (self.time(m[0]), m[0]))]
        return {"format": "voroproof-scene", "version": 1, "container": container,
                "container_law": "whole" if self.whole else "normal", "restitution": float(self.restitution),
                "horizon": float(self.horizon), "disks": disks, "maneuvers": maneuvers}

    # A turn is a pair, the smaller generator first, or a disk.

    def due(self, velocity):
        return [pair for pair in self.contacts if self.approach(*pair, velocity) < 0]

    def after(self, turn, velocity):
        after = list(velocity)
        if isinstance(turn, int):
            after[turn] = self.maneuvers[turn]
            return after
        i, j = turn
        n, square = self.apart(i, j), dot(self.apart(i, j), self.apart(i, j))
        if i == CONTAINER:
            v, sigma = velocity[j], self.wall_restitution
            if self.whole:
                after[j] = tuple(sigma * (x - 2 * dot(v, n) / square * m) for x, m in zip(v, n))
            else:
                after[j] = tuple(x - (1 + sigma) * dot(v, n) / square * m for x, m in zip(v, n))
            return after
        w = minus(velocity[j], velocity[i])
        share = (1 + self.restitution) * dot(w, n) / square / (self.mass[i] + self.mass[j])
        after[i] = tuple(x + self.mass[j] * share * m for x, m in zip(velocity[i], n))
        after[j] = tuple(x - self.mass[i] * share * m for x, m in zip(velocity[j], n))
        return after

    def velocities(self, turns):
        """Before the first turn, and after each."""
        all_ = [self.velocity]
        for turn in turns:
            all_.append(self.after(turn, all_[-1]))
        for velocity in all_:
            for i, j in self.contacts:
                if i == CONTAINER and velocity[j] != (0, 0) and self.approach(i, j, velocity) == 0:
                    raise Impossible
        return all_

    def right_order(self):
        turns, velocity = [], self.velocity

        def collisions():
            nonlocal velocity
            while pairs := self.due(velocity):
                turns.append(min(pairs))
                velocity = self.after(turns[-1], velocity)
                if len(turns) > MOST_TURNS:
                    raise Impossible

        collisions()
        for g in sorted(self.maneuvers):
            turns.append(g)
            velocity = self.after(g, velocity)
        collisions()
        return turns

    def orders(self, most, rng):
        """Up to so many orders that are consistent: nobody approaches at their end, and all maneuvers have come."""
        found = []
        for _ in range(most):
            turns, velocity, left = [], self.velocity, set(self.maneuvers)
            while (nexts := self.due(velocity) + sorted(left)) and len(turns) <= MOST_TURNS:
                turns.append(rng.choice(nexts))
                velocity = self.after(turns[-1], velocity)
                left.discard(turns[-1])
            try:
                self.velocities(turns)
                if not nexts and turns not in found:
                    found.append(turns)
            except Impossible:
                pass
        return found

    def may_happen(self, turns):
        """Each collision is of two that approach then, each maneuver comes once, and nobody approaches at the end."""
        if sorted(turn for turn in turns if isinstance(turn, int)) != sorted(self.maneuvers):
            return False
        states = self.velocities(turns)
        return not self.due(states[-1]) and all(
            isinstance(turn, int) or turn in self.due(velocity) for turn, velocity in zip(turns, states))

    def spoiled(self, turns, rng):
        """The turns, one of them left out, doubled or exchanged with that before it, or one collision more."""
        turns, k = list(turns), rng.randrange(len(turns))
        how = rng.randrange(4)
        if how == 0:
            del turns[k]
        elif how == 1:
            turns.insert(k, turns[k])
        elif how == 2 and k > 0:
            turns[k - 1], turns[k] = turns[k], turns[k - 1]
        elif self.contacts:
            turns.insert(k, rng.choice(self.contacts))
        return turns

    def is_quiet_after(self, turns):
        """Nobody who is not about to collide at the instant does so up to the horizon."""
        try:
            after = self.velocities(turns)[-1]
        except Impossible:
            return False
        pairs = [(i, j) for j in range(len(self.at)) for i in range(CONTAINER, j)]
        near = [(i, j) for i, j in pairs if i == CONTAINER or (i in self.late) == (j in self.late)]
        left = self.due(after)
        return all(pair in left or self.is_clear(*pair, after, self.horizon - self.time(pair[1])) for pair in near)

    def by_disk(self, turns):
        """The turns of each disk, one after the other."""
        return [[turn for turn in turns if turn == g or isinstance(turn, tuple) and g in turn]
                for g in range(len(self.at))]

    def lines(self, turns, rng):
        """The claims of these turns, some of them not quite at t; some give velocities, where doubles can."""
        lines = []
        off = rng.choice([0, 0, WITHIN])
        times = sorted(min(max(float(self.t) + rng.uniform(-off, off), 0), float(self.horizon)) for _ in turns)
        for turn, velocity, t in zip(turns, self.velocities(turns)[1:], times):
            line = {"t": t, **({"maneuver": turn} if isinstance(turn, int) else {"collide": list(turn)})}
            disks = [turn] if isinstance(turn, int) else [g for g in turn if g != CONTAINER]
            exact = all(Fraction(float(x)) == x for g in disks for x in velocity[g])
            if exact and rng.random() < 0.5:
                given = [[float(x) for x in velocity[g]] for g in disks]
                line["v"] = given[0] if isinstance(turn, int) else [None] * (2 - len(given)) + given
            lines.append(line)
        return lines


class DiagonalRow(World):
    """A row along x = y that contracts until all neighbours touch at once, at a time that is no fraction."""

    def __init__(self, rng):
        self.restitution = rng.choice([Fraction(1), Fraction(1, 2)])
        self.wall_restitution, self.whole, self.maneuvers, self.late = Fraction(1), False, {}, set()
        row = list(range(rng.choice([3, 3, 4, 5])))
        rng.shuffle(row)
        spacing, speed, drift = rng.randint(5, 7), rng.randint(1, 2), rng.randint(-1, 1)
        places = {g: (k - len(row) // 2) * spacing for k, g in enumerate(row)}
        self.start = [(Fraction(places[g]),) * 2 for g in sorted(row)]
        self.velocity = [tuple(drift - speed * p / spacing for p in place) for place in self.start]
        self.at = self.start  # for directions
        self.mass = [Fraction(rng.randint(1, rng.choice([1, 4]))) for _ in row]
        self.contacts = [tuple(sorted(pair)) for pair in zip(row, row[1:])]
        self.t = (spacing - 2 * RADIUS / Fraction(2 ** 0.5)) / speed  # nearly
        self.horizon = self.t + Fraction(1, 8)

    def scene(self):
        scene = super().scene()
        for disk, place in zip(scene["disks"], self.start):
            disk["center"] = [float(p) for p in place]
        return scene

    def is_quiet_after(self, turns):
        return True

    def is_worth_asking(self):
        return len(self.right_order()) >= 2
