"""The events that DynamO's output plugin Trajectory writes (trajectory.out), as the collisions of a history.

A collision gives the impulse and the distance vector of two particles, or the place and the new velocity of one that
hits a wall, all with 17 digits; its time has 4 decimals. So velocities are followed from impulse to impulse, in the
arithmetic of DynamO, and the time is the one at which the paths have that distance, or come to that place, if it is the
file's time up to these decimals.
"""

import json
import math
import re
import tempfile
from fractions import Fraction
from typing import Any, Callable, Dict, IO, List, NamedTuple, NoReturn, Optional, Sequence, Tuple, Union

from . import numbers
from .billiard import Setting
from .faults import printable
from .lines import Lines

_NUMBER = r"([^\s,{}]+)"
_VECTOR = r"Vector\{" + ",".join([_NUMBER] * 3) + r"\}"
_EVENT = re.compile(r"\d+, Source=([\w-]+), SourceID=(\d+), Event Type=(\w+), t=" + _NUMBER + r", dt=\S+")
_PAIR = re.compile(rf" *2PEvent: p1=(\d+), p2=(\d+), delP1={_VECTOR}, \|r12\|=\S+, post-r12={_VECTOR}, "
                   r"post-v12=Vector\S+, post-rvdot=\S+")
_SINGLE = re.compile(rf" *1PEvent: p1=(\d+), Type=\w+, delP1=Vector\S+, pos={_VECTOR}, vel={_VECTOR}, oldvel=Vector\S+")
_IDLE = ("VIRTUAL", "NON_EVENT")  # nothing changes
_MOST_BOXES = 2**30  # docs/formats.md, section 21
_NEAR = 1e-6  # so far, relatively, may a distance vector or a place of the paths be from that of the file

_Vector = Tuple[float, ...]
_Gap = Callable[[float], Tuple[_Vector, _Vector]]  # a vector at a time, and its change


class Events(NamedTuple):
    lines: IO[str]
    collisions: int
    last: float  # time of the last collision
    beyond: int  # collisions after the horizon
    decimals: int  # that the times of the file have
    astray: int  # collisions that are not where the paths lead


class _Body:
    """A disk on its path since its last turn."""

    def __init__(self, at: _Vector, velocity: _Vector, mass: Optional[float], gravity: _Vector):
        self.t = 0.0
        self.at = at
        self.velocity = velocity
        self.mass = mass  # None: it is fixed
        self.gravity = gravity if mass is not None else (0.0,) * 3

    def state(self, t: float) -> Tuple[_Vector, _Vector]:
        """Place and velocity."""
        s = t - self.t
        return (tuple(x + s * (v + s / 2 * g) for x, v, g in zip(self.at, self.velocity, self.gravity)),
                tuple(v + s * g for v, g in zip(self.velocity, self.gravity)))

    def turn(self, t: float, velocity: _Vector) -> None:
        self.at = self.state(t)[0]
        self.t, self.velocity = t, velocity


