"""Trapped chains, shadows, maneuvers at the instant of events, ties of different kinds, resting and
pointlike disks, inelastic collapse."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.configurations import jaws, tall_jaws, tiny
from degenerate.roots import CORNERS, square_closing
from degenerate.scene import disk, scene
from degenerate.wrong import (dropped, drops_tied_collision, drops_tied_flip, enlarges_smallest, inserted_flip,
                              inserted_hit, noise, of_scene, other_initial, wrong_velocity)


@family("trapped-chains", "chains of tiny disks trapped between large ones")
def trapped_chains():
    for n in (2, 3, 4, 6, 8):
        yield Case(
            f"column-at-rest-{n}", f"""{n} equal tiny disks stand one above the other exactly in the middle between two large ones, at rest. Each edge between a tiny disk and a jaw has its
            mirror image with the same times, names and lengths; which of the connecting edges exist depends on the distances alone. Triples such as (left, right, tiny) occur in both
            orientations {n} times over.""",
            scene(30, 2, tall_jaws(*[tiny(0, F(2 * i + 1 - n), r=F(1, 4)) for i in range(n)])), [0],
            ["trapped", "mirror", "at-rest", "configuration-X"], [noise(1)], events=(0, 0, 0))
        yield Case(
            f"row-falls-in-{n}", f"""{n} equal tiny disks fall one behind the other through the gap of two large ones, on the axis of symmetry, at one speed. The column is rigid, and mirror
            images touch its circles left and right all the time; only two edges flip, that of the last disk with the container when it is in, and that of
            the first when it is out. The {n - 1} quadruples of two neighbours and the jaws are never cotangent, by symmetry alone: in doubles
            their determinants are differences of equal numbers.""",
            scene(30, 16, tall_jaws(*[tiny(0, F(i + 8), 0, -1, r=F(1, 4)) for i in range(n)])), [0, 8, 16],
            ["trapped", "mirror"], [dropped("flip", 0), dropped("flip", 1, "stops-early")], events=(2, 0, 0))
    for n in (3, 5):
        yield Case(
            f"nested-{n}", f"""{n} tiny disks of falling size lie one behind the other on the axis from the right jaw outwards, all centres on one line, so that cells with two edges are nested: each
            edge pair of Configuration I has one common root. The largest moves up and frees them.""",
            scene(20, 2, jaws(*[tiny(F(7, 4) - F(k, 2), 0, 0, F(1, 2) if k == n - 1 else 0, F(1, 4) - F(k, 64)) for k in range(n)])),
            [0, 1, 2], ["trapped", "configuration-I", "collinear"], [dropped("flip", 0)])
    yield Case(
        "points", """Four points, radius zero, stand in the gap of two large disks on the axis of symmetry, and one of them moves through the column's line sideways.
        Points have no default mass and cells like the others'.""",
        scene(20, 3, jaws(*[tiny(0, F(i) - F(3, 2), r=0) for i in range(4)], tiny(-1, F(1, 4), F(1, 2), 0, r=0))), [0, 1, 3],
        ["trapped", "point", "mirror"], [dropped("flip", 0)])
    yield Case(
        "crossing", """Three tiny disks cross the gap of two large ones from jaw to jaw, one above the other and in step. In the middle they are neighbours of each other, near a
        jaw the jaws are neighbours between them: 22-to-33 flips at one instant above and below the middle one, and back. Each tie joins edges that
        share generators, so that one flip may give another name to the edge of the next.""",
        scene(30, 3, tall_jaws(*[tiny(F(-3, 2), y, 1, 0) for y in (-5, 0, 5)])), [0, F(3, 2), 3],
        ["trapped", "tie", "mirror", "configuration-W", "configuration-X"], [drops_tied_flip(0), dropped("flip", -1, "stops-early")],
        picture=1, events=(4, 0, 0))
    yield Case(
        "two-gaps-in-step", """Three large disks in a row, and in each of the two gaps a tiny disk; both fall at one speed, mirror images. Every event in one gap has a twin in the other.""",
        scene(20, 12, [disk(-12, 0, 4), disk(0, 0, 4), disk(12, 0, 4), tiny(-6, 6, 0, -1), tiny(6, 6, 0, -1)]), [0, 6, 12],
        ["trapped", "mirror", "tie"], [drops_tied_flip()], picture=1)
    yield Case(
        "rising-chain", """Five tiny disks in zigzag fill a tall gap; they rise with speeds in proportion to their height, so that the chain stretches and its Configurations X become W one after
        the other.""",
        scene(30, 4, tall_jaws(*[tiny(F(1, 4) * (-1) ** i, F(i - 2), 0, F(i - 2, 2)) for i in range(5)])), [0, 2, 4],
        ["trapped", "configuration-W", "configuration-X"], [dropped("flip", 0)])


