"""Symmetric scenes whose ties lie behind chains of collisions."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import drops_tied_collision

PROOF = "a proof of ties by symmetry"
# Three disks on the right of the vertical axis, with radii and velocities that make their collisions generic.
HALF = ((F(5, 2), 1, F(1, 2), F(1, 2), F(1, 4)), (5, -2, F(3, 4), F(-1, 2), F(1, 3)), (4, 4, 1, F(-1, 4), F(-3, 4)))


def mirrored(part=HALF):
    return ([disk(x, y, r, vx, vy) for x, y, r, vx, vy in part]
            + [disk(-x, y, r, -vx, vy) for x, y, r, vx, vy in part])


def half_turn(part=HALF):
    return ([disk(x, y, r, vx, vy) for x, y, r, vx, vy in part]
            + [disk(-x, -y, r, -vx, -vy) for x, y, r, vx, vy in part])


QUARTER = ((3, F(5, 2), F(5, 4), 1, F(-1, 2)), (6, -1, 1, -1, F(2, 3)))


def quarter_turns(part=QUARTER):
    disks = []
    for c, s in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        disks += [disk(c * x - s * y, s * x + c * y, r, c * vx - s * vy, s * vx + c * vy) for x, y, r, vx, vy in part]
    return disks


# When the k-th collision on one side has happened and the next has not.
MIRROR_HORIZONS = (2, 3, 4, 5, 7, 8, 10, 13, 17, 19, 25, 33)
HALF_TURN_HORIZONS = (2, 3, 6, 10, 12, 15, 19, 21)
QUARTER_TURN_HORIZONS = (2, 5, 8, 11)


@family("symmetry", "mirror and rotational symmetry: ties behind 1 to 12 collisions")
def symmetry():
    for k, horizon in enumerate(MIRROR_HORIZONS, 1):
        yield Case(
            f"mirror-{k:02}", f"""Three disks and their mirror images in the vertical axis. Every event on one side happens on the other at the same instant, and on the axis disks meet their own
            images. The horizon lies after {k} collision{"s" if k > 1 else ""} on a side: the ties that follow it have times in towers of up to {k}
            square roots, which differ by nothing and which no precision can tell to be equal. Only the symmetry proves it.""",
            scene(8, horizon, mirrored()), [0, horizon], ["mirror", "tie", "collision", f"depth-{k}"],
            [drops_tied_collision()], truths=("exact",), awaits=PROOF)
    for k, horizon in enumerate(HALF_TURN_HORIZONS, 1):
        yield Case(
            f"half-turn-{k:02}", f"""Three disks and their images under a half turn about the centre, until after {k} collision{"s" if k > 1 else ""} on a side. Events come in pairs at one instant;
            the two sides meet in the middle with opposite velocities.""",
            scene(8, horizon, half_turn()), [0, horizon], ["rotation", "tie", "collision", f"depth-{k}"],
            [drops_tied_collision()], truths=("exact",), awaits=PROOF)
    for k, horizon in enumerate(QUARTER_TURN_HORIZONS, 1):
        yield Case(
            f"quarter-turn-{k:02}", f"""Two disks and their images under quarter turns about the centre, until after {k} collision{"s" if k > 1 else ""} of each: events come by fours at one instant.""",
            scene(8, horizon, quarter_turns()), [0, horizon], ["rotation", "tie", "collision", f"depth-{k}"],
            [drops_tied_collision()], truths=("exact",), awaits=PROOF)
