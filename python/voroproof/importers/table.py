"""The tables that importers write, row by row, and what they say beside them: paths of waypoints or of pieces."""

import sys
import tempfile
from fractions import Fraction
from typing import Any, Dict, IO, Iterable, Iterator, List, NamedTuple, Optional, Tuple

from ..errors import OutputError
from ..files import whole_file
from . import numbers
from .faults import Refused, printable

MOST_ROWS = 20_000_000  # the most that `clearance` and `convert` read
Place = Tuple[Fraction, ...]  # in the plane or in space


class Paths:
    """Rows of disks, each written as it comes; of a disk only what the next row must follow is kept in memory.

    `with_radius`: the table has a column of radii. `dimension`: 2 or 3, the number of coordinates of a place.
    """

    ROWS = ""  # the word for them

    def __init__(self, with_radius: bool, dimension: int = 2):
        self._with_radius = with_radius
        self._axes = "xyz"[:dimension]
        self._rows: IO[str] = tempfile.TemporaryFile("w+", encoding="utf-8", newline="\n")
        self._disks: Dict[str, Any] = {}
        self._count = 0
        self._span: Optional[Tuple[Fraction, Fraction]] = None
        self.remarks: List[str] = []
        # Who and what may come near and is not in the table: nobody may call it free of approaches.
        self.missing: List[str] = []
        # The sides of a box whose images all disks have, by axis; None where the axis is not periodic.
        self.sides: List[Optional[Fraction]] = [None] * 3

    def __len__(self) -> int:
        return len(self._disks)

    def __contains__(self, name: str) -> bool:
        return name in self._disks

    def _require(self, name: str, values: Iterable[Tuple[str, Fraction]], radius: Optional[Fraction]) -> None:
        """Raises Refused where the table cannot hold another row with this name, these values and radius."""
        self._count += 1
        if self._count > MOST_ROWS:
            raise Refused("", f"more than {MOST_ROWS} {self.ROWS}")
        if not name or not name.isprintable() or name.strip() != name or "," in name or name[0] == "#":
            raise Refused("disk", "its name is empty, or has a comma or other characters that no table can hold")
        for field, value in (*values, ("radius", radius or Fraction(0))):
            try:
                numbers.within(value)
            except ValueError as error:
                raise Refused(field, str(error)) from error
        if radius is not None and radius < 0:
            raise Refused("radius", "negative")

    def _put(self, name: str, disk: Any, start: Fraction, end: Fraction, cells: Iterable[str]) -> None:
        """Writes a row, and keeps `disk`, with its radius, for the next. Raises Refused where the radius is another."""
        known = self._disks.get(name)
        if known is not None and known.radius != disk.radius:
            raise Refused("radius", f"another than before for disk {printable(name)}: a disk keeps its radius")
        self._disks[name] = disk
        self._span = (min(self._span[0], start), max(self._span[1], end)) if self._span else (start, end)
        radius = [numbers.text(disk.radius or Fraction(0))] if self._with_radius else []
        self._rows.write(",".join([name, *cells, *radius]) + "\n")

    def summary(self) -> List[str]:
        """All that is said of the table, a line each."""
        return self._remarks() + self._missing()

    def _missing(self) -> List[str]:
        return [f"missing: {reason}" for reason in self.missing]

    def _remarks(self) -> List[str]:
        """The table's own remarks, and then those of the reader."""
        span = f", t from {_short(self._span[0])} to {_short(self._span[1])}" if self._span else ""
        return [f"{len(self._disks)} disks, {self._count} {self.ROWS}{span}", *self._own_remarks(), *self.remarks]

    def _own_remarks(self) -> Iterator[str]:
        raise NotImplementedError

    def dimension(self) -> int:
        """The number of coordinates of a place, as the table is written."""
        return len(self._axes)

    def _columns(self) -> List[str]:
        """Between the name and the radius."""
        raise NotImplementedError

    def _written(self) -> Iterator[str]:
        """The rows as they stand in the table, in parts."""
        raise NotImplementedError

    def write(self, output: str) -> None:
        """Writes the table with its remarks, whole or not at all; "-" is standard output.

        Raises OutputError.
        """
        heading = "".join(f"# {printable(said, 1000)}\n" for said in [
            *(f"remark: {remark}" for remark in self._remarks()), *self._missing()])
        sides = self.sides[:self.dimension()]
        if any(sides):
            heading += "# periodic: " + ",".join(numbers.text(side) if side else "none" for side in sides) + "\n"
        heading += ",".join(["disk", *self._columns(), *(["radius"] if self._with_radius else [])]) + "\n"
        try:
            if output == "-":
                _copy(heading, self._written(), sys.stdout)
                sys.stdout.flush()
            else:
                with whole_file(output) as made:
                    _copy(heading, self._written(), made)
        except OSError as error:
            raise OutputError(f"{printable(output, 4096)}: {error.strerror or error}") from error


