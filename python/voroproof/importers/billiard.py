"""Billiards in space, as other programs tell them: scenes, and perhaps histories (docs/formats.md, section 21)."""

import contextlib
import hashlib
import io
import json
import sys
from fractions import Fraction
from typing import IO, Iterator, List, NamedTuple, Optional, Tuple

from ..errors import OutputError
from ..files import whole_file
from . import numbers
from .faults import printable

MOST_BALLS = 2_000_000  # docs/formats.md, section 11
Vector = Tuple[Fraction, Fraction, Fraction]


class Wall(NamedTuple):
    normal: Vector  # its length is 1
    offset: Fraction
    restitution: Fraction


class Ball(NamedTuple):
    center: Vector
    velocity: Vector
    radius: Fraction
    mass: Optional[Fraction]  # None: it is fixed


class Setting(NamedTuple):
    """A scene but for its horizon."""
    sides: Tuple[Optional[Fraction], ...]  # None: the axis is not periodic
    shear: Fraction
    walls: List[Wall]
    gravity: Vector
    restitution: Fraction
    balls: List[Ball]


class Told(NamedTuple):
    """The collisions of a history, as its lines."""
    producer: str
    lines: IO[str]
    collisions: int


class Billiard:
    """A scene, perhaps with a history of it that is written to a file of its own."""

    def __init__(self, setting: Setting, horizon: Fraction, remarks: List[str], told: Optional[Told] = None,
                 history: Optional[str] = None):
        self._setting = setting
        self._horizon = horizon
        self._remarks = remarks
        self._told = told
        self._history = history

    def summary(self) -> List[str]:
        """All that is said of both files, a line each."""
        said = [f"{len(self._setting.balls)} disks in space, t from 0 to {float(self._horizon):.9g}"
                + (f", {self._told.collisions} collisions" if self._told else "")]
        return said + self._remarks

    def write(self, output: str) -> None:
        """Writes the scene with its remarks and the history, whole or not at all; "-" is standard output.

        Raises OutputError.
        """
        try:
            with contextlib.ExitStack() as stack:
                file = _opened(output, stack)
                digest = hashlib.sha256()
                for part in self._scene():
                    file.write(part)
                    digest.update(part.encode())
                if self._told is not None:
                    self._write_history(self._told, _opened(self._history, stack), digest.hexdigest())
        except OSError as error:
            name = error.filename if isinstance(error.filename, str) else output
            raise OutputError(f"{printable(name, 4096)}: {error.strerror or error}") from error

    def _scene(self) -> Iterator[str]:
        setting = self._setting
        yield '{"format": "voroproof-scene", "version": 2, "contacts": "bounce", "dimension": 3,\n'
        yield f' "comment": {json.dumps("; ".join(printable(said, 1000) for said in self.summary()))},\n'
        yield f' "horizon": {exact(self._horizon)},\n "frame": {self._frame()},\n'
        if setting.restitution != 1:
            yield f' "restitution": {exact(setting.restitution)},\n'
        if any(setting.gravity):
            yield f' "gravity": {_vector(setting.gravity)},\n'
        yield ' "disks": ['
        separator = "\n  "
        for ball in setting.balls:
            state = ('"fixed": true' if ball.mass is None
                     else f'"velocity": {_vector(ball.velocity)}, "mass": {exact(ball.mass)}')
            yield f'{separator}{{"center": {_vector(ball.center)}, "radius": {exact(ball.radius)}, {state}}}'
            separator = ",\n  "
        yield "]}\n"

    def _frame(self) -> str:
        setting = self._setting
        fields = []
        if any(setting.sides):
            sides = ("null" if side is None else exact(side) for side in setting.sides)
            fields.append(f'"periodic": [{", ".join(sides)}]')
        if setting.shear:
            fields.append(f'"shear": {exact(setting.shear)}')
        if setting.walls:
            walls = (f'\n  {{"normal": {_vector(wall.normal)}, "offset": {exact(wall.offset)}, '
                     f'"restitution": {exact(wall.restitution)}}}' for wall in setting.walls)
            fields.append(f'"walls": [{",".join(walls)}]')
        return f'{{{", ".join(fields)}}}' if fields else '"none"'

    def _write_history(self, told: Told, file: IO[str], digest: str) -> None:
        horizon = exact(self._horizon)
        file.write(f'{{"format":"voroproof-history","version":2,"scene_sha256":"{digest}","horizon":{horizon},'
                   f'"producer":{json.dumps(told.producer)}}}\n')
        told.lines.seek(0)
        while chunk := told.lines.read(1 << 20):
            file.write(chunk)
        file.write(f'{{"end":{{"t":{horizon},"collisions":{told.collisions},"maneuvers":0}}}}\n')


def exact(value: Fraction) -> str:
    """The number in JSON: a small integer as it is, another value as the string that is exactly it."""
    if value.denominator == 1 and abs(value) < 2**53:
        return str(value.numerator)
    return f'"{numbers.text(value)}"'


def _vector(values: Vector) -> str:
    return f'[{", ".join(map(exact, values))}]'


def _opened(output: str, stack: contextlib.ExitStack) -> IO[str]:
    return stack.enter_context(_standard_output() if output == "-" else whole_file(output))


@contextlib.contextmanager
def _standard_output() -> Iterator[IO[str]]:
    buffer = io.StringIO()
    yield buffer
    sys.stdout.write(buffer.getvalue())
    sys.stdout.flush()
