"""A plane for positions in degrees, and angles in decimals of more digits than any file has."""

import decimal
from decimal import Decimal
from fractions import Fraction
from typing import Iterable, List, Tuple

from . import numbers
from .table import Place

DIGITS = decimal.Context(prec=60)
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459")
EARTH_RADIUS = Decimal("6371008.8")  # metres, the mean one
LARGEST_LATITUDE = 89  # degrees; nearer to a pole there is no such plane
PLACES = 6  # in metres a degree, and in other factors that are rounded


def as_decimal(value: Fraction) -> Decimal:
    """The value, rounded to DIGITS."""
    return DIGITS.divide(Decimal(value.numerator), Decimal(value.denominator))


def sine(radians: Decimal) -> Decimal:
    with decimal.localcontext(DIGITS):
        power, total, k = radians, radians, 1
        while abs(power) > Decimal("1e-58"):
            k += 2
            power *= -radians * radians / (k * (k - 1))
            total += power
        return total


def sine_and_cosine(degrees: Fraction) -> Tuple[Decimal, Decimal]:
    with decimal.localcontext(DIGITS):
        radians = as_decimal(degrees % 360) * PI / 180
        return sine(radians), sine(PI / 2 - radians)


def direction(start: Place, end: Place) -> Tuple[Decimal, Decimal]:
    """From one place to another: the sine and cosine of the heading. Precondition: they differ."""
    with decimal.localcontext(DIGITS):
        x, y = (as_decimal(b - a) for a, b in zip(start, end))
        length = (x * x + y * y).sqrt()
        return x / length, y / length


class Projection:
    """x to the east and y to the north of a point, in metres, by two factors with PLACES decimals.

    So the plane place of a position is exact: what is rounded are the factors, once, and they are told.
    """

    def __init__(self, latitude: Fraction, longitude: Fraction):
        """About a point in degrees. Raises ValueError where there is no such plane."""
        self.latitude = check_latitude(latitude)
        self.longitude = check_longitude(longitude)
        with decimal.localcontext(DIGITS):
            north = EARTH_RADIUS * PI / 180
            self.north = numbers.rounded(north, PLACES)
            self.east = numbers.rounded(north * sine_and_cosine(latitude)[1], PLACES)

    def place(self, latitude: Fraction, longitude: Fraction) -> Place:
        """The place of a position in degrees; longitudes are counted the short way around the Earth."""
        around = (longitude - self.longitude + 180) % 360 - 180
        return self.east * around, self.north * (latitude - self.latitude)

    def remarks(self, latitudes: Iterable[Fraction]) -> List[str]:
        """Remarks on the plane, and on how far off lengths in it are at these latitudes."""
        here = float(sine_and_cosine(self.latitude)[1])
        worst = max((abs(here / float(sine_and_cosine(value)[1]) - 1) for value in {*latitudes}), default=0.0)
        return [
            f"the plane is equirectangular about latitude {numbers.text(self.latitude)}, longitude "
            f"{numbers.text(self.longitude)}: x = {numbers.text(self.east)} m a degree of longitude, "
            f"y = {numbers.text(self.north)} m a degree of latitude",
            f"lengths from west to east are off by {100 * worst:.2g} % at most in this plane, and lengths in all "
            "directions by another 0.6 % at most, because the Earth is no sphere",
        ]


def around(latitudes: List[Fraction], longitude: Fraction) -> Projection:
    """About the middle of the latitudes and a longitude, both rounded to hundredths of a degree."""
    def hundredths(value: Fraction) -> Fraction:
        return Fraction(round(value * 100), 100)
    return Projection(hundredths((min(latitudes) + max(latitudes)) / 2), hundredths(longitude))


def check_latitude(value: Fraction) -> Fraction:
    if abs(value) > LARGEST_LATITUDE:
        raise ValueError(f"a latitude of more than {LARGEST_LATITUDE} degrees")
    return value


def check_longitude(value: Fraction) -> Fraction:
    """Up to 360, because some count so."""
    if not -180 <= value <= 360:
        raise ValueError("a longitude that is not from -180 to 360 degrees")
    return value
