"""The colours of disks in pictures, the same that the program draws (apps/draw/colours.h)."""

from __future__ import annotations

from typing import Tuple

_PALETTE = ((0.36, 0.58, 0.82), (0.93, 0.60, 0.32), (0.44, 0.70, 0.47), (0.85, 0.45, 0.47),
            (0.60, 0.51, 0.77), (0.87, 0.76, 0.33), (0.35, 0.70, 0.71), (0.84, 0.55, 0.74))
_NEXT_HUE = (6, 3, 5, 7, 0, 1, 2, 4)
_GOLDEN_SECTION = 0.6180339887498949

INK = (0.20, 0.23, 0.30)
#: The share of a disk's colour in its cell.
CELL_SHARE = 0.32


def disk_colour(disk: int) -> Tuple[float, float, float]:
    """Red, green and blue in [0, 1]: they follow from the id alone."""
    step, hue = divmod(disk, len(_PALETTE))
    share = _GOLDEN_SECTION * step % 1.0
    r, g, b = (x + share * (y - x) for x, y in zip(_PALETTE[hue], _PALETTE[_NEXT_HUE[hue]]))
    return r, g, b


def cell_colour(disk: int) -> Tuple[float, float, float]:
    """The colour of the disk, paler."""
    r, g, b = (1 + CELL_SHARE * (x - 1) for x in disk_colour(disk))
    return r, g, b
