"""Roots that are close, roots that are multiple, radii that are nearly equal, clocks that are late."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import (dropped, drops_pair, drops_tied_flip, inserted_flip, late, noise, of_scene)


CORNERS = ((1, 1), (-1, 1), (-1, -1), (1, -1))


def square_closing(x, t, r=F(1, 4), half=1, v=F(1, 4), s=1):
    """Three corners of a square about (x, 0) at rest and a fourth, on the side s = 1 or -1, that comes
    in along the diagonal with the speed (v, v) and makes it a square at t."""
    return [*[disk(x + a * half, b * half, r) for a, b in CORNERS if (a, b) != (s, 1)],
            disk(x + s * (half + v * t), half + v * t, r, -s * v, -v)]


@family("close-roots", "two flips, or two roots of one edge, nearer than 10^-4, 10^-12 and 10^-40")
def close_roots():
    for e in (4, 6, 9, 12, 15, 40):
        gap = F(1, 10**e)
        yield Case(
            f"two-edges-1e-{e:02}", f"""Two squares of equal disks, mirror images of each other but for a start 10^-{e} nearer on the right: each is closed by its
            moving corner, the right one at t = 2 - 4 * 10^-{e}, the left one at t = 2. {"Both times are the same binary64, and still the first flip is the right one's: order is a matter of exact comparison." if e > 15 else "The two flips are independent; an engine that merges roots nearer than a tolerance makes one of them."}""",
            scene(10, 4, [*square_closing(-5, F(2), s=-1), *square_closing(5, 2 - 4 * gap)]), [0, 2 - 2 * gap, 2],
            ["near-tie", "equal-radii", *(["one-time-two-instants"] if e > 15 else [])],
            [dropped("flip", 0, "near-roots-merged")])
    for e in (4, 6, 12, 40):
        gap = F(1, 10**e)
        depth = gap * gap / 8
        sc = scene(10, 8, [disk(-2, 0, F(1, 4)), disk(0, -2, F(1, 4)), disk(2, 0, F(1, 4)),
                           disk(-4, 2 - depth, F(1, 4), 1, 0)])
        yield Case(
            f"one-edge-1e-{e:02}", f"""A disk crosses the circle through three equal disks at rest so flatly that it is inside for {"about "}1.4 * 10^-{e} only: the edge flips and flips
            back. The polynomial dips below zero by less than 10^-{2 * e - 1}; sampled anywhere else it has no root at all. {"Both times round to t = 4." if e > 15 else ""}""",
            sc, [0, 4, 8] if e < 15 else [0, 8],
            ["near-double-root", "equal-radii", *(["one-time-two-instants"] if e > 15 else [])], [drops_pair()],
            picture=1 if e < 15 else 0)
        yield Case(
            f"no-root-1e-{e:02}", f"""The counterpart of one-edge-1e-{e:02}: the disk passes outside the circle by 10^-{2 * e}/8. The polynomial comes as near to zero and does not
            reach it. No event at t = 4.
        Together the two cases leave no tolerance that is right for both: what is a root there is none here.""",
            scene(10, 8, [disk(-2, 0, F(1, 4)), disk(0, -2, F(1, 4)), disk(2, 0, F(1, 4)), disk(-4, 2 + depth, F(1, 4), 1, 0)]),
            [0, 4, 8], ["near-double-root", "equal-radii", "no-event"], [inserted_flip(4, [0, 2, 1, 3], "even-root-there-and-back", back=True)],
            picture=1)
    for e in (12, 40):
        gap = F(1, 10**e)
        yield Case(
            f"flip-before-collision-1e-{e}", f"""A square closes at t = 2; 10^-{e} later its moving corner is hit from behind by a faster disk. The flip uses velocities that hold
            for 10^-{e} more.
        If the two are merged to one instant the flip is judged with the velocity after the blow, and gone.""",
            scene(10, 4, [*square_closing(0, F(2)), disk(F(3, 2) + F(5, 2) * F(3, 4) + F(3, 4) * gap, F(5, 2) * F(3, 4) + F(3, 2) + F(3, 4) * gap, F(1, 4), -1, -1)]),
            [0, 4], ["near-tie"], [dropped("flip", 0)])


def equal(s):
    for d in s.disks:
        d.r = F(1)


def nearly(e, base=F(1)):
    return base + F(1, 10**e)


@family("close-radii", "radii that differ by 10^-4 to 10^-15")
def close_radii():
    for e in (4, 6, 8, 10, 12, 15):
        eps = F(1, 10**e)
        yield Case(
            f"square-rest-1e-{e:02}", f"""Four disks rest on the corners of a square; the one with the smallest id is larger by 10^-{e}. The four are not cotangent: the diagonal belongs to the
            larger disk. An engine that takes the radii for equal resolves a tie that is none, by the largest id, the other way.""",
            scene(10, 2, [disk(3 * a, 3 * b, nearly(e) if k == 0 else 1) for k, (a, b) in enumerate(CORNERS)]), [0],
            ["equal-radii", "at-rest", "near-tie"], [of_scene("radii-taken-for-equal", "wrong initial diagram", equal)], events=(0, 0, 0))
        yield Case(
            f"slow-corner-1e-{e:02}", f"""Three disks of radius 1 and one of radius 1 + 10^-{e}, which creeps in along the diagonal with speed 10^-{e}: the four are
            cotangent at t = 3. With four equal radii they would be so at t = 4 only. The cotangency polynomial has coefficients
            from 1 to 10^-{4 * e}, and nearly a factor that vanishes for equal radii.""",
            scene(12, 6, [disk(5, 0, 1), disk(-3, 4, 1), disk(-3, -4, 1),
                          disk(F(3, 5) * (5 + 4 * eps), F(4, 5) * (5 + 4 * eps), nearly(e), -F(3, 5) * eps, -F(4, 5) * eps)]),
            [0, 3, F(7, 2), 6], ["equal-radii", "near-tie"], [of_scene("radii-taken-for-equal", "wrong time", equal)], picture=1)
    yield Case(
        "four-radii-1e-15", """Four radii that differ by multiples of 10^-15 in a square lattice cell which a common velocity carries along. The cotangency polynomial is a
        constant computed from coefficients that all but cancel; the diagonal is that of the two disks whose radii have the larger sum.""",
        scene(16, 4, [disk(3 * a - 3, 3 * b, 1 + F(k, 10**15), 1, 0) for k, (a, b) in zip((5, 1, 3, 0), CORNERS)]), [0, 4],
        ["equal-radii", "near-tie", "translating"],
        [of_scene("radii-taken-for-equal", "wrong initial diagram", equal)])
    yield Case(
        "equal-but-one-2x2", """Three radii 1 and one 1 - 10^-15 on a shearing square: the flip at the moment of the square is 10^-15 early or late, at a time
        that no binary64 separates from the square's.""",
        scene(12, 8, [disk(-2, -2, 1, 0, 0), disk(2, -2, 1, 0, 0), disk(-4, 2, 1, F(1, 2), 0), disk(0, 2, 1 - F(1, 10**15), F(1, 2), 0)]),
        [0, 4, 8], ["equal-radii", "near-tie", "shear"], [dropped("flip", 0)], picture=1)


