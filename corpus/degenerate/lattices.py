"""Square and triangular lattices: at rest, gliding, turning, shearing."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import (dropped, drops_tied_flip, noise, renumbered)


def square(columns, rows, velocity=lambda x, y: (0, 0), step=2, r=F(1, 2)):
    """A lattice about the origin, row by row from below."""
    points = [(step * (F(i) - F(columns - 1, 2)), step * (F(j) - F(rows - 1, 2)))
              for j in range(rows) for i in range(columns)]
    return [disk(x, y, r, *velocity(x, y)) for x, y in points]


def triangular(rings, velocity=lambda x, y: (0, 0), r=F(1, 2)):
    """A lattice of rational isosceles triangles with base 2 and height 7/4, in hexagonal outline."""
    points = [(2 * F(i) + F(j), F(7, 4) * j)
              for j in range(-rings, rings + 1) for i in range(-rings, rings + 1) if abs(i + j) <= rings]
    return [disk(x, y, r, *velocity(x, y)) for x, y in points]


def rows_backwards(columns, rows):
    """Disks counted from right to left in each row: the mirrored rule for what is cotangent for ever."""
    image = [j * columns + columns - 1 - i for j in range(rows) for i in range(columns)]
    return renumbered("smallest-id-enlarged", "wrong initial diagram", image)


@family("lattices", "grids and lattices at rest, gliding, turning by maneuvers, shearing")
def lattices():
    for columns, rows in ((2, 2), (3, 3), (4, 4), (5, 4)):
        n = columns * rows
        yield Case(
            f"rest-{columns}x{rows}", f"""{n} equal disks rest on a square lattice: every unit square is a permanently cotangent quadruple,
            {(columns - 1) * (rows - 1)} of them, each resolved by the rule of the largest id; symmetric
            quadruples with the container add to that. The diagonals of neighbouring squares depend on each
            other only through ids. Any joggling gives another diagram.""",
            scene(3 * columns, 2, square(columns, rows)), [0], ["lattice", "permanent", "at-rest"],
            [rows_backwards(columns, rows)], events=(0, 0, 0))
    yield Case(
        "rest-hexagonal-19", """19 equal disks rest on a triangular lattice with rational coordinates (isosceles triangles 2 by 7/4). Nothing
        inside is cotangent, but the outline is symmetric to both axes and so are its circles with the container.""",
        scene(10, 2, triangular(2)), [0], ["lattice", "at-rest", "mirror"], [noise(1)], events=(0, 0, 0))
    yield Case(
        "gliding-3x3", """A 3 by 3 lattice glides with one velocity. Every flip polynomial of lattice squares vanishes identically; in
        floating point it is noise around zero at each evaluation. No real flip comes: towards the wall and away from it
        the same disks stay its neighbours, so that every event in a history of this scene is made of rounding errors.""",
        scene(12, 5, square(3, 3, lambda x, y: (1, 0))), [0, F(5, 2), 5], ["lattice", "permanent", "translating"],
        [rows_backwards(3, 3)], events=(0, 0, 0))
    yield Case(
        "gliding-4x4-obliquely", """A 4 by 4 lattice glides along the direction (3, 4): nine permanently cotangent squares, and no symmetry with the
        container once it is off the centre.
        There is no event: noise at the nine squares must not make one.""",
        scene(14, 6, square(4, 4, lambda x, y: (F(3, 5), F(4, 5)))), [0, 3, 6], ["lattice", "permanent", "translating"],
        [rows_backwards(4, 4)])
    yield Case(
        "growing-3x3", """A 3 by 3 lattice expands uniformly: velocities are proportional to places. Squares stay squares; the polynomials vanish
        although every coordinate of every disk but one changes.""",
        scene(14, 4, square(3, 3, lambda x, y: (x / 2, y / 2))), [0, 2, 4], ["lattice", "permanent", "expanding"],
        [rows_backwards(3, 3)])
    yield Case(
        "spinning-3x3", """A 3 by 3 lattice with the velocities of a rotation: straight motion turns and stretches it, a
        similarity at every instant. All squares stay cotangent while all determinants have degree 4 in time.""",
        scene(14, 4, square(3, 3, lambda x, y: (-y / 2, x / 2))), [0, 2, 4], ["lattice", "permanent", "spinning"],
        [rows_backwards(3, 3)])
    # Velocity of the rotation by the direction (3/5, 4/5) a unit of time, along chords.
    c, s = F(3, 5), F(4, 5)

    def chord(x, y):
        return ((c - 1) * x - s * y, s * x + (c - 1) * y)

    for columns in (2, 3):
        disks = square(columns, columns, chord)
        turns = []
        for k in (1, 2, 3):
            for i, d in enumerate(square(columns, columns)):
                x, y = d.x, d.y
                for _ in range(k):
                    x, y = c * x - s * y, s * x + c * y
                turns.append((k, i, *chord(x, y)))
        yield Case(
            f"turning-by-maneuvers-{columns}x{columns}", f"""A {columns} by {columns} lattice flies the chords of a rotation: at t = 1, 2, 3 all {columns**2} velocities are turned by the
            Pythagorean angle (3, 4, 5) at once. Each maneuver alone would end the permanent cotangency of its squares; all together they
            preserve it. The {columns**2} maneuvers of one instant must be done before any edge is judged.""",
            scene(10, 4, disks, maneuvers=turns), [0, 1, F(3, 2), 4], ["lattice", "permanent", "maneuver", "turning"],
            [dropped("maneuver", -1, "maneuver-lost"), rows_backwards(columns, columns)], picture=2,
            truths=("exact",))
    for columns, rows in ((3, 3), (4, 4)):
        yield Case(
            f"shearing-{columns}x{rows}", f"""A {columns} by {rows} lattice shears: row j moves with velocity proportional to its height. A square becomes a
            parallelogram at t = 0+, at once, so the first diagram is the one for 0+, not the one of the lattice at rest; at t = 2 the rows have moved
            by half a step and at t = 4 by a whole one: there all squares are squares again and
            {(columns - 1) * (rows - 1)} inner quadruples become cocircular at the same instant, with neighbours that are not independent.""",
            scene(4 * columns, 6, square(columns, rows, lambda x, y: (y / 4, 0))), [0, 2, 4, 6], ["lattice", "shear", "tie"],
            [drops_tied_flip()], picture=2)
    yield Case(
        "shearing-both-ways", """Rows of a 4 by 3 lattice move alternately left and right at one speed. Every second unit of time the
        squares are restored and pass; all flips come in ties of a whole row.
        An engine that moves on by an epsilon after each flip finds the rest of the row in the past.""",
        scene(14, 5, square(4, 3, lambda x, y: (F(1, 2) if y else F(-1, 2), 0))), [0, 2, 4], ["lattice", "shear", "tie"],
        [drops_tied_flip()], picture=1)
    yield Case(
        "one-leaves-3x3", """The middle disk of a resting 3 by 3 lattice leaves along a row direction through a side of the lattice: four cotangent
        squares end at t = 0+, two at a time become something else, and the disk passes midway between two of the outer
        ring exactly.""",
        scene(10, 5, [*square(3, 3)[:4], disk(0, 0, F(1, 4), F(1, 2), 1), *square(3, 3)[5:]]), [0, F(1, 2)],
        ["lattice", "permanent", "tie"], [dropped("flip", 0)])
    yield Case(
        "two-lattices-pass", """Two 2 by 3 lattices glide past each other in opposite directions. Within each all is permanently cotangent, between
        them squares form and dissolve, three quadruples in a row at the same instants.""",
        scene(14, 6, [disk(x, y + 1, F(1, 2), 1, 0) for x in (-5, -3, -1) for y in (0, 2)]
              + [disk(x, y - 1, F(1, 2), -1, 0) for x in (1, 3, 5) for y in (0, -2)]),
        [0, 3, 6], ["lattice", "permanent", "tie"], [drops_tied_flip()], picture=1)
