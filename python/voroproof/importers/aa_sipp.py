"""Logs of the planner AA-SIPP(m): XML with root/log/agent/path/section, and with root/dynamicobstacles where it logs
what it was given.
"""

from fractions import Fraction
from typing import Iterator, Optional, Tuple

from . import numbers
from .faults import Refused, fail, printable
from .markup import Element, Markup
from .table import Place, Table

NAME = "aa-sipp"
LARGEST_SIZE = 10                  # the solver takes its default for an obstacle that is larger
DEFAULT_SIZE = Fraction(1, 2)      # where the file gives an obstacle none
ROUNDING = Fraction(1, 10**6)      # durations are binary32 numbers, so their sum is as exact as that


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction]):
        self.path = path
        self.file = Markup(path)
        self.radius = radius
        self.table = Table(with_radius=True)
        self.agents = self.without_path = self.turns = self.obstacles = 0
        self.obstacles_elsewhere = False

    def read(self) -> Table:
        root = self.file.read(("root", "log", "agent"), self.agent)
        if self.agents == 0:
            fail(self.path, 0, "root/log/agent", "no agent in the log")
        task = self.file.at_most_one(root, "agents")
        tasks = sum(child.tag == "agent" for child in task.children) if task else self.agents
        if tasks != self.agents:
            self.file.fail(task, "agent", f"{tasks} in the task, and {self.agents} in the log")
        self.obstacles_elsewhere = self.file.at_most_one(self.file.one(root, "log"), "obstaclesfilename") is not None
        given = self.file.at_most_one(root, "dynamicobstacles")
        if given is not None:
            default = self.file.at_most_one(given, "defaultparameters")
            size = DEFAULT_SIZE if default is None or "size" not in default.attributes else self.size(default)
            for child in given.children:
                if child.tag == "obstacle":
                    self.obstacle(child, size)
        self.table.remarks += self.remarks()
        self.table.missing += self.missing()
        return self.table

    def spot(self, element: Element, which: str) -> Place:
        return self.file.number(element, f"{which}.x"), self.file.number(element, f"{which}.y")

    def size(self, element: Element) -> Fraction:
        """That of obstacles."""
        size = self.file.number(element, "size")
        if not 0 < size <= LARGEST_SIZE:
            self.file.fail(element, "size", f"not more than 0 and at most {LARGEST_SIZE}: the solver takes another")
        return size

    def agent(self, element: Element) -> None:
        self.agents += 1
        path = self.file.one(element, "path")
        found = self.file.text(path, "pathfound")
        if found not in ("true", "false"):
            self.file.fail(path, "pathfound", "neither true nor false")
        if found == "false":
            self.without_path += 1
            return
        size = self.file.number(element, "size") if self.radius is None else self.radius
        t, at = self.follow(element, self.file.text(element, "id"), size, path, self.spot(element, "start"))
        # A path that lost sections is not the one that was made.
        told = self.file.number(path, "duration")
        if abs(told - t) > ROUNDING * max(told, t):
            self.file.fail(path, "duration", f"{numbers.text(told)}, and its sections take {numbers.text(t)}")
        if at != self.spot(element, "goal"):
            self.file.fail(element, "goal.x", "the path does not lead to the goal")

    def obstacle(self, element: Element, default: Fraction) -> None:
        self.obstacles += 1
        size = self.size(element) if "size" in element.attributes else default
        sections = self.file.children(element, "section")
        if not sections:
            self.file.fail(element, "section", "none tells where it is")
        self.follow(element, f"obstacle {self.file.text(element, 'id')}", size if self.radius is None else self.radius,
                    element, self.spot(sections[0], "start"))

    def follow(self, owner: Element, disk: str, size: Fraction, path: Element, at: Place) -> Tuple[Fraction, Place]:
        """Adds the waypoints of a path that begins somewhere; when and where it ends."""
        if disk in self.table:
            self.file.fail(owner, "id", f"{printable(disk)} occurs twice")
        t = Fraction(0)
        self.add(owner, disk, t, at, size)
        for k, section in enumerate(self.file.children(path, "section")):
            if self.file.integer(section, "id") != k:
                self.file.fail(section, "id", f"section {k} is missing before")
            start, goal = self.spot(section, "start"), self.spot(section, "goal")
            if start != at:
                self.file.fail(section, "start.x", "it starts elsewhere than the section before ends")
            duration = self.file.number(section, "duration")
            if duration < 0 or (duration == 0 and goal != start):
                self.file.fail(section, "duration", "negative" if duration < 0 else "0, and the agent moves")
            self.turns += section.attributes.get("start.heading") != section.attributes.get("goal.heading")
            if duration > 0:
                t, at = t + duration, goal
                self.add(section, disk, t, at, size)
        return t, at

    def add(self, element: Element, disk: str, t: Fraction, at: Place, size: Fraction) -> None:
        try:
            self.table.add(disk, t, at, size)
        except Refused as refused:
            self.file.fail(element, refused.field, refused.reason)

    def remarks(self) -> Iterator[str]:
        yield ("t is counted in the units of the plan from 0, where all paths begin; lengths are cells, and y grows "
               "downwards in the map")
        yield ("an agent is there from t = 0 to the end of its last section; the file does not say where it is after "
               "that")
        yield "obstacles of the map are left out"
        if self.obstacles:
            yield f"{self.obstacles} dynamic obstacles are disks, too, with the names \"obstacle ID\""
        if self.turns:
            yield f"headings are left out: in {self.turns} sections a disk stands where the agent turns"
        yield ("sizes are radii, as in the file" if self.radius is None
               else f"the radius of every disk is {numbers.text(self.radius)}, as given")
        yield ("no digit is lost, but the planner itself rounds sizes and durations to about 8 digits: disks that touch "
               "in its plan may overlap here by a little")

    def missing(self) -> Iterator[str]:
        """Agents and obstacles that may be near others and are not in the table."""
        if self.without_path:
            yield f"{self.without_path} agents for which no path was found"
        if self.obstacles_elsewhere:
            yield "the dynamic obstacles of another file, which the log names"


def read(path: str, *, radius: Optional[Fraction] = None) -> Table:
    """The paths of agents and dynamic obstacles. `radius`: of every disk, in place of the sizes. Raises InputError."""
    return _Reader(path, radius).read()
