"""Compiled shows of Skybrush (.skyc): a ZIP file with show.json and a trajectory of Bezier curves for each drone."""

import json
import math
import pathlib
import posixpath
import urllib.parse
import zipfile
from collections import Counter
from fractions import Fraction
from typing import Any, Dict, Iterator, List, NoReturn, Optional, Sequence, Tuple

from . import numbers
from .faults import Refused, fail, printable, refusing
from .pieces import DEGREE, Pieces
from .table import Place

NAME = "skybrush"
SHOW = "show.json"
MOST_DRONES = 5000        # Skybrush reads no more
LARGEST_PART = 1 << 25    # bytes of a JSON text
LARGEST_SHOW = 1 << 30    # bytes of all that are read
PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


class _Number(str):
    """A number of JSON, as it is spelled."""


def _object(pairs: List[Tuple[str, Any]]) -> Dict[str, Any]:
    made = dict(pairs)
    if len(made) != len(pairs):
        raise ValueError("a name occurs twice in an object")
    return made


def coefficients(points: Sequence[Fraction], duration: Fraction) -> List[Fraction]:
    """A coordinate of a Bezier curve as a polynomial in the time, of which it takes `duration`."""
    made, differences = [], list(points)
    for k in range(len(points)):
        made.append(math.comb(len(points) - 1, k) * differences[0] / duration**k)
        differences = [b - a for a, b in zip(differences, differences[1:])]
    return made


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction]):
        self.path = path
        self.radius = radius
        self.table = Pieces(radius is not None, dimension=3)
        self.read_bytes = 0
        self.part = SHOW  # the JSON text that is read
        self.parts: Counter = Counter()
        self.still = 0
        self.elsewhere: Counter = Counter()

    def fail(self, field: str, reason: str) -> NoReturn:
        fail(self.path, 0, f"{printable(self.part)} {field}".rstrip(), reason)

    def read(self) -> Pieces:
        if not pathlib.Path(self.path).is_file():
            fail(self.path, 0, "", "no such file, or no file of its own: a show cannot be read from a pipe")
        with refusing(self.path, "no show of Skybrush"), zipfile.ZipFile(self.path) as archive:
            self.parts.update(archive.namelist())
            self.show(archive)
        self.table.remarks += self.remarks()
        self.table.missing += self.missing()
        return self.table

    def json_of(self, archive: zipfile.ZipFile, part: str) -> Any:
        self.part = part
        if self.parts[part] != 1:
            self.fail("", "no such file in the show" if not self.parts[part] else "occurs twice in the show")
        with archive.open(part) as opened:
            if archive.getinfo(part).compress_type not in PACKED:
                self.fail("", "packed in another way than by deflation")
            text = opened.read(LARGEST_PART + 1)
        self.read_bytes += len(text)
        if len(text) > LARGEST_PART or self.read_bytes > LARGEST_SHOW:
            self.fail("", f"more than {LARGEST_PART} bytes, or more than {LARGEST_SHOW} in all")
        try:
            return json.loads(text.decode("utf-8"), parse_float=_Number, parse_int=_Number, parse_constant=_Number,
                              object_pairs_hook=_object)
        except (ValueError, RecursionError) as error:
            self.fail("", f"no JSON: {printable(str(error), 200)}")

    def show(self, archive: zipfile.ZipFile) -> None:
        show = self.json_of(archive, SHOW)
        self.require_version(show, "")
        drones = self.member(self.member(show, "swarm", dict), "drones", list, "swarm.")
        if not 0 < len(drones) <= MOST_DRONES:
            self.fail("swarm.drones", f"none, or more than {MOST_DRONES}")
        for k, drone in enumerate(drones):
            self.part = SHOW
            where = f"swarm.drones[{k}]."
            settings = self.member(drone, "settings", dict, where)
            where += "settings."
            name = self.text(settings, "name", where, str(k + 1))
            if name in self.table:
                self.fail(f"{where}name", f"{printable(name)}: that of another drone")
            ends = [self.optional_place(settings, what, where) for what in ("home", "landAt")]
            trajectory = self.member(settings, "trajectory", dict, where)
            if "$ref" in trajectory:
                trajectory = self.json_of(archive, self.reference(trajectory, f"{where}trajectory."))
                where = ""
            else:
                where += "trajectory."
            self.drone(name, trajectory, where, ends)

    def reference(self, trajectory: Dict[str, Any], where: str) -> str:
        """The name of the file in the show that it refers to."""
        address, _, inside = self.text(trajectory, "$ref", where, "").partition("#")
        if inside not in ("", "/"):
            self.fail(f"{where}$ref", "a part of a file: only whole files are read")
        return posixpath.normpath(urllib.parse.unquote(address))

    def drone(self, name: str, trajectory: Any, where: str, ends: Sequence[Optional[Place]]) -> None:
        self.require_version(trajectory, where)
        points = self.member(trajectory, "points", list, where)
        if not points:
            self.fail(f"{where}points", "none")
        start = trajectory.get("takeoffTime")
        takeoff = Fraction(0) if start is None else self.number(start, f"{where}takeoffTime")
        first = before = None
        for k, point in enumerate(points):
            t, at, control = self.keyframe(point, f"{where}points[{k}]")
            if before is None:
                first = at
                if control:
                    self.fail(f"{where}points[0]", "control points before the first point")
            else:
                self.piece(name, takeoff, before, (t, at, control), f"{where}points[{k}]")
            before = (t, at)
        self.still += len(points) == 1
        for what, end, last in zip(("home", "landAt"), ends, (first, before[1])):
            self.elsewhere[what] += end is not None and end != last

    def piece(self, name: str, takeoff: Fraction, before: Tuple[Fraction, Place],
              now: Tuple[Fraction, Place, List[Place]], field: str) -> None:
        (start, at), (end, to, control) = before, now
        if end <= start:
            self.fail(f"{field}[0]", "no later than the point before")
        curves = [coefficients(axis, end - start) for axis in zip(at, *control, to)]
        try:
            self.table.add(name, takeoff + start, end - start, curves, self.radius)
        except Refused as refused:
            self.fail(f"{field} {refused.field}", refused.reason)

    def keyframe(self, point: Any, field: str) -> Tuple[Fraction, Place, List[Place]]:
        if not isinstance(point, list) or len(point) not in (2, 3):
            self.fail(field, "not a time, a place and perhaps control points")
        control = point[2] if len(point) == 3 else []
        if not isinstance(control, list) or len(control) >= DEGREE:
            self.fail(f"{field}[2]", f"no list of at most {DEGREE - 1} control points")
        return (self.number(point[0], f"{field}[0]"), self.place(point[1], f"{field}[1]"),
                [self.place(each, f"{field}[2][{k}]") for k, each in enumerate(control)])

    def optional_place(self, settings: Dict[str, Any], what: str, where: str) -> Optional[Place]:
        given = settings.get(what)
        return None if given is None else self.place(given, where + what)

    def place(self, given: Any, field: str) -> Place:
        if not isinstance(given, list) or len(given) != 3:
            self.fail(field, "not three coordinates")
        return tuple(self.number(each, field) for each in given)

    def number(self, given: Any, field: str) -> Fraction:
        if not isinstance(given, _Number):
            self.fail(field, "not a number")
        try:
            return numbers.decimal(given)
        except ValueError as error:
            self.fail(field, f"{printable(given, 40)}: {error}")

    def text(self, holder: Dict[str, Any], name: str, where: str, default: str) -> str:
        given = holder.get(name)
        if given is None:
            return default
        if isinstance(given, _Number) or not isinstance(given, str):
            self.fail(where + name, "no string")
        return given

    def member(self, holder: Any, name: str, kind: type, where: str = "") -> Any:
        if not isinstance(holder, dict) or not isinstance(holder.get(name), kind):
            self.fail(f"{where}{name}", f"no {'list' if kind is list else 'object'} there")
        return holder[name]

    def require_version(self, holder: Any, where: str) -> None:
        if not isinstance(holder, dict) or not isinstance(holder.get("version"), _Number) or holder["version"] != "1":
            self.fail(f"{where}version", "not 1, which is the one that is read")

    def remarks(self) -> Iterator[str]:
        yield ("t is counted in seconds from the start of the show, lengths in metres; drones without a name are numbered "
               "from 1")
        yield "a drone is there from its take-off to the end of its trajectory, and not before or after that"
        yield "a show is a plan: wind and the errors of drones are not in the file"
        yield "lights, yaw, pyrotechnics, cues, cameras, fences and where on Earth the show is are left out"
        yield ("the file does not give the size of a drone: give --radius where the table is read"
               if self.radius is None
               else f"the radius of every disk is {numbers.text(self.radius)}, as given; a drone is taken for a ball")
        yield "Bezier curves are written as the polynomials that they are; no digit is lost"

    def missing(self) -> Iterator[str]:
        """Drones, or parts of their ways, that may be near others and are not in the table."""
        if self.still:
            yield f"{self.still} drones whose trajectory is one point at one time"
        if self.elsewhere["home"]:
            yield f"how {self.elsewhere['home']} drones come from home to the first points of their trajectories"
        if self.elsewhere["landAt"]:
            yield f"how {self.elsewhere['landAt']} drones come from the last points of their trajectories to landAt"


def read(path: str, *, radius: Optional[Fraction] = None) -> Pieces:
    """The pieces of the drones' trajectories. Raises InputError."""
    return _Reader(path, radius).read()
