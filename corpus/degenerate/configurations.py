"""Configurations I, X and W, every kind of flip, and shadows: Figs. 7 to 17 of the paper."""
from fractions import Fraction as F

from degenerate.case import Case, family
from degenerate.scene import disk, scene
from degenerate.wrong import (dropped, drops_tied_flip, edited, inserted_flip, late)


def jaws(*more):
    """Two large disks left and right of a gap of width 4, and what is between them."""
    return [disk(-6, 0, 4), disk(6, 0, 4), *more]


def tall_jaws(*more):
    """A gap of width 4 again, between disks so large that several trapped cells fit above each other."""
    return [disk(-12, 0, 10), disk(12, 0, 10), *more]


def tiny(x, y, vx=0, vy=0, r=F(1, 4)):
    return disk(x, y, r, vx, vy)


def instead(k, quad, kind):
    """The k-th flip is claimed for another edge of the same four."""
    def edit(history, events):
        events[history.indices("flip")[k]]["flip"] = quad
        return events
    return edited("wrong-edge-of-four", kind, edit)


@family("configurations", "Configurations I, X and W and the flips of the paper's Figs. 7 to 15")
def configurations():
    yield Case(
        "fig07-ordinary", """Four equal disks on the corners of a square, one moving along a diagonal
        towards the opposite corner: the Ordinary Flip of Fig. 7. All radii are equal, so the cotangency
        polynomial f is minus a square and its root, where the four become cocircular, is double: an engine that looks
        for sign changes of f never flips here.""",
        scene(12, 4, [disk(-3, 0, 1), disk(0, -3, 1), disk(3, 0, 1), disk(0, 5, 1, 0, -1)]), [0, 2, 4],
        ["ordinary", "equal-radii", "fig7"], [dropped("flip")], picture=1, events=(1, 0, 0))
    yield Case(
        "fig08-two-edge-cell", """A tiny disk inside the convex hull of two large ones: its cell has two edges, between
        two vertices with the same three generators in opposite orientations, and both edges have the same generator
        at both ends. Vertices must be told apart by orientation; a table keyed by sorted
        triples loses one of them.""",
        scene(20, 5, [*jaws(tiny(0, 0)), disk(0, 9, 2), disk(0, -9, 2)]), [0], ["two-edge-cell", "fig8", "at-rest"],
        [inserted_flip(1, [0, 2, 1, 1], "even-root-taken", "spurious event")], events=(0, 0, 0))
    yield Case(
        "fig09-3-to-2", """A tiny disk slides from the left cell boundary into the hull of two large disks: the triangular cell loses
        its edge with the disk above and keeps two. All three edges of a triangular cell have
        the same four generators, so all three have this root; exactly one of them shrinks. Choosing the first in the
        queue flips an edge of positive length.""",
        scene(20, 6, [*jaws(tiny(F(1, 4), 5, 0, -1)), disk(0, 10, 3)]), [0, 4, 6], ["3-to-2", "fig9"],
        [dropped("flip", 0)], flips={"3-to-2": 1})
    yield Case(
        "fig09-2-to-3", """The way back: the tiny disk leaves the hull of the two large ones. The edges of its two-edge
        cell have no polynomial at all; the flip is that of the connecting edge above. An engine that
        predicts from the edges of the moving cell alone predicts nothing.""",
        scene(20, 6, [*jaws(tiny(F(1, 4), -1, 0, 1)), disk(0, 10, 3)]), [0, 4, 6], ["2-to-3", "fig9"],
        [dropped("flip")], flips={"2-to-3": 1})
    yield Case(
        "fig09-3-to-2-mirrored", """Two tiny disks enter two gaps between three large ones, mirror images in the
        vertical axis: two 3-to-2 flips at the same instant, each with three edges that
        share its root. Six edges are due and two flip.""",
        scene(20, 5, [disk(-12, 0, 4), disk(0, 0, 4), disk(12, 0, 4), tiny(F(-23, 4), 5, 0, -1),
                      tiny(F(23, 4), 5, 0, -1), disk(-6, 10, 3), disk(6, 10, 3)]), [0, 5],
        ["3-to-2", "mirror", "tie", "fig9"],
        [drops_tied_flip()], flips={"3-to-2": 2})
    yield Case(
        "fig10-through-the-gap", """A tiny disk runs through the gap between two large ones, from an ordinary cell
        to a triangular one, to two edges, and back again on the other side: the whole of
        Fig. 10, symmetric in time about t = 8, where it crosses the axis.""",
        scene(20, 16, [*jaws(tiny(0, 8, 0, -1)), disk(-3, 12, 2), disk(4, 12, 2), disk(-3, -12, 2), disk(4, -12, 2)]),
        [0, 8, 16], ["3-to-2", "2-to-3", "fig10"], [dropped("flip", 1), dropped("flip", -1, "stops-early")], picture=1)
    yield Case(
        "fig11-24-to-33", """Configuration I becomes X. One trapped disk hides behind the other, and the bisector of the
        outer trapped disk and one jaw is cut into two edges of the same crossing and traversing pairs:
        same four generators, same root, same unordered quadruple. Only one of them shrinks; the names
        [l,r,s,e] tell them apart by orientation alone.""",
        scene(20, F(3, 2), jaws(tiny(1, F(1, 2)), tiny(F(1, 4), F(1, 2), 0, 1))), [0, 1, F(3, 2)],
        ["24-to-33", "configuration-I", "configuration-X", "fig11"], [dropped("flip")],
        flips={"24-to-33": 1})
    yield Case(
        "fig12-two-pairs", """Three tiny disks one behind the other before the right jaw: a nest of two-edge cells. Two pairs of
        edges have one root each, at different times, and in each pair one of two edges flips.""",
        scene(20, 6, jaws(tiny(F(5, 4), 0), tiny(F(1, 2), 0, 0, F(1, 4)), tiny(F(-1, 4), 0, 0, 1))), [0, 3, 6],
        ["24-to-33", "configuration-I", "fig12"], [dropped("flip")])
    yield Case(
        "fig13-33-to-24", """Configuration X becomes I: all five edges of the two triangular cells have the same four
        generators and the same root. Five candidates, one flip, and after it two of the remaining edges
        have the same unordered quadruple.""",
        scene(20, 6, jaws(tiny(F(-1, 4), 2), tiny(F(-1, 4), -1, F(-1, 4), F(1, 2)))), [0, 6],
        ["33-to-24", "configuration-X", "fig13"], [dropped("flip")], flips={"33-to-24": 1})
    yield Case(
        "fig14-w-to-x", """Configuration W: two trapped two-edge cells, one above the other, with a connecting edge of the two
        jaws between them. Its vertices are those of two triples, each in both orientations; the connecting edge flips
        when the tiny disks come near and Configuration X results (22-to-33). Before the flip the diagram
        and another one have the same set of vertices: only edges tell which is meant.""",
        scene(30, 4, tall_jaws(tiny(F(1, 4), 3), tiny(F(-1, 4), -3, 0, F(1, 2)))), [0, 4],
        ["22-to-33", "configuration-W", "fig14"], [dropped("flip")], flips={"22-to-33": 1})
    yield Case(
        "fig14-x-to-w", """The 33-to-22 flip: two adjacent trapped cells of three edges lose their common edge and become two
        isolated two-edge cells. Afterwards neither cell has an edge that could flip.
        An engine that looks for events at a moving cell's own edges never joins them again.""",
        scene(30, 4, tall_jaws(tiny(F(1, 4), 3), tiny(F(-1, 4), -1, 0, F(-1, 2)))), [0, 4],
        ["33-to-22", "configuration-W", "fig14"], [dropped("flip")], flips={"33-to-22": 1})
    yield Case(
        "fig14-w-opens", """Configuration W whose upper connecting edge flips: the upper trapped disk meets the cell of the disk above
        and gets a third edge (Fig. 14, from e15). The edge between the two trapped cells is not
        concerned, though it has both jaws in common with the one that flips.""",
        scene(30, 5, [*tall_jaws(tiny(F(1, 4), 1, 0, F(1, 2)), tiny(F(-1, 4), -4)), disk(0, 15, 8)]), [0, 5],
        ["2-to-3", "configuration-W", "fig14"], [dropped("flip")], flips={"2-to-3": 1})
    yield Case(
        "fig15-there-and-back", """Two tiny disks pass each other in the gap: W, X, W again with the roles of the disks exchanged.
        The diagram after the passage has the same vertices up to the exchange of two ids.""",
        scene(20, 12, jaws(tiny(F(3, 4), 3, 0, F(-1, 2)), tiny(F(-3, 4), -3, 0, F(1, 2)))), [0, 6, 12],
        ["configuration-W", "configuration-X", "fig15"], [dropped("flip"), dropped("flip", -1, "stops-early")], picture=1)
    yield Case(
        "tie-of-24-to-33-and-back", """Two equal tiny disks exchange their vertical order. At t = 8 both lie on the horizontal axis,
        diagonally opposite in the gap, and the four generators are cotangent to two circles at once, one above, one below,
        mirror images: one edge of each pair shrinks at the same instant. A 24-to-33 and a 33-to-24 flip
        happen together; a tie-break that takes the second for the return of the first drops both.""",
        scene(20, 12, jaws(tiny(F(-1, 2), 1), tiny(F(1, 2), -1, 0, F(1, 4)))), [0, 8, 12],
        ["24-to-33", "33-to-24", "tie"], [drops_tied_flip()], picture=1, flips={"24-to-33": 1, "33-to-24": 1})
    yield Case(
        "two-vertices-one-triple", """A tiny disk crosses the gap of two large ones exactly on the axis of symmetry
        x = 0, with nobody else about but the container: it is the third corner of the container's triple above, then below. The
        flips are 22-to-33 and 33-to-22 with the container as a trapped neighbour's partner, at
        rational times, t = 4 and t = 8.""",
        scene(20, 8, jaws(tiny(0, 6, 0, -1, F(1, 2)))), [0, 4, 6, 8], ["22-to-33", "33-to-22", "container"],
        [dropped("flip"), late(0, F(1, 1000))], picture=2, flips={"22-to-33": 1, "33-to-22": 1})
