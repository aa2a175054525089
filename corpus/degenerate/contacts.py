"""Contacts: cradles, corners, near misses, grazing, touching at the start, several at one instant."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import (dropped, drops_tied_collision, edited, inserted_hit, late, noise, of_scene, other_collision_order,
                              renumbered, wrong_velocity)


@family("cradles", "Newton's cradles of 2 to 20 equal disks: chains of collisions at one instant")
def cradles():
    def row(n, gap=0, v=1, r=F(1, 2), start=None, **options):
        """A disk comes from the left at speed v upon n - 1 that rest in a row, `gap` apart."""
        first = F(1 - n, 2) * (2 * r + gap)
        disks = [disk(first + i * (2 * r + gap), 0, r) for i in range(n)]
        disks[0].x -= 2 if start is None else start
        disks[0].vx = F(v)
        return disks

    for n in (2, 3, 4, 5, 8, 12, 20):
        yield Case(
            f"cradle-{n:02}", f"""{n} equal disks in a row, {n - 1} of them at rest and touching, the first coming in at unit speed. At t = 2
            the blow runs through the row: {n - 1} collisions at one instant, in the order of the pairs, each the consequence of the one before,
            and the last disk leaves with the whole velocity. No gap ever opens, so every contact has waiting time zero;
            an engine that asks for a positive time, or lets each pair collide once an instant by a tolerance on
            time, stops the blow in the middle.""",
            scene(n + 6, 4, row(n)), [0, 2, 4], ["cradle", "tie", "equal-radii", "collinear"],
            [drops_tied_collision()] if n > 2 else [dropped("collide", 0, "contact-missed")], picture=1, events=None)
    for n in (3, 10):
        yield Case(
            f"cradle-gaps-{n:02}", f"""The same with gaps of 10^-12 between the {n} disks: the blow takes a chain of {n - 1} collisions, 10^-12 apart.
            They are not simultaneous, and their order is the same; an engine with a tolerance of 1e-6 on contacts sees all pairs in contact
            at once.""",
            scene(n + 6, 4, row(n, F(1, 10**12))), [0, 3], ["cradle", "near-tie", "equal-radii", "collinear"],
            [dropped("collide", -1, "second-collision-dropped")])
    for n in (3, 5, 6):
        def both(n=n):
            disks = row(n)
            disks[-1].x += 2
            disks[-1].vx = F(-1)
            return disks
        yield Case(
            f"cradle-both-ends-{n:02}", f"""A row of {n} equal disks, the inner ones touching and at rest, is struck from both ends at t = 2. The collisions run towards each other, in an
            order that is the format's: always the smallest pair that touches and approaches, and from the start again after each. The outcome is
            mirror-symmetric whatever the order; the list of collisions is not.""",
            scene(n + 6, 4, both()), [0, 2, 4], ["cradle", "tie", "mirror", "collinear"],
            [other_collision_order(n, "another order of touching collisions")], picture=1)
    yield Case(
        "cradle-two-strike", """Two touching disks strike three that rest in a row: five disks, two come in and two must leave. With pairwise collisions
        in the order of the smallest pair the velocities pass through the row twice at one instant, six collisions;
        treating the row as one body gives another motion.""",
        scene(11, 4, [disk(-5, 0, F(1, 2), 1, 0), disk(-4, 0, F(1, 2), 1, 0)] + [disk(i - 1, 0, F(1, 2)) for i in range(3)]),
        [0, F(5, 2), 4], ["cradle", "tie", "collinear"], [drops_tied_collision()], picture=1)
    yield Case(
        "cradle-between-walls", """Three equal disks fill a diameter of the container but for a gap: the blow goes to the wall and back through the row.
        Wall and disk contacts share an instant: the disk at the wall touches both.""",
        scene(4, 7, [disk(F(-7, 2), 0, F(1, 2), 1, 0), disk(F(5, 2), 0, F(1, 2)), disk(F(7, 2), 0, F(1, 2))]),
        [0, 5, 7], ["cradle", "tie", "wall", "collinear"], [drops_tied_collision()], picture=1)
    yield Case(
        "cradle-unequal-masses", """A heavy disk strikes a row of three: masses 3, 1, 1, 1. The blow does not pass in one go: the striker goes on and strikes
        again at the same instant, until nobody approaches. The number of collisions follows from exact
        signs of velocity differences, some of which are small fractions.""",
        scene(9, 4, [disk(-4, 0, F(1, 2), 1, 0, 3)] + [disk(i - 1, 0, F(1, 2), 0, 0, 1) for i in range(3)]),
        [0, 2, 4], ["cradle", "tie", "collinear"], [drops_tied_collision()], picture=1)
    yield Case(
        "cradle-with-loss", """Restitution 1/2 and four equal disks: each collision leaves the pair separating at half the speed, so the one behind catches up with what it hit at
        the same instant again and again with other velocities; the pairs part after finitely many collisions
        at t = 2, and the order of these determines the result.""",
        scene(9, 3, row(4), restitution=F(1, 2)), [0, 2, 3], ["cradle", "tie", "inelastic", "collinear"],
        [drops_tied_collision()], picture=1)


@family("corners", "wall corners of contact: disk, disk and wall, or disk and two others, at one instant")
def corners():
    yield Case(
        "disk-into-wall-corner", """A disk runs into the corner between the wall and a resting disk that touches the wall and meets both at t = 3.
        The smallest approaching pair is the one with the wall, since the container has id -1; the collision with the disk comes after, with the
        velocity that the wall has left, at the same instant.""",
        scene(10, 6, [disk(0, -6, 4), disk(-7, 3, 2, 0, 0), disk(-3, 6, 1, -1, 0)]), [0, 3, 6], ["wall", "corner"], [dropped("collide", 0, "contact-missed")])
    yield Case(
        "between-two-disks", """A disk falls into the corner between two equal resting ones and touches both at t = 4, mirror-symmetrically. By symmetry the three
        would part symmetrically if the contacts were one; the law of pairs takes the smaller pair first, and the result
        is not symmetric. An engine that applies both impulses at once conserves momentum and energy too, and is wrong
        by these rules.""",
        scene(14, 8, [disk(-3, 0, 2), disk(3, 0, 2), disk(0, 8, 3, 0, -1)]), [0, 4, 8],
        ["tie", "mirror", "shared-disk"], [drops_tied_collision(), other_collision_order(3, "another order of touching collisions")], picture=1)
    yield Case(
        "two-into-one", """Two equal disks meet a resting one at t = 2 from directions at a right angle: two collisions that share a disk, at one instant.
        The normals are perpendicular, so the two commute: either order gives the same velocities, and only the
        order in the file is a matter of rule.""",
        scene(14, 6, [disk(0, 0, 1), disk(-4, 0, 1, 1, 0), disk(0, -4, 1, 0, 1)]), [0, 2, 6],
        ["tie", "shared-disk"], [drops_tied_collision()], picture=1)
    yield Case(
        "two-into-one-obliquely", """Two equal disks meet a resting one at t = 5 from directions (3, 4) and (-3, 4): the
        normals are not perpendicular, the collisions do not commute, and after both are made the first pair may
        approach again.""",
        scene(20, 8, [disk(0, 0, F(5, 2)), disk(-6, -8, F(5, 2), F(3, 5), F(4, 5)), disk(6, -8, F(5, 2), F(-3, 5), F(4, 5))]),
        [0, 5, 8], ["tie", "shared-disk", "mirror"], [drops_tied_collision(), other_collision_order(3, "another order of touching collisions")], picture=1)
    yield Case(
        "four-meet", """Four equal disks meet in the middle at t = 2, each touching two others: four contacts at one instant, in a cycle. The order of the pairs
        is the format's; the symmetric answer, all velocities reversed, is not what sequential collisions of pairs give before
        they have come round.""",
        scene(12, 5, [disk(s * 3, t * 3, 1, -s, -t) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1))]), [0, 2, 5],
        ["tie", "symmetric", "shared-disk"], [drops_tied_collision(), renumbered("collision-order", "another order of touching collisions", [1, 3, 0, 2])], picture=1)
    yield Case(
        "four-onto-one", """Four equal disks strike a resting fifth from four sides at t = 2. In total nothing happens to the one in the middle; in sequence it is struck
        four times and more at one instant.""",
        scene(12, 5, [disk(0, 0, 1), *[disk(4 * s, 4 * t, 1, -s, -t) for s, t in ((1, 0), (0, 1), (-1, 0), (0, -1))]]), [0, 2, 5],
        ["tie", "symmetric", "shared-disk"], [drops_tied_collision()], picture=1)
    yield Case(
        "wall-on-both-sides", """A disk as large as half the container touches the wall on the left and a small disk comes between it and the wall on
        the right, along the diameter: contacts with disk and wall alternate, then coincide at t = 4, where the gap is exactly the diameter.""",
        scene(8, 6, [disk(-4, 0, 4), disk(F(9, 2), 0, F(1, 2), F(3, 4), 0)]), [0, 4, 6], ["wall", "collinear"],
        [dropped("collide", 0, "contact-missed")])
    yield Case(
        "two-reach-the-wall-together", """Two touching disks, side by side with one velocity, reach the wall at the same instant. The wall turns both velocities towards each other: a collision
        of the two follows at that very instant, because they touch.""",
        scene(10, 10, [disk(-1, 0, 1, 0, 1), disk(1, 0, 1, 0, 1)]), [0, 8], ["tie", "wall", "touching-start", "mirror"],
        [dropped("collide", 2, "second-collision-dropped")], truths=("exact",))
    yield Case(
        "triangle-arrives", """Three mutually touching equal disks cannot have rational centres; these touch in two pairs and leave a
        gap of a hundredth in the third. The row of contacts is struck by a fourth at t = 2.""",
        scene(14, 5, [disk(0, 0, 1), disk(F(6, 5), F(8, 5), 1), disk(F(6, 5), F(-8, 5), 1), disk(-4, 0, 1, 1, 0)]), [0, 2, 5],
        ["tie", "touching-start", "mirror"], [drops_tied_collision(), other_collision_order(4, "another order of touching collisions")], picture=1)


@family("near-misses", "passing and touching, on both sides of contact, by 10^-6 to 10^-15")
def near_misses():
    for e in (6, 9, 12, 15):
        gap = F(1, 10**e)
        for side, sign, what in (("outside", 1, "miss each other by"), ("inside", -1, "overlap in their courses by")):
            hits = sign < 0
            sc = scene(10, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2 + sign * gap, 1)])
            yield Case(
                f"{side}-1e-{e}", f"""A disk passes another at rest; their courses {what} 10^-{e}. The discriminant of the contact is about 4 * 10^-{e}
                {"below zero: no collision" if not hits else f"above zero: they collide about 2 * 10^-{F(e, 2)} before the closest approach, almost tangentially"}.
                {"An engine with a tolerance on distance reports one." if not hits else "An engine that drops contacts with small discriminants lets the disks overlap."}""",
                sc, [0, 4, 8], ["near-miss", side], [inserted_hit(4, 0, 1, sc)] if not hits else [dropped("collide", 0, "contact-missed")], picture=1)
    sc = scene(10, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2, 1)])
    yield Case(
        "exact-graze", """A disk passes another at rest and touches it at t = 4 exactly, tangentially: the discriminant is zero, the root
        double, the pair does not approach at the contact. No collision.""",
        sc, [0, 4, 8], ["near-miss", "grazing", "even-root"], [inserted_hit(4, 0, 1, sc)], picture=1)
    for e in (6, 15):
        gap = F(1, 10**e)
        sc = scene(10, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2 + gap, 1), disk(0, -2 - gap, 1)])
        yield Case(
            f"through-a-gate-1e-{e}", f"""A disk passes between two others at rest, with a margin of 10^-{e} on either side, mirror-symmetrically: two near misses at
            the same instant, t = 4, at which also both vertices of the row of three are mirror images.""",
            sc, [0, 4, 8], ["near-miss", "mirror"], [inserted_hit(4, 0, 1, sc)], picture=1)
    for e in (9, 15):
        gap = F(1, 10**e)
        yield Case(
            f"stopped-short-of-the-wall-1e-{e}", f"""A disk flies at the wall and is turned by a maneuver at t = 3, 10^-{e} before contact. No collision; an engine that
            rounds the distance, or carries the maneuver out late, makes one.""",
            scene(10, 6, [disk(5 - gap, 0, 2, 1, 0), disk(-5, 0, 2)], maneuvers=[(3, 0, -1, 0)]), [0, 3, 6],
            ["near-miss", "wall", "maneuver"], [inserted_hit(3, -1, 0, scene(10, 6, [disk(5 - gap, 0, 2, 1, 0)]))], picture=1)


@family("grazing", "tangential contact: a double root of the distance, and no collision")
def grazing():
    sc = scene(12, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2, 1), disk(0, -2, 1)])
    yield Case(
        "between-two", """A disk passes exactly between two others, touching both tangentially at t = 4: two double roots at one instant. No collision, and the
        diagram at that instant has two edges of no width.""",
        sc, [0, 4, 8], ["grazing", "even-root", "mirror"], [inserted_hit(4, 0, 1, sc)], picture=1)
    sc = scene(12, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2, 1), disk(2, 2, 1)])
    yield Case(
        "two-in-succession", """A disk grazes two touching neighbours one after the other, at t = 4 and t = 6. Neither contact changes
        anything.
        The double roots are of different pairs but share a disk: an engine that handles one as a collision sends the
        disk into the other neighbour, or past it, with another velocity.""",
        sc, [0, 4, 5, 6], ["grazing", "even-root", "touching-start"], [inserted_hit(4, 0, 1, sc)], picture=1)
    sc = scene(16, 8, [disk(-4, 3, 1, 1, F(-3, 4)), disk(F(6, 5), F(8, 5), 1)])
    yield Case(
        "obliquely", """Grazing along the direction (4, -3): the contact at t = 4 is tangential exactly, with all coordinates in fifths. In doubles the discriminant is a rounding error of either
        sign.""",
        sc, [0, 4, 8], ["grazing", "even-root"], [inserted_hit(4, 0, 1, sc)], picture=1)
    sc = scene(14, 8, [disk(-4, -2, 1, 1, F(1, 2)), disk(4, 0, 1, -1, F(1, 2))])
    yield Case(
        "both-moving", """Two moving disks graze: their velocity relative to each other is horizontal, their distance across it exactly the sum of the radii. Neither path shows
        it by itself.""",
        sc, [0, 4, 8], ["grazing", "even-root"], [inserted_hit(4, 0, 1, sc)], picture=1)
    yield Case(
        "graze-then-hit", """A disk grazes one neighbour at t = 4 and hits the next head on at t = 6. The double root must be passed over without losing the
        simple one behind it.
        Root finders that stop at the first zero of the distance, or skip an interval around it, miss the collision or
        make two.""",
        scene(14, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2, 1), disk(4, 0, 1)]), [0, 4, 6, 8],
        ["grazing", "even-root"], [dropped("collide", 0, "contact-missed")], picture=1)
    yield Case(
        "graze-and-hit-at-once", """At t = 4 a disk hits one neighbour head on and grazes another: the collision is made with the pair that approaches, and after it the
        grazed pair parts. An engine that collides every touching pair turns the disk aside.""",
        scene(14, 8, [disk(-4, 0, 1, 1, 0), disk(2, 0, 1), disk(0, 2, 1)]), [0, 4, 8],
        ["grazing", "tie", "shared-disk"], [wrong_velocity(0, lambda v: [[0, -0.5], v[1]])], picture=1)
    yield Case(
        "graze-made-a-hit", """At t = 4, the instant of a tangential contact, a maneuver turns the passing disk towards the other: it touches and approaches now, so a collision follows at
        the same instant, after the maneuver.""",
        scene(14, 8, [disk(-4, 0, 1, 1, 0), disk(0, 2, 1)], maneuvers=[(4, 0, 0, 1)]), [0, 4, 8],
        ["grazing", "maneuver", "tie"], [dropped("collide", 0, "contact-missed")], picture=1)
    yield Case(
        "point-grazes", """A point of radius zero passes a disk along its tangent and touches it at t = 4. At that instant both tangent circles of any vertex
        of the two coincide in the point, where edges have no width and no direction.""",
        scene(12, 8, [disk(-4, 0, 0, 1, 0), disk(0, 2, 2), disk(0, -4, 1)]), [0, 8],
        ["grazing", "even-root", "point"], [noise(1)])


def turned_away(s):
    s.disks[0].vx = F(-1)


@family("touching-start", "touching at t = 0: approaching, sliding, resting, parting")
def touching_start():
    pair = [("approach", 1, 0, "approach: the collision has time 0 and comes first in the file", (0, 1, 0)),
            ("part", -1, 0, "part: no collision", (0, 0, 0)),
            ("slide", 0, 1, "move along their common tangent: the distance grows with t^2, and no collision happens", (0, 0, 0))]
    for name, vx, vy, what, events in pair:
        yield Case(
            name, f"""Two equal disks touch at t = 0 and {what}. The distance minus the sum of the radii is zero at the start, so its sign is that of
            the first derivative, or of the second where that vanishes; asking for roots in t > 0 or t >= 0 is wrong in
            one of the cases approach, part and slide whichever is chosen.""",
            scene(14, 3, [disk(-1, 0, 1, vx, vy), disk(1, 0, 1)]), [0, 3], ["touching-start"],
            [dropped("collide", 0, "contact-missed")] if events[1]
            else [inserted_hit(0, 0, 1, scene(14, 3, [disk(-1, 0, 1, vx, vy), disk(1, 0, 1)]))], events=events)
    yield Case(
        "rest", """Two disks touch and rest: the distance is zero for ever. It neither falls nor grows, so no collision happens, at no time; engines that
        collide whatever touches write one at t = 0, or one a step.""",
        scene(14, 3, [disk(-1, 0, 1), disk(1, 0, 1), disk(0, 4, 1)]), [0, 3], ["touching-start", "at-rest"], [noise(1)], events=(0, 0, 0))
    yield Case(
        "glide-together", """Two disks touch and have one velocity: in contact for ever, with moving coordinates; the squared distance minus four is the zero polynomial, computed from
        coefficients that cancel. A third waits in their way.""",
        scene(14, 6, [disk(-5, 0, 1, 1, 0), disk(-5, 2, 1, 1, 0), disk(4, 6, 1)]), [0, 6],
        ["touching-start", "permanent"], [noise(3)], events=None)
    yield Case(
        "approach-by-maneuver", """Two disks touch and rest; a maneuver at t = 2 sends one into the other: maneuver and collision
        have one time, the maneuver comes first in the file.
        Whoever takes up the search for contacts behind the maneuver's instant lets the disks overlap.""",
        scene(14, 4, [disk(-1, 0, 1), disk(1, 0, 1)], maneuvers=[(2, 0, 1, 0)]), [0, 2, 4],
        ["touching-start", "maneuver", "tie"], [dropped("collide", 0, "contact-missed")])
    yield Case(
        "approach-averted-by-maneuver", """Two disks touch at t = 0 and approach, and a maneuver at t = 0 turns the first one away. Collisions come before maneuvers at one
        instant: the collision happens, and the maneuver then replaces the velocity that it gave.""",
        scene(14, 4, [disk(-1, 0, 1, 1, 0), disk(1, 0, 1)], maneuvers=[(0, 0, -1, 0)]), [0, 4],
        ["touching-start", "maneuver", "tie"],
        [of_scene("maneuver-first", "missing event", turned_away)])
    yield Case(
        "row-approaches-at-both-ends", """Three disks in a row touch at t = 0 and both outer ones press inwards: three collisions at time zero or more,
        in the order of the rule.
        The first sends the middle disk against the last, and so to and fro: engines that collect the contacts of an
        instant before they respond make two.""",
        scene(14, 3, [disk(-2, 0, 1, 1, 0), disk(0, 0, 1), disk(2, 0, 1, -1, 0)]), [0, 3], ["touching-start", "tie", "mirror"],
        [drops_tied_collision()])
    yield Case(
        "wall-approach", """A disk touches the wall at t = 0 and flies against it obliquely; another disk touches it too, and is let go by the bounce or struck: the
        signs after the bounce decide.""",
        scene(10, 3, [disk(8, 0, 2, 1, F(1, 2)), disk(5, 0, 1)]), [0, 3], ["touching-start", "wall", "tie"],
        [dropped("collide", 0, "contact-missed")])
    yield Case(
        "ring-of-touching", """Four disks touch in a ring around the centre, each two neighbours, and all move around it tangentially with one speed: every pair slides or parts
        at 0+, by the second derivative.""",
        scene(10, 2, [disk(s - t, s + t, 1, -(s + t), s - t) for s, t in ((1, 0), (0, 1), (-1, 0), (0, -1))]), [0, 2],
        ["touching-start", "symmetric"], [noise(1)], events=(0, 0, 0))
