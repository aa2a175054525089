"""Histories of all kinds: an array of events, and a file."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Tuple

import numpy as np

from . import _core
from .scene import Number, Path

if TYPE_CHECKING:
    import pandas

FLIP, COLLISION, MANEUVER = 0, 1, 2
KINDS = ("flip", "collision", "maneuver")


class Ending(NamedTuple):
    """How a history ends: complete up to its horizon t, or right before t only, and why."""

    complete: bool
    t: float
    reason: str


def core_ending(ending: Optional[Ending], horizon: Number) -> _core.Ending:
    """The ending given, by default that of a history which is complete."""
    return _core.Ending(*(ending or Ending(True, float(Fraction(horizon)), "")))


class Events:
    """A history, whatever its events are."""

    _core: Any
    _kinds: Tuple[str, ...] = KINDS

    def write(self, path: Path) -> None:
        """Writes a history file, whole or not at all. Raises OutputError and InputError."""
        self._core.write(os.fspath(path))

    @property
    def events(self) -> np.ndarray:
        """The events, shape (k,): the memory itself, for reading only."""
        return self._core.rows

    def _frame(self, axes: str) -> "pandas.DataFrame":
        """The events as a frame, with the coordinates along these axes."""
        import pandas

        e = self.events
        columns = {"t": e["t"], "kind": pandas.Categorical.from_codes(e["kind"], KINDS)}
        columns.update({f"id{k}": e["ids"][:, k] for k in range(e["ids"].shape[1])})
        for name, field in (("v", "velocity"), ("", "center")):
            for side in range(2):
                for axis, letter in enumerate(axes):
                    columns[f"{name}{letter}{side}"] = e[field][:, side, axis]
        return pandas.DataFrame(columns)

    @property
    def horizon(self) -> Fraction:
        """Up to which it claims to tell."""
        return self._core.horizon

    @property
    def ending(self) -> Ending:
        end = self._core.ending
        return Ending(end.complete, end.t, end.reason)

    @property
    def producer(self) -> str:
        return self._core.producer

    @property
    def rounded(self) -> int:
        """How many events of the file state numbers that no binary64 equals: here they are rounded."""
        return self._core.rounded

    def __len__(self) -> int:
        return len(self.events)

    def counts(self) -> "dict[str, int]":
        """How many events there are of each kind."""
        counts = np.bincount(self.events["kind"], minlength=len(KINDS))
        return {kind: int(counts[KINDS.index(kind)]) for kind in self._kinds}

    def __repr__(self) -> str:
        told = ", ".join(f"{count} {kind}s" for kind, count in self.counts().items())
        end = self.ending
        how = f"complete up to {end.t:g}" if end.complete else f"stopped at {end.t:g}: {end.reason}"
        return f"<{type(self).__name__}: {told}; {how}>"
