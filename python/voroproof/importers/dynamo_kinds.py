"""DynamO's interactions: which holds between which particles, and that all are those of balls with radii."""

from fractions import Fraction
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence, Set, Tuple

from .faults import printable
from .markup import Element, Markup

MOST = 64  # interactions, ranges of particles, and kinds of particles that these tell apart

Value = Callable[[int], Fraction]  # each particle has one
_Matches = Callable[[int, int, bool], bool]  # takes two kinds, and whether one particle is meant twice


class Interaction(NamedTuple):
    element: Element
    diameter: Value
    elasticity: Value


class Ranges:
    """Ranges of particles. Raises InputError."""

    def __init__(self, document: Markup, particles: int):
        self._document = document
        self._particles = particles
        self._count = 0

    def within(self, element: Element) -> Callable[[int], bool]:
        """Whether a particle is in the IDRange in the element."""
        return self.range(self._document.one(element, "IDRange"))

    def range(self, element: Element) -> Callable[[int], bool]:
        """Whether a particle is in the IDRange that the element is."""
        document = self._document
        self._count += 1
        if self._count > MOST:
            document.fail(element, "", f"more than {MOST} ranges of particles in the file")
        kind = document.text(element, "Type")
        if kind == "All":
            return lambda i: True
        if kind == "None":
            return lambda i: False
        if kind == "Ranged":
            first, last = document.integer(element, "Start"), document.integer(element, "End")
            self._require(element, [first, last])
            return range(first, last + 1).__contains__
        if kind == "List":
            listed = {document.integer(one, "val") for one in document.children(element, "ID")}
            self._require(element, sorted(listed))
            return listed.__contains__
        if kind == "Union":
            parts = [self.range(part) for part in document.children(element, "IDRange")]
            return lambda i: any(part(i) for part in parts)
        document.fail(element, "Type", f"{printable(kind)} is not known")

    def _require(self, element: Element, ids: List[int]) -> None:
        if ids and not 0 <= ids[0] <= ids[-1] < self._particles:
            self._document.fail(element, "", f"not in order, or beyond the {self._particles} particles of the file")


class Sizes:
    """The radii and the restitution that the interactions of all pairs of particles come to. Raises InputError."""

    def __init__(self, document: Markup, ranges: Ranges, interactions: Sequence[Interaction], particles: int):
        self.document = document
        self.particles = particles
        self._ranges = ranges
        self._held: List[Callable[[int], bool]] = []
        self._matches = [self._pairs(document.one(one.element, "IDPairRange")) for one in interactions]
        self._interactions = interactions
        self._kinds = self._tell_apart()
        self.radii: List[Fraction] = [Fraction(0)] * particles
        self._restitutions: Set[Fraction] = set()
        self._bounced: Set[Tuple[int, int]] = set()  # interactions and kinds whose restitution is known
        self._excesses: Dict[Tuple[int, int], Optional[Fraction]] = {}
        for kind in range(len(self._kinds)):
            self._size(kind)
        for k in range(len(self._kinds)):
            for other in range(k):
                self._require_sum(other, k)
        self.restitution = self._restitutions.pop() if self._restitutions else Fraction(1)

    def _hold(self, element: Element) -> int:
        """The number of a range of particles."""
        self._held.append(self._ranges.range(element))
        return len(self._held) - 1

    def _pairs(self, element: Element) -> _Matches:
        kind = self.document.text(element, "Type")
        if kind == "All":
            return lambda a, b, same: True
        if kind == "None":
            return lambda a, b, same: False
        if kind in ("Single", "Self"):
            held = self._hold(self.document.one(element, "IDRange"))
            return lambda a, b, same: self._has(a, held) and self._has(b, held) and (same or kind == "Single")
        if kind == "Pair":
            ranges = self.document.children(element, "IDRange")
            if len(ranges) != 2:
                self.document.fail(element, "IDRange", f"{len(ranges)}, not two")
            p, q = map(self._hold, ranges)
            return lambda a, b, same: (self._has(a, p) and self._has(b, q)) or (self._has(b, p) and self._has(a, q))
        if kind == "Union":
            parts = [self._pairs(part) for part in self.document.children(element, "IDPairRange")]
            if len(parts) > MOST:
                self.document.fail(element, "IDPairRange", f"more than {MOST}")
            return lambda a, b, same: any(part(a, b, same) for part in parts)
        self.document.fail(element, "Type", f"{printable(kind)} is not read: here ranges of particles make pairs")

    def _has(self, kind: int, held: int) -> bool:
        return self._held[held](self._kinds[kind][0])

    def _tell_apart(self) -> List[List[int]]:
        """The particles of each kind: those of one kind are in the same ranges."""
        kinds: Dict[Tuple[bool, ...], List[int]] = {}
        for i in range(self.particles):
            kinds.setdefault(tuple(holds(i) for holds in self._held), []).append(i)
            if len(kinds) > MOST:
                self.document.fail(self._interactions[0].element, "",
                                   f"the ranges of interactions tell more than {MOST} kinds of particles apart")
        return list(kinds.values())

    def _between(self, a: int, b: int, same: bool) -> int:
        """The first interaction in the file that holds, as DynamO has it."""
        for number, matches in enumerate(self._matches):
            if matches(a, b, same):
                return number
        i, j = self._kinds[a][0], self._kinds[b][-1]
        self.document.fail(self._interactions[0].element, "IDPairRange",
                           f"no interaction holds between particles {i} and {j}")

    def _size(self, kind: int) -> None:
        members = self._kinds[kind]
        number = self._between(kind, kind, len(members) == 1)
        interaction = self._interactions[number]
        for i in members:
            self.radii[i] = interaction.diameter(i) / 2
            if self.radii[i] < 0:
                self.document.fail(interaction.element, "Diameter", f"negative for particle {i}")
        if len(members) > 1:
            self._bounce(number, kind)

    def _require_sum(self, a: int, b: int) -> None:
        """Particles of the two kinds touch where the distance is the sum of their radii."""
        number = self._between(a, b, False)
        excess = self._excess(number, a), self._excess(number, b)
        if None in excess or sum(excess) != 0:
            i, j = self._kinds[a][0], self._kinds[b][0]
            self.document.fail(self._interactions[number].element, "Diameter", f"particles {i} and {j} do not touch where "
                               "the distance is the sum of their radii: a billiard has additive diameters")
        self._bounce(number, a)
        self._bounce(number, b)

    def _excess(self, number: int, kind: int) -> Optional[Fraction]:
        """By how much the interaction's diameter is more than that of each particle; None if not by one number."""
        if (number, kind) not in self._excesses:
            diameter = self._interactions[number].diameter
            found = {diameter(i) - 2 * self.radii[i] for i in self._kinds[kind]}
            self._excesses[number, kind] = found.pop() if len(found) == 1 else None
        return self._excesses[number, kind]

    def _bounce(self, number: int, kind: int) -> None:
        """Particles of the kind that collide by the interaction have the one restitution."""
        if (number, kind) in self._bounced:
            return
        self._bounced.add((number, kind))
        interaction = self._interactions[number]
        self._restitutions.update(map(interaction.elasticity, self._kinds[kind]))
        if not 0 <= min(self._restitutions) <= max(self._restitutions) <= 1:
            self.document.fail(interaction.element, "Elasticity", "not from 0 to 1")
        if len(self._restitutions) > 1:
            self.document.fail(interaction.element, "Elasticity",
                               "not one for all pairs: a billiard has one restitution between disks")
