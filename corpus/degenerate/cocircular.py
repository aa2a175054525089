"""Polygons of disks with one common tangent circle, at an instant and over intervals."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.geometry import ring
from degenerate.scene import disk, scene
from degenerate.wrong import (drops_tied_flip, enlarges_smallest, of_scene, reversed_tie, dropped)


def moved_a_little(kind):
    def change(s):
        s.disks[-1].x += F(1, 10**9)
    return of_scene("input-moved", kind, change)


def closing(k, offsets, radius=lambda i: F(1, 4), digits=12, r=4, spread=F(1, 16), t=2):
    """k disks that all touch the circle of radius r about the centre from outside at t, and are
    offsets[i] * spread further out a unit of time later."""
    return [disk((r + radius(i) - t * a * spread) * x, (r + radius(i) - t * a * spread) * y, radius(i),
                 a * spread * x, a * spread * y)
            for i, ((x, y), a) in enumerate(zip(ring(k, digits=digits), offsets))]


def scattered(k):
    return [(7 * i * i + 3 * i) % 11 - 5 for i in range(k)]


@family("cocircular-instant", "k-gons with a common tangent circle at one instant, k = 4 to 64")
def instants():
    numbers = {4: "Two", 5: "Three", 6: "Four", 7: "Five", 8: "Six"}
    for k in (4, 5, 6, 7, 8, 12, 16, 24, 32):
        t, end = (2, 4) if k < 16 else (F(1, 4), F(1, 2))
        yield Case(
            f"points-{k:02}", f"""{k} equal disks move along radii with different constant speeds so that at t = {t} all
            {k} touch the circle of radius 4 about the centre, and at no other time more than three
            of them do near that time. {numbers.get(k, k - 2)} vertices meet in one point and come apart in another way: the triangulation of
            the {k}-gon before and the one after share no more diagonals than chance wants. Between
            them leads a sequence of flips at one instant, in which each must be possible when it is made. An
            engine that treats the {k * (k - 1) * (k - 2) * (k - 3) // 24} quadruples pairwise, or moves on by an epsilon after each, ends in a
            diagram that is none.""",
            scene(10, end, closing(k, scattered(k), digits=12 if k < 24 else 30, t=t)), [0, t, end],
            [f"k{k}", "instant", "equal-radii"],
            [drops_tied_flip(), reversed_tie()] if k > 4 else [dropped("flip")], picture=1)
    for k in (6, 12):
        yield Case(
            f"unequal-{k:02}", f"""As with points-{k:02}, but all radii differ: the {k} disks have one common tangent circle at t = 2 while
            their centres are on no circle. Tests of cocircularity of centres, of equal distances or of equal
            radii see nothing special.""",
            scene(12, 4, closing(k, scattered(k), lambda i: F(1 + i % 7, 8))), [0, 2, 4],
            [f"k{k}", "instant", "unequal-radii"], [drops_tied_flip()], picture=1)
    for k in (4, 8, 16):
        yield Case(
            f"star-{k:02}", f"""{k} equal disks; every other one moves outwards, the rest inwards, all at one speed, and all are on one circle
            at t = 2. Before and after, the disks of either kind are cocircular among themselves for ever: a
            permanently cotangent {k // 2}-gon inside, resolved by the rule of the largest id, turns into another one at
            an instant at which all {k} are cotangent. The order of the flips is decided by signs just after
            t = 2, where some are still zero.""",
            scene(10, 4, closing(k, [1 if i % 2 else -1 for i in range(k)], spread=F(1, 8))), [0, 2, 4],
            [f"k{k}", "instant", "permanent", "equal-radii"], [drops_tied_flip() if k > 4 else dropped("flip")], picture=1)
    k = 64
    yield Case(
        "points-64", """64 equal disks meet a common circle at t = 1/16: 62 vertices at one place and instant. The number of
        quadruples is 635,376, each of them cotangent; whoever
        looks at more than the edges of the diagram pays for that, and whoever orders them by rounded times flips edges that
        are not there.""",
        scene(10, F(1, 8), closing(k, scattered(k), lambda i: F(1, 16), 60, t=F(1, 16))), [F(1, 16)],
        ["k64", "instant", "equal-radii"], [drops_tied_flip()])


@family("cocircular-always", "k-gons with a common tangent circle over whole intervals")
def always():
    for k in (4, 5, 6, 8, 12, 16, 32):
        yield Case(
            f"rest-{k:02}", f"""{k} equal disks rest on a circle. All quadruples stay cotangent for ever, so which
            {k - 3} diagonals the diagram has is a convention: the disk with the largest id counts as infinitely little larger, then the next. All
            diagonals of the polygon therefore end in the disk with the largest id. The wrong variant enlarges the
            smallest id.""",
            scene(10, 3, [disk(4 * x, 4 * y, F(1, 4)) for x, y in ring(k, digits=24)]), [0],
            [f"k{k}", "permanent", "at-rest"], [enlarges_smallest(k), moved_a_little("wrong initial diagram")], events=(0, 0, 0))
    yield Case(
        "rest-64", """64 equal disks rest on a circle: 635,376 permanently cotangent quadruples, 61 diagonals, all in the
        disk with the largest id.
        An engine that looks for cotangent quadruples instead of edges does not end, and one that perturbs its input
        ends in one of the Catalan number of triangulations.""",
        scene(10, 1, [disk(4 * x, 4 * y, F(1, 16)) for x, y in ring(64, digits=60)]), [0],
        ["k64", "permanent", "at-rest"], [enlarges_smallest(64)], events=(0, 0, 0))
    yield Case(
        "translating-06", """A hexagon of equal disks, rational but not regular, glides along. Its flip polynomials vanish identically, though no
        coordinate is constant: in floating point their coefficients are rounding errors of either sign, whose roots are
        noise. There is no event at all.""",
        scene(20, 8, [disk(3 * x - 4, 3 * y, F(1, 2), 1, F(1, 2)) for x, y in ring(6)]), [0, 4, 8],
        ["k6", "permanent", "translating"], [enlarges_smallest(6)])
    yield Case(
        "growing-08", """An octagon of equal disks expands: velocities are proportional to the places. The centres stay on one circle
        that grows; all quadruples of degree 4 in t vanish identically.
        In doubles their coefficients are rounding errors, whose roots come as a burst of flips in some engines and
        never in others.""",
        scene(12, 4, [disk(3 * x, 3 * y, F(1, 4), x, y) for x, y in ring(8)]), [0, 2, 4],
        ["k8", "permanent", "expanding"], [enlarges_smallest(8)], events=(0, 0, 0))
    yield Case(
        "spinning-08", """An octagon of equal disks whose velocities are those of a rotation: straight motion turns and
        stretches it, and it stays cocircular exactly. An engine that steps in time sees it spiral out of
        its circle.""",
        scene(14, 4, [disk(4 * x, 4 * y, F(1, 4), -2 * y, 2 * x) for x, y in ring(8)]), [0, 2, 4],
        ["k8", "permanent", "spinning"], [enlarges_smallest(8)], events=(0, 0, 0))
    yield Case(
        "unequal-rest-07", """Seven disks of different radii rest against one circle from outside: permanently cotangent, while their centres are on
        no circle. Joggling the input, or testing centres for cocircularity, gives one of 42
        triangulations of the heptagon by chance.""",
        scene(10, 3, [disk((3 + F(1 + i, 8)) * x, (3 + F(1 + i, 8)) * y, F(1 + i, 8)) for i, (x, y) in enumerate(ring(7))]),
        [0], ["k7", "permanent", "at-rest", "unequal-radii"], [moved_a_little("wrong initial diagram")], events=(0, 0, 0))
    yield Case(
        "unequal-gliding-06", """Six disks of different radii with one common tangent circle and one common velocity. The cotangency
        polynomial of degree 8 is identically zero with all coefficients far from zero before cancellation.""",
        scene(20, 6, [disk((3 + F(1 + i % 3, 4)) * x - 3, (3 + F(1 + i % 3, 4)) * y, F(1 + i % 3, 4), 1, F(1, 3))
                      for i, (x, y) in enumerate(ring(6))]),
        [0, 3, 6], ["k6", "permanent", "translating", "unequal-radii"], [moved_a_little("wrong initial diagram")])
    yield Case(
        "two-rings", """Two concentric squares of equal disks at rest, the outer one twice the size: within each ring all is cotangent, and by
        symmetry so are pairs of inner with pairs of outer disks. Different classes of cotangency share edges.""",
        scene(10, 3, [disk(s * x, s * y, F(1, 2)) for s in (2, 4) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]),
        [0], ["k4", "permanent", "at-rest", "symmetric"], [enlarges_smallest(8)], events=(0, 0, 0))
    yield Case(
        "with-the-container", """Four disks of different sizes and the container have one common tangent circle for ever: the five
        generators touch it from outside, the container from without. The container has the smallest id and is never enlarged; an engine that treats it
        as a disk of radius -R with its own tie rule decides otherwise.""",
        scene(10, 3, [disk(5 + (3 + r) * x, (3 + r) * y, r) for (x, y), r in
                      zip(((F(-4, 5), F(3, 5)), (F(-3, 5), F(-4, 5)), (0, 1), (0, -1)),
                          (F(1, 2), F(3, 4), F(1, 4), F(1, 3)))], center=(-2, 0)),
        [0], ["k5", "permanent", "at-rest", "container"], [moved_a_little("wrong initial diagram")], events=(0, 0, 0))
    square = [disk(2 * x, 2 * y, F(1, 2)) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    yield Case(
        "begins-by-maneuver", """One corner of a square of equal disks arrives along its diagonal and is stopped by a maneuver at t = 2, exactly when the four become
        cocircular, and stays. The polynomial before has a simple root there, the one after is zero: the
        sign just after t = 2 is that of the rule of the largest id, and whether an edge flips follows from it.""",
        scene(10, 4, [*square[:3], disk(4, -4, F(1, 2), -1, 1)], maneuvers=[(2, 3, 0, 0)]), [0, 2, 4],
        ["k4", "permanent", "maneuver"], [of_scene("maneuver-lost", "wrong response", lambda s: s.maneuvers.__setitem__(0, (2, 3, -1, 1)))],
        picture=1)
    yield Case(
        "ends-by-maneuver", """A square of equal disks at rest; at t = 2 the disk with the smallest id leaves along the diagonal, outwards. Until then the diagonal is
        the convention's; from t = 2 on it is that of the geometry, which may ask for a flip at the very instant of the maneuver, although no
        polynomial had a root there before.""",
        scene(10, 4, square, maneuvers=[(2, 0, F(1, 2), F(1, 2))]), [0, 2, 4],
        ["k4", "permanent", "maneuver"], [dropped("maneuver", 0, "maneuver-lost")], picture=2)
    yield Case(
        "ends-by-maneuver-inwards", """As ends-by-maneuver, but the disk moves inwards at t = 2. Of these two cases one needs
        a flip at the instant of the maneuver and the other none.
        An engine that asks for a sign change of a polynomial finds neither a value before t = 2 nor, in the next piece
        of motion, a root.""",
        scene(10, 4, square, maneuvers=[(2, 0, F(-1, 2), F(-1, 2))]), [0, 2, 4],
        ["k4", "permanent", "maneuver"], [dropped("flip", 0)], picture=2)
    yield Case(
        "ends-by-collision", """A square of equal disks at rest is hit at t = 2 by a fifth, which sends a corner off along the diagonal. The collision ends
        a permanent cotangency; the flip that follows from it, if any, has the time of the collision.""",
        scene(12, 4, [*square, disk(6, 6, F(1, 2), F(-3, 2), F(-3, 2), )]), [0, 4],
        ["k4", "permanent", "collision"], [dropped("collide", 0, "contact-missed")])
    yield Case(
        "through-a-permanent-square", """A fifth equal disk flies through the middle of a resting square. Alone the square is
        permanently cotangent; while the visitor is inside there is no such quadruple in the
        diagram, and when it leaves, the diagonal of the convention must be restored, at instants at which five are
        involved.""",
        scene(12, 12, [*square, disk(-6, 0, F(1, 2), 1, 0)]), [0, 6, 12],
        ["k4", "permanent", "symmetric", "tie"], [drops_tied_flip()], picture=1)
