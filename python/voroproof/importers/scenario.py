"""The lines of BlueSky's scenarios: a time, ">", a command with its arguments."""

import itertools
import re
from decimal import Decimal
from fractions import Fraction
from typing import List, NamedTuple, Optional

from . import airspeed, geography, numbers
from .lines import Lines

SPEED_PLACES = 3  # in metres a second: speeds are rounded to these
FASTEST = 10_000  # knots, or Mach numbers; nothing in an atmosphere is faster
MOST_COMMANDS = 5_000_000  # they are put in order in memory

_LINE = re.compile(r"\s*([0-9]{1,4}):([0-9]{1,2}):([0-9]{1,2}(?:\.[0-9]{1,9})?)\s*>\s*(.*)")
_SEPARATOR = re.compile(r"\s*,\s*|\s+")


class Command(NamedTuple):
    t: Fraction  # seconds
    line: int
    words: List[str]  # in capitals; the first is the command


class Scenario(NamedTuple):
    commands: List[Command]  # in order of time, and of lines at equal times
    ignored: int             # lines that are neither empty nor comments, and have no time


def read(lines: Lines) -> Scenario:
    """Raises InputError."""
    commands: List[Command] = []
    ignored, before = 0, ""
    for line in itertools.chain(lines, [""]):  # the empty line ends a command that the last line leaves open
        text = before + line.split("#", 1)[0].strip()
        if text.endswith("\\"):
            before = text[:-1].strip() + " "
            continue
        before = ""
        if not text:
            continue
        match = _LINE.fullmatch(text)
        if match is None or not match[4]:
            ignored += 1
            continue
        t = int(match[1]) * 3600 + int(match[2]) * 60 + Fraction(match[3])
        if len(commands) == MOST_COMMANDS:
            lines.fail("", f"more than {MOST_COMMANDS} commands")
        words = [word.strip("'\"").upper() for word in _SEPARATOR.split(match[4].strip())]
        commands.append(Command(t, lines.number, words))
    return Scenario(sorted(commands, key=lambda command: command.t), ignored)


def latitude(word: str) -> Fraction:
    """Raises ValueError, also where the place is given in another way than by degrees."""
    return geography.check_latitude(numbers.decimal(word))


def longitude(word: str) -> Fraction:
    return geography.check_longitude(numbers.decimal(word))


def height(word: str) -> Decimal:
    """In metres, of feet or of a flight level. Raises ValueError."""
    feet = numbers.decimal(word[2:]) * 100 if word.startswith("FL") else numbers.decimal(word)
    return geography.as_decimal(feet) * airspeed.FOOT


def true_airspeed(word: str, at: Decimal, mach_below: Fraction) -> Fraction:
    """In m/s, rounded to SPEED_PLACES: of Mach numbers, M.8 or what is less than `mach_below` m/s, and of calibrated
    airspeeds in knots. Raises ValueError.
    """
    number = numbers.decimal(word[1:] if word.startswith("M") else word)
    if not 0 <= number <= FASTEST:
        raise ValueError(f"a speed that is not from 0 to {FASTEST}")
    value = geography.as_decimal(number)
    if word.startswith("M") and number >= 20:
        value /= 100  # M80 is Mach 0.8
    if word.startswith("M") or 0 < number * Fraction(1852, 3600) < mach_below:
        speed = airspeed.of_mach(value, at)
    else:
        speed = airspeed.of_calibrated(value * airspeed.KNOT, at)
    return numbers.rounded(speed, SPEED_PLACES)


def argument(words: List[str], k: int) -> Optional[str]:
    """The k-th word; None where it is missing or empty."""
    return words[k] if k < len(words) and words[k] else None