def shadow(name, story, s, instants, wrong, **more):
    return Case(name, story, s, instants, ["shadow", *more.pop("tags", [])], wrong, **more)


@family("shadow-flips", "roots at which another edge of the same four generators, or none, collapses")
def shadows():
    yield shadow(
        "fig16-without-cover", """Fig. 16: Configuration I, two edges with one quadruple of generators and one root, of which one shrinks. The scene beside fig17-cover, without the disk that covers
        the edge.""",
        scene(20, F(3, 2), jaws(tiny(1, F(1, 2)), tiny(F(1, 4), F(1, 2), 0, 1))), [0, F(3, 2)], [dropped("flip", 0)])
    covered = (tiny(1, F(1, 2)), tiny(F(1, 4), F(1, 2), 0, 1))
    yield shadow(
        "fig17-cover", """Fig. 17: as fig16-without-cover with a further tiny disk, whose cell covers the place where the edge would shrink at t = 0.195. The root is there,
        and so is the tangent circle of the four, but the fifth disk lies in it: a shadow flip, of an edge that the diagram does not
        have. The other edge of the same four must not flip instead; the wrong history takes the shadow for real.""",
        scene(20, F(3, 2), jaws(*covered, tiny(F(1, 2), F(-1, 2), 0, 0, F(1, 8)))), [0, 1, F(3, 2)],
        [inserted_flip(F(195, 1000), [1, 3, 2, 0], "shadow-taken", "wrong quadruple")], tags=["configuration-I", "fig17"])
    yield shadow(
        "cover-elsewhere", """As fig17-cover with the further disk at the other end, over the edge of the pair that has the root too and does not shrink. The circle is
        empty and the flip real: of two edges with one quadruple of generators and one root, a cover on the one says nothing about the
        other.""",
        scene(20, F(3, 2), jaws(*covered, tiny(F(1, 2), F(5, 4), F(1, 8), 1, F(1, 8)))), [0, 1, F(3, 2)],
        [dropped("flip", 0)], tags=["configuration-I"])
    yield shadow(
        "inner-circle", """Four disks around a fifth: as the outer four become cotangent, their common circle holds the fifth. The quadruple of the outer four is cotangent at t = 2, exactly and with sign
        change, and no edge of the diagram has it.""",
        scene(10, 4, [*square_closing(0, F(2), half=2), disk(0, 0, F(1, 2))]), [0, 2, 4], [inserted_flip(2, [0, 2, 1, 4], "shadow-taken", "edge not present")], tags=["no-event"], events=(0, 0, 0))
    yield shadow(
        "inner-contact", """Four disks touch one circle, but one of them from inside: a root of the cotangency polynomial f that belongs to another kind of tangency and flips
        nothing. The paper's Eq. (2), as printed, does not tell such roots from real ones.""",
        scene(10, 8, [disk(-2, 0, F(1, 4)), disk(0, -2, F(1, 4)), disk(2, 0, F(1, 4)), disk(-3, F(5, 2), F(3, 4), F(1, 2), F(-1, 4))]), [0, 4], [dropped("flip", 0)])
    yield shadow(
        "three-covered", """Three tiny disks in a gap, two of them in step, mirror images. Quadruples of them and the jaws become cotangent, two at the same instants, while
        others cover the place; no edge flips, and the collision of the two at t = 3 is the only event. Engines that keep a candidate
        for each quadruple and not for each edge must recognize each as a shadow when its time comes.""",
        scene(20, 4, jaws(tiny(1, 1, F(-1, 4), F(-1, 4)), tiny(-1, 1, F(1, 4), F(-1, 4)), tiny(0, F(-3, 2)))), [0, 2, 4],
        [dropped("collide", 0, "contact-missed")], tags=["mirror"], events=(0, 1, 0))
    yield shadow(
        "shadow-and-real-at-once", """Two squares are closed at t = 2 by corners in mirror-symmetric motion, but in the right one a fifth disk sits in the common circle: at one instant one
        quadruple flips and its twin is a shadow.""",
        scene(10, 4, [*square_closing(-5, F(2), s=-1), *square_closing(5, F(2)), disk(5, 0, F(1, 4))]), [0, 2, 4],
        [dropped("flip", 0)], tags=["tie", "mirror"], picture=1)


