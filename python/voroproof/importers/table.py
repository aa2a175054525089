"""The table of waypoints that an importer writes, and what it says beside it."""

import sys
import tempfile
from fractions import Fraction
from typing import Dict, IO, List, NamedTuple, Optional, Tuple

from ..errors import OutputError
from ..files import whole_file
from . import numbers
from .faults import Refused, printable

MOST_WAYPOINTS = 20_000_000  # the most that `clearance` and `convert` read
Place = Tuple[Fraction, ...]  # in the plane or in space


class _Disk(NamedTuple):
    t: Fraction
    at: Place
    radius: Optional[Fraction]
    frame: Optional[int]


class Table:
    """Waypoints, each written as it comes; of a disk only the last is kept in memory.

    `with_radius`: the table has a column of radii. `dimension`: 2 or 3, the number of coordinates of a place. A table
    in space whose heights are all the same is written in the plane.
    """

    def __init__(self, with_radius: bool, dimension: int = 2):
        self._with_radius = with_radius
        self._axes = "xyz"[:dimension]
        self._height: Optional[Fraction] = None  # where the first waypoint is
        self._flat = True
        self._rows: IO[str] = tempfile.TemporaryFile("w+", encoding="utf-8", newline="\n")
        self._disks: Dict[str, _Disk] = {}
        self._waypoints = 0
        self._bridged = 0
        self._span: Optional[Tuple[Fraction, Fraction]] = None
        self._longest: Tuple[Fraction, str, Fraction] = (Fraction(0), "", Fraction(0))
        self._farthest: Tuple[float, str, Fraction] = (0.0, "", Fraction(0))
        self.remarks: List[str] = []
        # Who and what may come near and is not in the table: nobody may call it free of approaches.
        self.missing: List[str] = []

    def __len__(self) -> int:
        return len(self._disks)

    def last(self, name: str) -> Optional[Tuple[Fraction, Place]]:
        """The time and place of the disk's last waypoint; None where it has none."""
        known = self._disks.get(name)
        return known and (known.t, known.at)

    def add(self, name: str, t: Fraction, at: Place, radius: Optional[Fraction] = None,
            frame: Optional[int] = None) -> None:
        """A waypoint. `frame`: its number in files of frames, to count what is missing between.

        Raises Refused where the table cannot hold it.
        """
        self._waypoints += 1
        if self._waypoints > MOST_WAYPOINTS:
            raise Refused("", f"more than {MOST_WAYPOINTS} waypoints")
        if not name or not name.isprintable() or name.strip() != name or "," in name or name[0] == "#":
            raise Refused("disk", "its name is empty, or has a comma or other characters that no table can hold")
        for field, value in (("t", t), *zip(self._axes, at), ("radius", radius or Fraction(0))):
            try:
                numbers.within(value)
            except ValueError as error:
                raise Refused(field, str(error)) from error
        if radius is not None and radius < 0:
            raise Refused("radius", "negative")
        known = self._disks.get(name)
        if known is not None:
            self._follow(name, known, t, at, radius, frame)
        self._disks[name] = _Disk(t, at, radius, frame)
        if self._axes == "xyz":
            self._height = at[2] if self._height is None else self._height
            self._flat = self._flat and at[2] == self._height
        self._span = (min(self._span[0], t), max(self._span[1], t)) if self._span else (t, t)
        cells = [name, *map(numbers.text, (t, *at))]
        if self._with_radius:
            cells.append(numbers.text(radius if radius is not None else Fraction(0)))
        self._rows.write(",".join(cells) + "\n")

    def _follow(self, name: str, known: _Disk, t: Fraction, at: Place, radius: Optional[Fraction],
                frame: Optional[int]) -> None:
        if t <= known.t:
            raise Refused("t", f"no later than the sample before of disk {printable(name)}")
        if radius != known.radius:
            raise Refused("radius", f"another than before for disk {printable(name)}: a disk keeps its radius")
        if frame is not None and known.frame is not None and frame > known.frame + 1:
            self._bridged += 1
        self._longest = max(self._longest, (t - known.t, name, known.t), key=lambda leg: leg[0])
        length = float(sum((now - before)**2 for now, before in zip(at, known.at)))**0.5
        self._farthest = max(self._farthest, (length, name, known.t), key=lambda leg: leg[0])

    def summary(self) -> List[str]:
        """All that is said of the table, a line each."""
        return self._remarks() + self._missing()

    def _missing(self) -> List[str]:
        return [f"missing: {reason}" for reason in self.missing]

    def _remarks(self) -> List[str]:
        """The table's own remarks, and then those of the reader."""
        said = [f"{len(self._disks)} disks, {self._waypoints} waypoints"
                + (f", t from {_short(self._span[0])} to {_short(self._span[1])}" if self._span else "")]
        if self._longest[1]:
            said.append("between its waypoints each disk is taken to move uniformly: at most for a time of "
                        f"{_short(self._longest[0])} (disk {self._longest[1]}, from t = {_short(self._longest[2])}), "
                        f"over {self._farthest[0]:.6g} at most")
        if self._bridged:
            said.append(f"{self._bridged} times a disk is missing from frames between two of its own, and is taken to "
                        "move uniformly meanwhile")
        return said + self.remarks

    def write(self, output: str) -> None:
        """Writes the table with its remarks, whole or not at all; "-" is standard output.

        Raises OutputError.
        """
        heading = "".join(f"# {printable(said, 1000)}\n" for said in [
            *(f"remark: {remark}" for remark in self._remarks()), *self._missing()])
        self._rows.seek(0)
        try:
            if output == "-":
                self._copy(heading, sys.stdout)
                sys.stdout.flush()
            else:
                with whole_file(output) as made:
                    self._copy(heading, made)
        except OSError as error:
            raise OutputError(f"{printable(output, 4096)}: {error.strerror or error}") from error

    def _copy(self, remarks: str, to: IO[str]) -> None:
        columns = ["disk", "t", *self._axes, *(["radius"] if self._with_radius else [])]
        one_height = self._axes == "xyz" and self._flat
        if one_height:
            columns.remove("z")
        to.write(remarks + ",".join(columns) + "\n")
        if one_height:
            for row in self._rows:
                cells = row.rstrip("\n").split(",")
                del cells[4]  # z
                to.write(",".join(cells) + "\n")
        else:
            while chunk := self._rows.read(1 << 20):
                to.write(chunk)


def _short(value: Fraction) -> str:
    return f"{float(value):.9g}"