def by_time(t, *disks):
    """Disks whose places are given for time t."""
    return [disk(d.x - t * d.vx, d.y - t * d.vy, d.r, d.vx, d.vy, d.mass) for d in disks]


def order_of(velocities, scale=F(1, 16)):
    return by_time(2, *[disk(2 * a, 2 * b, F(1, 4), scale * vx, scale * vy)
                        for (a, b), (vx, vy) in zip(CORNERS, velocities)])


def unlike(growth):
    """Four different disks that touch one circle of radius 39/10 about the centre at t = 2, with tangential
    speeds w such that the sum of w^2/distance, with alternating signs, vanishes."""
    axes = ((1, 0), (0, 1), (-1, 0), (0, -1))
    return by_time(2, *[disk(d * x, d * y, d - F(39, 10), F(growth * x - w * y, 80), F(growth * y + w * x, 80))
                        for (x, y), d, w in zip(axes, (9, 4, 9, 16), (21, 10, 3, 20))])


@family("multiple-roots", "double, triple and quadruple roots of flip polynomials")
def multiple_roots():
    three = [disk(-2, 0, F(1, 4)), disk(0, -2, F(1, 4)), disk(2, 0, F(1, 4))]
    taken = inserted_flip(4, [0, 2, 1, 3], "even-root-taken")
    back = inserted_flip(4, [0, 2, 1, 3], "even-root-there-and-back", back=True)
    yield Case(
        "double-equal-radii", """A disk glides along the tangent of the circle through three equal disks at rest and touches it at t = 4: the in-circle function has a double root
        and no sign change, and so nothing flips. For four equal radii the cotangency polynomial f is a square anyway: here it has a root of order 4,
        at a simple flip one of order 2. The order of a root of f says nothing by itself.""",
        scene(10, 8, [*three, disk(-4, 2, F(1, 4), 1, 0)]), [0, 4, 8], ["even-root", "equal-radii", "no-event"], [taken, back], picture=1)
    yield Case(
        "double-unequal-radii", """As double-equal-radii, but the passing disk is larger and touches the common tangent circle of the three
        at t = 4 from outside: a double root of f proper, with no sign change.
        To flip at every root of f is wrong here, to flip at its sign changes alone is wrong for equal radii: what
        counts is the sign of both in-circle functions.""",
        scene(10, 8, [*three, disk(-4, F(11, 4), 1, 1, 0)]), [0, 4, 8], ["even-root", "unequal-radii", "no-event"], [taken, back], picture=1)
    yield Case(
        "double-at-the-start", """The double root lies at t = 0: the four are cotangent at the start and separate to the same side in past and future. The initial diagram is that for 0+, and no
        flip has time 0.
        Whoever constructs the diagram at 0 and not at 0+ has zero for the sign and may begin with either diagonal, one
        of which is never mended.""",
        scene(10, 4, [*three, disk(0, 2, F(1, 4), 1, 0)]), [0, 4], ["even-root", "equal-radii", "start"],
        [inserted_flip(0, [0, 2, 1, 3], "even-root-taken")])
    yield Case(
        "simple-at-the-start", """The four disks are cotangent at t = 0 exactly and the sign changes there: the flip is not an event of [0, horizon], because the header's diagram
        is that for 0+ already. An engine that writes a flip at time 0 flips twice.""",
        scene(10, 4, [*three, disk(0, 2, F(1, 4), 0, -F(1, 4))]), [0, 4], ["equal-radii", "start"],
        [inserted_flip(0, [1, 3, 0, 2], "even-root-taken", "wrong quadruple")])
    yield Case(
        "simple-at-the-horizon", """The four become cotangent at the horizon exactly. The horizon belongs to the history, and the diagram there is that just after: the flip is
        claimed at the last instant.
        Half-open intervals lose it, and the last diagram with it.""",
        scene(10, 2, square_closing(0, F(2))), [0, 2], ["equal-radii", "horizon"], [dropped("flip", 0)])
    yield Case(
        "double-at-the-horizon", """A double root at the horizon: no flip, but whoever decides by the sign at the horizon has zero there, and the edge that is correct just after has to be
        found from the second derivative.""",
        scene(10, 4, [*three, disk(-4, 2, F(1, 4), 1, 0)]), [0, 4], ["equal-radii", "horizon", "even-root", "no-event"], [taken])
    triples = {"a": [(-2, 3), (-3, 0), (1, -2), (2, 3)], "b": [(-1, 3), (3, 3), (-1, -1), (1, -3)],
               "c": [(2, 2), (3, 3), (1, 3), (2, 2)]}
    for name, v in triples.items():
        yield Case(
            f"triple-equal-radii-{name}", """Four equal disks whose in-circle polynomial is a multiple of (t - 2)^3, up to higher powers: value, velocity and acceleration vanish together, and
            still the sign changes. One flip. Newton's method converges slowly, deflation of one root leaves a double one, and
            a test of the first derivative sees no crossing.""",
            scene(10, 4, order_of(v)), [0, 2, 4], ["odd-root", "triple-root", "equal-radii"], [dropped("flip", 0), late(0, F(1, 10**4))], picture=1)
    fourfold = {"a": [(-1, 2), (1, -1), (2, 2), (2, 3)], "b": [(-2, 2), (-3, 1), (-2, -3), (1, 0)]}
    for name, v in fourfold.items():
        yield Case(
            f"quadruple-equal-radii-{name}", """Four equal disks whose in-circle polynomial is a multiple of (t - 2)^4: the edge comes to length zero with three derivatives and turns
            back. No flip at t = 2.
        In doubles the value is below rounding error for a while before and after, and its sign there is chance.""",
            scene(10, 4, order_of(v)), [0, 2, 4], ["even-root", "quadruple-root", "equal-radii", "no-event"], [noise(2)], picture=1)
    yield Case(
        "triple-unequal-radii", """Four different disks pass the corners of a common tangent circle that grows: radial speeds are equal and the
        tangential ones are such that the second derivative of the in-circle function vanishes at t = 2 as well. f, of degree 8, is
        (t - 2)^3 times what has no root there. One flip, at an instant about which f is below rounding error for long, and at which the
        derivative says nothing about its direction.""",
        scene(36, 4, unlike(10)), [0, 2, 4], ["odd-root", "triple-root", "unequal-radii"], [dropped("flip", 0)], picture=1)
    yield Case(
        "triple-unequal-radii-spinning", """As triple-unequal-radii without the growth: four different disks move along the tangents of their places, each at its own speed,
        and all are nearest to the common circle at t = 2, so that each alone would come and go. Together they have a triple root and
        one flip. To conclude from the distances, which are all even about t = 2, that the root is even is wrong: the angles are not.""",
        scene(36, 4, unlike(0)), [0, 2, 4], ["odd-root", "triple-root", "unequal-radii"], [dropped("flip", 0)], picture=1)
    yield Case(
        "double-beside-simple", """At t = 4 one square is closed with a sign change and its mirror image is touched and left: of two quadruples that become cocircular at one instant one flips and
        one does not. A tie that is resolved by flipping all is wrong, and so is one resolved by flipping the first.""",
        scene(14, 8, [*[disk(d.x - 5, d.y, d.r) for d in three], disk(-9, 2, F(1, 4), 1, 0),
                      *[disk(d.x + 5, d.y, d.r) for d in three], disk(5, 4, F(1, 4), 0, F(-1, 2))]), [0, 4, 6],
        ["even-root", "tie", "equal-radii"], [dropped("flip", 0, "tie-drops-flip", "missing event")], picture=1)


