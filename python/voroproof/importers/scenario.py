"""The lines of BlueSky's scenarios: a time, ">", a command with its arguments."""

import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import List, NamedTuple, Optional, Tuple

from . import airspeed, geography, numbers
from .lines import Lines

SPEED_PLACES = 3  # in metres a second: speeds are rounded to these
FASTEST = 10_000  # knots, or Mach numbers; nothing in an atmosphere is faster
MOST_COMMANDS = 5_000_000  # they are put in order in memory

_SEPARATOR = re.compile(r"\s*,\s*|\s+")
_QUOTED = re.compile(r"""^(['"])([^'"]+)\1$""")
_SHORTEST = 12  # characters; BlueSky skips shorter lines, and in newer versions those of less than 10


class Command(NamedTuple):
    t: Fraction  # seconds
    line: int
    words: List[str]  # in capitals; the first is the command
    sure: bool  # whether all versions of BlueSky read it as these words


class Scenario(NamedTuple):
    commands: List[Command]      # in order of time, and of lines at equal times
    at_no_time: List[List[str]]  # words of commands at times that are not surely understood
    ignored: int                 # lines that are neither empty nor comments, and have no time


def read(lines: Lines) -> Scenario:
    """Raises InputError."""
    found: List[Tuple[float, Command]] = []
    at_no_time: List[List[str]] = []
    ignored, before = 0, ""
    for line in lines:
        line = line.strip()
        if not line or line[0] == "#":
            continue
        goes_on = line.endswith("\\")
        if len(line) < _SHORTEST and (before or goes_on):
            lines.fail("", f"a part of a command, shorter than {_SHORTEST} characters: BlueSky may skip it")
        text = before + line
        before = text[:-1].strip() + " " if goes_on else ""
        if goes_on:
            continue
        stamp, mark, said = text.partition(">")
        moment = _moment(stamp) if mark else None
        if moment is None:
            ignored += 1
            continue
        commands = [words for words in map(_words, said.split(";")) if words != [""]]
        if len(found) + len(at_no_time) + len(commands) > MOST_COMMANDS:
            lines.fail("", f"more than {MOST_COMMANDS} commands")
        try:
            t = _time(stamp)
        except ValueError:
            at_no_time += commands
            continue
        # Older versions begin a comment only with a line, newer ones at any "#".
        sure = len(line) >= _SHORTEST and "#" not in said
        for words in commands:
            quoted = any(quote in word for word in words for quote in "'\"")
            found.append((moment, Command(t, lines.number, words, sure and not quoted)))
    if before:
        lines.fail("", "the last command goes on, and the file ends")
    found.sort(key=lambda one: one[0])
    return Scenario([command for _, command in found], at_no_time, ignored)


def _moment(stamp: str) -> Optional[float]:
    """The seconds that BlueSky reads; None where it reads none, and leaves the line out."""
    fields = stamp.split(":")
    try:
        return int(fields[0]) * 3600.0 + int(fields[1]) * 60.0 + float(fields[2])
    except OverflowError:
        return math.inf
    except (ValueError, IndexError):
        return None


def _time(stamp: str) -> Fraction:
    """The seconds, exactly. Raises ValueError for what BlueSky reads, and people may not mean."""
    hours, minutes, seconds = (field.strip() for field in stamp.split(":"))
    t = numbers.integer(hours) * 3600 + numbers.integer(minutes) * 60 + numbers.decimal(seconds)
    if t < 0:
        raise ValueError("before the beginning")
    return t


def _words(command: str) -> List[str]:
    words = [_QUOTED.sub(r"\2", word).upper() for word in _SEPARATOR.split(command.strip())]
    return words[:-1] if len(words) > 1 and not words[-1] else words  # one comma may end it


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