@family("cancelled", "maneuvers that cancel, make or exchange events at their own instant")
def cancelled():
    def closing():
        return square_closing(0, F(2))

    yield Case(
        "flip-turned-back", """A square is closed at t = 2 and at that instant a maneuver sends the corner back the way it came. The polynomial has a simple root there and would change
        sign; with the new velocity it does not. No flip: the sign that counts is the one just after, with the velocities that then hold.""",
        scene(10, 4, closing(), maneuvers=[(2, 3, F(1, 4), F(1, 4))]), [0, 2, 4], ["maneuver", "tie", "no-event"],
        [of_scene("maneuver-lost", "wrong response", lambda s: s.maneuvers.__setitem__(0, (2, 3, F(-1, 4), F(-1, 4)))),
         inserted_flip(2, [0, 2, 1, 3], "cancelled-event-kept", "spurious event")], picture=1, events=(0, 0, 1))
    yield Case(
        "flip-stopped", """As flip-turned-back, but the corner stops: from t = 2 on the four are cotangent for ever, and the diagonal is that of the largest id. Whether a flip has the time 2
        depends on ids.""",
        scene(10, 4, closing(), maneuvers=[(2, 3, 0, 0)]), [0, 2, 4], ["maneuver", "tie", "permanent"], [dropped("maneuver", 0, "maneuver-lost")], picture=1)
    yield Case(
        "flip-stopped-other-ids", """The same motion as in flip-stopped with the ids counted backwards. Nothing geometric differs, but the largest id is now at another corner and asks for the other
        diagonal: the answer about the flip is the opposite.""",
        scene(10, 4, closing()[::-1], maneuvers=[(2, 0, 0, 0)]), [0, 2, 4], ["maneuver", "tie", "permanent"], [dropped("maneuver", 0, "maneuver-lost")], picture=1)
    yield Case(
        "flip-made-tangential", """At t = 2 a maneuver turns the corner into the tangent of the common circle: the simple root before becomes a double one after. No flip, and none later.
        The sign just before t = 2 and the slope of the old polynomial ask for a flip; both belong to a motion that is
        over.""",
        scene(10, 4, closing(), maneuvers=[(2, 3, F(-1, 4), F(1, 4))]), [0, 2, 4], ["maneuver", "tie", "even-root"], [
            inserted_flip(2, [0, 2, 1, 3], "cancelled-event-kept", "spurious event")], picture=1)
    yield Case(
        "flip-made-by-maneuver", """A disk glides along the tangent of the circle of three others; at the point of contact, t = 4, a maneuver turns it inwards: a double root becomes a sign change at
        the same instant, and the edge flips at t = 4.""",
        scene(10, 6, [disk(-2, 0, F(1, 4)), disk(0, -2, F(1, 4)), disk(2, 0, F(1, 4)), disk(-4, 2, F(1, 4), 1, 0)],
              maneuvers=[(4, 3, 0, F(-1, 4))]), [0, 4, 6], ["maneuver", "tie", "even-root"], [dropped("flip", 0)], picture=1)
    yield Case(
        "collision-cannot-be-cancelled", """A disk hits another at t = 2, and a maneuver of that instant would have turned it away. Collisions come first: both happen, and the struck disk keeps what it
        got.
        Whoever sorts events of one time by kind, maneuvers first, loses the collision and with it the struck disk's
        motion.""",
        scene(14, 4, [disk(-3, 0, 1, 1, 0), disk(1, 0, 1)], maneuvers=[(2, 0, -1, 0)]), [0, 2, 4], ["maneuver", "tie", "collision"],
        [of_scene("maneuver-first", "missing event", lambda s: s.maneuvers.__setitem__(0, (F(2) - F(1, 10**9), 0, -1, 0)))], picture=1)
    yield Case(
        "collision-again", """After a head-on collision at t = 2 a maneuver of that instant sends the first disk against the second once more: two collisions of one pair at one instant, with a maneuver between
        them.""",
        scene(14, 4, [disk(-3, 0, 1, 1, 0), disk(1, 0, 1)], maneuvers=[(2, 0, 3, 0)]), [0, 2, 4], ["maneuver", "tie", "collision"],
        [dropped("collide", 1, "second-collision-dropped")], picture=1)
    yield Case(
        "wall-and-maneuver", """A disk reaches the wall at t = 3 and is told at that instant to fly into it again: bounce, maneuver, bounce.
        The same pair collides twice at one time, with the wall's contact never open in between; engines that bar a pair
        from colliding again at once let the disk leave the container.""",
        scene(10, 6, [disk(5, 0, 2, 1, 0), disk(-5, 0, 2)], maneuvers=[(3, 0, 2, 0)]), [0, 3, 6], ["maneuver", "tie", "wall"],
        [dropped("collide", 1, "second-collision-dropped")], picture=1)
    yield Case(
        "all-stop-in-a-square", """Four disks arrive at the corners of a square at t = 2 and all are stopped by maneuvers of that instant: before, the diagram is generic, after, permanently cotangent. Judged after each
        maneuver instead of after all, edges flip to and fro.""",
        scene(12, 4, [disk(2 * a - 2 * vx, 2 * b - 2 * vy, F(1, 2), vx, vy) for (a, b), (vx, vy) in
                      zip(CORNERS, ((1, 0), (F(-1, 2), 1), (0, F(-1, 2)), (F(3, 4), F(1, 4))))],
              maneuvers=[(2, i, 0, 0) for i in range(4)]), [0, 2, 4], ["maneuver", "tie", "permanent"],
        [dropped("maneuver", -1, "maneuver-lost")], picture=1)
    yield Case(
        "maneuver-to-the-same", """Maneuvers that change nothing: a disk is told its own velocity at t = 2, the instant of its flip, and another, at rest, to rest. Both are events and are written, nothing else
        changes.""",
        scene(10, 4, closing(), maneuvers=[(2, 0, 0, 0), (2, 3, F(-1, 4), F(-1, 4))]), [0, 2, 4], ["maneuver", "tie"],
        [dropped("maneuver", 0, "maneuver-lost"), dropped("flip", 0)], picture=1)
    yield Case(
        "maneuver-at-the-horizon", """A maneuver exactly at the horizon takes place: it belongs to the closed interval, and the velocity in the last diagram is the new one.
        No later event would show that it was left out, only the number of maneuvers and the diagram's velocities do.""",
        scene(10, 2, closing(), maneuvers=[(2, 3, F(1, 4), F(1, 4))]), [0, 2], ["maneuver", "horizon", "tie"],
        [dropped("maneuver", 0, "maneuver-lost")])
    yield Case(
        "maneuver-at-the-start", """A maneuver at t = 0 replaces the velocity of the scene before anything moves. The initial diagram, of 0+, is that of the new velocity: the four disks are cotangent at
        t = 0, and the diagonal differs.""",
        scene(10, 2, square_closing(0, F(0)), maneuvers=[(0, 3, F(1, 4), F(1, 4))]), [0, 2], ["maneuver", "start", "tie"],
        [other_initial([0, 2, 1, 3], "maneuver-lost")])


