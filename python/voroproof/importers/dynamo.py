"""Configurations of DynamO and what happens in its runs, as billiards and their histories."""

from fractions import Fraction
from typing import Iterator, Optional

from . import dynamo_config, dynamo_events, numbers
from .billiard import Billiard, Told
from .faults import fail

NAME = "dynamo"


def _remarks(events: dynamo_events.Events) -> Iterator[str]:
    half = numbers.text(Fraction(1, 2 * 10**events.decimals))
    yield (f"the file of events gives times with {events.decimals} decimals: each is the time, at most {half} from "
           "that, at which the paths are where the file has the particles")
    yield "velocities follow from the impulses of the file, which has 17 digits of them"
    if events.astray:
        yield (f"{events.astray} collisions are not where the paths lead: they have the time of the file, and "
               f"--tolerance {numbers.text(Fraction(1, 10**events.decimals))} may be needed")
    if events.beyond:
        yield f"{events.beyond} collisions after the horizon are left out"


def read(path: str, *, horizon: Optional[Fraction] = None, events: Optional[str] = None,
         history: Optional[str] = None) -> Billiard:
    """The scene of a configuration, and with `events` (trajectory.out of a run that began with it) the history that
    goes into the file `history`. Without a horizon it is the time of the last collision. Raises InputError.
    """
    if (events is None) != (history is None):
        fail(path, 0, "", "--events and --history go together: the file of the collisions, and the one to write")
    if events is None and horizon is None:
        fail(path, 0, "", "the file does not say when the run ends: give --horizon")
    setting, remarks = dynamo_config.read(path)
    remarks += ["lengths, times and masses are in the units of the file",
                "no digit is lost: decimals are taken as they stand"]
    if events is None:
        return Billiard(setting, horizon, remarks)
    told = dynamo_events.read(events, setting, horizon)
    if horizon is None:
        if told.collisions == 0:
            fail(events, 0, "", "no collision, and so no end of the run: give --horizon")
        horizon = Fraction(told.last)
        remarks.append("the horizon is the time of the last collision of the file")
    remarks += _remarks(told)
    return Billiard(setting, horizon, remarks, Told("DynamO", told.lines, told.collisions), history)