@family("late-clocks", "events near t = 10^6, where a binary64 knows time to 10^-10")
def late_clocks():
    million = 10**6
    yield Case(
        "flip", """A square of disks is closed at t = 10^6 by a corner that creeps along the diagonal. In absolute time the polynomial has coefficients from 1 to 10^-24,
        and values near its root lose twenty digits; with time shifted to the present it is as harmless as any.""",
        scene(10, million + 10, square_closing(0, F(million), v=F(1, million))), [0, million, million + 10],
        ["late", "equal-radii"], [dropped("flip", 0), late(0, F(1, 10**4))])
    yield Case(
        "two-flips-within-an-ulp", """Two flips near t = 10^6, 10^-12 apart: their times are the same binary64, since neighbouring binary64 are 10^-10 apart there. The
        right square's flip comes first.
        An engine with absolute times sees one instant and orders the two by ids, or by the order in its queue.""",
        scene(10, million + 10, [*square_closing(-5, F(million), v=F(1, million), s=-1),
                                 *square_closing(5, million - F(1, 10**12), v=F(1, million))]),
        [million - F(1, 2 * 10**12), million], ["late", "near-tie", "equal-radii", "one-time-two-instants"],
        [dropped("flip", 0, "near-roots-merged")])
    yield Case(
        "tie", """Two mirror-symmetric flips at t = 10^6 exactly. Their computed times differ by some 10^-10 of rounding, in either direction: which one is first, and
        whether they are one instant, cannot be told from them.""",
        scene(10, million + 10, [*square_closing(-5, F(million), v=F(1, million), s=-1), *square_closing(5, F(million), v=F(1, million))]),
        [million], ["late", "tie", "mirror", "equal-radii"], [drops_tied_flip()])
    yield Case(
        "collision-from-afar", """A disk flies for 10^6 units of time before it meets another, in a container of radius 2 * 10^6. The contact is off centre by 3/5 of the reach, so its
        time is rational, 10^6.""",
        scene(2 * million, million + 10, [disk(F(-4, 1) - million, 3, 2, 1, 0), disk(0, 0, 3), disk(20, 0, 1)]),
        [million, million + 10], ["late", "scales"], [late(0, F(1, 10**5), "collide"), dropped("collide", 0, "contact-missed")])
    yield Case(
        "graze-from-afar", """A disk grazes another at t = 10^6, tangentially and exactly. An error of one ulp of its position makes the
        contact a collision or a miss.""",
        scene(2 * million, million + 10, [disk(-million, 2, 1, 1, 0), disk(0, 0, 1), disk(20, 0, 1)]),
        [million], ["late", "grazing", "even-root"], [noise(1000)])
    yield Case(
        "late-maneuver-cancels", """A square would be closed at t = 10^6; a maneuver stops its corner one binary64 before, 2^-33 units of time.
        The claimed times differ by the last bit. An engine that rounds the flip's time down, or has an epsilon for
        ties, flips the edge before the maneuver comes.""",
        scene(10, million + 10, square_closing(0, F(million), v=F(1, million)), maneuvers=[(million - F(1, 2**33), 3, 0, 0)]),
        [million], ["late", "maneuver", "near-tie"], [of_scene("maneuver-lost", "missing event", lambda s: s.maneuvers.clear())], events=(0, 0, 1))


