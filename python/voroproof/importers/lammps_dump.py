"""Text dumps of LAMMPS: frames of ITEM: TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS and ATOMS.

Read are the styles `atom` and `custom` with a column `id`, and one of x, xs, xu, xsu for each axis.
"""

from fractions import Fraction
from typing import Dict, Iterator, List, NamedTuple, Optional, Tuple

from . import boxes, numbers
from .faults import Refused, printable
from .lines import Frames
from .table import Table

NAME = "lammps-dump"

# For each axis: the columns that are looked for, in this order, and whether they are unwrapped or scaled.
_COLUMNS = (("{}u", True, False), ("{}su", True, True), ("{}", False, False), ("{}s", False, True))


class _Axis(NamedTuple):
    name: str
    column: int
    unwrapped: bool
    scaled: bool
    image: Optional[int]  # the column of image flags


class _Frame(NamedTuple):
    t: Fraction
    atoms: int
    bounds: List[boxes.Bounds]
    periodic: List[Optional[bool]]


class _Reader(Frames):
    def __init__(self, path: str, radius: Optional[Fraction], timestep: Optional[Fraction],
                 periodic: Optional[str], flatten: bool):
        super().__init__(path)
        self.radius = radius
        self.timestep = timestep
        self.treatment = periodic
        self.heights = boxes.Heights(flatten)
        self.columns: List[str] = []
        self.table: Optional[Table] = None
        self.frames = 0
        self.has_time = False
        self.units = ""
        self.images = boxes.Images()

    def read(self) -> Table:
        for item in self.rest:
            if item.strip():
                self.atoms(self.head(item))
        if self.table is None:
            self.lines.number = 0
            self.fail("", "no frame: this is no dump of LAMMPS")
        self.table.remarks += self.remarks()
        self.images.tell(self.table)
        return self.table

    def head(self, item: str) -> _Frame:
        """The items of a frame before its atoms, the first of which is given; the columns are kept."""
        step = time = atoms = None
        box: Optional[Tuple[List[boxes.Bounds], List[Optional[bool]]]] = None
        while not item.startswith("ITEM: ATOMS"):
            if item.startswith("ITEM: UNITS"):
                self.units = printable(self.line("UNITS").strip())
            elif item.startswith("ITEM: TIMESTEP"):
                step = self.integer(self.line("TIMESTEP"), "TIMESTEP")
            elif item.startswith("ITEM: TIME"):
                time = self.number(self.line("TIME").strip(), "TIME")
            elif item.startswith("ITEM: NUMBER OF ATOMS"):
                atoms = self.integer(self.line("NUMBER OF ATOMS"), "NUMBER OF ATOMS")
                if atoms < 0:
                    self.fail("NUMBER OF ATOMS", "negative")
            elif item.startswith("ITEM: BOX BOUNDS"):
                box = self.box(item.split()[3:])
            else:
                self.fail("", f"not an item of a frame: {printable(item)}")
            item = self.line("ITEM")
        for name, value in (("TIMESTEP", step), ("NUMBER OF ATOMS", atoms), ("BOX BOUNDS", box)):
            if value is None:
                self.fail(name, "missing before ITEM: ATOMS")
        columns = item.split()[2:]
        if self.table is not None and columns != self.columns:
            self.fail("ATOMS", "other columns than in the frame before")
        self.columns = columns
        return _Frame(self.time(step, time), atoms, *box)

    def time(self, step: int, time: Optional[Fraction]) -> Fraction:
        if self.frames and (time is not None) != self.has_time:
            self.fail("TIME", "not in every frame")
        self.has_time = time is not None
        if time is not None:
            if self.timestep is not None:
                self.fail("TIME", "the file has its own times: --timestep has no use")
            return time
        return step * (self.timestep if self.timestep is not None else 1)

    def box(self, words: List[str]) -> Tuple[List[boxes.Bounds], List[Optional[bool]]]:
        if words[:1] and words[0] in ("xy", "abc"):
            self.fail("BOX BOUNDS", "a tilted box; only boxes along the axes are read")
        periodic: List[Optional[bool]] = [None, None, None]
        if len(words) >= 2:
            periodic = ["p" in word for word in words[:3]]
        bounds = []
        for axis in ("x", "y", "z")[:len(words) if len(words) == 2 else 3]:
            cells = self.line("BOX BOUNDS").split()
            if len(cells) != 2:
                self.fail("BOX BOUNDS", f"not two numbers for {axis}")
            low, high = (self.number(cell, f"BOX BOUNDS {axis}") for cell in cells)
            if high < low:
                self.fail("BOX BOUNDS", f"the bounds of {axis} are exchanged")
            bounds.append((low, high))
        if len(words) == 2:  # a box in the plane
            bounds.append((Fraction(0), Fraction(0)))
            periodic.append(False)
        return bounds, periodic

    def axis(self, name: str) -> Optional[_Axis]:
        for pattern, unwrapped, scaled in _COLUMNS:
            column = pattern.format(name)
            if column in self.columns:
                image = self.columns.index("i" + name) if "i" + name in self.columns else None
                return _Axis(name, self.columns.index(column), unwrapped, scaled, image)
        return None

    def axes(self, frame: _Frame) -> List[_Axis]:
        """Those of x and y, and that of z where the file has heights."""
        found = []
        for name in "xyz":
            axis = self.axis(name)
            if axis is None and name != "z":
                self.fail("ATOMS", f"no column of {name}: one of {name}, {name}s, {name}u, {name}su")
            if axis is not None:
                low, high = frame.bounds[len(found)]
                self.images.take(len(found), frame.periodic[len(found)], high - low)
                if name != "z":
                    self.side(frame, axis, len(found))
                found.append(axis)
        return found

    def side(self, frame: _Frame, axis: _Axis, k: int) -> None:
        """Refuses a periodic side of the box with which nothing is to be done."""
        try:
            boxes.side(axis.name, frame.periodic[k], self.treatment)
        except ValueError as error:
            self.fail("BOX BOUNDS", str(error))
        if frame.periodic[k] is not False:
            if self.treatment == boxes.UNWRAP and not axis.unwrapped and axis.image is None:
                self.fail("ATOMS", f"no column {axis.name}u or i{axis.name}, by which {axis.name} could be unwrapped")

    def atoms(self, frame: _Frame) -> None:
        columns = {name: k for k, name in enumerate(self.columns)}
        if len(columns) != len(self.columns):
            self.fail("ATOMS", "a column occurs twice")
        if "id" not in columns:
            self.fail("ATOMS", "no column id: the order of atoms says nothing about which is which")
        axes = self.axes(frame)
        size = next((name for name in ("radius", "diameter") if name in columns), None)
        if self.table is None:
            self.table = Table(self.radius is not None or size is not None, 2 if self.heights.flatten else len(axes))
        for _ in range(frame.atoms):
            row = self.line("ATOMS").split()
            if len(row) != len(columns):
                self.fail("ATOMS", f"{len(row)} values, not the {len(columns)} of the columns")
            self.atom(frame, row, columns, axes, size)
        self.frames += 1

    def atom(self, frame: _Frame, row: List[str], columns: Dict[str, int], axes: List[_Axis],
             size: Optional[str]) -> None:
        name = str(self.integer(row[columns["id"]], "id"))
        radius = self.radius
        if radius is None and size is not None:
            radius = self.number(row[columns[size]], size) / (1 if size == "radius" else 2)
        at = [self.coordinate(frame, row, axis, k, name) for k, axis in enumerate(axes)]
        if len(axes) == 3:
            self.heights.take(at[2])
            if self.heights.flatten:
                at.pop()
            elif self.heights.differ:
                self.side(frame, axes[2], 2)
        try:
            self.table.add(name, frame.t, tuple(at), radius, self.frames)
        except Refused as refused:
            self.fail(refused.field, refused.reason)

    def coordinate(self, frame: _Frame, row: List[str], axis: _Axis, k: int, name: str) -> Fraction:
        value = self.number(row[axis.column], self.columns[axis.column])
        low, high = frame.bounds[k]
        if axis.scaled:
            value = low + value * (high - low)
        if frame.periodic[k] is False or axis.unwrapped or (axis.name == "z" and self.heights.flatten):
            return value
        if self.treatment == boxes.UNWRAP and axis.image is not None:
            return value + self.integer(row[axis.image], "i" + axis.name) * (high - low)
        last = self.table.last(name)
        if last is not None:
            try:
                boxes.require_no_jump(axis.name, last[1][k], value, high - low)
            except ValueError as error:
                self.fail(self.columns[axis.column], str(error))
        return value

    def remarks(self) -> Iterator[str]:
        if not self.has_time:
            yield ("t is counted in steps: the file does not say how long one takes" if self.timestep is None
                   else f"a step takes {numbers.text(self.timestep)}, as given: the file does not say so")
        yield f"lengths are in the units of the file{f' ({self.units})' if self.units else ''}"
        yield "what happens between two frames is not in the file; forces and walls are not, either"
        if self.radius is not None:
            yield f"the radius of every disk is {numbers.text(self.radius)}, as given"
        elif not ({"radius", "diameter"} & set(self.columns)):
            yield "the file does not give radii: give --radius where the table is read"
        yield from self.heights.remarks()
        yield "no digit is lost: decimals are taken as they stand"


def read(path: str, *, radius: Optional[Fraction] = None, timestep: Optional[Fraction] = None,
         periodic: Optional[str] = None, flatten: bool = False) -> Table:
    """The paths of a dump. Raises InputError."""
    return _Reader(path, radius, timestep, periodic, flatten).read()
