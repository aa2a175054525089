"""Tracks of ships: tables of AIS messages as authorities publish them, one a line, with a heading.

Known are the headings of the American (MMSI, BaseDateTime, LAT, LON; also in their newer spelling) and
the Danish tables (# Timestamp, MMSI, Latitude, Longitude); others are named by an option.
"""

import csv
import datetime
import re
from fractions import Fraction
from typing import Dict, Iterator, List, NamedTuple, Optional, Set, Tuple

from . import geography, numbers
from .faults import Refused, printable
from .lines import Lines
from .table import Table

NAME = "ais"
MOST_MESSAGES = 5_000_000  # they are put in order in memory
NOT_AVAILABLE = {"lat": 91, "lon": 181}
NO_SPEED, NO_COURSE = Fraction("102.3"), 360  # knots and degrees; what is no less is not available

KNOWN = {
    "id": ("mmsi",),
    "time": ("basedatetime", "base_date_time", "# timestamp", "timestamp"),
    "lat": ("lat", "latitude"),
    "lon": ("lon", "longitude"),
    "speed": ("sog",),
    "course": ("cog",),
}
MOTION = ("speed", "course")  # columns for which only --until asks
_ISO = re.compile(r"(\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d)(\.\d{1,9})?)?(?:Z|[+-]00:?00)?", re.ASCII)
_DAY_FIRST = re.compile(r"(\d\d?)/(\d\d?)/(\d{4}) (\d\d):(\d\d)(?::(\d\d)(\.\d{1,9})?)?", re.ASCII)
_EPOCH = datetime.datetime(1970, 1, 1)


class _Message(NamedTuple):
    t: Fraction
    lat: Fraction
    lon: Fraction
    line: int
    speed: Optional[Fraction] = None   # knots over ground
    course: Optional[Fraction] = None  # degrees


