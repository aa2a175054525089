"""The Voronoi diagram at one instant."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import TYPE_CHECKING, Optional

import numpy as np

from . import _core
from .scene import Path

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Incidences:
    """The vertices and edges of a diagram, which has them in `_core`."""

    _core: "_core.Diagram | _core.StaticDiagram"

    @property
    def vertices(self) -> np.ndarray:
        """The three generators of each vertex, counterclockwise, shape (m, 3), sorted."""
        return self._core.vertices()

    @property
    def vertex_positions(self) -> np.ndarray:
        """The centre of the circle that touches the three, shape (m, 2)."""
        return self._core.vertex_positions()

    @property
    def vertex_radii(self) -> np.ndarray:
        """The radius of that circle, shape (m,)."""
        return self._core.vertex_radii()

    @property
    def edges(self) -> np.ndarray:
        """Each edge as l, r, s, e, shape (k, 4), sorted: l to its left, r to its right, s and e at
        its ends."""
        return self._core.edges()


class Diagram(Incidences):
    """The diagram of n disks and their container at a time `t`: exact topology, rounded places.

    Made by `Scene.diagram(t)`, `History.diagram(t)` and `Diagram.read(path)`.
    """

    def __init__(self, core: _core.Diagram):
        self._core = core

    @classmethod
    def read(cls, path: Path) -> "Diagram":
        """Reads a diagram file. Raises InputError."""
        return cls(_core.read_diagram(os.fspath(path)))

    def write(self, path: Path) -> None:
        """Writes a diagram file, whole or not at all. Raises OutputError."""
        self._core.write(os.fspath(path))

    @property
    def t(self) -> Fraction:
        return self._core.t

    @property
    def scene_sha256(self) -> str:
        return self._core.scene_sha256

    @property
    def container(self) -> "tuple[float, float, float]":
        """x and y of its centre, and its radius."""
        return self._core.container

    @property
    def positions(self) -> np.ndarray:
        """The centres of the disks, shape (n, 2)."""
        return self._core.positions()

    @property
    def velocities(self) -> np.ndarray:
        """The velocities of the disks just after t, shape (n, 2)."""
        return self._core.velocities()

    @property
    def radii(self) -> np.ndarray:
        """The radii of the disks, shape (n,)."""
        return self._core.radii()

    def neighbours(self, generator: int) -> "list[int]":
        """The generators whose cells share an edge with that of the generator, sorted."""
        return self._core.neighbours(generator)

    def edge_polylines(self, tolerance: Optional[float] = None) -> "list[np.ndarray]":
        """The edges in their order as chains of points, each of shape (p, 2).

        Chords keep within about `tolerance` of the true arcs, by default a thousandth of the
        container's radius. Raises ValueError for less than 1e-9 of it.
        """
        return self._core.edge_polylines(self._tolerance(tolerance))

    def cell_polygons(self, tolerance: Optional[float] = None) -> "list[np.ndarray]":
        """The boundaries of the cells of disks 0 to n-1 and, at -1, of the container.

        Closed polygons of shape (p, 2) with the cell on the left: those of disks run
        counterclockwise. The container's cell lies outside of its own. Errors as for edges.
        """
        return self._core.cell_polygons(self._tolerance(tolerance))

    def cell_areas(self, tolerance: Optional[float] = None) -> np.ndarray:
        """The areas of the disks' cells by their polygons, shape (n,)."""
        areas = []
        for polygon in self.cell_polygons(tolerance)[:-1]:
            x, y = (polygon - polygon[0]).T
            areas.append(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
        return np.array(areas, dtype=float)

    def _tolerance(self, tolerance: Optional[float]) -> float:
        return 1e-3 * self.container[2] if tolerance is None else tolerance

    def plot(self, ax: "Optional[Axes]" = None) -> "Axes":
        """Draws the disks and the cells. Needs matplotlib."""
        from .plots import plot_diagram
        return plot_diagram(self, ax)

    def __repr__(self) -> str:
        return (f"<Diagram at t = {self.t}: {len(self.radii)} disks, {len(self.vertices)} vertices, "
                f"{len(self.edges)} edges>")
