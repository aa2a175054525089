"""Coordinates in boxes whose opposite sides are one (periodic boundaries)."""

from fractions import Fraction
from typing import List, Optional, Tuple

UNWRAP, AS_IS = "unwrap", "as-is"
Bounds = Tuple[Fraction, Fraction]

MISSING = ("the box is periodic, and the periodic images of the disks are not in the table: across a side two may come "
           "nearer than in it")


def side(axis: str, periodic: Optional[bool], treatment: Optional[str]) -> None:
    """Raises ValueError where a periodic axis, or one of which that is not known (None), has no treatment."""
    if treatment is None and periodic is not False:
        state = "periodic" if periodic else "perhaps periodic: the file does not say"
        raise ValueError(f"the box is {state} in {axis}: give --periodic unwrap (by image flags, or by coordinates "
                         "that are unwrapped) or --periodic as-is (where no disk crosses a side)")


def require_no_jump(axis: str, before: Fraction, now: Fraction, length: Fraction) -> None:
    """Raises ValueError where a wrapped coordinate changes by more than half of the box: it crossed a side."""
    if 2 * abs(now - before) > length:
        raise ValueError(f"{axis} changes by more than half of the box between two samples: the disk crossed a side, "
                         "and its coordinates are not unwrapped")


class Plane:
    """That all heights of a file are one, or are left out on request."""

    def __init__(self, flatten: bool):
        self._flatten = flatten
        self._height: Optional[Fraction] = None
        self._differs = False

    def take(self, z: Fraction) -> None:
        """Raises ValueError where heights differ and are not to be left out."""
        if self._height is None:
            self._height = z
        elif z != self._height:
            self._differs = True
            if not self._flatten:
                raise ValueError("not the same for all disks: this motion is not in a plane (--flatten leaves heights "
                                 "out, and judges the shadows)")

    def remarks(self) -> List[str]:
        if self._differs:
            return ["heights are left out: the disks are shadows on the xy plane, and overlap where bodies pass over "
                    "each other"]
        return []
