"""Scenarios of the air traffic simulator BlueSky, as plans: straight flight at constant speed.

Followed are CRE, ADDWPT and DEST with places in degrees or of DEFWPT, HDG, SPD, DEL and CASMACHTHR. Whoever
flies by another command is followed up to there. Beyond its route an aircraft flies straight on, as in BlueSky,
whose autopilot drops the route there and holds track and speed until DEL.
"""

import math
import re
from collections import Counter
from fractions import Fraction
from typing import Dict, Iterable, Iterator, List, Optional, Tuple

from . import geography, numbers, scenario
from .faults import Refused, printable
from .lines import Lines
from .scenario import Command, argument
from .table import Place, Table

NAME = "bluesky"
TIME_PLACES = 6  # in seconds: the times at waypoints are rounded to these
# Commands of an aircraft that leave its way over ground as it is, or as if it were (heights).
HARMLESS = {"ALT", "VS", "ORIG", "TYPE", "COLOR", "COLOUR", "LABEL", "PAN", "POS", "SSD", "TRAIL", "TRAILS", "ECHO"}
# Commands of the simulator, its screen and its logs, which create and move nobody. Any other may.
OF_NOBODY = {"HOLD", "OP", "FF", "DT", "DTMULT", "FIXDT", "REALTIME", "DATE", "TIME", "SCEN", "SEED", "ZOOM", "SWRAD", "SYMBOL",
             "INSEDIT", "LEGEND", "LINE", "BOX", "CIRCLE", "POLY", "POLYALT", "POLYLINE", "DEFWPT", "SHOWPOLY", "SHOWTRAF",
             "SHOWWPT", "SHOWAPT", "FILTERALT", "CRELOG", "SNAPLOG", "INSTLOG", "SKYLOG", "METRICS", "PLOT", "SAVEIC", "DIST",
             "HELP"}
# How many words those have that are followed; ADDWPT and DEST have as many as their places.
WORDS = {"DEL": 2, "HDG": 3, "SPD": 3, "LNAV": 3, "VNAV": 3}
POINT = re.compile(r"(?![NS][0-9.])[A-Z].*")
TURNS = {"FLYBY", "FLYOVER", "FLYTURN"}


