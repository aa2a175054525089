"""Coordinates in boxes whose opposite sides are one (periodic boundaries)."""

from fractions import Fraction
from typing import List, Optional, Tuple

UNWRAP, AS_IS = "unwrap", "as-is"
Bounds = Tuple[Fraction, Fraction]

MISSING = ("the box is periodic, and the periodic images of the disks are not in the table: across a side two may come "
           "nearer than in it")

PERHAPS_MISSING = ("the periodic images of the disks, where the box is periodic: the file does not say whether it is")


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


class Heights:
    """Whether the heights of a file differ, and whether they are left out on request."""

    def __init__(self, flatten: bool):
        self.flatten = flatten
        self.differ = False
        self._first: Optional[Fraction] = None

    def take(self, z: Fraction) -> None:
        if self._first is None:
            self._first = z
        self.differ = self.differ or z != self._first

    def remarks(self) -> List[str]:
        if self.differ and self.flatten:
            return ["heights are left out: the disks are shadows on the xy plane, and overlap where bodies pass over "
                    "each other"]
        return []