@family("simultaneous", "events of different kinds and places at one instant")
def simultaneous():
    yield Case(
        "flip-and-collision-apart", """At t = 2 a square is closed on the left and two disks collide on the right, without any connection. The collision is written first, the flip second, with one
        time.""",
        scene(12, 4, [*square_closing(-5, F(2)), disk(3, 0, 1, 1, 0), disk(7, 0, 1)]), [0, 2, 4], ["tie", "collision"],
        [dropped("flip", 0, "tie-drops-flip"), dropped("collide", 0, "contact-missed")], picture=1)
    yield Case(
        "flip-and-collision-shared", """The corner that closes a square at t = 2 is struck at that instant from behind, along the diagonal: the flip must be judged with the velocity after the
        collision.""",
        scene(12, 3, [*square_closing(0, F(2)), disk(F(13, 10) + 2, F(7, 5) + 2, F(1, 4), -1, -1)]), [0, 2, 3], ["tie", "collision"],
        [dropped("flip", 0, "tie-drops-flip")], picture=1)
    yield Case(
        "flip-cancelled-by-collision", """The corner that would close a square at t = 2 is struck at that instant from within and flies back: the root is there, the
        sign change is not.
        The flip was foreseen long before the blow, at the same time; of two equal times in a queue chance takes the
        first.""",
        scene(12, 4, [disk(-2, 2, F(1, 4)), disk(-2, -2, F(1, 4)), disk(2, -2, F(1, 4)), disk(F(5, 2), F(5, 2), F(1, 4), F(-1, 4), F(-1, 4)),
                      disk(2 - F(3, 10) - 1, 2 - F(2, 5) - 1, F(1, 4), F(1, 2), F(1, 2), 100)]), [0, 2, 4], ["tie", "collision"], [dropped("collide", 0, "contact-missed")], picture=1)
    for n, flips, across in ((2, 3, "one more edge, between"), (3, 6, "three more edges, between"), (4, 11, "seven more edges, between")):
        centers = ((-6, 0), (6, 0), (0, 6), (0, -6))[:n]
        yield Case(
            f"{n}-squares-at-once", f"""{n} equal squares of equal disks in different places are closed at t = 2, each by an edge of its own. They are translates of each other,
            so {across} them, are due at that very instant: {flips} flips, which are ordered by their quadruples and by nothing geometric, and each of which
            must be there when its turn comes. After the first an engine that restarts behind its time, by however little, has lost the
            others.""",
            scene(12, 4, [disk(d.x + x, d.y + y, d.r, d.vx, d.vy) for x, y in centers for d in square_closing(0, F(2))]), [0, 2, 4],
            ["tie", "equal-radii"], [drops_tied_flip(k=-1)], picture=1)
    yield Case(
        "collisions-apart", """Three collisions at t = 2 in three places, of pairs that have nothing in common.
        Nothing but the ids orders them: first the smallest pair. A queue ordered by computed times gives whatever order
        the rounding errors have.""",
        scene(14, 4, [disk(-6, -6, 1, 1, 0), disk(-2, -6, 1), disk(-6, 0, 1, 1, 0), disk(-2, 0, 1), disk(-6, 6, 1, 1, 0), disk(-2, 6, 1)]), [0, 2, 4],
        ["tie", "collision"], [drops_tied_collision()], picture=1)
    yield Case(
        "wall-disk-and-flip", """At t = 2 one disk meets the wall, two others collide and a square is closed.
        Three kinds of events have to be written in the order of the format, collisions by pair first, the flip last,
        though no two of them share a disk.""",
        scene(12, 4, [*square_closing(0, F(2)), disk(-9, 0, 1, -1, 0), disk(3, -6, 1, 1, 0), disk(7, -6, 1)]), [0, 2, 4], ["tie", "wall", "collision"],
        [dropped("flip", 0, "tie-drops-flip"), drops_tied_collision()], picture=1)
    yield Case(
        "pass-through-the-centre", """Four equal disks in a cross pass the corners of a square with the velocities of a windmill: at t = 2 the square is restored, mirrored diagonals exchange, and each disk is nearest to
        its neighbours.""",
        scene(14, 4, [disk(3 * x - 2 * -y, 3 * y - 2 * x, 1, -y, x) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))]), [0, 2, 4],
        ["symmetric", "tie", "permanent"], [noise(2)])