@family("wide-scales", "sizes and speeds from 10^-6 to 10^6 in one scene, or far from 1")
def wide_scales():
    yield Case(
        "radii", """Radii 10^-6, 10^-3, 1, 10^3 and 10^6 side by side in a container of radius 4 * 10^6. Differences of squared radii have 24 digits;
        the cell of the smallest is smaller than an ulp of the largest coordinate.""",
        scene(4 * 10**6, 3000, [disk(-10**6 - 2, 0, 10**6), disk(1500, 3000, 1000, 0, -1), disk(5, 0, 1, 0, F(1, 100)),
                                disk(0, 0, F(1, 1000), F(1, 1000), 0), disk(0, 1, F(1, 10**6), 0, F(1, 1000))]),
        [0, 1000, 3000], ["scales"], [dropped("flip", 0), dropped("flip", 1, "stops-early")], events=(2, 0, 0))
    yield Case(
        "speeds", """Speeds 10^-6, 1 and 10^6: the fastest disk crosses the container while the slowest moves by an atom's width, and passes between two resting ones
        within a microsecond.
        Steps of time that suit one of the speeds are useless for the others, and the sum of a large and a small
        velocity loses the small.""",
        scene(1000, F(1, 1000), [disk(-900, 0, 1, 10**6, 0), disk(0, 5, 1), disk(0, -5, 1, F(1, 10**6), 0), disk(50, 20, 3, 1, 0)]),
        [0, F(9, 10000), F(1, 1000)], ["scales"], [dropped("flip", 0)])
    yield Case(
        "tiny-in-the-gap", """A disk of radius 10^-6 lies between two disks of radius 10^6 that leave a gap of 10^-5, and runs through it
        from end to end of its cell's life.
        Circles that touch it have radii of 10^-6 beside 10^6; differences of coordinates of the large disks have few
        correct digits for them.""",
        scene(3 * 10**6, 4, [disk(-10**6 - F(5, 10**6), 0, 10**6), disk(10**6 + F(5, 10**6), 0, 10**6),
                             disk(0, 3, F(1, 10**6), 0, -1), disk(F(2, 10**6), -1, F(1, 10**6), 0, F(1, 2))]),
        [0, 4], ["scales", "two-edge-cell"], [dropped("flip", 0)])
    yield Case(
        "far-from-the-origin", """The whole scene lies 10^6 from the origin of coordinates, with sizes of 1 and a square that is closed at t = 2. Squares of coordinates cost twelve digits to those who
        form them before differences.""",
        scene(10, 4, [disk(d.x + 10**6, d.y - 10**6, d.r, d.vx, d.vy) for d in square_closing(0, F(2))], center=(10**6, -10**6)),
        [0, 2, 4], ["scales", "equal-radii"], [dropped("flip", 0)])
    yield Case(
        "tie-across-scales", """Two squares of disks, one a millionth of the size of the other, are closed at the same instant t = 2.
        Their polynomials differ by 24 orders of magnitude. A tolerance that is relative to the scene makes the small
        square always cotangent; an absolute one fits neither.""",
        scene(100, 4, [*square_closing(-50, F(2), r=4, half=10, v=F(5, 2)),
                       *[disk(d.x / 10**6 + 50, d.y / 10**6, d.r / 10**6, d.vx / 10**6, d.vy / 10**6) for d in square_closing(0, F(2), r=F(1, 4))]]),
        [0, 2, 4], ["scales", "tie", "equal-radii"], [drops_tied_flip()])
    for name, power in (("lengths-of-10-to-60", 60), ("lengths-of-10-to-minus-60", -60)):
        unit = F(10) ** power
        yield Case(
            name, f"""Six disks that pass each other in a scene whose lengths are all of the order 10^{power}, within the range of binary64.
            The flip polynomial has degree eight in the lengths and leaves that range: its coefficients become infinite, not a number, or zero,
            and a comparison with one of these is false whichever way it is written.""",
            scene(20 * unit, 12, [disk(*(x * unit for x in d)) for d in (
                (-10, 1, 1, 2, 0), (9, 0, 2, -1, 0), (0, 9, 1, 0, -1), (1, -11, 3, 0, 1), (-8, -8, F(3, 2), 1, F(3, 2)), (7, 8, F(1, 2), -1, -1))]),
            [0, 6, 12], ["scales"], [dropped("flip", 0), dropped("flip", -1, "stops-early")])
