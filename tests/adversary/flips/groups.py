"""Groups of disks that touch one circle, with or without the container, and their velocities.

All numbers are rational. Groups of one world do not touch each other's circles.
"""
import math
from fractions import Fraction
from typing import NamedTuple

FAR = 20  # the container's radius
RESTING = Fraction(0), Fraction(0)
# Points of the unit circle, counterclockwise.
DIRECTIONS = sorted({(Fraction(sx * x, z), Fraction(sy * y, z))
                     for a, b, z in ((3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (0, 1, 1))
                     for x, y in ((a, b), (b, a)) for sx in (1, -1) for sy in (1, -1)},
                    key=lambda u: math.atan2(u[1], u[0]))
# (x, distance of (x, 0) from (0, 6)), both rational.
RATIONAL = [(Fraction(s * x, 4), Fraction(distance, 4)) for s in (1, -1)
            for x, distance in ((32, 40), (18, 30), (10, 26), (7, 25))]
RATIONAL.append((Fraction(0), Fraction(6)))
IN_PAIRS = ["two groups", "two groups at the container"]
SHAPES = ["one group"] * 2 + ["at the container"] * 2 + IN_PAIRS + ["lattice", "mirror images"]
# The disks of a group that move together stay cotangent.
MOTIONS = ["random", "random", "two", "one", "few", "around", "around", "together"]


class Impossible(Exception):
    """The random numbers make no group."""


class Disk(NamedTuple):
    place: tuple
    radius: Fraction
    direction: tuple = RESTING  # from the circle's centre


def moved(at, velocity, duration):
    return tuple(x + v * duration for x, v in zip(at, velocity))


def some_groups(rng, shape):
    radii = rng.choice([[0], [Fraction(1, 4)], [0, Fraction(1, 4)],
                        [Fraction(1, 8), Fraction(1, 4), Fraction(1, 2), 1]])
    if shape == "one group":
        centre = Fraction(rng.randint(-2, 2)), Fraction(rng.randint(-2, 2))
        return [around(rng, centre, rng.choice([5, 7, 8]), rng.choice([4, 5, 5, 6]), radii)]
    if shape == "at the container":
        return [at_container(rng, rng.choice(DIRECTIONS), rng.choice([3, 4, 4, 5]), radii)]
    if shape == "two groups":
        return [around(rng, (Fraction(x), Fraction(0)), 5, rng.choice([4, 4, 5]), radii)
                for x in (-9, 9)]
    if shape == "two groups at the container":
        return [at_container(rng, (Fraction(x), Fraction(0)), 3, radii) for x in (-1, 1)]
    return [lattice(rng)] if shape == "lattice" else [mirror_images(rng)]


def around(rng, centre, rho, count, radii):
    """Disks that touch the circle of this centre and radius."""
    group = []
    for u in rng.sample(DIRECTIONS, count):
        radius = rng.choice(radii)
        group.append(Disk(moved(centre, u, rho + radius), radius, u))
    return group


def at_container(rng, direction, count, radii):
    """Disks that touch a circle which touches the container from within."""
    rho = rng.choice([6, 7, 8])
    for _ in range(50):
        group = around(rng, moved((0, 0), direction, FAR - rho), rho, count, radii)
        if all(x * x + y * y < (FAR - radius - 1) ** 2 for (x, y), radius, _ in group):
            return group
    raise Impossible


def lattice(rng):
    """One square, or two that have two disks in common."""
    width, radius = rng.choice([2, 3, 3]), rng.choice([0, Fraction(1, 4), 1])
    return [Disk((Fraction(4 * i - 2 * (width - 1)), Fraction(4 * j - 2)), radius)
            for i in range(width) for j in range(2)]


def mirror_images(rng):
    """Disks with their centres on a line: two circles touch them all, one on either side."""
    rho, shift = 6 - rng.choice([0, 0, Fraction(1, 8)]), rng.randint(-2, 2)
    count, group = rng.choice([4, 5, 6]), []
    for x, distance in rng.sample(RATIONAL, len(RATIONAL)):
        x, radius = x + shift, distance - rho
        apart = all(abs(x - disk.place[0]) > radius + disk.radius for disk in group)
        if apart and len(group) < count:
            group.append(Disk((x, Fraction(0)), radius))
    if len(group) < 4:
        raise Impossible
    return group


def some_velocities(rng, motion, group, is_at_container):
    few = [eighths(rng, 4) for _ in range(2)]
    half = Fraction(1, 2)
    if motion == "random":
        return [eighths(rng, 8) for _ in group]
    if motion == "two":
        return [rng.choice(few) for _ in group]
    if motion == "few":
        slow = [RESTING, (half, 0), (-half, 0), (0, half), (0, -half)]
        return [rng.choice(slow) for _ in group]
    if motion == "around":
        return [across(rng, disk.direction, few[0]) for disk in group]
    velocities = [RESTING if is_at_container else few[0]] * len(group)
    if motion == "one":
        velocities[rng.randrange(len(group))] = eighths(rng, 8)
    return velocities


def eighths(rng, most):
    return Fraction(rng.randint(-most, most), 8), Fraction(rng.randint(-most, most), 8)


def across(rng, direction, drift):
    """A drift, and some velocity across the direction from the circle's centre, seldom along it.

    Where nothing moves along it, the contact is of an even order.
    """
    x, y = direction
    turning = rng.choice([0, 0, Fraction(1, 2), Fraction(-1, 2), 1])
    growing = rng.choice([0, 0, 0, Fraction(1, 2), Fraction(-1, 2)])
    return drift[0] - turning * y + growing * x, drift[1] + turning * x + growing * y
