"""Symmetric scenes whose ties lie behind chains of collisions."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import drops_tied_collision

# Isometries that fix the centre: (x, y) -> (a x + b y, c x + d y) as (a, b, c, d).
IDENTITY, HALF, LEFT, RIGHT = (1, 0, 0, 1), (-1, 0, 0, -1), (0, -1, 1, 0), (0, 1, -1, 0)
ACROSS, UPSIDE_DOWN, DIAGONAL, ANTIDIAGONAL = (-1, 0, 0, 1), (1, 0, 0, -1), (0, 1, 1, 0), (0, -1, -1, 0)
MIRROR = (IDENTITY, ACROSS)
HALF_TURN = (IDENTITY, HALF)
QUARTER_TURNS = (IDENTITY, LEFT, HALF, RIGHT)
SQUARE = (*QUARTER_TURNS, ACROSS, UPSIDE_DOWN, DIAGONAL, ANTIDIAGONAL)


def images(group, part):
    """The disks of a part (x, y, radius, velocity) with their images under a group."""
    return [disk(a * x + b * y, c * x + d * y, r, a * vx + b * vy, c * vx + d * vy)
            for a, b, c, d in group for x, y, r, vx, vy in part]


# Radii and velocities that make the collisions of a part generic.
THREE = ((F(5, 2), 1, F(1, 2), F(1, 2), F(1, 4)), (5, -2, F(3, 4), F(-1, 2), F(1, 3)), (4, 4, 1, F(-1, 4), F(-3, 4)))
TWO = ((F(5, 2), F(11, 4), F(5, 4), F(1, 4), F(1, 9)), (F(21, 4), F(19, 4), F(1, 2), F(-1, 2), 1))
ONE = ((F(9, 2), F(5, 4), F(5, 4), F(-3, 4), 1),)

# The k-th lies between the k-th instant of collisions and the next.
MIRROR_HORIZONS = (2, 3, 4, 5, 7, 8, 10, 12, 14, 16, 18, 19)
HALF_TURN_HORIZONS = (2, 3, 6, 10, 12, 15, F(339, 20), F(86, 5), 19, 22, 24, 26)
QUARTER_TURN_HORIZONS = (2, 7, F(35, 4), 12, 16, 20, 23, 25, 27, 28, F(147, 5), 30)
SQUARE_HORIZONS = (1, 3, 5, F(11, 2), F(13, 2), 8)


def until(name, story, group, part, horizons, tags, deepest=4):
    """A case for each horizon. Diagrams are expected up to the depth `deepest`: further on they cannot be
    constructed from scratch, where no symmetry is known and the field is of degree 32."""
    for k, horizon in enumerate(horizons, 1):
        behind = ("the first instant of collisions" if k == 1 else f"{k} instants of collisions one behind the other")
        field = ("The states that come of it have one square root." if k == 1 else
                 f"The states that come of it can have towers of up to {k} square roots, degree {2**k}: numbers in them that are equal differ "
                 "by nothing at any precision, and only the symmetry of their pasts proves it.")
        yield Case(f"{name}-{k:02}", f"{story} The horizon lies behind {behind}. {field}", scene(8, horizon, images(group, part)),
                   [0, horizons[min(k, deepest) - 1]], [*tags, "tie", "collision", f"depth-{k}"],
                   [drops_tied_collision(-1)], truths=("exact",), picture=1)


@family("symmetry", "mirror, half-turn, quarter-turn and square symmetry: ties behind 1 to 12 instants of collisions")
def symmetry():
    yield from until(
        "mirror", """Three disks and their mirror images in the vertical axis. What happens on one side happens on the other at
        the same instant, disks meet their own images on the axis, and two pairs of images have a common circle as long as they
        live, whatever they hit. An engine that compares rounded times orders the two sides by noise.""",
        MIRROR, THREE, MIRROR_HORIZONS, ["mirror"])
    yield from until(
        "half-turn", """Three disks and their images under a half turn about the centre. Events come in pairs at one instant, and the two
        sides meet in the middle with opposite velocities. Unlike mirror images, two pairs are cotangent by
        chance only: it is times that tie, not circles.""",
        HALF_TURN, THREE, HALF_TURN_HORIZONS, ["rotation"])
    yield from until(
        "quarter-turn", """Two disks and their images under quarter turns about the centre. Events come by fours at one instant, and the four images
        of a disk stay on one circle about the centre for ever: in the middle of the diagram a diagonal is the convention's all the time,
        through all collisions, where an engine in doubles sees it flip to and fro.""",
        QUARTER_TURNS, TWO, QUARTER_TURN_HORIZONS, ["rotation", "permanent"])
    yield from until(
        "square", """One disk and its images under all symmetries of a square, eight in all. Collisions happen on the four axes, by fours, and bounces off
        the wall by eights; all eight stay on one circle about the centre, the corners of an octagon that is not regular and
        whose diagonals are the convention's from beginning to end.""",
        SQUARE, ONE, SQUARE_HORIZONS, ["mirror", "rotation", "permanent"], deepest=3)
    yield Case(
        "quarter-turn-ring", """Two disks and their images under quarter turns, of which four meet in a ring about the centre at t = 7.47, behind six
        instants of collisions: four contacts at one instant, each sharing a disk with the next. The law takes them one after the other by
        number; but neighbours in the ring are at right angles, so the order makes no difference, and the symmetry goes on.""",
        scene(8, 8, images(QUARTER_TURNS, ((3, F(5, 2), F(5, 4), 1, F(-1, 2)), (6, -1, 1, -1, F(2, 3))))), [0, 2],
        ["rotation", "tie", "collision", "shared-disk"], [drops_tied_collision()], truths=("exact",))
