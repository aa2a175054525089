"""Answers about the recorded motion over time."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple, Optional


class Neighbourhood(NamedTuple):
    """A spell in which a generator's cell shares an edge with that of the disk asked for."""

    generator: int
    start: Fraction
    end: Fraction


class LeastGap(NamedTuple):
    """The least gap of i < j, reached first at t; `gap` is a pair of floats with the gap between."""

    i: int
    j: int
    t: Fraction
    gap: "tuple[float, float]"
    contact: bool


def least_gap_of(answer: Any) -> Optional[LeastGap]:
    return None if answer is None else LeastGap(*answer)