class _Aircraft:
    """One that is there from its creation until `ended`; `rows` are its waypoints so far."""

    def __init__(self, line: int, t: Fraction, at: Place, heading: Fraction, height: "scenario.Decimal",
                 speed: Fraction):
        self.line = line
        self.t, self.at = t, at
        self.height = height
        self.speed = speed
        self.turn(heading)
        self.route: List[Optional[Tuple[Place, Optional[Fraction]]]] = []  # None: it goes on to where nobody knows
        self.goal: Optional[Place] = None  # where it goes after its route
        self.goal_unknown = False          # it goes on to a place that has a name only
        self.route_left = False            # by a heading or at its end; by what it is taken up again is not followed
        self.route_end: Optional[Fraction] = None  # when it came to the end of its route, and flies on
        self.leg: Optional[Tuple[Place, Optional[Fraction]]] = None  # the way to the place that it heads for
        self.ended = self.cut = False
        self.rows: List[Tuple[Fraction, Place]] = [(t, at)]

    def turn(self, heading: Fraction) -> None:
        self.direction = geography.sine_and_cosine(heading)

    def head_for_next(self) -> None:
        """Turns to the next place of the route, once: near a place its direction is badly known."""
        if self.leg is self.route[0]:
            return
        self.leg = self.route[0]
        if self.leg[0] != self.at:
            self.direction = geography.direction(self.at, self.leg[0])

    def note(self) -> None:
        """Makes where it is a waypoint."""
        if self.rows[-1][0] < self.t:
            self.rows.append((self.t, self.at))

    def end(self, cut: bool) -> None:
        self.note()
        self.ended, self.cut = True, cut

    def fly(self, until: Optional[Fraction]) -> None:
        """Until a time, or to the end of its route."""
        while not self.ended and self.has_way(until):
            if self.route[0] is None:
                self.end(cut=True)
                return
            self.head_for_next()
            (target, next_speed), arrival = self.route[0], self.arrival()
            if until is not None and (arrival is None or arrival > until):
                self.go(target, arrival, until)
                return
            if arrival is None:
                raise Refused("SPD", "it stands still on its route, and no --until is given")
            self.t, self.at = arrival, target
            self.note()
            self.speed = self.speed if next_speed is None else next_speed
            if self.route.pop(0) == (self.goal, None):
                self.goal = None
            if not self.route and self.goal is None and not self.goal_unknown:
                self.route_left, self.route_end = True, self.t
        if self.goal_unknown and not self.ended and (until is None or until > self.t):
            self.end(cut=True)
        if self.ended or (self.route_end is not None if until is None else until <= self.t):
            return
        if until is None:
            raise Refused("HDG", "it flies on a heading for ever: give --until")
        speed = [numbers.rounded(geography.as_decimal(self.speed) * part, geography.PLACES) for part in self.direction]
        self.at = (self.at[0] + speed[0] * (until - self.t), self.at[1] + speed[1] * (until - self.t))
        self.t = until

    def has_way(self, until: Optional[Fraction]) -> bool:
        """Whether a place is next; its goal is, when it flies on without another."""
        if not self.route and self.goal is not None and (until is None or until > self.t):
            self.route.append((self.goal, None))
        return bool(self.route)

    def leave_route(self) -> None:
        self.route_left = self.route_left or bool(self.route) or self.goal is not None or self.goal_unknown
        self.route.clear()
        self.goal, self.goal_unknown = None, False
        self.route_end = None

    def insert(self, target: Place, speed: Optional[Fraction]) -> None:
        """A place before the goal."""
        if self.route == [(self.goal, None)]:
            self.route.clear()
        if not self.route:
            self.note()
        self.route.append((target, speed))

    def arrival(self) -> Optional[Fraction]:
        """At the next waypoint; None for one that stands still elsewhere."""
        (x, y), _ = self.route[0]
        square = (x - self.at[0])**2 + (y - self.at[1])**2
        if square == 0:
            return self.t
        if self.speed == 0:
            return None
        # Rounded up, so that it is later.
        scale = 10**TIME_PLACES
        return self.t + Fraction(math.isqrt(int(square * scale**2 / self.speed**2)) + 1, scale)

    def go(self, target: Place, arrival: Optional[Fraction], until: Fraction) -> None:
        if arrival is not None and until > self.t:
            part = (until - self.t) / (arrival - self.t)
            self.at = tuple(Fraction(round((a + part * (b - a)) * 10**geography.PLACES), 10**geography.PLACES)
                            for a, b in zip(self.at, target))
        self.t = max(until, self.t)


