"""Diagrams at rest as tables and shapes of pandas, Shapely and GeoPandas, each where it is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence

import numpy as np

if TYPE_CHECKING:
    import geopandas
    import pandas
    from shapely.geometry.base import BaseGeometry

    from .static import StaticDiagram


def _no(package: str, error: ImportError) -> ImportError:
    return ImportError(f"{package} is not installed, which this needs: pip install {package.lower()}, or Debian's "
                       f"python3-{package.lower()} ({error})")


def _columns(diagram: "StaticDiagram", given: "Optional[Mapping[str, Sequence]]",
             taken: Sequence[str]) -> "dict[str, list]":
    columns = {} if given is None else {str(name): list(given[name]) for name in given}
    for name, values in columns.items():
        if name in taken:
            raise ValueError(f"columns: {name}: the diagram has a column of this name")
        if len(values) != len(diagram.radii):
            raise ValueError(f"columns: {name}: {len(values)} values, not {len(diagram.radii)}")
    return columns


def pandas_table(diagram: "StaticDiagram",
                 columns: "Optional[Mapping[str, Sequence]]") -> "pandas.DataFrame":
    """See StaticDiagram.to_pandas."""
    try:
        import pandas
    except ImportError as error:
        raise _no("pandas", error) from error
    hosts = diagram.hosts
    own: "dict[str, Any]" = {
        "x": diagram.centers[:, 0], "y": diagram.centers[:, 1], "radius": diagram.radii,
        "hidden_by": pandas.array(hosts, dtype="Int64"),
        "degree": np.bincount(diagram.neighbours.ravel(), minlength=len(hosts)),
    }
    own["hidden_by"][hosts == -2] = pandas.NA
    own.update(_columns(diagram, columns, [*own, "geometry"]))
    return pandas.DataFrame(own, index=pandas.RangeIndex(len(hosts), name="disk"))


def shapes(diagram: "StaticDiagram", box: "Optional[Sequence[float]]",
           tolerance: Optional[float]) -> "list[BaseGeometry]":
    """See StaticDiagram.polygons."""
    try:
        from shapely.geometry import MultiPolygon, Polygon
    except ImportError as error:
        raise _no("Shapely", error) from error
    cells = diagram.cells(box, tolerance)
    return [Polygon(*cell) if len(cell) < 2 else MultiPolygon([Polygon(piece) for piece in cell])
            for cell in cells]


def geopandas_table(diagram: "StaticDiagram", box: "Optional[Sequence[float]]", tolerance: Optional[float],
                    columns: "Optional[Mapping[str, Sequence]]", crs: Any) -> "geopandas.GeoDataFrame":
    """See StaticDiagram.to_geopandas."""
    try:
        import geopandas
    except ImportError as error:
        raise _no("GeoPandas", error) from error
    return geopandas.GeoDataFrame(pandas_table(diagram, columns), geometry=shapes(diagram, box, tolerance), crs=crs)
