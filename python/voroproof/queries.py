"""Questions about one instant of a scene, answered by its true motion; all order is exact."""

from __future__ import annotations

from typing import NamedTuple

from . import _core
from .free_space import Critical, OffsetArc, Void, arc_of, critical_of, void_of
from .scene import Number

#: Two floats with the true value between them.
Enclosure = "tuple[float, float]"


class NearDisk(NamedTuple):
    """A disk and the distance of the point from its boundary, negative inside.

    `tied`: at the very same distance as the one before.
    """

    disk: int
    distance: "tuple[float, float]"
    tied: bool


class Neighbour(NamedTuple):
    """A generator whose cell shares so many edges, and the gap between the boundaries."""

    generator: int
    edges: int
    gap: "tuple[float, float]"


class Closest(NamedTuple):
    """All pairs that have the least gap; `gap` has no meaning where there is no pair."""

    pairs: "list[tuple[int, int]]"
    gap: "tuple[float, float]"


class Instant:
    """The scene just after all events at a time: `Scene.at(t)`. All may raise Undecided."""

    def __init__(self, core: _core.Instant):
        self._core = core

    def nearest(self, x: Number, y: Number, count: int = 1) -> "list[NearDisk]":
        """The `count` nearest disks to the point, nearest first, equally near ones by their ids."""
        return [NearDisk(*near) for near in self._core.nearest(x, y, count)]

    def neighbours(self, disk: int) -> "list[Neighbour]":
        """The generators whose cells share an edge with that of the disk, by their ids."""
        return [Neighbour(*n) for n in self._core.neighbours(disk)]

    def closest_generators(self) -> Closest:
        """The closest pairs, of two disks or of a disk and the container."""
        return Closest(*self._core.closest_generators())

    def closest_disks(self) -> Closest:
        """The closest pairs of disks."""
        return Closest(*self._core.closest_disks())

    # Where a probe of the given radius fits; ValueError for negative radii.

    def offset(self, probe: Number) -> "list[OffsetArc]":
        """The boundary of the places for the probe's centre: arcs by generator, the container's first."""
        return [arc_of(arc) for arc in self._core.offset(probe)]

    def voids(self, probe: Number) -> "list[Void]":
        """The components of the places for the probe's centre, in the order of their smallest vertices."""
        return [void_of(v) for v in self._core.voids(probe)]

    def critical(self) -> Critical:
        """For all probes at once: when each tunnel closes and each void vanishes."""
        return critical_of(self._core.critical())