@family("zero", "no size, no speed, nothing moving; concentric; touching the container")
def zero():
    corners = [(3 * a, 3 * b) for a, b in CORNERS]
    yield Case(
        "points-at-rest", """Four points on the corners of a square: radius zero, all at rest, permanently cotangent.
        Code that divides by radii, or takes radius zero for an empty slot, fails here; the diagonal is that of the
        largest id as with disks.""",
        scene(10, 2, [disk(x, y, 0) for x, y in corners]), [0], ["point", "at-rest", "permanent"], [enlarges_smallest(4)], events=(0, 0, 0))
    yield Case(
        "points-moving", """Five points in motion: the Voronoi diagram of points proper, with f of degree 8 where the in-circle determinant of degree 4 would do, and every root of f
        double.""",
        scene(10, 6, [disk(3, 1, 0, F(-1, 2), F(1, 4)), disk(-3, 2, 0, F(1, 2), F(-1, 8)), disk(0, -3, 0, F(1, 8), F(1, 2)), disk(1, 3, 0, 0, F(-1, 2)),
                       disk(-2, -2, 0, F(1, 4), 0)]), [0, 3, 6], ["point"], [dropped("flip", 0)])
    yield Case(
        "point-hits-disk", """A point, of mass 1, hits a disk head on at t = 2: reach is the radius of the disk alone. At the contact the tangent circles of the two degenerate.""",
        scene(10, 4, [disk(-5, 0, 0, 1, 0), disk(-1, 0, 2), disk(4, 4, 1)]), [0, 1, 4], ["point", "collision"],
        [dropped("collide", 0, "contact-missed")])
    yield Case(
        "point-hits-the-wall", """A point runs along a diameter into the wall and back. At the contact its cell shrinks to a segment: both vertices of its edge with the container meet, at a time
        that is a root of no flip, and the cell opens again. Code that expects two distinct vertices there divides by zero.""",
        scene(10, 8, [disk(6, 0, 0, 1, 0), disk(-4, 0, 1)]), [0, 8], ["point", "wall"], [dropped("collide", 0, "contact-missed")])
    yield Case(
        "point-among-equals", """A point crosses a resting 2 by 2 lattice of points through its centre: five cocircular at no time, but the point is equidistant from all four when in the
        middle.""",
        scene(10, 8, [*[disk(x, y, 0) for x, y in corners], disk(-4, 0, 0, 1, 0)]), [0, 4, 8], ["point", "symmetric"], [dropped("flip", 0)], picture=1)
    yield Case(
        "all-at-rest", """Six different disks at rest, in general position: no polynomial has any degree, every search ends at once.
        A solver that divides by the leading coefficient, or by the speed, divides by zero, and a window of search that
        grows with the mean distance over the speed is infinite.""",
        scene(12, 5, [disk(3, 1, 1), disk(-4, 2, F(3, 2)), disk(0, -5, 2), disk(5, -4, F(1, 2)), disk(-6, -4, 1), disk(1, 6, F(7, 4))]), [0, 5],
        ["at-rest", "no-event"], [inserted_flip(2, [-1, 1, 4, 5], "even-root-taken")], events=(0, 0, 0))
    yield Case(
        "common-velocity", """Six different disks with one velocity, towards the wall: relative motion is zero, and only the container makes events.
        Quadruples without the container have constant polynomials; their higher coefficients are rounding errors in
        doubles, with roots anywhere.""",
        scene(20, 8, [disk(x - 4, y, r, -1, -1) for x, y, r in ((3, 1, 1), (-4, 2, F(3, 2)), (0, -5, 2), (5, -4, F(1, 2)), (-6, -4, 1), (1, 6, F(7, 4)))]),
        [0, 8], ["translating"], [dropped("flip", 0), dropped("collide", 0, "contact-missed")])
    yield Case(
        "concentric-ring", """Six equal disks around a seventh that is concentric with the container, all at rest. Bisector of the seventh and the container is a circle that no edge
        uses.""",
        scene(10, 2, [disk(0, 0, 1), *[disk(5 * x, 5 * y, 1) for x, y in ((1, 0), (F(3, 5), F(4, 5)), (F(-3, 5), F(4, 5)), (-1, 0), (F(-3, 5), F(-4, 5)), (F(3, 5), F(-4, 5)))]]),
        [0], ["concentric", "at-rest", "symmetric"], [noise(1)], events=(0, 0, 0))
    yield Case(
        "passing-the-centre", """A disk passes the centre of the container at t = 4, concentric for an instant, between two resting disks: the distance of its centre to O has a root of the derivative and a zero
        there.""",
        scene(12, 8, [disk(-4, 0, 1, 1, 0), disk(0, 4, 1), disk(0, -4, 1)]), [0, 4, 8], ["concentric", "mirror", "tie"], [noise(4)], picture=1)
    yield Case(
        "touching-the-container", """Four disks of different sizes touch the container from inside, at rest, in rational points; a fifth moves about. Edges between container and disk pass through the
        points of contact.""",
        scene(10, 4, [disk((10 - r) * x, (10 - r) * y, r) for (x, y), r in zip(((1, 0), (F(-3, 5), F(4, 5)), (F(-4, 5), F(-3, 5)), (F(3, 5), F(-4, 5))), (2, 1, 3, F(3, 2)))]
              + [disk(0, 2, 1, F(1, 2), F(1, 4))]), [0, 4], ["wall", "at-rest", "touching-start"], [noise(1)])
    yield Case(
        "horizon-zero", """A history on [0, 0]: what happens at t = 0 happens, and nothing else. Two disks touch and approach.
        They collide at 0, and the history has one event. Loops over times before the horizon never run.""",
        scene(10, 0, [disk(-1, 0, 1, 1, 0), disk(1, 0, 1), disk(0, 4, 1)]), [0], ["horizon", "touching-start", "start"],
        [dropped("collide", 0, "contact-missed")])


