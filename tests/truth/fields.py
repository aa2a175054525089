"""Fields of the truth set's lines: exact numbers, generators at rest and in motion.

All numbers are binary64, so those of one line become integers when they are multiplied by one power of
two. A similarity changes no answer, and integers are faster than fractions.
"""
import re
from fractions import Fraction

# These are exact without a check: 53 bits at most, and an exponent of a normal number.
NORMAL = re.compile(r"-?0x1(?:\.[0-9a-f]{1,13})?p[+-]\d{1,3}\Z").match
ANY_HEX = re.compile(r"(-?)0x([0-9a-fA-F]+)(?:\.([0-9a-fA-F]*))?p([+-]?\d{1,4})\Z").match
INTEGER = re.compile(r"-?(?:0|[1-9]\d*)\Z").match
AXES = {(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)}


class Malformed(Exception):
    """The line is not of the format."""


class Wrong(Exception):
    """The line is of the format, but what it says is not so."""


def binary64(text):
    """The float that a hexadecimal token denotes exactly."""
    if NORMAL(text):
        return float.fromhex(text)
    match = ANY_HEX(text)
    if not match:
        raise Malformed(f"no hexadecimal number: {text!r}")
    sign, whole, part, exponent = match.groups()
    digits = part or ""
    exact = int(whole + digits, 16) * Fraction(2) ** (int(exponent) - 4 * len(digits))
    try:
        value = float.fromhex(text)
    except OverflowError:
        raise Malformed(f"beyond binary64: {text}") from None
    if abs(Fraction(value)) != exact:
        raise Malformed(f"no binary64: {text}")
    return value


class Fields:
    """The fields of one line, taken from left to right."""

    def __init__(self, line):
        self.tokens = line.split(" ")
        if "" in self.tokens:
            raise Malformed("an empty line, or a blank too many")
        self.place = 0

    def word(self, *allowed):
        if self.place == len(self.tokens):
            raise Malformed("too few fields")
        token = self.tokens[self.place]
        if allowed and token not in allowed:
            raise Malformed(f"{token!r}, not one of {' '.join(allowed)}")
        self.place += 1
        return token

    def integer(self, least, most):
        token = self.word()
        if not INTEGER(token) or len(token) > 9 or not least <= int(token) <= most:
            raise Malformed(f"{token!r} is no integer from {least} to {most}")
        return int(token)

    def number(self):
        return binary64(self.word())

    def numbers(self, count):
        return [self.number() for _ in range(count)]

    def generators(self, count, rates=False):
        """Pairs of a letter and its numbers: 3, or 6 in motion."""
        return [(self.word("d", "c", "w"), self.numbers(6 if rates else 3)) for _ in range(count)]

    def end(self):
        if self.place != len(self.tokens):
            raise Malformed("too many fields")


def admissible(generators):
    """Raises Wrong where generators are not those that the format describes."""
    letters = [letter for letter, _ in generators]
    if letters.count("c") > 1 or ("c" in letters and "w" in letters):
        raise Wrong("a container beside another or beside a wall")
    for letter, numbers in generators:
        if letter == "w" and tuple(numbers[:2]) not in AXES:
            raise Wrong("a wall's vector is no unit vector along an axis")
        if letter != "w" and numbers[2] < 0:
            raise Wrong("a negative radius")
        if letter != "d" and any(numbers[3:]):
            raise Wrong("a container or wall that moves")


def integers(values):
    """The values times one power of two that makes integers of all of them."""
    ratios = [value.as_integer_ratio() for value in values]
    scale = max((denominator for _, denominator in ratios), default=1)
    return [numerator * (scale // denominator) for numerator, denominator in ratios]


def scaled(generators):
    """Admissible generators as (letter, integer, ...). A wall's vector is not scaled: it is a direction."""
    flat = []
    for letter, numbers in generators:
        flat += numbers[2:] if letter == "w" else numbers
    rest = iter(integers(flat))
    result = []
    for letter, numbers in generators:
        if letter == "w":
            a, b = int(numbers[0]), int(numbers[1])
            result.append((letter, a, b, next(rest), *(next(rest) for _ in numbers[3:])))
        else:
            result.append((letter, *(next(rest) for _ in numbers)))
    return result
