"""Schedules of libMultiRobotPlanning: YAML with the states x, y, t of each agent, as its planners and others write it.

Read are maps of one line a key, and states in block form or in braces. Other YAML is refused.
"""

import re
from fractions import Fraction
from typing import Dict, Iterator, NoReturn, Optional

from . import numbers
from .faults import Refused, printable
from .lines import Lines
from .table import Table

NAME = "mapf"
COORDINATES = ("x", "y", "t")

_KEY = re.compile(r"([A-Za-z0-9_][A-Za-z0-9_. -]*): *(.*)", re.ASCII)
_PAIR = re.compile(r"([A-Za-z]\w*): +(\S+)", re.ASCII)
_OCTAL = re.compile(r"[+-]?0[0-9]")


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction]):
        self.lines = Lines(path)
        self.radius = radius
        self.table = Table(radius is not None)
        self.sections: Dict[str, int] = {}
        self.section = ""
        self.statistics: Dict[str, Fraction] = {}
        self.agent: Optional[str] = None
        self.agent_line = 0
        self.agent_indent: Optional[int] = None  # that of the agents' names
        self.item_indent: Optional[int] = None   # that of this agent's states
        self.state: Optional[Dict[str, str]] = None
        self.state_line = 0
        self.ends: Dict[str, Fraction] = {}  # when each agent's last state is
        self.idle = 0                        # agents without a plan

    def fail(self, line: int, field: str, reason: str) -> NoReturn:
        self.lines.number = line
        self.lines.fail(field, reason)

    def read(self) -> Table:
        for line in self.lines:
            text = line.split(" #")[0].rstrip()
            if not text or text.lstrip().startswith("#") or (text == "---" and not self.sections):
                continue
            indent = len(text) - len(text.lstrip(" "))
            if indent == 0 and not text.startswith("-"):
                self.open_section(text)
            elif self.section == "schedule":
                self.schedule(indent, text[indent:])
            elif self.section == "statistics":
                self.statistic(text.strip())
            elif not self.section:
                self.lines.fail("", "no schedule: a line that belongs to no key")
        self.end_agent()
        if "schedule" not in self.sections:
            self.fail(0, "schedule", "no such key")
        if not self.ends and not self.idle:
            self.fail(self.sections["schedule"], "schedule", "no agent")
        self.require_whole()
        self.table.remarks += self.remarks()
        if self.idle:
            self.table.missing.append(f"{self.idle} agents of which the schedule has no state: no plan was found")
        return self.table

    def open_section(self, text: str) -> None:
        self.end_agent()
        found = _KEY.fullmatch(text)
        if not found:
            self.lines.fail("", f"{printable(text, 40)!r}: no key of a schedule")
        self.section = found[1]
        if self.section in self.sections:
            self.lines.fail(self.section, "occurs twice")
        self.sections[self.section] = self.lines.number
        if self.section == "schedule" and found[2]:
            self.lines.fail("schedule", "no agents below it")

    def statistic(self, text: str) -> None:
        found = _PAIR.fullmatch(text)
        if found and found[1] in ("cost", "makespan"):
            self.statistics[found[1]] = self.number(self.lines.number, found[1], found[2])

    def schedule(self, indent: int, text: str) -> None:
        if text == "-" or text.startswith("- "):
            self.open_state(indent, text[1:])
        elif self.item_indent is not None and self.state is not None and indent == self.item_indent + 2:
            self.take(text)
        elif text == "[]" and self.agent is not None and indent > self.agent_indent and self.item_indent is None:
            self.no_plan()
        elif self.agent_indent is None or indent == self.agent_indent:
            self.open_agent(indent, text)
        else:
            self.lines.fail("schedule", f"{printable(text, 40)!r}: neither an agent nor a state, as it is indented")

    def open_agent(self, indent: int, text: str) -> None:
        self.end_agent()
        found = _KEY.fullmatch(text)
        if not found or found[2] not in ("", "[]"):
            self.lines.fail("schedule", f"{printable(text, 40)!r}: no agent's name with a colon")
        self.agent, self.agent_line, self.agent_indent = found[1].rstrip(), self.lines.number, indent
        if self.agent in self.table:
            self.lines.fail(printable(self.agent), "occurs twice")
        if found[2]:
            self.no_plan()

    def no_plan(self) -> None:
        self.idle += 1
        self.agent = None

    def open_state(self, indent: int, text: str) -> None:
        if self.agent is None or indent < self.agent_indent or self.item_indent not in (None, indent):
            self.lines.fail("schedule", "a state that belongs to no agent, as it is indented")
        self.end_state()
        self.item_indent, self.state, self.state_line = indent, {}, self.lines.number
        text = text.strip()
        if text.startswith("{") and text.endswith("}"):
            for pair in text[1:-1].split(","):
                self.take(pair.strip())
            self.end_state()
        else:
            self.take(text)

    def take(self, text: str) -> None:
        found = _PAIR.fullmatch(text)
        field = f"{printable(self.agent)} {printable(found[1], 20) if found else ''}".rstrip()
        if not found:
            self.lines.fail(field, f"{printable(text, 40)!r}: no coordinate of a state, as in x: 1")
        if found[1] == "v":
            self.lines.fail(field, "a vertex of a roadmap; the schedule does not say where it is")
        if found[1] not in COORDINATES or found[1] in self.state:
            self.lines.fail(field, "occurs twice" if found[1] in self.state else "not x, y or t")
        self.state[found[1]] = found[2]

    def end_state(self) -> None:
        if self.state is None:
            return
        state, self.state = self.state, None
        absent = [name for name in COORDINATES if name not in state]
        if absent:
            self.fail(self.state_line, f"{printable(self.agent)} {absent[0]}", "missing in this state")
        x, y, t = (self.number(self.state_line, f"{printable(self.agent)} {name}", state[name]) for name in COORDINATES)
        try:
            self.table.add(self.agent, t, (x, y), self.radius)
        except Refused as refused:
            self.fail(self.state_line, f"{printable(self.agent)} {refused.field}", refused.reason)
        self.ends[self.agent] = t

    def end_agent(self) -> None:
        self.end_state()
        if self.agent is not None and self.item_indent is None:
            self.fail(self.agent_line, printable(self.agent), "no state")
        self.agent = self.item_indent = None

    def number(self, line: int, field: str, text: str) -> Fraction:
        try:
            if _OCTAL.match(text):
                raise ValueError("0 before another digit: YAML may read it as octal")
            return numbers.decimal(text)
        except ValueError as error:
            self.fail(line, field, f"{printable(text, 40)!r}: {error}")

    def require_whole(self) -> None:
        """A schedule that lost states is not the one that was made. An agent costs no more than it takes."""
        if "makespan" not in self.statistics:
            return
        for name, total in (("makespan", max(self.ends.values(), default=Fraction(0))),
                            ("cost", sum(self.ends.values(), Fraction(0)))):
            if self.statistics.get(name, total) > total:
                self.fail(0, f"statistics {name}", f"{numbers.text(self.statistics[name])}, and the schedule takes "
                          f"only {numbers.text(total)}: states are missing")

    def remarks(self) -> Iterator[str]:
        yield "t is counted in time steps, lengths in cells"
        yield ("an agent is there from its first state to its last; whether it stays at its goal or leaves is not in the "
               "file")
        yield "obstacles of the map are not in the file"
        yield ("the file does not give the size of an agent: give --radius where the table is read"
               if self.radius is None else f"the radius of every disk is {numbers.text(self.radius)}, as given")
        yield "no digit is lost"


def read(path: str, *, radius: Optional[Fraction] = None) -> Table:
    """The paths of agents. Raises InputError."""
    return _Reader(path, radius).read()
