"""The judge: which tellings of the flips of an instant are right.

The rules are those of docs/formats.md, sections 6 and 8. A telling is a list of claims, in the
order of the file: {"t": time, "flip": V-edge} or {"t": time, "maneuver": disk}. It is judged from
the diagram before the first of the world's instants.
"""
from fractions import Fraction

from apollonius import circle, in_circle, turns_left
from diagrams import name, vertices

TOLERANCE = Fraction(1, 10 ** 6)
RIGHT, WRONG, UNCLEAR = "right", "wrong", "unclear"
# Just after an instant is so much later. The numbers of the worlds are small, so that no in-circle
# function that is not zero throughout has another zero so near.
SOON = Fraction(1, 2 ** 300)


class NotClear(Exception):
    """An in-circle function vanishes just after an instant, but not throughout."""


class Judge:
    def __init__(self, world):
        self.world = world
        self.known = {}

    def is_legal(self, edge, t):
        """The V-edge is legal just after t: where it stays cotangent, by the rule of the ids."""
        key = "legal", name(edge), t
        if key not in self.known:
            l, r, s, e = edge
            value = 1 if s == e else self.in_circle(edge, t + SOON)
            if value == 0 and self.in_circle(edge, t + SOON / 3) != 0:
                raise NotClear
            # A V-edge from one circle of the four to its mirror image is legal.
            self.known[key] = value > 0 or value == 0 and (
                max(l, r) > max(s, e) or not self.collapses(edge, t + SOON))
        return self.known[key]

    def in_circle(self, edge, t):
        """The sign of the in-circle function of a V-edge whose two circles exist."""
        l, r, s, e = edge
        generators = self.world.generators(t)
        first, second = circle(generators, l, s, r), circle(generators, l, r, e)
        if first is None or second is None:
            raise NotClear
        signs = in_circle(generators, first, e), in_circle(generators, second, s)
        return 0 if 0 in signs else min(signs)

    def collapses(self, edge, t):
        """The two vertices of the V-edge are one at t. A mirror image is another vertex."""
        key = "collapses", name(edge), t
        if key not in self.known:
            l, r, s, e = edge
            generators = self.world.generators(t)
            found = None if s == e else circle(generators, l, s, r)
            self.known[key] = (found is not None and in_circle(generators, found, e) == 0
                               and turns_left(generators, found, l, r, e))
        return self.known[key]

    def is_all_legal(self, diagram, t):
        return all(self.is_legal(edge, t) for edge in diagram.edges)

    def collapsed(self, diagram, t):
        """The V-edges, legal or not, that a circle of four generators lets flip at t."""
        return sorted(edge for edge in diagram.edges
                      if self.collapses(edge, t) and diagram.flipped(edge) is not None)

    def due(self, diagram, t):
        return [edge for edge in self.collapsed(diagram, t) if not self.is_legal(edge, t)]

    def judge(self, diagram, claims):
        try:
            return self.verdict(diagram, claims)
        except NotClear:
            return UNCLEAR

    def verdict(self, diagram, claims):
        flips = [claim["flip"] for claim in claims if "flip" in claim]
        if self.world.is_at_start and (flips or not self.is_all_legal(diagram, Fraction(0))):
            return WRONG  # the first diagram is that after all flips at 0
        told = diagram
        for edge in flips:
            told = told.flipped(edge)
            if told is None:
                return WRONG
        if sum("maneuver" in claim for claim in claims) != (self.world.maneuver is not None):
            return WRONG
        if not Search(self, claims).succeeds(0, diagram, 0):
            return WRONG
        return UNCLEAR if self.has_flip_before_its_turn(claims) else RIGHT

    def has_flip_before_its_turn(self, claims):
        """A flip is told before the maneuver of one of its disks, and collapses at that instant.

        By section 8 that depends on whether its V-edge would collapse without the maneuver.
        """
        kinds = ["maneuver" in claim for claim in claims]
        if True not in kinds:
            return False
        t, disk, _ = self.world.maneuver
        return any(disk in claim["flip"] and self.collapses(claim["flip"], t)
                   for claim in claims[:kinds.index(True)])


class Search:
    """Whether some order of the claims is right.

    Claims that do not commute keep the file's order. Two flips commute where no vertex goes or
    comes with both. A flip commutes with a maneuver.
    """

    def __init__(self, judge, claims):
        self.judge, self.claims = judge, claims
        self.instants = judge.world.instants
        self.all = (1 << len(claims)) - 1  # sets of claims are bits
        self.seen = set()
        touched = [vertices(claim["flip"]) if "flip" in claim else set() for claim in claims]
        self.needed = [sum(1 << y for y in range(x) if touched[x] & touched[y])
                       for x in range(len(claims))]

    def succeeds(self, done, diagram, instant):
        """From the diagram after the claims `done`, at the instant of this number."""
        state = done, diagram.edges, instant
        if state in self.seen:
            return False
        self.seen.add(state)
        t = self.instants[instant]
        maneuver = self.maneuver_at(t)
        if maneuver is not None:
            if not self.is_near(maneuver, t):
                return False
            done |= 1 << maneuver  # before all flips of its instant
        if self.judge.is_all_legal(diagram, t):
            if instant + 1 < len(self.instants):
                if self.succeeds(done, diagram, instant + 1):
                    return True
            elif done == self.all:
                return True
        return any(self.succeeds(done | 1 << x, diagram.flipped(self.claims[x]["flip"]), instant)
                   for x in self.next_flips(done, diagram, t))

    def maneuver_at(self, t):
        if self.judge.world.maneuver is None or self.judge.world.maneuver[0] != t:
            return None
        return next(x for x, claim in enumerate(self.claims) if "maneuver" in claim)

    def next_flips(self, done, diagram, t):
        due = set(self.judge.due(diagram, t))
        return [x for x, claim in enumerate(self.claims)
                if "flip" in claim and not done >> x & 1 and self.needed[x] & ~done == 0
                and self.is_near(x, t) and name(claim["flip"]) in due]

    def is_near(self, x, t):
        return abs(self.claims[x]["t"] - t) <= TOLERANCE
