"""Trajectories of JuPedSim: an SQLite database with the tables trajectory_data and metadata."""

import contextlib
import pathlib
import sqlite3
from fractions import Fraction
from typing import Any, NoReturn, Optional

from . import numbers
from .faults import Refused, fail, printable, refusing
from .table import Table

NAME = "jupedsim"
VERSIONS = ("1", "2")


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction]):
        self.path = path
        self.radius = radius

    def fail(self, field: str, reason: str) -> NoReturn:
        fail(self.path, 0, field, reason)

    def read(self) -> Table:
        if not pathlib.Path(self.path).is_file():
            self.fail("", "no such file, or no file of its own: a database cannot be read from a pipe")
        place = pathlib.Path(self.path).absolute().as_uri() + "?mode=ro"
        with refusing(self.path, "no trajectories of JuPedSim"):
            with contextlib.closing(sqlite3.connect(place, uri=True)) as database:
                return self.table(database)

    def metadata(self, database: sqlite3.Connection, key: str) -> str:
        found = database.execute("SELECT value FROM metadata WHERE key = ?", (key,)).fetchone()
        if found is None:
            self.fail(f"metadata {key}", "missing")
        return str(found[0])

    def require_tables(self, database: sqlite3.Connection) -> None:
        """Views would be programs of the file."""
        for name in ("trajectory_data", "metadata", "geometry"):
            found = database.execute("SELECT type FROM sqlite_master WHERE name = ?", (name,)).fetchone()
            if found is None or found[0] != "table":
                self.fail(name, "no such table" if found is None else "no table")

    def table(self, database: sqlite3.Connection) -> Table:
        self.require_tables(database)
        version = self.metadata(database, "version")
        if version not in VERSIONS:
            self.fail("metadata version", f"{printable(version)}; versions {' and '.join(VERSIONS)} are read")
        try:
            rate = numbers.decimal(self.metadata(database, "fps"))
        except ValueError as error:
            self.fail("metadata fps", str(error))
        if rate <= 0:
            self.fail("metadata fps", "not positive")
        walls = database.execute("SELECT count(*) FROM geometry").fetchone()[0]
        table = Table(self.radius is not None)
        frames = database.execute("SELECT DISTINCT frame FROM trajectory_data ORDER BY frame")
        index = {frame: k for k, (frame,) in enumerate(frames)}
        rows = database.execute("SELECT frame, id, pos_x, pos_y FROM trajectory_data ORDER BY frame, id")
        for row in rows:
            self.sample(table, rate, index[row[0]], *row)
        table.remarks += [
            f"t is the frame divided by the {numbers.text(rate)} frames per second of the file; lengths are metres",
            f"walls are left out: {walls} {'geometry' if walls == 1 else 'geometries'} of the file",
            "orientations and the ways that agents meant to go are left out",
            "an agent is there from its first frame to its last; what happens between two frames is not in the file",
            "the file does not give the size of an agent: give --radius where the table is read" if self.radius is None
            else f"the radius of every disk is {numbers.text(self.radius)}, as given: JuPedSim's agents need not be disks",
            "no digit is lost: positions are binary64 numbers, written exactly",
        ]
        return table

    def sample(self, table: Table, rate: Fraction, index: int, frame: Any, agent: Any, x: Any, y: Any) -> None:
        place = f"trajectory_data frame {printable(str(frame))} id {printable(str(agent))}"
        if not isinstance(frame, int) or not isinstance(agent, int):
            self.fail(place, "frame or id is no integer")
        try:
            at = []
            for name, value in (("pos_x", x), ("pos_y", y)):
                if not isinstance(value, (int, float)):
                    raise Refused(name, "no number")
                at.append(numbers.binary(value))
            table.add(str(agent), frame / rate, (at[0], at[1]), self.radius, index)
        except ValueError as error:
            self.fail(place, str(error))
        except Refused as refused:
            self.fail(f"{place} {refused.field}", refused.reason)


def read(path: str, *, radius: Optional[Fraction] = None) -> Table:
    """The paths of agents. Raises InputError."""
    return _Reader(path, radius).read()
