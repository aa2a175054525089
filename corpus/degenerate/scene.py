"""Scenes by exact numbers, and their files."""
import json
from dataclasses import dataclass, field
from fractions import Fraction


def exact(x):
    """An exact number from an int, a Fraction or text ("1/3", "0.1", "1e-40")."""
    if isinstance(x, float):
        raise TypeError(f"{x}: a float is not exact enough to describe a scene")
    return Fraction(x)


def decimal_text(x):
    """The finite decimal of a Fraction, or None where there is none of at most 60 digits."""
    denominator, twos, fives = x.denominator, 0, 0
    while denominator % 2 == 0:
        denominator, twos = denominator // 2, twos + 1
    while denominator % 5 == 0:
        denominator, fives = denominator // 5, fives + 1
    places = max(twos, fives)
    if denominator != 1 or places > 60:
        return None
    digits = str(abs(x.numerator) * 10**places // x.denominator).rjust(places + 1, "0")
    whole, rest = digits[:len(digits) - places], digits[len(digits) - places:]
    return ("-" if x < 0 else "") + whole + ("." + rest if rest else "")


def float_text(x):
    """The shortest decimal of a binary64, as the program writes it."""
    if x == int(x) and abs(x) < 2**53:
        return str(int(x))
    mantissa, _, exponent = repr(x).partition("e")
    mantissa = mantissa.removesuffix(".0")
    return mantissa + (f"e{int(exponent)}" if exponent else "")


def number_text(x):
    """JSON for exactly x: a number where some binary64 equals it, else a string."""
    if Fraction(float(x)) == x:
        return float_text(float(x))
    return json.dumps(decimal_text(x) or f"{x.numerator}/{x.denominator}")


def instant_text(x):
    """JSON for an instant, as diagram files write it: what is no binary64 is "p/q"."""
    return float_text(float(x)) if Fraction(float(x)) == x else f'"{x.numerator}/{x.denominator}"'


@dataclass
class Disk:
    x: Fraction
    y: Fraction
    r: Fraction
    vx: Fraction
    vy: Fraction
    mass: Fraction = None

    def at(self, t):
        return (self.x + t * self.vx, self.y + t * self.vy)


def disk(x, y, r, vx=0, vy=0, mass=None):
    """A disk by anything that `exact` takes. A point among others gets mass 1: it has no default."""
    r = exact(r)
    if mass is None and r == 0:
        mass = 1
    return Disk(exact(x), exact(y), r, exact(vx), exact(vy), None if mass is None else exact(mass))


@dataclass
class Scene:
    radius: Fraction
    horizon: Fraction
    disks: list
    maneuvers: list = field(default_factory=list)  # (t, disk, vx, vy)
    center: tuple = (0, 0)
    restitution: Fraction = 1
    wall: Fraction = 1
    law: str = "normal"

    def text(self, name, comment):
        def pair(x, y):
            return f"[{number_text(exact(x))}, {number_text(exact(y))}]"

        lines = ['{"format": "voroproof-scene", "version": 1,',
                 f' "name": {json.dumps(name)}, "comment": {json.dumps(comment)},',
                 f' "container": {{"center": {pair(*self.center)}, '
                 f'"radius": {number_text(exact(self.radius))}'
                 + (f', "restitution": {number_text(exact(self.wall))}' if self.wall != 1 else "")
                 + "},"]
        if self.law != "normal":
            lines.append(f' "container_law": "{self.law}",')
        if self.restitution != 1:
            lines.append(f' "restitution": {number_text(exact(self.restitution))},')
        lines.append(f' "horizon": {number_text(exact(self.horizon))},')
        disks = [f'  {{"center": {pair(d.x, d.y)}, "radius": {number_text(d.r)}, '
                 f'"velocity": {pair(d.vx, d.vy)}'
                 + (f', "mass": {number_text(d.mass)}' if d.mass is not None else "") + "}"
                 for d in self.disks]
        lines.append(' "disks": [' + ("\n" + ",\n".join(disks) if disks else "") + "]"
                     + ("," if self.maneuvers else "}"))
        if self.maneuvers:
            turns = [f'  {{"t": {number_text(exact(t))}, "disk": {i}, "velocity": {pair(vx, vy)}}}'
                     for t, i, vx, vy in sorted(self.maneuvers,
                                                key=lambda m: (exact(m[0]), m[1]))]
            lines.append(' "maneuvers": [\n' + ",\n".join(turns) + "]}")
        return "\n".join(lines) + "\n"


def scene(radius, horizon, disks, **options):
    return Scene(exact(radius), exact(horizon), list(disks), **options)


@dataclass
class Generated:
    """The output of `voroproof generate` for these words. Scenes that only the program can tell have wrong
    variants by edits alone."""
    words: tuple