class _Disk(NamedTuple):
    t: Fraction
    at: Place
    radius: Optional[Fraction]
    frame: Optional[int]


class Table(Paths):
    """Waypoints, between which the disks move uniformly. A table in space whose heights are all the same is written in
    the plane.
    """

    ROWS = "waypoints"

    def __init__(self, with_radius: bool, dimension: int = 2):
        super().__init__(with_radius, dimension)
        self._height: Optional[Fraction] = None  # that of the first waypoint
        self._flat = dimension == 3
        self._bridged = 0
        self._longest: Tuple[Fraction, str, Fraction] = (Fraction(0), "", Fraction(0))
        self._farthest: Tuple[float, str, Fraction] = (0.0, "", Fraction(0))

    def last(self, name: str) -> Optional[Tuple[Fraction, Place]]:
        """The time and place of the disk's last waypoint; None where it has none."""
        known = self._disks.get(name)
        return known and (known.t, known.at)

    def add(self, name: str, t: Fraction, at: Place, radius: Optional[Fraction] = None,
            frame: Optional[int] = None) -> None:
        """A waypoint. `frame`: its number in files of frames, to count what is missing between.

        Raises Refused where the table cannot hold it.
        """
        self._require(name, [("t", t), *zip(self._axes, at)], radius)
        known = self._disks.get(name)
        if known is not None:
            self._follow(name, known, t, at, frame)
        if self._flat:
            self._height = at[2] if self._height is None else self._height
            self._flat = at[2] == self._height
        self._put(name, _Disk(t, at, radius, frame), t, t, map(numbers.text, (t, *at)))

    def _follow(self, name: str, known: _Disk, t: Fraction, at: Place, frame: Optional[int]) -> None:
        if t <= known.t:
            raise Refused("t", f"no later than the sample before of disk {printable(name)}")
        if frame is not None and known.frame is not None and frame > known.frame + 1:
            self._bridged += 1
        self._longest = max(self._longest, (t - known.t, name, known.t), key=lambda leg: leg[0])
        length = float(sum((now - before)**2 for now, before in zip(at, known.at)))**0.5
        self._farthest = max(self._farthest, (length, name, known.t), key=lambda leg: leg[0])

    def dimension(self) -> int:
        return 2 if self._flat else super().dimension()

    def _columns(self) -> List[str]:
        return ["t", *self._axes[:self.dimension()]]

    def _written(self) -> Iterator[str]:
        self._rows.seek(0)
        if self._flat:
            for row in self._rows:
                cells = row.rstrip("\n").split(",")
                yield ",".join(cells[:4] + cells[5:]) + "\n"  # without z
            return
        while chunk := self._rows.read(1 << 20):
            yield chunk

    def _own_remarks(self) -> Iterator[str]:
        if self._flat and self.sides[2]:
            yield "all heights are one, and images above and below are left out"
        if self._longest[1]:
            yield ("between its waypoints each disk is taken to move uniformly: at most for a time of "
                   f"{_short(self._longest[0])} (disk {self._longest[1]}, from t = {_short(self._longest[2])}), "
                   f"over {self._farthest[0]:.6g} at most")
        if self._bridged:
            yield (f"{self._bridged} times a disk is missing from frames between two of its own, and is taken to "
                   "move uniformly meanwhile")


def _copy(heading: str, rows: Iterator[str], to: IO[str]) -> None:
    to.write(heading)
    to.writelines(rows)


def _short(value: Fraction) -> str:
    return f"{float(value):.9g}"
