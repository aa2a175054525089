"""The weighted Voronoi diagram of any disks at rest."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Optional, Sequence

import numpy as np

from . import _core

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Box = "tuple[float, float, float, float]"


class StaticDiagram:
    """The additively weighted (Apollonius) diagram of n disks, made by `voronoi`.

    All decisions are exact; coordinates are rounded to nearest. Disks may overlap, lie in each other
    and coincide. A disk that another one contains is hidden: it has no cell.
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
    def edges(self) -> np.ndarray:
        """The edges [l, r, s, e], shape (m, 4): between the cells of l and r, from the vertex [l, s, r]
        to the vertex [l, r, e]. -1 is the frame; without one it is infinity."""
        return self._core.edges()

    @property
    def neighbours(self) -> np.ndarray:
        """The pairs of disks whose cells share an edge, each once, sorted, shape (k, 2)."""
        pairs = np.sort(self.edges[:, :2], axis=1)
        return np.unique(pairs[pairs[:, 0] >= 0], axis=0)

    @property
    def vertices(self) -> np.ndarray:
        """The three generators of each vertex, counterclockwise, shape (v, 3), sorted; without those at
        infinity."""
        return self._core.vertices()

    @property
    def vertex_positions(self) -> np.ndarray:
        """The centre of the circle that touches the three, shape (v, 2)."""
        return self._core.vertex_positions()

    @property
    def vertex_radii(self) -> np.ndarray:
        """The radius of that circle, negative where disks overlap, shape (v,)."""
        return self._core.vertex_radii()

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
        cut = tuple(float(x) for x in (self.box if box is None else box))
        if len(cut) != 4:
            raise ValueError("box: not x0, y0, x1, y1")
        size = max(cut[2] - cut[0], cut[3] - cut[1])
        return self._core.cells(cut, size / 1000 if tolerance is None else float(tolerance))

    def to_geojson(self, box: Optional[Sequence[float]] = None,
                   tolerance: Optional[float] = None) -> str:
        """The cells as a feature collection, with the properties `disk`, `radius` and `hidden_by`."""
        features = []
        for k, (cell, host) in enumerate(zip(self.cells(box, tolerance), self.hosts)):
            rings = [[[*p] for p in (*ring.tolist(), ring[0].tolist())] for ring in cell]
            geometry = None
            if len(rings) == 1:
                geometry = {"type": "Polygon", "coordinates": rings}
            elif rings:
                geometry = {"type": "MultiPolygon", "coordinates": [[ring] for ring in rings]}
            properties = {"disk": k, "radius": float(self.radii[k])}
            if host != -2:
                properties["hidden_by"] = int(host)
            features.append({"type": "Feature", "geometry": geometry, "properties": properties})
        return json.dumps({"type": "FeatureCollection", "features": features})

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
