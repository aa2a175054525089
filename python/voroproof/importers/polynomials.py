"""Trajectories of Crazyswarm and uav_trajectories: tables of polynomials of degree 7, a file a drone."""

import csv
import pathlib
from fractions import Fraction
from typing import Iterator, List, Optional

from . import numbers
from .faults import Refused, fail, printable
from .lines import Lines
from .pieces import DEGREE, Pieces

NAME = "polynomials"
HEADING = ["duration", *(f"{axis}^{k}" for axis in ("x", "y", "z", "yaw") for k in range(DEGREE + 1))]
AXES = 3  # yaw is left out


class _Reader:
    """One file, into a table of all."""

    def __init__(self, path: str, radius: Optional[Fraction], table: Pieces):
        self.lines = Lines(path)
        self.radius = radius
        self.table = table
        self.disk = pathlib.PurePath(path).name.removesuffix(".gz").removesuffix(".csv")
        self.t = Fraction(0)

    def read(self) -> None:
        if self.disk in self.table:
            fail(self.lines.path, 0, printable(self.disk), "another file before has this name, which is the disk's")
        heading = False
        try:
            for row in self.lines.rows():
                cells = [cell.strip() for cell in row]
                if cells and not cells[-1]:
                    del cells[-1]  # Crazyswarm's lines end with a comma
                if not heading:
                    self.require_heading(cells)
                    heading = True
                elif cells:
                    self.piece(cells)
        except csv.Error as error:
            self.lines.fail("", str(error))
        if self.disk not in self.table:
            fail(self.lines.path, 0, "", "no piece" if heading else "no heading")

    def require_heading(self, cells: List[str]) -> None:
        names = [cell.lower() for cell in cells]
        if names and names[0].startswith("#"):
            names[0] = names[0][1:].strip()  # as NumPy writes it
        if names != HEADING:
            self.lines.fail("heading", "not duration,x^0,...,x^7 and so on for y, z and yaw")

    def piece(self, cells: List[str]) -> None:
        if len(cells) != len(HEADING):
            self.lines.fail("", f"{len(cells)} fields, not the {len(HEADING)} of the heading")
        values = []
        for name, cell in zip(HEADING, cells):
            try:
                values.append(numbers.decimal(cell))
            except ValueError as error:
                self.lines.fail(name, f"{printable(cell, 40)!r}: {error}")
        duration, width = values[0], DEGREE + 1
        curves = [values[1 + axis * width:1 + (axis + 1) * width] for axis in range(AXES)]
        try:
            self.table.add(self.disk, self.t, duration, curves, self.radius)
        except Refused as refused:
            self.lines.fail(refused.field, refused.reason)
        self.t += duration


def _remarks(radius: Optional[Fraction]) -> Iterator[str]:
    yield "t is counted in seconds, lengths in metres; disks are named as the files"
    yield ("all trajectories are taken to start at t = 0, at their own speed, and where their files say: Crazyswarm may "
           "shift them to where each drone is, stretch and reverse them")
    yield "yaw is left out, and with it how a drone tilts; take-off and landing are not in the files"
    yield ("the files do not give the size of a drone: give --radius where the table is read" if radius is None
           else f"the radius of every disk is {numbers.text(radius)}, as given; a drone is taken for a ball")
    yield "no digit is lost"


def read(*paths: str, radius: Optional[Fraction] = None) -> Pieces:
    """The pieces of the files' trajectories, a disk a file. Raises InputError."""
    table = Pieces(radius is not None, dimension=AXES)
    for path in paths:
        _Reader(path, radius, table).read()
    table.remarks += _remarks(radius)
    return table
