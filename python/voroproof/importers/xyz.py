"""xyz files: frames of a count, a comment and a line for each atom.

A comment of the extended form gives the box (Lattice, pbc), the time (Time) and the columns (Properties); its keys and
the names of properties are read in capitals and small letters alike. Without Properties an atom is a name and x, y, z.
"""

import re
from fractions import Fraction
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

from . import boxes, numbers
from .faults import Refused, printable
from .lines import Frames
from .table import Table

NAME = "xyz"

_WORD = re.compile(r"""=|"[^"]*"|'[^']*'|[^\s="']+""")
_KEYS = ("lattice", "pbc", "time", "properties")
_STEP = re.compile(r"\s*Atoms\. Timestep: ([0-9]{1,18})\s*")  # as LAMMPS writes
_MOST_COLUMNS = 1000


class _Column(NamedTuple):
    kind: str  # S, R, I or L
    first: int
    count: int


class _Columns(NamedTuple):
    named: Dict[str, _Column]
    count: Optional[int]  # None: there may be more than those named


_PLAIN = _Columns({"species": _Column("S", 0, 1), "pos": _Column("R", 1, 3)}, None)


class _Frame(NamedTuple):
    t: Fraction
    atoms: int
    columns: _Columns
    sides: Optional[List[Fraction]]  # None: the file gives no box
    periodic: List[Optional[bool]]