class _Reader:

    def __init__(self, path: str, setting: Setting, horizon: Optional[Fraction]):
        self.source = Lines(path)
        self.rest = iter(self.source)
        self.sides = [float(side) if side is not None else None for side in setting.sides]
        self.shear = float(setting.shear)
        self.walls = len(setting.walls)
        gravity = _floats(setting.gravity)
        self.bodies = [_Body(_floats(ball.center), _floats(ball.velocity),
                             float(ball.mass) if ball.mass is not None else None, gravity) for ball in setting.balls]
        self.horizon = horizon
        self.lines: IO[str] = tempfile.TemporaryFile("w+", encoding="utf-8", newline="\n")
        self.collisions = self.beyond = self.decimals = self.astray = 0
        self.last = self.told_last = 0.0

    def fail(self, field: str, reason: str) -> NoReturn:
        self.source.fail(field, reason)

    def number(self, text: str, field: str) -> float:
        try:
            return float(numbers.decimal(text))
        except ValueError as error:
            self.fail(field, str(error))

    def vector(self, texts: Sequence[str], field: str) -> _Vector:
        return tuple(self.number(text, field) for text in texts)

    def read(self) -> Events:
        detail = self.next_line()
        while detail is not None:
            found = _EVENT.fullmatch(detail)
            if found is None:
                self.fail("", "not an event of DynamO's plugin Trajectory")
            source, number, kind, time = found.groups()
            details = []
            while (detail := self.next_line()) is not None and detail.startswith(" "):
                details.append(detail)
                if kind not in _IDLE:
                    self.event(kind, source, number, time, details)
            if not details:
                self.fail("", "an event without the particles that it changes: the file is cut off")
        return Events(self.lines, self.collisions, self.last, self.beyond, self.decimals, self.astray)

    def next_line(self) -> Optional[str]:
        return next((line for line in self.rest if line), None)

    def event(self, kind: str, source: str, number: str, time: str, details: List[str]) -> None:
        pair = (source, kind) == ("Interaction", "CORE")
        if not pair and (source, kind) != ("Local", "WALL"):
            self.fail("Event Type", f"{printable(source)} {printable(kind)}: a billiard knows collisions only")
        if len(details) > 1:
            self.fail("", "a second change in one collision")
        t = self.number(time, "t")
        decimals = len(time.partition(".")[2])
        if not time.replace(".", "", 1).lstrip("+-").isdigit():
            self.fail("t", "not a number with decimals")
        self.decimals = max(self.decimals, decimals)
        unit = 0.5001 * 10.0**-decimals
        if t < self.told_last - 2 * unit:
            self.fail("t", "earlier than the collision before")
        self.told_last = t
        found = (_PAIR if pair else _SINGLE).fullmatch(details[0])
        if found is None:
            self.fail("", f"not a line {'2PEvent' if pair else '1PEvent'}")
        if pair:
            self.pair(t, unit, found.groups())
        else:
            self.hit(t, unit, self.integer(number, "SourceID", self.walls, "walls"), found.groups())

    def integer(self, text: str, field: str, count: int, what: str) -> int:
        if len(text) > 18 or int(text) >= count:
            self.fail(field, f"{printable(text)}, and the configuration has {count} {what}")
        return int(text)

    def pair(self, t: float, unit: float, words: Sequence[str]) -> None:
        i, j = (self.integer(word, field, len(self.bodies), "particles") for word, field in zip(words, ("p1", "p2")))
        if i >= j:
            self.fail("p2", "not larger than p1")
        impulse, apart = self.vector(words[2:5], "delP1"), self.vector(words[5:8], "post-r12")
        a, b = self.bodies[i], self.bodies[j]
        image = self.image(a, b, t, apart)
        when = self.when(t, unit, lambda s: self.apart(a, b, s, image, apart), math.hypot(*apart))
        claim: Dict[str, Any] = {"collide": [i, j]}
        if when is not None and any(self.sides):
            claim["image"] = image
        new = [None if body.mass is None else
               tuple(v + sign * p / body.mass for v, p in zip(body.state(t if when is None else when)[1], impulse))
               for body, sign in ((a, -1), (b, 1))]
        self.tell(t, when, claim, [(a, new[0]), (b, new[1])])

    def image(self, a: _Body, b: _Body, t: float, apart: _Vector) -> List[int]:
        """The image of b that is nearest to where the file has b, as seen from a."""
        image = [0, 0, 0]
        gap = self.apart(a, b, t, image, apart)[0]
        for axis in (2, 1, 0):
            if self.sides[axis] is not None:
                shift = image[1] * self.shear * self.sides[1] * t if axis == 0 and self.shear else 0.0
                boxes = (gap[axis] - shift) / self.sides[axis]
                image[axis] = round(boxes) if abs(boxes) < _MOST_BOXES else 0
        return image

    def apart(self, a: _Body, b: _Body, t: float, image: Sequence[int], told: _Vector) -> Tuple[_Vector, _Vector]:
        """The distance vector from b's image to a at t, less the one told, and its change in time."""
        (p, v), (q, w) = a.state(t), b.state(t)
        shift = [k * side if side is not None else 0.0 for k, side in zip(image, self.sides)]
        slide = image[1] * self.shear * self.sides[1] if self.shear else 0.0
        shift[0] += slide * t
        return (tuple(x - y - z - r for x, y, z, r in zip(p, q, shift, told)),
                (v[0] - w[0] - slide, v[1] - w[1], v[2] - w[2]))

    def hit(self, t: float, unit: float, wall: int, words: Sequence[str]) -> None:
        i = self.integer(words[0], "p1", len(self.bodies), "particles")
        place, velocity = self.vector(words[1:4], "pos"), self.vector(words[4:7], "vel")
        body = self.bodies[i]
        def gap(s: float) -> Tuple[_Vector, _Vector]:
            at, speed = body.state(s)
            return tuple(x - y for x, y in zip(at, place)), speed
        when = self.when(t, unit, gap, max(map(abs, place)))
        self.tell(t, when, {"collide": [-1 - wall, i], "p": [None, tuple(map(_short, place))]}, [(None, None), (body, velocity)])

    def when(self, told: float, unit: float, gap: _Gap, scale: float) -> Optional[float]:
        """The time near that of the file at which the gap, a vector, is closest to 0; None where it is not 0 there."""
        t = told
        for _ in range(4):  # Newton's method, for parabolas
            off, speed = gap(t)
            square = sum(v * v for v in speed)
            if square == 0:
                return None
            t -= sum(x * v for x, v in zip(off, speed)) / square
        near = abs(t - told) <= unit + 1e-12 * abs(t) and math.hypot(*gap(t)[0]) <= _NEAR * scale
        return t if near else None

    def tell(self, told: float, when: Optional[float], claim: Dict[str, Any],
             turns: List[Tuple[Optional[_Body], Optional[_Vector]]]) -> None:
        t = max(told if when is None else when, self.last, 0.0)
        if self.horizon is not None and Fraction(t) > self.horizon:
            self.beyond += 1
            return
        self.astray += when is None
        self.last = t
        self.collisions += 1
        for body, velocity in turns:
            if velocity is not None:
                body.turn(t, velocity)
        claim["v"] = [velocity and tuple(map(_short, velocity)) for _, velocity in turns]
        try:
            self.lines.write(json.dumps({"t": _short(t), **claim}, separators=(",", ":"), allow_nan=False) + "\n")
        except ValueError:
            self.fail("", "a velocity beyond the range of binary64")


def _short(value: float) -> Union[float, int]:
    """The number, as an integer where it is one."""
    return int(value) if value.is_integer() and abs(value) < 2**53 else value


def _floats(values: Sequence[Fraction]) -> _Vector:
    return tuple(map(float, values))


def read(path: str, setting: Setting, horizon: Optional[Fraction]) -> Events:
    """The collisions up to the horizon, as lines of a history. Raises InputError."""
    return _Reader(path, setting, horizon).read()
