"""Worlds of one instant, or of two that are nearer than the tolerance: groups of disks that move.

All numbers are rational. The places at the instant are chosen, and the motion goes through them.
"""
from fractions import Fraction

from apollonius import CONTAINER
from groups import FAR, IN_PAIRS, MOTIONS, SHAPES, eighths, moved, some_groups, some_velocities

KINDS = ["plain"] * 3 + ["maneuver"] * 2 + ["maneuver nearby", "later group"]
# Turns have times that are doubles: so recorded paths are the true ones.
DOUBLES = [Fraction(1, 2), Fraction(1, 4), Fraction(3, 8)]
OTHERS = [Fraction(1, 3), Fraction(2, 7)]
# Less than the tolerance.
NEARBY = [Fraction(1, 2 ** 22), Fraction(1, 2 ** 24), Fraction(1, 2 ** 60)]
# A drift takes each of its velocities for so long, and is over before all instants but the start.
STEP = Fraction(1, 64)
# Each is far below the last place of the one before: what they add up to takes a double each.
SCALES = [Fraction(1, 2 ** bits) for bits in (30, 90, 150, 210, 270, 330)]


class World:
    """Disks that are at `places` at `times`, each at its own. At the `maneuver`, if any, one turns.

    `maneuver` is (time, disk, velocity), and `instants` are all times at which flips may be due. Up to `since` all disks
    have the velocities of the `drift`, one after the other.
    """

    def __init__(self, rng):
        self.choose_instant(rng)
        self.place_disks(rng)
        self.maneuver = None
        if self.kind.startswith("maneuver"):
            off = rng.choice([-1, 1]) * NEARBY[0] if self.kind == "maneuver nearby" else 0
            self.maneuver = self.t + off, rng.randrange(len(self.places)), eighths(rng, 8)
        self.instants = sorted({*self.times, *(self.maneuver or ())[:1]})
        self.horizon = self.instants[-1] + (0 if self.is_at_horizon else Fraction(1, 4))
        # The container would not drift with the others. In recorded paths the velocities after the drift are doubles.
        can_drift = not self.is_at_start and not self.has_container and all(
            Fraction(float(x)) == x for velocity in self.velocities for x in velocity)
        drifts = can_drift and rng.random() < 0.4
        self.drift = [(scale * rng.randint(1, 7), scale * rng.randint(-7, 7)) for scale in SCALES] if drifts else []
        self.since = len(self.drift) * STEP

    def choose_instant(self, rng):
        when = rng.choice(["between"] * 4 + ["start", "horizon"])
        self.is_at_start, self.is_at_horizon = when == "start", when == "horizon"
        # Nothing is near the start but what is at it.
        self.kind = rng.choice(["plain", "maneuver"] if self.is_at_start else KINDS)
        if self.is_at_start:
            self.t = Fraction(0)
        else:
            self.t = rng.choice(DOUBLES + (OTHERS if self.kind == "plain" else []))

    def place_disks(self, rng):
        self.places, self.radii, self.velocities, self.times = [], [], [], []
        shape = rng.choice(IN_PAIRS if self.kind == "later group" else SHAPES)
        self.has_container = "container" in shape
        motion = rng.choice(MOTIONS)
        delay = rng.choice(NEARBY) if self.kind == "later group" else 0
        disks = []
        for number, group in enumerate(some_groups(rng, shape)):
            velocities = some_velocities(rng, motion, group, self.has_container)
            disks += [(disk, v, self.t + number * delay) for disk, v in zip(group, velocities)]
        rng.shuffle(disks)  # for their ids
        for disk, velocity, t in disks:
            self.places.append(disk.place)
            self.radii.append(disk.radius)
            self.velocities.append(velocity)
            self.times.append(t)

    def velocity(self, g, t):
        """Just after t."""
        if t < self.since:
            return self.drift[int(t / STEP)]
        if self.maneuver and self.maneuver[1] == g and t >= self.maneuver[0]:
            return self.maneuver[2]
        return self.velocities[g]

    def centre(self, g, t):
        at = self.centre_without_drift(g, max(t, self.since))
        for k, velocity in enumerate(self.drift):
            at = moved(at, velocity, min(t, (k + 1) * STEP) - min(t, k * STEP))
        return at

    def centre_without_drift(self, g, t):
        """As if nothing had drifted, from the end of the drift on."""
        at, since = self.places[g], self.times[g]
        if self.maneuver and self.maneuver[1] == g:
            turn = self.maneuver[0]
            if min(t, since) < turn < max(t, since):
                at, since = moved(at, self.velocity_between(g, since, turn), turn - since), turn
        return moved(at, self.velocity_between(g, since, t), t - since)

    def velocity_between(self, g, some, other):
        """Between two times that have no turn between them."""
        return self.velocity(g, (some + other) / 2)

    def generators(self, t):
        disks = {g: (*self.centre(g, t), r) for g, r in enumerate(self.radii)}
        return {CONTAINER: (0, 0, -FAR), **disks}

    def scene(self):
        disks = [{"center": texts(self.centre(g, Fraction(0))), "radius": str(radius),
                  "velocity": texts(self.velocity(g, Fraction(0))), "mass": 1}
                 for g, radius in enumerate(self.radii)]
        turns = [k * STEP for k in range(1, len(self.drift) + 1)]
        maneuvers = [{"t": str(t), "disk": g, "velocity": texts(self.velocity(g, t))}
                     for t in turns for g in range(len(self.places))]
        if self.maneuver:
            t, disk, velocity = self.maneuver
            maneuvers.append({"t": str(t), "disk": disk, "velocity": texts(velocity)})
        return {"format": "voroproof-scene", "version": 1,
                "container": {"center": [0, 0], "radius": FAR}, "horizon": str(self.horizon),
                "disks": disks, "maneuvers": maneuvers}


def texts(numbers):
    return [str(x) for x in numbers]
