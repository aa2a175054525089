"""Tellings of the flips of a world's instants, right ones and others.

A telling is a list of claims as judge.py has it, which says whether it is right. A variant is a
pair (first diagram, telling); the first diagram is None where it is that of `simulate`.
"""
from fractions import Fraction

from diagrams import Diagram, back, without_orientation

MOST_FLIPS = 14  # per telling: the judge tries all orders
OFF = 15         # ten-millionths: more than the tolerance, and WITHIN is less
WITHIN = 9


class TooLong(Exception):
    """The flips of an instant are more than MOST_FLIPS."""


class Variants:
    def __init__(self, world, judge, diagram, rng):
        self.world, self.judge, self.diagram, self.rng = world, judge, diagram, rng
        self.times = [rounded(t) for t in world.instants]

    def some(self, count):
        """As many variants as `count`, or fewer: no two are the same."""
        found = []
        for _ in range(2 * count):
            variant = self.at_start() if self.world.is_at_start else (None, self.telling())
            if variant not in found and len(found) < count:
                found.append(variant)
        return found

    def telling(self):
        kinds = [self.path, self.path, self.one_left_out, self.there_and_back, self.detour,
                 self.another_end, self.shuffled, self.turn_moved]
        return self.with_times(self.rng.choice(kinds)())

    def path(self, diagram=None, flips=()):
        """A path that flips any due edge at each instant again and again, after the `flips` of the first instant."""
        diagram = diagram or self.diagram
        claims = [self.flip(edge, self.times[0]) for edge in flips]
        for t, written in zip(self.world.instants, self.times):
            if self.world.maneuver and self.world.maneuver[0] == t:
                claims.append({"t": t, "maneuver": self.world.maneuver[1]})
            while due := self.judge.due(diagram, t):
                edge = self.rng.choice(due)
                diagram = diagram.flipped(edge)
                claims.append(self.flip(edge, written))
                if len(claims) > MOST_FLIPS:
                    raise TooLong
        return claims

    @staticmethod
    def flip(edge, t):
        return {"t": t, "flip": edge}

    def one_left_out(self):
        return self.without(self.path())

    def without(self, claims):
        """The claims without one, if there is one."""
        left = self.rng.randrange(len(claims)) if claims else 0
        return claims[:left] + claims[left + 1:]

    def there_and_back(self):
        """A flip on the way, and the flip that undoes it."""
        claims = self.path()
        at = self.rng.randint(0, len(claims))
        edge = self.some_edge(self.after(claims[:at]))
        pair = [self.flip(q, self.times[0]) for q in (edge, back(edge))] if edge else []
        return claims[:at] + pair + claims[at:]

    def detour(self):
        """Up to two flips that are not due, and what is due then."""
        diagram, flips = self.diagram, []
        for _ in range(self.rng.choice([1, 1, 2])):
            if edge := self.some_edge(diagram):
                diagram, flips = diagram.flipped(edge), flips + [edge]
        return self.path(diagram, flips)

    def another_end(self):
        """One flip that is not due behind a right telling."""
        claims = self.path()
        edge = self.some_edge(self.after(claims))
        return claims + ([self.flip(edge, self.times[-1])] if edge else [])

    def shuffled(self):
        """Two neighbours exchanged, or all in any order."""
        claims = self.path()
        if self.rng.random() < 0.5:
            self.rng.shuffle(claims)
        elif len(claims) > 1:
            x = self.rng.randrange(len(claims) - 1)
            claims[x], claims[x + 1] = claims[x + 1], claims[x]
        return claims

    def turn_moved(self):
        claims = self.path()
        turns = [claim for claim in claims if "maneuver" in claim]
        flips = [claim for claim in claims if "flip" in claim]
        at = self.rng.randint(0, len(flips))
        return flips[:at] + turns + flips[at:]

    def some_edge(self, diagram):
        """One that collapses at an instant, legal or not; else any that can be flipped."""
        edges = [edge for t in self.world.instants for edge in self.judge.collapsed(diagram, t)]
        edges = edges or sorted(edge for edge in diagram.edges if diagram.flipped(edge) is not None)
        return self.rng.choice(edges) if edges else None

    def after(self, claims):
        diagram = self.diagram
        for claim in claims:
            if "flip" in claim:
                diagram = diagram.flipped(claim["flip"])
        return diagram

    def with_times(self, claims):
        """Times within the tolerance, or one of them beyond it; and so that none decreases."""
        claims = [dict(claim) for claim in claims]
        if claims and self.rng.random() < 0.35:
            offs = sorted(self.rng.randint(-WITHIN, WITHIN) for _ in claims)
            if self.rng.random() < 0.3:
                offs[self.rng.randrange(len(offs))] = self.rng.choice([-OFF, OFF])
            for claim, off in zip(claims, offs):
                claim["t"] += Fraction(off, 10 ** 7)
        latest = Fraction(0)
        for claim in claims:
            latest = max(latest, min(rounded(claim["t"]), rounded(self.world.horizon)))
            claim["t"] = latest
        return claims

    def at_start(self):
        """Another first diagram, or the right one, and flips at 0 or soon after it."""
        diagram, flips = self.diagram, []
        for _ in range(self.rng.choice([1, 1, 2, 3])):
            if edge := self.some_edge(diagram):
                diagram, flips = diagram.flipped(edge), flips + [edge]
        undone = [back(edge) for edge in reversed(flips)]
        turn = [claim for claim in self.path() if "maneuver" in claim]
        first, told = self.rng.choice([(diagram, []), (diagram, undone), (None, flips + undone),
                                       (None, flips)])
        t = self.rng.choice([Fraction(0), Fraction(1, 2 ** 30), Fraction(1, 2 ** 21)])
        return first, turn + [self.flip(edge, t) for edge in told]


def without_orientations(diagram, claims, rng):
    """The telling with some quadruplets that have lost their orientation; None where none can.

    A quadruplet without orientation must not be the name of another V-edge on the way.
    """
    diagrams = [diagram]
    for claim in claims:
        if "flip" in claim:
            diagrams.append(diagrams[-1].flipped(claim["flip"]))
    changed = []
    for claim in claims:
        edge = without_orientation(claim["flip"]) if "flip" in claim else None
        if edge and rng.random() < 0.7 and not any(other.has(edge) for other in diagrams):
            changed.append({**claim, "flip": edge})
        else:
            changed.append(claim)
    return changed if changed != claims else None


def rounded(t):
    return Fraction(float(t))


def first_diagram(edges):
    return Diagram(tuple(edge) for edge in edges)