def seconds(text: str) -> "tuple[Fraction, bool]":
    """Seconds since 1970 and True for a date with time; a plain number itself and False. Raises ValueError."""
    if match := _ISO.fullmatch(text):
        year, month, day, *clock = match.groups()
    elif match := _DAY_FIRST.fullmatch(text):
        day, month, year, *clock = match.groups()
    else:
        return numbers.decimal(text), False
    hour, minute, second, part = clock
    moment = datetime.datetime(int(year), int(month), int(day), int(hour), int(minute), int(second or 0))
    whole = moment - _EPOCH
    return Fraction(whole.days * 86400 + whole.seconds) + Fraction(part or 0), True


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction], columns: Optional[Dict[str, str]],
                 origin: Optional[geography.Projection], longest_gap: Optional[Fraction], until: Optional[Fraction]):
        self.lines = Lines(path)
        self.radius = radius
        self.given = columns or {}
        self.origin = origin
        self.longest_gap = longest_gap
        self.until = until
        self.messages: Dict[str, List[_Message]] = {}
        self.dates = True
        self.count = self.unavailable = self.repeated = self.contradicting = self.cuts = self.still_unknown = 0
        self.without_place: Set[str] = set()

    def read(self) -> Table:
        columns: Optional[Dict[str, int]] = None
        try:
            for row in self.lines.rows():
                if not row:
                    continue
                if columns is None:
                    columns = self.heading(row)
                    width = len(row)
                elif len(row) != width:
                    self.lines.fail("", f"{len(row)} fields, not the {width} of the heading")
                else:
                    self.message({name: row[k].strip() for name, k in columns.items()})
        except csv.Error as error:
            self.lines.fail("", str(error))
        if columns is None:
            self.lines.fail("", "no heading")
        return self.table()

    def heading(self, row: List[str]) -> Dict[str, int]:
        names = [name.strip().lower() for name in row]
        columns = {}
        for what, known in KNOWN.items():
            if what in MOTION and self.until is None:
                continue
            wanted = (self.given[what].lower(),) if what in self.given else known
            found = [k for k, name in enumerate(names) if name in wanted]
            if len(found) != 1:
                self.lines.fail("heading", f"{'no column' if not found else 'several columns'} of {what}: "
                                f"{' or '.join(wanted)} (--columns names others)")
            columns[what] = found[0]
        return columns

    def message(self, row: Dict[str, str]) -> None:
        self.count += 1
        if self.count > MOST_MESSAGES:
            self.lines.fail("", f"more than {MOST_MESSAGES} messages: take a part of the file")
        field = "time"
        try:
            t, is_date = seconds(row["time"])
            if is_date != self.dates and self.messages:
                raise ValueError("dates and plain numbers are mixed")
            self.dates = is_date
            place = []
            for field, check in (("lat", geography.check_latitude), ("lon", geography.check_longitude)):
                value = numbers.decimal(row[field])
                if value == NOT_AVAILABLE[field]:
                    self.unavailable += 1
                    self.without_place.add(row["id"])
                    return
                place.append(check(value))
            motion = []
            for field, none in (("speed", NO_SPEED), ("course", Fraction(NO_COURSE))) if self.until is not None else ():
                value = numbers.decimal(row[field]) if row[field] else none
                if value < 0:
                    raise ValueError("negative")
                motion.append(value if value < none else None)
        except ValueError as error:
            self.lines.fail(field, f"{printable(row[field], 40)!r}: {error}")
        self.messages.setdefault(row["id"], []).append(_Message(t, *place, self.lines.number, *motion))

    def table(self) -> Table:
        table = Table(self.radius is not None)
        everything = [message for track in self.messages.values() for message in track]
        if everything:
            latitudes = [message.lat for message in everything]
            start = min(message.t for message in everything)
            plane = self.origin or geography.around(latitudes, everything[0].lon)
            for name, track in self.messages.items():
                disk, last = self.track(table, plane, name, sorted(track, key=lambda message: message.t), start)
                self.go_on(table, disk, last)
            table.remarks += [f"t is counted in seconds from {self.moment(start)}, lengths in metres",
                              *plane.remarks([min(latitudes), max(latitudes)])]
        table.remarks += self.remarks()
        table.missing += self.missing()
        return table

    def track(self, table: Table, plane: geography.Projection, name: str, track: List[_Message],
              start: Fraction) -> Tuple[str, _Message]:
        """Its name in the table, that of the last part, and its last message."""
        part, last = 1, None
        for message in track:
            if last is not None and message.t == last.t:
                same = (message.lat, message.lon) == (last.lat, last.lon)
                self.repeated += same
                self.contradicting += not same
                continue
            if last is not None and self.longest_gap is not None and message.t - last.t > self.longest_gap:
                part += 1
                while f"{name}/{part}" in self.messages:  # another ship's name
                    part += 1
                self.cuts += 1
            last = message
            try:
                at = plane.place(message.lat, message.lon)
                disk = name if part == 1 else f"{name}/{part}"
                known = table.last(disk)
                if known is not None and abs(at[0] - known[1][0]) > 180 * plane.east:
                    raise Refused("lon", "the track goes around the other side of the Earth: take another origin")
                table.add(disk, message.t - start, at, self.radius)
            except Refused as refused:
                self.lines.number = message.line
                self.lines.fail(refused.field, refused.reason)
        return disk, last

    def go_on(self, table: Table, disk: str, message: _Message) -> None:
        """From its last message to `until` with the speed and the course that it gives."""
        if self.until is None:
            return
        t, at = table.last(disk)
        if self.until <= t:
            self.lines.number = message.line
            self.lines.fail("time", f"--until {numbers.text(self.until)} is no later than this message, at {numbers.text(t)}")
        if message.speed is None or (message.course is None and message.speed > 0):
            self.still_unknown += 1
            return
        length = message.speed * Fraction(1852, 3600) * (self.until - t)
        east_north = geography.sine_and_cosine(message.course or Fraction(0))
        way = [numbers.rounded(geography.as_decimal(length) * part, geography.PLACES) for part in east_north]
        try:
            table.add(disk, self.until, (at[0] + way[0], at[1] + way[1]), self.radius)
        except Refused as refused:
            self.lines.number = message.line
            self.lines.fail(refused.field, refused.reason)

    def moment(self, start: Fraction) -> str:
        if not self.dates:
            return f"the number {numbers.text(start)} of the file"
        part = f" and {numbers.text(start % 1)} s" if start % 1 else ""
        return (_EPOCH + datetime.timedelta(seconds=int(start // 1))).isoformat() + part + " UTC"

    def remarks(self) -> Iterator[str]:
        if self.until is None:
            yield "a ship is taken for a disk about its antenna: length, width, heading, speed and course are left out"
            if all(len(track) == 1 for track in self.messages.values()):
                yield "one message a ship: --until gives motion, by speed and course over ground"
        else:
            yield "a ship is taken for a disk about its antenna: length, width and heading are left out"
            yield (f"from its last message each ship goes on with the speed and the course over ground that it gives, "
                   f"straight in the plane, until t = {numbers.text(self.until)}; where that leads is rounded to "
                   f"{geography.PLACES} decimals of m")
        if self.radius is None:
            yield "give --radius where the table is read"
        else:
            yield f"the radius of every disk is {numbers.text(self.radius)}, as given"
        yield "what a ship does between two messages is not in the file, nor are coasts and depths"
        if self.unavailable:
            yield f"{self.unavailable} messages without a position are left out (latitude 91 or longitude 181)"
        if self.repeated:
            yield f"{self.repeated} messages repeat another of the same ship and time, and are left out"
        if self.cuts:
            yield "the parts of a ship whose track is cut are named NAME, NAME/2, ..."
        yield "no digit is lost but by the plane"


    def missing(self) -> Iterator[str]:
        """Ships, or parts of their ways, that may be near others and are not in the table."""
        unplaced = self.without_place - self.messages.keys()
        if unplaced:
            yield f"{len(unplaced)} ships of which no message has a position"
        if self.contradicting:
            yield (f"{self.contradicting} messages that give another place than one before of the same ship and time, and "
                   "are left out")
        if self.cuts:
            yield (f"ships between the parts of their tracks, which are cut {self.cuts} times, where two messages are more "
                   f"than {numbers.text(self.longest_gap)} s apart")
        if self.still_unknown:
            yield f"{self.still_unknown} ships after their last message, which has no speed or no course"


def read(path: str, *, radius: Optional[Fraction] = None, columns: Optional[Dict[str, str]] = None,
         origin: Optional[geography.Projection] = None, longest_gap: Optional[Fraction] = None,
         until: Optional[Fraction] = None) -> Table:
    """The tracks of a table. `columns`: names of columns by what they hold, as in KNOWN. `until`: each ship goes on from
    its last message, with the speed and course that it gives, up to so many seconds after the first of all. Raises
    InputError.
    """
    return _Reader(path, radius, columns, origin, longest_gap, until).read()
