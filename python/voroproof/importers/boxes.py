"""Coordinates in boxes whose opposite sides are one (periodic boundaries)."""

from fractions import Fraction
from typing import Dict, List, Optional, Tuple

from .table import Table

UNWRAP, AS_IS = "unwrap", "as-is"
Bounds = Tuple[Fraction, Fraction]

PERHAPS_MISSING = "the periodic images of the disks, where the box is periodic: the file does not say whether it is"
CHANGING_MISSING = "the periodic images of the disks: the box is not the same in all frames"


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


class Images:
    """The sides of a periodic box, as the frames of a file give them."""

    def __init__(self) -> None:
        self._sides: Dict[int, Optional[Fraction]] = {}  # by axis; None where it is not periodic
        self._missing: Dict[int, str] = {}  # by axis

    def take(self, axis: int, periodic: Optional[bool], length: Optional[Fraction]) -> None:
        """Takes one frame. `periodic` or `length` None: the file does not say."""
        if periodic is None or (periodic and length is None):
            self._missing[axis] = PERHAPS_MISSING
        side = length if periodic else None
        if self._sides.setdefault(axis, side) != side:
            self._missing[axis] = CHANGING_MISSING

    def tell(self, table: Table) -> None:
        """Lets the table, which is whole, have the sides, or name the images as missing."""
        table.missing += {why for axis, why in self._missing.items() if axis < table.dimension()}
        table.sides = [self._sides.get(axis) for axis in range(3)]


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
