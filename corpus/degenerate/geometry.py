"""Rational points, rotations and polynomials."""
import math
from fractions import Fraction


def unit(t):
    """The rational point ((1-t^2)/(1+t^2), 2t/(1+t^2)) of the unit circle."""
    t = Fraction(t)
    return ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))


def ring(k, turn=Fraction(1, 7), digits=12):
    """k rational points of the unit circle, counterclockwise and nearly evenly spaced."""
    points = []
    for i in range(k):
        angle = 2 * math.pi * i / k + float(turn)
        angle = math.remainder(angle, 2 * math.pi)
        points.append(unit(Fraction(math.tan(angle / 2)).limit_denominator(digits)))
    if len(set(points)) != k:
        raise ValueError(f"{k} points need finer fractions than 1/{digits}")
    return points


def turned(x, y, u):
    """(x, y) turned by the direction of the unit vector u."""
    return (x * u[0] - y * u[1], x * u[1] + y * u[0])
