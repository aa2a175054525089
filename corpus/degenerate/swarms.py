"""Formation flights: many equal disks that start, arrive and turn together."""
from degenerate.case import Case, family
from degenerate.scene import Generated
from degenerate.wrong import dropped, drops_tied_flip, reversed_tie


def flight(*words):
    return Generated(("formation", *words))


@family("swarms", "formation flights of 9 to 58 equal disks, which leave and reach lattices, letters and circles together")
def swarms():
    yield Case(
        "square-to-circle-20", """20 vehicles on the sides of a square fly straight to the points of a circle and stop there together, at t = 16 (Figs. 24
        to 26 of the paper). The places are exactly on one circle, so that at that instant all 4,845 quadruples become cotangent and, since the
        vehicles stay, remain so: 20 maneuvers and then a whole triangulation of the 20-gon by the rule of the largest id, at one time. An engine that
        judges edges after each maneuver, or rounds the places of arrival, ends with one of the other triangulations.""",
        flight("--preset", "figure24"), [0, 8, 16, 32], ["swarm", "equal-radii", "maneuver", "permanent", "tie"],
        [drops_tied_flip(-1), reversed_tie(), dropped("maneuver", -1, "maneuver-lost")], picture=2)
    yield Case(
        "h-to-y-19", """19 drones in the shape of an H rearrange to a Y (Fig. 1d of the paper). Both letters are straight strokes of equally spaced equal
        disks: collinear centres, mirror images, lattice squares that are cotangent only until the flight begins and when it ends.
        In between a disk passes along a stroke, and three, four or five edges flip at one instant about one vertex; two such flips make and
        consume a cell of two edges.""",
        flight("--preset", "h-to-y"), [0, 8, 16, 32], ["swarm", "equal-radii", "maneuver", "collinear", "tie"],
        [drops_tied_flip(), dropped("maneuver", 0, "maneuver-lost")], picture=1)
    yield Case(
        "segments-58", """58 drones fly eight segments: from a square turning, to rings, east, to an H, a Y, west, to a circle, to staggered rows. At each joint 58
        maneuvers have one instant, and before and after it the same disks form a lattice, circles or strokes, with other
        quadruples that stay cotangent. An engine that judges an edge between two of the 58 maneuvers, or predicts from old velocities of some
        and new ones of others, flips edges that stay.""",
        flight("--preset", "segments58"), [0, 80], ["swarm", "equal-radii", "maneuver", "permanent", "tie"],
        [drops_tied_flip()])
    yield Case(
        "lattice-turns-and-shears-9", """Nine disks in a square lattice turn by the angle of (3, 4, 5), shear, spread, rest, and turn again, all by straight flights with common
        joints at multiples of 16. While they turn or spread the lattice stays similar to itself, and what was cotangent remains so with no polynomial
        that is constant. The shear ends four cotangencies at its joint, passes through a lattice of rectangles, where four diagonals flip at one
        instant, and leaves parallelograms, of which none is cotangent.""",
        flight("--n", "9", "--horizon", "96", "--flight", "square,turn,shear,spread,rest,turn"), [0, 16, 24, 30, 96],
        ["swarm", "equal-radii", "maneuver", "permanent", "tie", "lattice", "shear"],
        [drops_tied_flip(), dropped("maneuver", 0, "maneuver-lost")], picture=2)
    yield Case(
        "rings-to-square-to-circle-16", """16 disks fly from rings to a square lattice and, at t = 16, straight on to a circle, where they stop at t = 32. The nine lattice squares are cotangent at t = 16 alone, the
        instant at which all velocities change: whether an edge flips there depends on the velocities after all
        maneuvers. The circle begins at t = 32 and stays, with 24 flips of that instant.""",
        flight("--n", "16", "--horizon", "48", "--flight", "rings,square,circle"), [0, 16, 24, 32],
        ["swarm", "equal-radii", "maneuver", "instant", "permanent", "tie"], [drops_tied_flip(-1), reversed_tie()], picture=1)
