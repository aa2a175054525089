"""The table of pieces that an importer writes of curves: polynomials in the time since a piece begins.

Its columns are disk, t, duration, x^0, x^1, ... and so on for y and z, and perhaps radius.
"""

from fractions import Fraction
from typing import Iterator, List, NamedTuple, Optional, Sequence

from . import numbers
from .faults import Refused, printable
from .table import Paths

DEGREE = 7  # the highest
MOST_BITS = 2000  # in a numerator or denominator, so that 24 such numbers fit in a line of the table


class _Flight(NamedTuple):
    end: Fraction
    radius: Optional[Fraction]


class Pieces(Paths):
    """Pieces: a disk is at the sum of x^k s^k at the time s since the piece began. Those of a disk follow each other
    without a gap in time, and may jump in place.
    """

    ROWS = "pieces"

    def __init__(self, with_radius: bool, dimension: int):
        super().__init__(with_radius, dimension)
        self._degree = 0

    def add(self, name: str, t: Fraction, duration: Fraction, curves: Sequence[Sequence[Fraction]],
            radius: Optional[Fraction] = None) -> None:
        """A piece. `curves`: coefficients by axis, the constant one first, at most DEGREE + 1.

        Raises Refused where the table cannot hold it.
        """
        values = [("t", t), ("duration", duration), *((f"{axis}^{k}", value) for axis, curve in zip(self._axes, curves)
                                                      for k, value in enumerate(curve))]
        for field, value in values:
            if max(value.numerator.bit_length(), value.denominator.bit_length()) > MOST_BITS:
                raise Refused(field, f"a numerator or denominator of more than {MOST_BITS} bits")
        self._require(name, values, radius)
        if duration <= 0:
            raise Refused("duration", "not positive")
        known = self._disks.get(name)
        if known is not None and t != known.end:
            raise Refused("t", f"{'before' if t < known.end else 'after'} the end of the piece before of disk "
                          f"{printable(name)}: pieces follow each other without a gap in time")
        kept = [_without_zeros(curve) for curve in curves]
        self._degree = max(self._degree, *(len(curve) - 1 for curve in kept))
        self._put(name, _Flight(t + duration, radius), t, t + duration,
                  [numbers.text(t), numbers.text(duration), *(" ".join(map(numbers.text, curve)) for curve in kept)])

    def _columns(self) -> List[str]:
        return ["t", "duration", *(f"{axis}^{k}" for axis in self._axes for k in range(self._degree + 1))]

    def _written(self) -> Iterator[str]:
        """The degree of the table is known only after its last piece: coefficients of an axis wait in one cell."""
        first, end = 3, 3 + len(self._axes)
        self._rows.seek(0)
        for row in self._rows:
            cells = row.rstrip("\n").split(",")
            curves = [cell.split(" ") for cell in cells[first:end]]
            filled = [value for curve in curves for value in curve + ["0"] * (self._degree + 1 - len(curve))]
            yield ",".join([*cells[:first], *filled, *cells[end:]]) + "\n"

    def _own_remarks(self) -> Iterator[str]:
        yield f"pieces are polynomials of degree {self._degree} at most"


def _without_zeros(curve: Sequence[Fraction]) -> Sequence[Fraction]:
    """Without zeros at its end, but for the constant."""
    last = max((k for k, value in enumerate(curve) if value != 0), default=0)
    return curve[:last + 1]
