"""The weighted Voronoi diagram of any disks at rest."""

from __future__ import annotations

from typing import TYPE_CHECKING, Mapping, Optional, Sequence

import numpy as np

from . import _core
from .diagram import Incidences

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Box = "tuple[float, float, float, float]"


def _corners(box: Optional[Sequence[float]]) -> "Optional[list[float]]":
    if box is None:
        return None
    corners = [float(x) for x in box]
    if len(corners) != 4:
        raise ValueError("box: not x0, y0, x1, y1")
    return corners


class StaticDiagram(Incidences):
    """The additively weighted (Apollonius) diagram of n disks, made by `voronoi`.

    All decisions are exact; coordinates are rounded to nearest. Disks may overlap, lie in each other
    and coincide. A disk that another one contains is hidden: it has no cell. In `edges`, -1 is the
    frame; without one it is infinity. `vertices` have none at infinity, and where disks overlap
    `vertex_radii` are negative.
    """

    def __init__(self, centers: np.ndarray, radii: np.ndarray,
                 frame: "Optional[tuple[float, float, float]]"):
        self.centers, self.radii, self.frame = centers, radii, frame
        self._core = _core.StaticDiagram(centers, radii, frame)

    def __repr__(self) -> str:
        where = "the plane" if self.frame is None else "a circle"
        return f"<StaticDiagram of {len(self.radii)} disks in {where}, {int(self.hidden.sum())} hidden>"

    @property
    def hosts(self) -> np.ndarray:
        """By disk: -2, or a disk that hides it, or -1 where it lies outside of the frame, shape (n,)."""
        return self._core.hosts()

    @property
    def hidden(self) -> np.ndarray:
        """Which disks have no cell, shape (n,)."""
        return self.hosts != -2

    @property
    def neighbours(self) -> np.ndarray:
        """The pairs of disks whose cells share an edge, each once, sorted, shape (k, 2)."""
        pairs = np.sort(self.edges[:, :2], axis=1)
        return np.unique(pairs[pairs[:, 0] >= 0], axis=0)

    @property
    def box(self) -> Box:
        """x0, y0, x1, y1 of all visible disks and a tenth of their size around, or of the frame."""
        return self._core.box()

    def cells(self, box: Optional[Sequence[float]] = None,
              tolerance: Optional[float] = None) -> "list[list[np.ndarray]]":
        """The cells by disk, cut to the box: each a list of polygons, counterclockwise, shape (k, 2).

        A hidden disk has none. The sides keep within about `tolerance` of the true arcs: a thousandth
        of the size of the box where none is given. Raises ValueError for a box without area, and a
        tolerance less than 1e-9 of its size.
        """
        return self._core.cells(_corners(box), tolerance)

    def to_geojson(self, box: Optional[Sequence[float]] = None, tolerance: Optional[float] = None,
                   columns: "Optional[Mapping[str, Sequence]]" = None) -> str:
        """The cells as a feature collection, a feature a disk, with the properties `disk`, `x`, `y`,
        `radius`, `hidden_by`, and those of `columns` (a data frame, say), one value a disk, as text.
        Raises ValueError as `cells` does, and for a column of another length."""
        given = [] if columns is None else [(str(name), [str(value) for value in columns[name]])
                                            for name in columns]
        return self._core.geojson(_corners(box), tolerance, given)

    def plot(self, ax: "Optional[Axes]" = None, box: Optional[Sequence[float]] = None) -> "Axes":
        """Draws cells and disks with matplotlib, and returns the axes."""
        import matplotlib.pyplot as plt

        if ax is None:
            ax = plt.gca()
        for k, cell in enumerate(self.cells(box)):
            for ring in cell:
                ax.fill(*ring.T, facecolor=f"C{k % 10}", alpha=0.25, edgecolor="black", linewidth=0.8)
        for (x, y), r, hidden in zip(self.centers, self.radii, self.hidden):
            ax.add_patch(plt.Circle((x, y), max(float(r), 0.0), fill=False, linewidth=0.5,
                                    linestyle=":" if hidden else "-"))
        ax.set_aspect("equal")
        return ax


def voronoi(centers: "np.ndarray | Sequence[Sequence[float]]", radii: "np.ndarray | Sequence[float]",
            frame: "Optional[tuple[float, float, float]]" = None) -> StaticDiagram:
    """The weighted Voronoi diagram of disks in the plane, or in a circle `frame` = (x, y, radius).

    A place belongs to the disk whose boundary is nearest, with a sign inside of disks. In the plane
    only differences of radii count, which may be negative. Raises ValueError for wrong shapes, numbers
    that are not finite or beyond 1e-100 to 1e100 in magnitude, and negative radii in a frame.
    """
    centers = np.ascontiguousarray(centers, dtype=float).reshape(-1, 2) if np.size(centers) == 0 \
        else np.ascontiguousarray(centers, dtype=float)
    radii = np.ascontiguousarray(radii, dtype=float)
    if centers.ndim != 2 or centers.shape[1] != 2:
        raise ValueError("centers: the shape is not (n, 2)")
    if radii.shape != centers.shape[:1]:
        raise ValueError("radii: the shape is not (n,)")
    return StaticDiagram(centers, radii, None if frame is None else tuple(map(float, frame)))