@family("collapse", "what has no continuation: inelastic collapse, sliding along the wall, points that meet")
def collapse():
    def gives_up(name, story, s, instants=(0,), truths=("exact",), **more):
        return Case(name, story, s, list(instants), ["undecided", *more.pop("tags", [])], verdict="undecided", truths=truths, **more)

    yield gives_up(
        "three-in-line", """Three equal disks on a line with restitution 1/20, the outer ones moving inwards: below 7 - 4 * sqrt(3) = 0.0718 infinitely many collisions happen in
        finite time. There is no first event after the limit, so no history goes on; the run must stop and say so, and what it has written up to there is
        right.""",
        scene(12, 20, [disk(-4, 0, 1, 1, 0), disk(F(1, 3), 0, 1), disk(4, 0, 1, -1, 0)], restitution=F(1, 20)), tags=["inelastic"])
    yield gives_up(
        "four-in-line", """Four equal disks on a line, restitution 1/10, closing from both ends: collapse of a chain.
        With four the limit ratio is larger than with three, and each round takes more collisions; an engine that bars a
        pair from colliding again within some time turns the collapse into overlap.""",
        scene(16, 20, [disk(-6, 0, 1, 1, 0), disk(F(-7, 3), 0, 1), disk(F(5, 2), 0, 1), disk(6, 0, 1, -1, 0)], restitution=F(1, 10)), tags=["inelastic"])
    yield gives_up(
        "settling-on-the-wall", """One disk bounces off a wall that takes three quarters of the normal velocity at each contact. The wall is concave: the tangential motion carries the disk back into it after times that
        shrink geometrically, and it ends sliding along the wall, which this model does not have.""",
        scene(6, 100, [disk(3, 0, 1, 0, 1)], wall=F(1, 4)), tags=["inelastic", "wall"])
    yield gives_up(
        "slides-after-a-collision", """A disk touches the wall and is struck from the side at its own mass: the wall's normal component is gone and what is left is exactly along the wall. The exact
        tangent has no motion in this model; a computed one leaves or presses by a rounding error.""",
        scene(10, 5, [disk(8, 0, 2, 1, F(1, 2)), disk(4, 0, 2)]), tags=["wall"], instants=())
    yield gives_up(
        "slides-by-maneuver", """A maneuver at the instant of a wall contact asks a disk to move exactly along the wall.
        The disk would have to leave its line at once and at every later instant: no collision law says how. Engines
        that go on let it leave the container or bounce at every step.""",
        scene(10, 6, [disk(0, 5, 1, 0, 1), disk(0, -5, 2)], maneuvers=[(4, 0, 1, 0)]), tags=["wall", "maneuver"])
    yield gives_up(
        "points-meet", """Two points run into each other: at the contact they coincide, and their bisector is nowhere defined.
        Up to the contact everything is regular, and the last edge between them is as wide as ever; the run must stop at
        the contact and not a little before or after.""",
        scene(10, 5, [disk(-2, 0, 0, 1, 0), disk(2, 0, 0), disk(0, 5, 1)]), tags=["point"])
    yield gives_up(
        "point-touches-at-start", """A point touches a disk at t = 0: both vertices of their edge coincide, and no order around them is defined.
        Nothing of the history can be said, not even its first line; the program must stop with a reason, and one that
        bisects towards the event that is not there does not.""",
        scene(10, 5, [disk(-2, 0, 0), disk(0, 0, 2), disk(0, 5, 1)]), tags=["point", "touching-start"], instants=())