def counted(commands: Iterable[Tuple[str, int]]) -> str:
    return ", ".join(f"{printable(word, 20)} {count}" for word, count in sorted(commands)[:40])


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction], origin: Optional[geography.Projection],
                 until: Optional[Fraction]):
        self.lines = Lines(path)
        self.radius = radius
        self.plane = origin
        self.until = until
        self.fleet: Dict[str, _Aircraft] = {}
        self.latitudes: List[Fraction] = []
        self.left_out: List[str] = []
        self.not_followed: Counter = Counter()
        self.mach_below = Fraction(2)
        self.points: Dict[str, Optional[Tuple[Fraction, Fraction]]] = {}  # from DEFWPT; None: nobody knows where

    def read(self) -> Table:
        read = scenario.read(self.lines)
        self.choose_plane(read.commands)
        for words in read.at_no_time:
            if words[0] == "DEFWPT":
                self.define(words, sure=False)
            elif words[0] not in HARMLESS:
                self.not_followed[words[0]] += 1
        for command in read.commands:
            if self.until is None or command.t <= self.until:
                self.obey(command)
        for name, aircraft in self.fleet.items():
            if not aircraft.ended:
                self.fly(name, aircraft, self.until)
        # Without --until the plan ends with the last route; who is there before flies on to that time.
        end = max((aircraft.t for aircraft in self.fleet.values()), default=None)
        table = Table(self.radius is not None)
        for name, aircraft in self.fleet.items():
            if not aircraft.ended:
                self.fly(name, aircraft, end)
                aircraft.note()
            self.add(table, name, aircraft)
        if len(table) == 0:
            self.lines.number = 0
            self.lines.fail("CRE", "of no aircraft a motion is known in degrees, feet and knots")
        table.remarks += self.remarks(read.ignored)
        table.missing += self.missing()
        return table

    def choose_plane(self, commands: List[Command]) -> None:
        created = []
        for command in commands:
            if command.words[0] == "CRE" and len(command.words) > 4:
                try:
                    created.append((scenario.latitude(command.words[3]), scenario.longitude(command.words[4])))
                except ValueError:
                    pass
        if not created:
            self.lines.number = 0
            self.lines.fail("CRE", "no aircraft is created at a place in degrees")
        if self.plane is None:
            self.plane = geography.around([latitude for latitude, _ in created], created[0][1])

    def obey(self, command: Command) -> None:
        words, sure = command.words, command.sure
        if words[0] in self.fleet:
            # A name of letters may be that of a command, too.
            sure = sure and any(c.isdigit() for c in words[0])
            if sure:
                words = [*(words[1:2] or ["POS"]), words[0], *words[2:]]
        if words[0] in HARMLESS:
            return
        if words[0] == "CRE":
            self.create(command._replace(words=words, sure=sure))
        elif words[0] == "DEFWPT":
            self.define(words, sure)
        elif words[0] == "CASMACHTHR" and sure and len(words) == 2:
            try:
                self.mach_below = numbers.decimal(words[1])
            except ValueError as error:
                self.lines.number = command.line
                self.lines.fail("CASMACHTHR", str(error))
        elif not self.followed(command.t, words, sure):
            self.not_followed[words[0]] += 1

    def followed(self, t: Fraction, words: List[str], sure: bool) -> bool:
        """Whether the command can be followed; it is, then. Who may be meant by another ends here."""
        done = False
        for name in dict.fromkeys(words[:2]):
            if name in self.fleet:
                aircraft = self.fleet[name]
                self.fly(name, aircraft, t)
                done = sure and words[1:2] == [name] and self.steer(aircraft, words)
                if not done and not aircraft.ended:
                    aircraft.end(cut=True)
        return done

    def create(self, command: Command) -> None:
        words = command.words
        name = argument(words, 1) or ""
        try:
            if not command.sure or len(words) != 8:
                raise ValueError("not understood")
            if name in self.fleet:
                raise ValueError("it is there already")
            latitude, longitude = scenario.latitude(words[3]), scenario.longitude(words[4])
            heading = numbers.decimal(words[5])
            height = scenario.height(words[6])
            speed = scenario.true_airspeed(words[7], height, self.mach_below)
        except ValueError:
            self.left_out.append(name)
            return
        self.latitudes.append(latitude)
        self.fleet[name] = _Aircraft(command.line, command.t, self.plane.place(latitude, longitude), heading, height,
                                     speed)

    def steer(self, aircraft: _Aircraft, words: List[str]) -> bool:
        """Whether the command can be followed; it is, then."""
        if len(words) != WORDS.get(words[0], len(words)):
            return False
        if aircraft.ended:
            return words[0] == "DEL"
        try:
            if words[0] == "DEL":
                aircraft.end(cut=False)
            elif words[0] == "HDG":
                heading = numbers.decimal(words[2])
                aircraft.note()
                aircraft.leave_route()
                aircraft.turn(heading)
            elif words[0] == "SPD":
                speed = scenario.true_airspeed(words[2], aircraft.height, self.mach_below)
                aircraft.note()
                aircraft.speed = speed
            elif aircraft.route_left:
                return False
            elif words[0] == "ADDWPT":
                self.add_waypoint(aircraft, words)
            elif words[0] == "DEST":
                self.head_for(aircraft, words)
            elif words[0] in ("LNAV", "VNAV"):
                return words[2] == "ON"
            else:
                return False
        except (ValueError, IndexError):
            return False
        return True

    def add_waypoint(self, aircraft: _Aircraft, words: List[str]) -> None:
        if words[2] in TURNS and len(words) == 3:
            return
        try:
            latitude, longitude, rest = self.spot(words)
        except (ValueError, IndexError):
            # TAKEOFF and a fourth argument may put it before others.
            if not aircraft.route or len(words) > 5 or words[2].replace("-", "") == "TAKEOFF":
                raise
            aircraft.route.append(None)
            return
        if len(words) > rest + 2:
            raise ValueError("it may not go to the end of the route")
        if argument(words, rest):
            scenario.height(words[rest])
        if aircraft.route and aircraft.route[-1] is None:
            return
        spoken = argument(words, rest + 1)
        speed = None if spoken is None else scenario.true_airspeed(spoken, aircraft.height, self.mach_below)
        self.latitudes.append(latitude)
        aircraft.insert(self.plane.place(latitude, longitude), speed)

    def head_for(self, aircraft: _Aircraft, words: List[str]) -> None:
        try:
            latitude, longitude, rest = self.spot(words)
        except (ValueError, IndexError):
            aircraft.goal_unknown = True
            return
        if len(words) > rest:
            raise ValueError("it has a speed there")
        self.latitudes.append(latitude)
        aircraft.goal = self.plane.place(latitude, longitude)

    def spot(self, words: List[str]) -> Tuple[Fraction, Fraction, int]:
        """The place that a command names, in degrees, and which word follows."""
        point = None if words[2] in self.fleet else self.points.get(words[2])
        if point is not None:
            return (*point, 3)
        return scenario.latitude(words[2]), scenario.longitude(words[3]), 4

    def define(self, words: List[str], sure: bool) -> None:
        """A point; nobody knows where it is if its name is that of another, or like a latitude."""
        name = argument(words, 1) or ""
        try:
            if not sure or len(words) != 4 or name in self.points or not POINT.fullmatch(name):
                raise ValueError("not understood")
            self.points[name] = (scenario.latitude(words[2]), scenario.longitude(words[3]))
        except ValueError:
            self.points[name] = None
            self.not_followed["DEFWPT"] += 1

    def fly(self, name: str, aircraft: _Aircraft, until: Optional[Fraction]) -> None:
        try:
            aircraft.fly(until)
        except Refused as refused:
            self.lines.number = aircraft.line
            self.lines.fail(f"{printable(name)} {refused.field}", refused.reason)

    def add(self, table: Table, name: str, aircraft: _Aircraft) -> None:
        if len(aircraft.rows) == 1 and aircraft.cut:
            self.left_out.append(name)
            return
        try:
            for t, at in aircraft.rows:
                table.add(name, t, at, self.radius)
        except Refused as refused:
            self.lines.number = aircraft.line
            self.lines.fail(f"{printable(name)} {refused.field}", refused.reason)

    def remarks(self, ignored: int) -> Iterator[str]:
        yield "t is counted in seconds, lengths in metres"
        yield from self.plane.remarks(self.latitudes)
        yield ("a plan, and no flight: each aircraft goes straight, turns at once, and keeps the true airspeed that it has "
               "at the height where it is created; climbs, wind, accelerations, resolutions of conflicts and what its type "
               "can do are not followed")
        on = sum(aircraft.route_end is not None and aircraft.t > aircraft.route_end for aircraft in self.fleet.values())
        if on:
            yield (f"{on} aircraft fly straight on from the ends of their routes, as in BlueSky, until DEL or the end of the "
                   "table")
        yield "heights are left out: aircraft that are near in the plane may be apart in height"
        yield (f"speeds are rounded to {scenario.SPEED_PLACES} decimals of m/s, their parts to the east and north to "
               f"{geography.PLACES}, times at waypoints up to {TIME_PLACES} of s, places where a command is given on the way "
               f"to {geography.PLACES} of m; no other digit is lost but by the plane")
        if self.radius is None:
            yield "give --radius where the table is read: half of a separation makes that a contact"
        else:
            yield f"the radius of every disk is {numbers.text(self.radius)}, as given"
        of_nobody = [item for item in self.not_followed.items() if item[0] in OF_NOBODY]
        if of_nobody:
            yield f"commands that are not followed, and move nobody: {counted(of_nobody)}"
        if ignored:
            yield f"{ignored} lines have no time, and are left out, as BlueSky does"

    def missing(self) -> Iterator[str]:
        """Aircraft, or parts of their ways, that may be near others and are not in the table."""
        cut = sum(aircraft.cut and len(aircraft.rows) > 1 for aircraft in self.fleet.values())
        if cut:
            yield f"{cut} aircraft are followed only up to a command or place that is not understood"
        if self.left_out:
            some = ", ".join(printable(name, 20) for name in self.left_out[:5])
            yield (f"{len(self.left_out)} aircraft are left out, of which no motion is known in degrees, feet and knots: "
                   f"{some}{', ...' if len(self.left_out) > 5 else ''}")
        others = [item for item in self.not_followed.items() if item[0] not in OF_NOBODY]
        if others:
            yield f"what these commands do, which are not followed and may create or move somebody: {counted(others)}"


def read(path: str, *, radius: Optional[Fraction] = None, origin: Optional[geography.Projection] = None,
         until: Optional[Fraction] = None) -> Table:
    """The plans of a scenario until a time in seconds, or to the end of the last route. Raises InputError."""
    return _Reader(path, radius, origin, until).read()
