"""The weighted Voronoi diagram of any disks at rest."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence

import numpy as np

from . import _core
from .diagram import Incidences

if TYPE_CHECKING:
    import geopandas
    import pandas
    from matplotlib.axes import Axes
    from shapely.geometry.base import BaseGeometry

Box = "tuple[float, float, float, float]"


_MEASURE = np.dtype([("area", float), ("perimeter", float), ("centroid", float, (2,)), ("area_error", float),
                     ("perimeter_error", float), ("centroid_error", float)])


def _corners(box: Optional[Sequence[float]]) -> "Optional[list[float]]":
    if box is None:
        return None
    corners = [float(x) for x in box]
    if len(corners) != 4:
        raise ValueError("box: not x0, y0, x1, y1")
    return corners


class EmptyCircle(NamedTuple):
    """A circle that no disk and no frame enters, and the generators that it touches, sorted."""

    center: "tuple[float, float]"
    radius: float
    generators: "tuple[int, ...]"


class StaticDiagram(Incidences):
    """The additively weighted (Apollonius) diagram of n disks, made by `voronoi`.

    All decisions are exact; coordinates are rounded to nearest. Disks may overlap, lie in each other
    and coincide. A disk that another one contains is hidden: it has no cell. In `edges`, -1 is the
    circle around; without one it is infinity, and n to n+3 are the left, the bottom, the right and the
    top wall of a rectangle. `vertices` have none at infinity, and where disks overlap `vertex_radii`
    are negative.
    """

    def __init__(self, centers: np.ndarray, radii: np.ndarray,
                 frame: "Optional[tuple[float, ...]]"):
        self.centers, self.radii, self.frame = centers, radii, frame
        self._core = _core.StaticDiagram(centers, radii, frame)

    def __repr__(self) -> str:
        where = "the plane" if self.frame is None else "a circle" if len(self.frame) == 3 else "a rectangle"
        return f"<StaticDiagram of {len(self.radii)} disks in {where}, {int(self.hidden.sum())} hidden>"

    @property
    def hosts(self) -> np.ndarray:
        """By disk: -2, or a disk that hides it, or -1 where it lies outside of the circle, or a wall that
        it lies behind, shape (n,)."""
        return self._core.hosts()

    @property
    def hidden(self) -> np.ndarray:
        """Which disks have no cell, shape (n,)."""
        return self.hosts != -2

    @property
    def neighbours(self) -> np.ndarray:
        """The pairs of disks whose cells share an edge, each once, sorted, shape (k, 2)."""
        pairs = np.sort(self.edges[:, :2], axis=1)
        return np.unique(pairs[(pairs[:, 0] >= 0) & (pairs[:, 1] < len(self.radii))], axis=0)

    @property
    def box(self) -> Box:
        """x0, y0, x1, y1 of all visible disks and a tenth of their size around, or of the frame."""
        return self._core.box()

    def cells(self, box: Optional[Sequence[float]] = None,
              tolerance: Optional[float] = None) -> "list[list[np.ndarray]]":
        """The cells by disk, cut to the box: each a list of polygons, counterclockwise, shape (k, 2).

        A hidden disk has none. The sides keep within about `tolerance` of the true arcs: a thousandth
        of the size of the box where none is given. Raises ValueError for a box without area or beyond 1e100, and a
        tolerance less than 1e-9 of its size.
        """
        return self._core.cells(_corners(box), tolerance)

    def edge_arcs(self, box: Optional[Sequence[float]] = None, errors: bool = False) -> "list[np.ndarray]":
        """The edges by their order in `edges`, cut to the box: arcs of conics from its start to its end, shape
        (k, 7), as start (2), control (2), end (2) and weight w of the curve

            ((1-t)^2 start + 2 t (1-t) w control + t^2 end) / ((1-t)^2 + 2 t (1-t) w + t^2),   t from 0 to 1.

        With `errors` an eighth column says how far its points may be from the true edge. Where an arc does not
        start at the end of the one before the edge leaves the box in between. Edges with infinity have none.
        Raises ValueError for a box without area or beyond 1e100.
        """
        return [arcs if errors else arcs[:, :7] for arcs in self._core.arcs(_corners(box))]

    def measures(self, box: Optional[Sequence[float]] = None) -> np.ndarray:
        """The cells by disk, cut to the box: a structured array of shape (n,) with the fields `area`, `perimeter`,
        `centroid` (two numbers), and proved bounds of what rounding leaves, `area_error`, `perimeter_error` and
        `centroid_error`, which include about 1e-8 of the perimeter.

        They are those of the true arcs. A disk that is hidden, or whose cell misses the box, has zeros and a
        centroid that is no number. Raises ValueError for a box without area or beyond 1e100.
        """
        return self._core.measures(_corners(box)).view(_MEASURE).reshape(-1)

    def areas(self, box: Optional[Sequence[float]] = None) -> np.ndarray:
        """The areas of the cells in the box, as in `measures`, shape (n,)."""
        return self.measures(box)["area"].copy()

    def nearest(self, points: "np.ndarray | Sequence") -> "tuple[np.ndarray, np.ndarray]":
        """The generators whose cells contain the points, and their distances.

        Shape (..., 2) gives two arrays of shape (...). A distance is that from the disk's boundary,
        negative inside, or inwards from the frame, which is -1. It is decided exactly who is nearest: of
        several the largest id. Distances are rounded to nearest. Raises ValueError for another shape,
        numbers that are not finite or beyond 1e100 in magnitude, and points in the plane without a disk.
        """
        points = np.asarray(points, dtype=float)
        if points.ndim == 0 or points.shape[-1] != 2:
            raise ValueError("points: the shape is not (..., 2)")
        generators, distances = self._core.nearest(points.reshape(-1, 2))
        return generators.reshape(points.shape[:-1]), distances.reshape(points.shape[:-1])

    def largest_empty_circle(self, box: Optional[Sequence[float]] = None) -> Optional[EmptyCircle]:
        """The largest circle with its centre in the box that no disk and no frame enters, up to roundings:
        the first of `voids(0, box)`. None where disks cover the box. Raises ValueError as `voids` does."""
        circle = self._core.largest_empty_circle(_corners(box))
        return None if circle is None else EmptyCircle(*circle)

    def voids(self, probe: float, box: Optional[Sequence[float]] = None) -> "list[EmptyCircle]":
        """The circles of at least the radius `probe` that are larger than those around all places near in
        the box, the largest first.

        Their centres are vertices, points of edges with the frame that are farthest from it, and places
        on the sides of the box. Which count is decided exactly, but on the sides by doubles. Raises
        ValueError for a box without area or beyond 1e100, a negative probe, and in the plane without a disk.
        """
        return [EmptyCircle(*circle) for circle in self._core.voids(float(probe), _corners(box))]

    def to_geojson(self, box: Optional[Sequence[float]] = None, tolerance: Optional[float] = None,
                   columns: "Optional[Mapping[str, Sequence]]" = None) -> str:
        """The cells as a feature collection, a feature a disk, with the properties `disk`, `x`, `y`,
        `radius`, `hidden_by`, and those of `columns` (a data frame, say), one value a disk, as text.
        Raises ValueError as `cells` does, and for a column of another length."""
        given = [] if columns is None else [(str(name), [str(value) for value in columns[name]])
                                            for name in columns]
        return self._core.geojson(_corners(box), tolerance, given)

    def to_pandas(self, columns: "Optional[Mapping[str, Sequence]]" = None) -> "pandas.DataFrame":
        """A row a disk: x, y, radius, hidden_by (missing where it is visible, -1 for the frame), degree
        (the number of neighbours), and `columns`, one value a disk. Needs pandas. Raises ValueError for a
        column of another length, or of a name that is taken."""
        from .tables import pandas_table
        return pandas_table(self, columns)

    def polygons(self, box: Optional[Sequence[float]] = None,
                 tolerance: Optional[float] = None) -> "list[BaseGeometry]":
        """The cells by disk as Shapely has them: a Polygon, empty where a disk has no cell in the box, or a
        MultiPolygon where the box cuts it in pieces. Needs Shapely. Raises ValueError as `cells` does."""
        from .tables import shapes
        return shapes(self, box, tolerance)

    def to_geopandas(self, box: Optional[Sequence[float]] = None, tolerance: Optional[float] = None,
                     columns: "Optional[Mapping[str, Sequence]]" = None,
                     crs: Any = None) -> "geopandas.GeoDataFrame":
        """`to_pandas(columns)` with the geometry `polygons(box, tolerance)`, in the reference system `crs` of
        the centres. Needs GeoPandas. Raises ValueError as these do."""
        from .tables import geopandas_table
        return geopandas_table(self, box, tolerance, columns, crs)

    def plot(self, ax: "Optional[Axes]" = None, box: Optional[Sequence[float]] = None,
             labels: "Optional[Sequence[object]]" = None) -> "Axes":
        """Draws cells and disks with matplotlib, in the colours of the program's pictures, and returns the
        axes. `labels`, one a disk, stand at the centres of visible disks in the box. Raises ValueError as
        `cells` does, and for another number of labels."""
        from .plots import plot_static
        return plot_static(self, ax, box, labels)

    def _repr_html_(self) -> str:
        from .notebook import static_html
        return static_html(self)


def voronoi(centers: "np.ndarray | Sequence[Sequence[float]]", radii: "np.ndarray | Sequence[float]",
            frame: "Optional[tuple[float, ...]]" = None) -> StaticDiagram:
    """The weighted Voronoi diagram of disks in the plane, in a circle `frame` = (x, y, radius), or in a
    rectangle `frame` = (x0, y0, x1, y1), of which the walls are generators, too.

    A place belongs to the disk whose boundary is nearest, with a sign inside of disks. In the plane
    only differences of radii count, which may be negative. Raises ValueError for wrong shapes, numbers
    that are not finite or beyond 1e-100 to 1e100 in magnitude, and negative radii in a frame.
    """
    return StaticDiagram(*_disks(centers, radii), None if frame is None else tuple(map(float, frame)))


@dataclass(frozen=True)
class DiagramReport:
    """The certifier's words about a diagram: `verdict` is "certified", "refuted" or "undecided", `about` what
    was judged, `reservations` what was accepted that is a matter of choice, each a line, and `reason` why
    it is not certified."""

    verdict: str
    about: str
    reservations: "list[str]"
    reason: str

    @property
    def certified(self) -> bool:
        return self.verdict == "certified"


def certify_diagram(centers: "np.ndarray | Sequence[Sequence[float]]", radii: "np.ndarray | Sequence[float]", *,
                    frame: "Optional[tuple[float, ...]]" = None, hosts: "Optional[Sequence[int]]" = None,
                    edges: "Optional[Sequence[Sequence[int]]]" = None,
                    neighbours: "Optional[Sequence[Sequence[int]]]" = None,
                    vertices: "Optional[tuple[Any, Any, Any]]" = None, tolerance: float = 1e-9,
                    threads: int = 1) -> DiagramReport:
    """Proves or refutes what any program says of the diagram of these disks.

    `frame` is as in `voronoi`; `hosts`, `edges`, `neighbours` are as in `StaticDiagram`; of pairs of
    neighbours those with the frame, or with walls, may all be left out. `vertices` are generators, centres
    and radii of vertices, with `edges` of all, and may be off by `tolerance` times the largest number of
    the circle and its generators. Raises
    ValueError as `voronoi` does, and for a claim that says nothing or names disks that do not exist.
    """
    def lists(values: Any) -> Any:
        return None if values is None else np.asarray(values).tolist()

    at, sizes = _disks(centers, radii)
    circles = None if vertices is None else tuple(lists(part) for part in vertices)
    return DiagramReport(**_core.certify_diagram(at.tolist(), sizes.tolist(), frame, lists(hosts), lists(edges),
                                                 lists(neighbours), circles, tolerance, threads))


def _disks(centers: "np.ndarray | Sequence[Sequence[float]]",
           radii: "np.ndarray | Sequence[float]") -> "tuple[np.ndarray, np.ndarray]":
    centers = np.ascontiguousarray(centers, dtype=float).reshape(-1, 2) if np.size(centers) == 0 \
        else np.ascontiguousarray(centers, dtype=float)
    radii = np.ascontiguousarray(radii, dtype=float)
    if centers.ndim != 2 or centers.shape[1] != 2:
        raise ValueError("centers: the shape is not (n, 2)")
    if radii.shape != centers.shape[:1]:
        raise ValueError("radii: the shape is not (n,)")
    return centers, radii
