"""Circles that touch three generators, in doubles, by the formulas of exact/predicates.h."""
import numpy as np


def tangent_circles(triples):
    """x, y, radius and side of the circle that touches the three of each triple counterclockwise.

    `triples`: x, y and signed radius of each, shape (m, 3, 3); the container's radius is negative. The side
    is negative where there is none: the circle is around the three then, and its radius negative.
    """
    # The base is a disk.
    sites = np.where(triples[:, :1, 2:] < 0, np.roll(triples, -1, axis=1), triples)
    side = np.where((sites[:, 1:, 2] < 0).any(axis=1), -1, 1)
    base = sites[:, 0].T
    (xj, yj, rj), (xk, yk, rk) = (sites[:, k].T - base for k in (1, 2))
    pj, pk = xj * xj + yj * yj - rj * rj, xk * xk + yk * yk - rk * rk
    xp, yp, sp = xj * pk - pj * xk, yj * pk - pj * yk, rj * pk - pj * rk
    xs, ys, xy = xj * rk - rj * xk, yj * rk - rj * yk, xj * yk - yj * xk
    square = xp * xp + yp * yp
    root = side * np.sqrt(np.maximum(square - sp * sp, 0))
    with np.errstate(all="ignore"):
        half = 2 * (xp * xs + yp * ys + root * xy)
        return np.stack([base[0] - (yp * root + sp * xp) / half, base[1] + (xp * root - sp * yp) / half,
                         square / half - base[2], np.sign(half)])
