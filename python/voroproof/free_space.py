"""Where a probe, a disk of a given radius, fits between the generators (docs/queries.md, "Clearance")."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional


class Place(NamedTuple):
    """A point of the diagram.

    `kind` is "vertex", the V-vertex of three generators; "gate", the middle of the gap of two, a disk
    first; or "far", on the edge of a disk and the container, across from the disk.
    """

    kind: str
    generators: "tuple[int, ...]"


class Tunnel(NamedTuple):
    """A V-edge (l, r, s, e) as a way from end to end: probes larger than `closes` do not pass, because of `at`."""

    edge: "tuple[int, int, int, int]"
    closes: "tuple[float, float]"
    at: Place


class Vanishing(NamedTuple):
    """A place of locally greatest clearance: a void vanishes there for probes larger than `vanishes`."""

    vanishes: "tuple[float, float]"
    at: Optional[Place]


class Void(NamedTuple):
    """A component of the places for a probe's centre: the V-vertices and the open V-edges in it.

    It vanishes for probes larger than `vanishes`; `at` is the place of its greatest clearance, None without disks:
    then that is the container's centre.
    """

    vertices: "list[tuple[int, int, int]]"
    tunnels: "list[Tunnel]"
    vanishes: "tuple[float, float]"
    at: Optional[Place]


class Critical(NamedTuple):
    """The radii of probes at which a tunnel closes or a void vanishes, for all probes."""

    tunnels: "list[Tunnel]"
    voids: "list[Vanishing]"


class OffsetPoint(NamedTuple):
    """The point of the V-edge of i and j whose clearance is the probe's radius, on the left (side = 1) or the
    right (-1) of the axis from the centre of disk i to its gate with j."""

    i: int
    j: int
    side: int
    x: "tuple[float, float]"
    y: "tuple[float, float]"


class OffsetArc(NamedTuple):
    """An arc around a generator, at the probe's distance from it, counterclockwise; without ends all of the circle."""

    generator: int
    start: Optional[OffsetPoint]
    end: Optional[OffsetPoint]


class Opening(NamedTuple):
    """A spell in which a probe passes or fits; both ends are pairs of floats with the time between."""

    start: "tuple[float, float]"
    end: "tuple[float, float]"


class VoidLife(NamedTuple):
    """A void over time; `before` and `after` are the voids, by index, out of which it comes and into which it goes.

    Both are empty where it opens or vanishes, and at the ends of the window. `at` is a place in it at the beginning.
    """

    start: "tuple[float, float]"
    end: "tuple[float, float]"
    before: "list[int]"
    after: "list[int]"
    at: Optional[Place]


def _place(answer: Any) -> Optional[Place]:
    return None if answer is None else Place(*answer)


def _tunnel(answer: Any) -> Tunnel:
    edge, closes, at = answer
    return Tunnel(edge, closes, Place(*at))


def _point(answer: Any) -> Optional[OffsetPoint]:
    return None if answer is None else OffsetPoint(*answer)


def arc_of(answer: Any) -> OffsetArc:
    generator, start, end = answer
    return OffsetArc(generator, _point(start), _point(end))


def void_of(answer: Any) -> Void:
    vertices, tunnels, vanishes, at = answer
    return Void(vertices, [_tunnel(t) for t in tunnels], vanishes, _place(at))


def critical_of(answer: Any) -> Critical:
    tunnels, voids = answer
    return Critical([_tunnel(t) for t in tunnels], [Vanishing(radius, _place(at)) for radius, at in voids])


def life_of(answer: Any) -> VoidLife:
    start, end, before, after, at = answer
    return VoidLife(start, end, before, after, _place(at))
