"""Zeros of a gap in a window of time, and the order of roots in two windows."""
from math import inf, nextafter

from fields import Wrong
from flip import Three, cotangency, gap_at, require_apart
from polynomial import (before, common_divisor, derivative, dyadic, middle, roots_between, squarefree,
                        vanishes)


def apart_from(root, other):
    """A place between two roots, neither of which it is."""
    while not before(root.high, other.low) and (root.exact or other.exact or before(other.low, root.high)):
        root.refine()
        other.refine()
    return middle(root.high, other.low)


def places_between(roots, t0, t1):
    return [t0, *(apart_from(r, s) for r, s in zip(roots, roots[1:])), t1]


def require_neighbours(low, high):
    if low != high and high != nextafter(low, inf):
        raise Wrong("LO and HI are neither equal nor neighbours")


def is_rounded(root, low, high):
    """Whether low and high, equal or neighbours, are the root, rounded down and up."""
    if low == high:
        return root.side(dyadic(low)) == 0
    return root.side(dyadic(low)) > 0 > root.side(dyadic(high))


def zeros_of_gap(generators, t0, t1):
    """(the sign at t0, [(root, order, sign after)]) of the gap between the circle of three, which is shown to
    exist in all of [t0, t1], and the fourth."""
    require_apart(generators, t0, t1)
    first = gap_at(generators, t0)
    if not first or not gap_at(generators, t1):
        raise Wrong("the gap is zero at an end of the window")
    three = Three(generators[:3])
    three.require_finite(t0, t1)
    # f vanishes with the gap, and where the other circle of the three touches the fourth.
    f, gap = cotangency(generators), None
    if not f or not three.a:
        gap = three.gap(generators[3])
        f = gap.u
    free = squarefree(f)
    roots = roots_between(free, t0, t1)
    simple = len(free) == len(f)
    places = places_between(roots, t0, t1)
    found, last = [], first
    for root, place in zip(roots, places[1:]):
        now = gap_at(generators, place)
        assert now
        order = int(now != last)
        # A simple zero of f is a simple zero of the gap, if its sign changes, or none of it.
        if gap is not None or not (simple or not vanishes(derivative(f), root)):
            gap = gap or three.gap(generators[3])
            order = gap.order(root)
            assert order is not None and order >= 0 and order % 2 == (now != last)
        if order:
            found.append((root, order, now))
        last = now
    return first, found


def single_root(f, t0, t1):
    """The only root in the open window, of the squarefree part of f."""
    if not f:
        raise Wrong("f is zero at all times")
    roots = roots_between(squarefree(f), t0, t1)
    if len(roots) != 1:
        raise Wrong(f"{len(roots)} roots in a window")
    return roots[0]


def same(r, s):
    """Whether two roots, each the only one of its polynomial in its interval, are equal."""
    if r.exact or s.exact:
        exact, other = (r, s) if r.exact else (s, r)
        return other.side(exact.low) == 0
    low = s.low if before(r.low, s.low) else r.low
    high = s.high if before(s.high, r.high) else r.high
    if not before(low, high):
        return False
    divisor = common_divisor(r.p, s.p)
    # A common root in both intervals is the only one of either.
    return len(divisor) > 1 and bool(roots_between(divisor, low, high))


def order_of(r, s):
    """-1 where r is before s, 0 where they are equal, else 1."""
    if same(r, s):
        return 0
    while True:
        if not before(s.low, r.high):
            return -1
        if not before(r.low, s.high):
            return 1
        for one, other in ((r, s), (s, r)):
            one.side(other.low)
            one.side(other.high)
        r.refine()
        s.refine()
