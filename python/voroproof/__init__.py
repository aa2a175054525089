"""Exact event histories of the Voronoi diagram of moving disks, and their certifier.

    import voroproof as vp
    scene = vp.Scene.reference(30, horizon=100)
    history = vp.simulate(scene)
    print(vp.certify(scene, history))
    history.plot_gap(0, 1)

Disks are named by their index, the container by -1 (`vp.CONTAINER`). Lengths, times and speeds are in
one consistent set of units of the caller's. Exact numbers go in as `fractions.Fraction`, `int`,
`decimal.Decimal`, text ("1/3", "0.1") or `float`, which means the binary64 that it is; they come out as
`Fraction`. Arrays hold binary64, rounded to nearest. docs/python.md says more.
"""

from .errors import Error, InputError, Interrupted, OutputError, Undecided

try:
    from ._core import version as __version__
    from .billiard import Billiard, BilliardHistory, billiard_event_dtype
    from .diagram import Diagram
    from .events import COLLISION, FLIP, MANEUVER, Ending
    from .free_space import Critical, OffsetArc, OffsetPoint, Opening, Place, Tunnel, Vanishing, Void, VoidLife
    from .history import CONTAINER, History, event_dtype, simulate
    from .motion import LeastGap, Neighbourhood
    from .plan import Approach, Plan, Vehicle, plan
    from .queries import Closest, Instant, NearDisk, Neighbour
    from .report import Divergence, Leniency, Report, Witness, WitnessMotion, certify, certify_files
    from .scene import Disk, Maneuver, Scene
    from .static import DiagramReport, EmptyCircle, StaticDiagram, certify_diagram, voronoi
except ImportError as error:  # the importers need neither the compiled part nor NumPy
    _missing = error

    def __getattr__(name):
        if name in __all__:
            raise ImportError(f"voroproof.{name} is not there: {_missing}") from _missing
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

__all__ = [
    "COLLISION", "CONTAINER", "FLIP", "MANEUVER", "Approach", "Billiard", "BilliardHistory", "Closest", "Critical", "Diagram",
    "DiagramReport", "Disk", "Divergence", "EmptyCircle", "Ending", "Error", "History", "InputError", "Instant",
    "Interrupted", "LeastGap", "Leniency", "Maneuver", "NearDisk", "Neighbour", "Neighbourhood",
    "OffsetArc", "OffsetPoint", "Opening", "OutputError", "Place", "Plan", "Report", "Scene",
    "StaticDiagram", "Tunnel", "Undecided", "Vanishing", "Vehicle", "Void", "VoidLife", "Witness",
    "WitnessMotion", "__version__", "billiard_event_dtype", "certify", "certify_diagram", "certify_files", "event_dtype", "plan", "simulate",
    "voronoi",
]
