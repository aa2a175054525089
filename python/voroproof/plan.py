"""Collision-free plans: everybody flies straight to its goal and arrives at the same time."""

from __future__ import annotations

from fractions import Fraction
from typing import Callable, Iterable, NamedTuple, Optional, Tuple

from . import _core
from .scene import Number, Scene


class Vehicle(NamedTuple):
    """A vehicle: radius, where it starts, where it shall arrive."""

    radius: Number
    start: Tuple[Number, Number]
    goal: Tuple[Number, Number]


class Approach(NamedTuple):
    """Two vehicles and the least gap of their boundaries, proved: a pair of floats around it."""

    i: int
    j: int
    t: Fraction
    gap: "tuple[float, float]"


class Plan(NamedTuple):
    """`found`: everybody keeps the clearance, proved. `scene` is the plan (so far) as a scene.

    `nearest` is the least gap of the plan, None with fewer than two. Where no plan was found
    `conflict` is a pair that cannot, or does not, keep the clearance. `avoided` counts the
    conjunctions that were predicted.
    """

    found: bool
    scene: Scene
    nearest: Optional[Approach]
    conflict: Optional[Approach]
    avoided: int


def plan(vehicles: Iterable[Vehicle], *, container: Tuple[Number, Number, Number], arrive: Number,
         clearance: Number = 0, name: str = "",
         progress: Optional[Callable[[int], Optional[bool]]] = None) -> Plan:
    """Plans flights from 0 to `arrive` > 0; conjunctions are avoided by changes of speed.

    `container` is x, y, radius; starts and goals lie strictly inside. `clearance` >= 0 is the least
    gap between two vehicles. `progress(conjunctions)` is told how many are left; False stops with
    what there is. Deterministic. Raises InputError where the task is none.
    """
    fields = [(v.radius, *v.start, *v.goal) for v in (Vehicle(*given) for given in vehicles)]
    made = _core.plan(fields, tuple(container), arrive, clearance, name, progress)
    approach = lambda a: None if a is None else Approach(*a)
    return Plan(made["found"], Scene._of(made["scene"]), approach(made["nearest"]),
                approach(made["conflict"]), made["avoided"])
