"""No disk, one, two and three."""
from fractions import Fraction

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import (cut_tail, dropped, inserted_flip, late, noise, of_scene, wrong_velocity)


@family("few", "0, 1, 2 and 3 disks: diagrams too small for the rules of large ones")
def few():
    yield Case(
        "none", """An empty container. There is no generator but the container, no vertex and no edge, and
        nothing ever happens: the right history is a header with an empty initial diagram and a last
        line. Implementations fail on it by dividing by the number of disks, by asking for the first
        of no events, or by writing no file at all.""",
        scene(10, 5, []), [0, 5], ["n0"], events=(0, 0, 0))
    yield Case(
        "one-at-rest-in-the-centre", """One disk rests concentric with the container. The only edge is a
        closed circle without vertices, which no quadruple names, so the diagram is written with no
        edge. Every point of that circle has the same distance to both; whoever parametrizes the
        edge by the direction between the two centres divides zero by zero.""",
        scene(10, 5, [disk(0, 0, 2)]), [0], ["n1", "concentric", "at-rest"], events=(0, 0, 0))
    yield Case(
        "one-along-a-diameter", """One disk runs along a diameter and meets the wall at t = 3, 11 and 19, and
        passes the centre concentrically at t = 7 and 15. Each contact is exact and perpendicular:
        the tangential part of the velocity is zero and must stay so, or the disk leaves the
        diameter after some bounces.""",
        scene(6, 20, [disk(-1, 0, 2, 1, 0)]), [0, 3, 7, 19], ["n1", "wall", "concentric"],
        [dropped("collide", 1, "contact-missed"),
         wrong_velocity(0, lambda v: [None, [v[1][0], 1e-3]])], picture=2)
    yield Case(
        "one-along-chords", """One disk runs along chords whose directions turn by a Pythagorean angle at each
        bounce: times and velocities stay rational with numbers that grow by two digits a bounce.
        An engine in doubles is off by an ulp at the second contact already; correct rounding of the
        tenth asks for all digits.""",
        scene(6, 60, [disk(3, 0, 1, 0, 1)]), [0, 4, Fraction(284, 25)], ["n1", "wall"],
        [late(2, 1e-5, "collide"), cut_tail(3)], picture=1)
    yield Case(
        "one-touches-the-wall-and-leaves", """The disk touches the wall at t = 0 and moves away from it. The
        contact is there, but nothing approaches, so there is no collision; the discriminant of the
        contact polynomial has one root at exactly 0, which is not an event. The far wall is met at
        t = 8.""",
        scene(6, 10, [disk(4, 0, 2, -1, 0)]), [0, 8], ["n1", "wall", "touching-start"],
        [wrong_velocity(0, lambda v: [None, [v[1][0] / 2, 0]])], events=(0, 1, 0))
    yield Case(
        "one-touches-the-wall-and-presses", """The disk touches the wall at t = 0 and moves straight into it:
        the collision happens at t = 0 and belongs to the history, although the time before has no
        length. Engines that look for roots in (0, infinity) let the disk leave the container.""",
        scene(6, 10, [disk(4, 0, 2, 1, 0)]), [0, 8], ["n1", "wall", "touching-start"],
        [dropped("collide", 0, "contact-missed", "wrong time")], events=(0, 2, 0))
    yield Case(
        "one-rests-at-the-wall", """A disk at rest touches the wall for ever. The contact polynomial vanishes
        identically, and so does the length of the normal part of the velocity: neither approach nor
        separation, no event.""",
        scene(6, 10, [disk(4, 0, 2)]), [0, 10], ["n1", "wall", "at-rest"], events=(0, 0, 0))
    yield Case(
        "two-mirrored", """Two equal disks, mirror images of each other, run head on through the centre of the
        container. With two disks there are two vertices and three edges, and every edge has the same
        generator at both ends (s = e): there are no four generators, so no polynomial for a flip, and none
        may be solved for. The disks collide at t = 3 in the centre
        and both meet the wall at t = 9, at the same instant.""",
        scene(8, 10, [disk(-4, 0, 1, 1, 0), disk(4, 0, 1, -1, 0)]), [0, 3, 9], ["n2", "mirror", "tie"],
        [dropped("collide", 2, "second-collision-dropped"), dropped("collide", 0, "contact-missed")],
        picture=1)
    yield Case(
        "two-concentric-pass", """A large disk rests in the centre, a small one circles it along chords. The
        large disk is concentric with the container all the time: the bisector of these two is a
        circle, on which the small cell cuts out an arc. No pair touches but the small disk and the
        wall.""",
        scene(10, 30, [disk(0, 0, 2), disk(5, -5, 1, 0, 1)]), [0, 5, 10], ["n2", "concentric", "wall"],
        [wrong_velocity(0, lambda v: [None, [-v[1][0], v[1][1]]])], picture=1)
    yield Case(
        "two-huge-and-tiny", """A disk that nearly fills the container and a point-like one (ratio 10^6) in the
        crescent beside it, moving along it. The two tangent circles of the three generators are mirror images and both
        are thousands of times larger than the tiny disk; differences of squared radii lose ten digits
        here.""",
        scene(10, 4, [disk(Fraction(-1, 2), 0, 9), disk("9.4", 0, "0.000009", 0, "0.125")]), [0, 2],
        ["n2", "scales"])
    yield Case(
        "two-touch-and-rest", """Two disks touch each other, one of them also the wall, and all are at rest. The
        edge between them passes through the contact point, where it has width zero; nothing
        happens.""",
        scene(6, 5, [disk(4, 0, 2), disk(0, 0, 2)]), [0, 5], ["n2", "touching-start", "at-rest"])
    yield Case(
        "three-in-a-row", """Three equal disks rest on a diameter. Nothing is cotangent by fours, but the
        configuration is symmetric about the row: the two vertices of each pair of neighbours are
        mirror images, and orientation tests of the three centres are exactly zero. A construction
        that starts with the convex hull of the centres has no triangle to start with.""",
        scene(10, 5, [disk(-4, 0, 1), disk(0, 0, 1), disk(4, 0, 1)]), [0], ["n3", "collinear", "at-rest"], [noise(1)], events=(0, 0, 0))
    yield Case(
        "three-pass-in-line", """The middle one of three equal disks crosses the line of the other two at t = 4,
        at a right angle and midway, symmetrically in time. The outer two are neighbours until
        a first flip, and again, on the other side, from a second one on; at t = 4 itself the three centres are collinear, the determinants of orientation of every
        triple vanish, two circles of contact with the wall are mirror images, and no event happens. An engine whose tests of
        cotangency degenerate with the line of centres sees one there.""",
        scene(10, 8, [disk(-4, 0, 1), disk(0, -4, 1, 0, 1), disk(4, 0, 1)]), [0, 4, 8],
        ["n3", "collinear", "mirror"],
        [dropped("flip", 1)], picture=1, events=(2, 0, 0))
    yield Case(
        "three-around-the-centre", """Three equal disks at equal distances from the centre of the container, at
        rest: one circle about the centre touches all three, and the circle that touches two of them
        and the wall exists on either side. One Pythagorean angle keeps all coordinates rational. With
        equal distances many determinants vanish, yet no four generators are cotangent.""",
        scene(10, 5, [disk(5, 0, 1), disk(-3, 4, 1), disk(-3, -4, 1)]), [0], ["n3", "at-rest", "no-event"],
        [of_scene("input-moved", "wrong initial diagram", lambda s: s.disks.reverse())])
