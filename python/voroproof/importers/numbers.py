"""Numbers of files, exactly: a decimal is what it says, a binary number the fraction that it is."""

import math
import re
from decimal import Decimal
from fractions import Fraction
from typing import Union

# Limits of the tables of paths (docs/formats.md, section 11).
LEAST, MOST = Fraction(1, 10**100), Fraction(10**100)
LONGEST = 400  # characters

_DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?")
_INTEGER = re.compile(r"[+-]?[0-9]{1,18}")


def within(value: Fraction) -> Fraction:
    """The value itself. Raises ValueError where it is beyond what a table of paths may hold."""
    if value != 0 and not LEAST <= abs(value) <= MOST:
        raise ValueError("not zero, and not from 1e-100 to 1e100 in magnitude")
    return value


def decimal(text: str) -> Fraction:
    """The number that a decimal denotes. Raises ValueError."""
    if len(text) > LONGEST or not _DECIMAL.fullmatch(text):
        raise ValueError("not a decimal number")
    return within(Fraction(text))


def integer(text: str) -> int:
    """The integer of at most 18 digits that a text denotes. Raises ValueError."""
    if not _INTEGER.fullmatch(text):
        raise ValueError("not an integer")
    return int(text)


def binary(value: Union[float, int]) -> Fraction:
    """The number that a float or an int is. Raises ValueError where it is none."""
    if not math.isfinite(value):
        raise ValueError("not a finite number")
    return within(Fraction(value))


def rounded(value: Decimal, places: int) -> Fraction:
    """The decimal with that many places that is nearest to the value, ties to even."""
    return Fraction(value.quantize(Decimal(1).scaleb(-places)))


def text(value: Fraction) -> str:
    """The value as a decimal where one is equal to it, else as a fraction p/q."""
    numerator, denominator = value.numerator, value.denominator
    twos = (denominator & -denominator).bit_length() - 1
    rest, fives = denominator >> twos, 0
    while rest % 5 == 0:
        rest //= 5
        fives += 1
    if rest != 1:
        return f"{numerator}/{denominator}"
    places = max(twos, fives)
    digits = str(abs(numerator) * 10**places // denominator).rjust(places + 1, "0")
    sign = "-" if numerator < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)
