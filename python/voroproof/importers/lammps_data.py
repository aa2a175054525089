"""Data files of LAMMPS (write_data): one configuration, perhaps with velocities."""

from fractions import Fraction
from typing import Dict, Iterator, List, NamedTuple, Optional

from . import boxes, numbers
from .faults import Refused, printable
from .lines import Lines
from .table import Place, Table

NAME = "lammps-data"


class _Style(NamedTuple):
    x: int  # the column of x, from 0; y and z follow
    diameter: Optional[int] = None


STYLES = {
    "atomic": _Style(2), "charge": _Style(3), "bond": _Style(3), "angle": _Style(3), "molecular": _Style(3),
    "full": _Style(4), "sphere": _Style(4, 2),
}


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction], style: Optional[str], until: Optional[Fraction],
                 flatten: bool):
        self.lines = Lines(path)
        self.radius = radius
        self.style_given = style
        self.until = until
        self.heights = boxes.Heights(flatten)
        self.style: Optional[_Style] = None
        self.atoms: Optional[int] = None
        self.places: Dict[str, Place] = {}
        self.radii: Dict[str, Optional[Fraction]] = {}
        self.velocities: Dict[str, Place] = {}

    def number(self, text: str, field: str) -> Fraction:
        try:
            return numbers.decimal(text)
        except ValueError as error:
            self.lines.fail(field, str(error))

    def read(self) -> Table:
        section = ""
        for line in self.lines:
            if self.lines.number == 1:
                continue  # a comment, always
            body, _, comment = line.partition("#")
            words = body.split()
            if not words:
                continue
            if words[0][0].isalpha():
                section = " ".join(words)
                if section == "Atoms":
                    self.begin_atoms(comment.strip())
            elif not section and words[1:] == ["atoms"]:
                self.atoms = self.count(words[0])
            elif section == "Atoms":
                self.atom(words)
            elif section == "Velocities":
                self.velocity(words)
        return self.table()

    def count(self, text: str) -> int:
        try:
            return numbers.integer(text)
        except ValueError as error:
            self.lines.fail("atoms", str(error))

    def begin_atoms(self, said: str) -> None:
        if self.style is not None:
            self.lines.fail("Atoms", "a second section of this name")
        name = self.style_given or said
        if name not in STYLES:
            self.lines.fail("Atoms", (f"the style {printable(name)} is not read" if name else
                                      "no style is said behind a #: give --atom-style")
                            + f"; {', '.join(STYLES)} are")
        self.style = STYLES[name]
        if self.atoms is None:
            self.lines.fail("Atoms", "the head of the file does not say how many")

    def name(self, words: List[str], known: Dict[str, Place], section: str) -> str:
        try:
            name = str(numbers.integer(words[0]))
        except ValueError as error:
            self.lines.fail(f"{section} id", str(error))
        if name in known:
            self.lines.fail(f"{section} id", f"{name} a second time")
        return name

    def atom(self, words: List[str]) -> None:
        x = self.style.x
        if len(words) not in (x + 3, x + 6):
            self.lines.fail("Atoms", f"{len(words)} values, not {x + 3}, or {x + 6} with image flags")
        if len(self.places) == self.atoms:
            self.lines.fail("Atoms", f"more than the {self.atoms} that the head of the file says")
        name = self.name(words, self.places, "Atoms")
        self.places[name] = tuple(self.number(words[x + k], f"Atoms {axis}") for k, axis in enumerate("xyz"))
        self.radii[name] = self.radius
        if self.radius is None and self.style.diameter is not None:
            self.radii[name] = self.number(words[self.style.diameter], "Atoms diameter") / 2

    def velocity(self, words: List[str]) -> None:
        if len(words) < 4:
            self.lines.fail("Velocities", f"{len(words)} values, not 4 at least")
        name = self.name(words, self.velocities, "Velocities")
        self.velocities[name] = tuple(self.number(words[1 + k], f"Velocities v{axis}") for k, axis in enumerate("xyz"))

    def table(self) -> Table:
        self.lines.number = 0
        if self.style is None:
            self.lines.fail("Atoms", "no such section: this is no data file of LAMMPS")
        if self.atoms != len(self.places):
            self.lines.fail("Atoms", f"{len(self.places)} atoms, and the head of the file says {self.atoms}")
        if self.until is not None and self.velocities.keys() != self.places.keys():
            self.lines.fail("Velocities", "not those of the atoms: no motion until a time is known")
        dimension = 2 if self.heights.flatten else 3
        table = Table(self.radius is not None or self.style.diameter is not None, dimension)
        try:
            for name, at in self.places.items():
                samples = [(Fraction(0), at)]
                if self.until is not None:
                    samples.append((self.until, tuple(x + self.until * v for x, v in zip(at, self.velocities[name]))))
                for t, place in samples:
                    self.heights.take(place[2])
                    table.add(name, t, place[:dimension], self.radii[name])
        except Refused as refused:
            self.lines.fail(refused.field, refused.reason)
        table.remarks += self.remarks()
        table.missing.append(boxes.PERHAPS_MISSING)
        return table

    def remarks(self) -> Iterator[str]:
        if self.until is None:
            yield "one instant, t = 0: velocities, where the file has them, are not used (--until gives motion)"
        else:
            yield ("each disk goes on with the velocity that the file gives it until "
                   f"t = {numbers.text(self.until)}; forces and collisions are not in the file")
        yield "lengths and times are in the units of the file, which it does not say"
        if self.radius is not None:
            yield f"the radius of every disk is {numbers.text(self.radius)}, as given"
        elif self.style.diameter is None:
            yield "atoms of this style have no size: give --radius where the table is read"
        yield from self.heights.remarks()
        yield "no digit is lost: decimals are taken as they stand"


def read(path: str, *, radius: Optional[Fraction] = None, style: Optional[str] = None,
         until: Optional[Fraction] = None, flatten: bool = False) -> Table:
    """The atoms of a data file; with `until` > 0 their straight paths from t = 0. Raises InputError."""
    return _Reader(path, radius, style, until, flatten).read()