class _Reader(Frames):

    def __init__(self, path: str, radius: Optional[Fraction], timestep: Optional[Fraction], periodic: Optional[str],
                 flatten: bool):
        super().__init__(path)
        self.radius = radius
        self.timestep = timestep
        self.treatment = periodic
        self.heights = boxes.Heights(flatten)
        self.table: Optional[Table] = None
        self.columns = _PLAIN
        self.species: List[str] = []  # where atoms have no ids
        self.frames = 0
        self.timed: Optional[str] = None  # by what frames have times
        self.images = boxes.Images()

    def read(self) -> Table:
        for line in self.rest:
            if line.strip():
                atoms = self.integer(line, "count")
                if atoms < 0:
                    self.fail("count", "negative")
                self.atoms(self.head(atoms, self.line("comment")))
        if self.table is None:
            self.lines.number = 0
            self.fail("", "no frame: this is no xyz file")
        self.table.remarks += self.remarks()
        self.images.tell(self.table)
        return self.table

    def head(self, atoms: int, comment: str) -> _Frame:
        keys = self.keys(comment)
        columns = self.properties(keys["properties"]) if "properties" in keys else _PLAIN
        if self.frames and columns != self.columns:
            self.fail("Properties", "other columns than in the frame before")
        self.columns = columns
        sides, upright = self.lattice(keys["lattice"]) if "lattice" in keys else (None, True)
        periodic = self.periodic(keys["pbc"]) if "pbc" in keys else [None] * 3
        if not upright and periodic != [False] * 3:
            self.fail("Lattice", "a tilted box; only boxes along the axes are read")
        if sides is None and True in periodic:
            self.fail("pbc", "periodic, and no Lattice")
        return _Frame(self.time(keys.get("time"), _STEP.fullmatch(comment)), atoms, columns, sides, periodic)

    def keys(self, comment: str) -> Dict[str, str]:
        """The values of those keys of the comment that mean something here."""
        found: Dict[str, str] = {}
        words = _WORD.findall(comment)
        for key, equals, value in zip(words, words[1:], words[2:]):
            if equals == "=" and key.lower() in _KEYS:
                if key.lower() in found:
                    self.fail(key, "a second time")
                found[key.lower()] = value.strip("\"'")
        return found

    def time(self, time: Optional[str], step: Optional["re.Match[str]"]) -> Fraction:
        timed = "time" if time is not None else "step" if step is not None else "frame"
        if self.timed not in (None, timed):
            self.fail("comment", f"a frame with a {timed}, after those with a {self.timed}")
        self.timed = timed
        if time is not None:
            if self.timestep is not None:
                self.fail("Time", "the file has its own times: --timestep has no use")
            return self.number(time, "Time")
        count = int(step[1]) if step is not None else self.frames
        return count * (self.timestep if self.timestep is not None else Fraction(1))

    def properties(self, text: str) -> _Columns:
        words = text.split(":")
        named: Dict[str, _Column] = {}
        first = 0
        if len(words) % 3 != 0:
            self.fail("Properties", "not triples of a name, a type and a number of columns")
        for name, kind, number in zip(words[::3], words[1::3], words[2::3]):
            count = self.integer(number, "Properties")
            if kind not in ("S", "R", "I", "L") or not 0 < count <= _MOST_COLUMNS:
                self.fail("Properties",
                          f"{printable(name)} is not of a type S, R, I or L with 1 to {_MOST_COLUMNS} columns")
            if name.lower() in named:
                self.fail("Properties", f"{printable(name)} a second time")
            named[name.lower()] = _Column(kind, first, count)
            first += count
        if "pos" not in named or named["pos"].kind != "R" or named["pos"].count not in (2, 3):
            self.fail("Properties", "no pos:R:3 or pos:R:2")
        for name, kinds in (("id", "SI"), ("radius", "RI"), ("species", "SI")):
            if name in named and (named[name].kind not in kinds or named[name].count != 1):
                self.fail("Properties", f"{name} is not one column of a type {' or '.join(kinds)}")
        return _Columns(named, first)

    def lattice(self, text: str) -> Tuple[List[Fraction], bool]:
        """The sides of the box, and whether they are along the axes."""
        values = [self.number(word, "Lattice") for word in text.split()]
        if len(values) != 9:
            self.fail("Lattice", f"{len(values)} numbers, not 9")
        return values[::4], not any(value for k, value in enumerate(values) if k % 4)

    def periodic(self, text: str) -> List[Optional[bool]]:
        meaning = {"T": True, "1": True, "TRUE": True, "F": False, "0": False, "FALSE": False}
        words = text.upper().split()
        if len(words) not in (2, 3) or not all(word in meaning for word in words):
            self.fail("pbc", "not two or three of T and F")
        return [meaning[word] for word in words] + [False] * (3 - len(words))

    def side(self, frame: _Frame, k: int) -> None:
        """Refuses a periodic side of the box with which nothing is to be done."""
        if frame.periodic[k] is False or frame.sides is None:
            return
        if frame.sides[k] <= 0:
            self.fail("Lattice", "no positive length")
        if self.treatment == boxes.UNWRAP:
            self.fail("Lattice", "an xyz file has no image flags by which coordinates could be unwrapped")
        try:
            boxes.side("xyz"[k], frame.periodic[k], self.treatment)
        except ValueError as error:
            self.fail("Lattice", str(error))

    def atoms(self, frame: _Frame) -> None:
        dimension = frame.columns.named["pos"].count
        for k in range(dimension):
            self.images.take(k, frame.periodic[k], frame.sides[k] if frame.sides else None)
        for k in range(2):
            self.side(frame, k)
        if self.table is None:
            self.table = Table(self.radius is not None or "radius" in frame.columns.named,
                               2 if self.heights.flatten else dimension)
        if "id" not in frame.columns.named and self.frames and frame.atoms != len(self.species):
            self.fail("count", "another number of atoms than before: they have no ids, so that nothing tells which are "
                      "gone or new")
        for i in range(frame.atoms):
            row = self.line("atom").split()
            columns = frame.columns.count
            if len(row) != columns if columns is not None else len(row) < 4:
                self.fail("atom", f"{len(row)} values, not {columns if columns is not None else 'a name and x, y, z'}")
            self.atom(frame, i, row)
        self.frames += 1

    def name(self, frame: _Frame, i: int, row: List[str]) -> str:
        """By the column id, or else by the order of atoms."""
        named = frame.columns.named
        if "id" in named:
            text = row[named["id"].first]
            return text if named["id"].kind == "S" else str(self.integer(text, "id"))
        species = row[named["species"].first] if "species" in named else ""
        if self.frames == 0:
            self.species.append(species)
        elif species != self.species[i]:
            self.fail("species", "another than that of the atom at this place before: atoms have no ids, and their "
                      "order changes")
        return str(i)

    def atom(self, frame: _Frame, i: int, row: List[str]) -> None:
        name = self.name(frame, i, row)
        named = frame.columns.named
        radius = self.radius
        if radius is None and "radius" in named:
            radius = self.number(row[named["radius"].first], "radius")
        first, count = named["pos"].first, named["pos"].count
        at = [self.number(word, axis) for word, axis in zip(row[first:first + count], "xyz")]
        if count == 3:
            self.heights.take(at[2])
            if self.heights.flatten:
                at.pop()
            elif self.heights.differ:
                self.side(frame, 2)
        try:
            self.require_no_jump(frame, name, at)
            self.table.add(name, frame.t, tuple(at), radius, self.frames)
        except Refused as refused:
            self.fail(refused.field, refused.reason)

    def require_no_jump(self, frame: _Frame, name: str, at: List[Fraction]) -> None:
        last = self.table.last(name)
        if frame.sides is None or last is None:
            return
        for axis, periodic, before, now, length in zip("xyz", frame.periodic, last[1], at, frame.sides):
            if periodic is not False:
                try:
                    boxes.require_no_jump(axis, before, now, length)
                except ValueError as error:
                    self.fail(axis, str(error))

    def remarks(self) -> Iterator[str]:
        if self.timed != "time":
            what = "steps" if self.timed == "step" else "frames"
            yield (f"t is counted in {what}: the file does not say how long one takes" if self.timestep is None
                   else f"one of the {what} takes {numbers.text(self.timestep)}, as given: the file does not say so")
        yield "lengths and times are in the units of the file, which it does not say"
        yield "what happens between two frames is not in the file; forces and walls are not, either"
        if "id" not in self.columns.named:
            yield "atoms have no ids: those at one place of each frame's list are taken for one"
        if self.radius is not None:
            yield f"the radius of every disk is {numbers.text(self.radius)}, as given"
        elif "radius" not in self.columns.named:
            yield "the file does not give radii: give --radius where the table is read"
        yield from self.heights.remarks()
        yield "no digit is lost: decimals are taken as they stand"


def read(path: str, *, radius: Optional[Fraction] = None, timestep: Optional[Fraction] = None,
         periodic: Optional[str] = None, flatten: bool = False) -> Table:
    """The paths of an xyz file. Raises InputError."""
    return _Reader(path, radius, timestep, periodic, flatten).read()
