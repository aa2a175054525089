"""Views of a history, of a scene and of a diagram at rest in notebooks."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING, Tuple

from .colours import cell_colour, disk_colour
from .errors import Error

if TYPE_CHECKING:
    from .history import History
    from .scene import Scene
    from .static import StaticDiagram

#: A notebook keeps what it shows: some 30 bytes an event, 100 a disk. Beyond these it gets a line of text.
MAX_EVENTS = 20_000
MAX_DISKS = 2_000


def _told(thing: object, why: str = "") -> str:
    return f"<p>{escape(repr(thing))}{escape(why)}</p>"


def history_html(history: "History") -> str:
    """The player in a frame, or a line that says why there is none."""
    try:
        scene = history.scene
        if len(history) > MAX_EVENTS or len(scene) > MAX_DISKS:
            return _told(history, f". The player is left out beyond {MAX_EVENTS} events or {MAX_DISKS} disks: "
                                  "write_movie(path) makes a page of it.")
        page = history.movie_page()
    except (Error, ValueError) as error:
        return _told(history, f". No player: {error}")
    # The frame may run its scripts and save pictures, and sees nothing of the notebook. It is one line: where a
    # notebook becomes Markdown an empty line would end it.
    page = escape(page).replace("\n", "&#10;")
    return (f'<iframe srcdoc="{page}" title="{escape(repr(history))}" sandbox="allow-scripts allow-downloads" '
            'style="width: 100%; height: 720px; border: 0"></iframe>')


def scene_html(scene: "Scene") -> str:
    """The container and the disks at t = 0, or a line where there are too many."""
    if len(scene) > MAX_DISKS:
        return _told(scene)
    x, y, radius = map(float, scene.container)
    # In units of the container's radius, from its centre; y grows downwards in SVG.
    circles = [(0.0, 0.0, 1.0, "none")]
    circles += [((float(d.x) - x) / radius, (y - float(d.y)) / radius, float(d.radius) / radius, "#8fb4dc")
                for d in scene.disks]
    drawn = "".join(f'<circle cx="{cx:.6g}" cy="{cy:.6g}" r="{r:.6g}" fill="{fill}"/>' for cx, cy, r, fill in circles)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-1.01 -1.01 2.02 2.02" width="320" height="320" '
            f'role="img" aria-label="{escape(repr(scene))}"><g stroke="#5a6478" stroke-width="0.006">{drawn}</g></svg>'
            + _told(scene))


def _hex(colour: Tuple[float, float, float]) -> str:
    return "#" + "".join(f"{round(255 * x):02x}" for x in colour)


def static_html(diagram: "StaticDiagram") -> str:
    """The cells and the disks, hidden ones with broken rims, or a line where there are too many."""
    if len(diagram.radii) > MAX_DISKS:
        return _told(diagram)
    x0, y0, x1, y1 = diagram.box
    size = max(x1 - x0, y1 - y0)
    unit = 1000 / size
    drawn = []
    for k, cell in enumerate(diagram.cells(tolerance=2e-3 * size)):
        for ring in cell:
            points = " ".join(f"{unit * (x - x0):.1f},{unit * (y1 - y):.1f}" for x, y in ring)
            drawn.append(f'<polygon points="{points}" fill="{_hex(cell_colour(k))}"/>')
    for k, ((x, y), radius, hidden) in enumerate(zip(diagram.centers, diagram.radii, diagram.hidden)):
        # A point is a dot.
        r = max(unit * radius, 2.0)
        look = 'fill="none" stroke-dasharray="6"' if hidden else f'fill="{_hex(disk_colour(k))}" fill-opacity="0.6"'
        drawn.append(f'<circle cx="{unit * (x - x0):.1f}" cy="{unit * (y1 - y):.1f}" r="{r:.1f}" {look}/>')
    width, height = unit * (x1 - x0), unit * (y1 - y0)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.1f} {height:.1f}" width="{0.48 * width:.0f}" '
            f'height="{0.48 * height:.0f}" role="img" aria-label="{escape(repr(diagram))}">'
            f'<g stroke="#333c4d" stroke-width="2">{"".join(drawn)}</g></svg>' + _told(diagram))
