"""The pictures that are wanted first. They need matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Sequence

import numpy as np

from .colours import INK, cell_colour, disk_colour
from .events import COLLISION, KINDS
from .history import History

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .diagram import Diagram
    from .static import StaticDiagram


def _axes(ax: "Optional[Axes]") -> "Axes":
    if ax is not None:
        return ax
    import matplotlib.pyplot as plt

    return plt.subplots()[1]


def plot_events(history: History, ax: "Optional[Axes]" = None) -> "Axes":
    """Draws how many events of each kind have happened, over time. Returns the axes."""
    ax = _axes(ax)
    events, end = history.events, history.ending.t
    for kind, name in enumerate(KINDS):
        times = events["t"][events["kind"] == kind]
        if len(times) > 0:
            ax.step(np.concatenate((np.zeros(1), times, np.full(1, end))),
                    np.append(np.arange(len(times) + 1), len(times)), where="post",
                    label=f"{name}s")
    ax.set_xlabel("time")
    ax.set_ylabel("events so far")
    if ax.lines:
        ax.legend()
    return ax


def plot_gap(history: History, i: int, j: int, ax: "Optional[Axes]" = None) -> "Axes":
    """Draws the gap of two generators over time, and their collisions. Returns the axes."""
    ax = _axes(ax)
    events = history.events
    pair = (min(i, j), max(i, j))
    hits = events["t"][(events["kind"] == COLLISION) & (events["ids"][:, 0] == pair[0])
                       & (events["ids"][:, 1] == pair[1])]
    times = history.times()
    times = np.unique(np.concatenate((times, hits[hits <= times[-1]])))
    ax.plot(times, history.gap_series(i, j, times))
    ax.plot(hits, np.zeros(len(hits)), "o", label="collision")
    ax.set_xlabel("time")
    names = ["container" if g < 0 else f"disk {g}" for g in (i, j)]
    ax.set_ylabel(f"gap of {names[0]} and {names[1]}")
    ax.set_ylim(bottom=min(0, ax.get_ylim()[0]))
    if len(hits) > 0:
        ax.legend()
    return ax


def plot_diagram(diagram: "Diagram", ax: "Optional[Axes]" = None) -> "Axes":
    """Draws the container, the disks and the cells of a diagram. Returns the axes."""
    from matplotlib.collections import LineCollection, PatchCollection
    from matplotlib.patches import Circle

    ax = _axes(ax)
    x, y, radius = diagram.container
    ax.add_patch(Circle((x, y), radius, fill=False, edgecolor="black"))
    disks = [Circle(center, r) for center, r in zip(diagram.positions, diagram.radii)]
    ax.add_collection(PatchCollection(disks, facecolor="tab:blue", alpha=0.6))
    # A lone disk's cell is bounded by a closed curve that is no edge.
    lines = diagram.edge_polylines()
    if len(disks) == 1:
        cell = diagram.cell_polygons()[0]
        lines = [np.concatenate((cell, cell[:1]))]
    ax.add_collection(LineCollection(lines, colors="tab:red", linewidths=1))
    ax.set_xlim(x - 1.02 * radius, x + 1.02 * radius)
    ax.set_ylim(y - 1.02 * radius, y + 1.02 * radius)
    ax.set_aspect("equal")
    ax.set_title(f"t = {float(diagram.t):g}")
    return ax


def plot_static(diagram: "StaticDiagram", ax: "Optional[Axes]", box: "Optional[Sequence[float]]",
                labels: "Optional[Sequence[object]]") -> "Axes":
    """See StaticDiagram.plot."""
    from matplotlib.collections import PolyCollection
    from matplotlib.patches import Circle

    cells, hidden = diagram.cells(box), diagram.hidden
    if labels is not None and len(labels) != len(hidden):
        raise ValueError(f"labels: {len(labels)}, not {len(hidden)}")
    ax = _axes(ax)
    pieces = [(ring, cell_colour(k)) for k, cell in enumerate(cells) for ring in cell]
    ax.add_collection(PolyCollection([ring for ring, _ in pieces], edgecolors=[INK], linewidths=0.8,
                                     facecolors=[colour for _, colour in pieces]))
    for k, (center, radius) in enumerate(zip(diagram.centers, diagram.radii)):
        if radius > 0:
            fill = "none" if hidden[k] else (*disk_colour(k), 0.6)
            ax.add_patch(Circle(center, radius, facecolor=fill, edgecolor=INK, linewidth=0.6,
                                linestyle=":" if hidden[k] else "-"))
    points = diagram.centers[diagram.radii <= 0]
    ax.plot(points[:, 0], points[:, 1], ".", color=INK, markersize=3)
    x0, y0, x1, y1 = diagram.box if box is None else map(float, box)
    for k in np.flatnonzero(~hidden) if labels is not None else ():
        x, y = diagram.centers[k]
        if x0 <= x <= x1 and y0 <= y <= y1:
            ax.annotate(str(labels[k]), (x, y), (0, 2), textcoords="offset points", ha="center", fontsize=8)
    ax.set_xlim(x0, x1)
    ax.set_ylim(y0, y1)
    ax.set_aspect("equal")
    return ax
