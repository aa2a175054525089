"""Histories: every change of the diagram of a scene, with its time."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, Sequence, overload

import numpy as np

from . import _core
from .events import Ending, Events, core_ending
from .files import write_whole
from .free_space import Opening, VoidLife, life_of
from .motion import LeastGap, Neighbourhood, least_gap_of
from .scene import Number, Path, Scene

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

    from .billiard import Billiard, BilliardHistory
    from .diagram import Diagram
    from .report import Report

CONTAINER = -1

#: The items of `History.events`: time `t`; `kind` (FLIP, COLLISION, MANEUVER); `ids`, shape (4,): l, r, s, e
#: of a flip, i, j of a collision, the disk of a maneuver, -2 for nothing; `velocity` just after and
#: `center`, shape (2, 2), of the first and the second id of a collision or a maneuver, NaN for nothing.
event_dtype: np.dtype = _core.event_dtype

Progress = Callable[[float, int], Optional[bool]]


class History(Events):
    """A history of a scene; it does not change.

    Made by `simulate`, by `History.read`, or of arrays of an engine of your own by the constructor.

    `events` is a structured array of `event_dtype`, in the order of the events. The paths between them
    are those that the history records: a disk starts as the scene says and turns, where it is, at each
    of its collisions and maneuvers, to the velocity that the event gives. What asks for places
    (`positions`, `sample`, `gap_series`, ...) raises InputError where collisions lack velocities, and
    ValueError for times beyond the history.
    """

    def __init__(self, scene: Scene, events: Any, *, initial: Any = None,
                 horizon: Optional[Number] = None, producer: str = "",
                 ending: Optional[Ending] = None):
        """Takes `events`, an array of `event_dtype` (copied), as a history of the scene.

        `initial`, shape (m, 4), are the edges at 0+ as l, r, s, e, or None; the horizon is the
        scene's unless given; `ending` says how it ends, by default complete at the horizon.
        Whether it is a history at all is checked where it is used; `certify` judges it.
        """
        end = scene.horizon if horizon is None else horizon
        rows = np.ascontiguousarray(events, dtype=event_dtype)
        edges = None if initial is None else np.asarray(initial, dtype=int).reshape(-1, 4).tolist()
        self._scene: Optional[Scene] = scene
        self._core = _core.EventTable(scene.sha256, end, producer, edges, rows, core_ending(ending, end))
        self._motion_made: Optional[_core.RecordedMotion] = None

    @classmethod
    def _of(cls, core: _core.EventTable, scene: Optional[Scene]) -> "History":
        history = cls.__new__(cls)
        history._core, history._scene, history._motion_made = core, scene, None
        return history

    @classmethod
    def read(cls, path: Path, scene: Optional[Scene] = None) -> "History":
        """Reads a history file.

        What asks for places or diagrams needs the scene, too. Raises InputError, also where the
        history is one of another scene.
        """
        core = _core.read_history(os.fspath(path))
        if scene is not None and core.scene_sha256 != scene.sha256:
            from .errors import InputError
            reason = "the history is one of another scene"
            raise InputError(f"{path}:1: scene_sha256: {reason}", os.fspath(path), 1, "scene_sha256",
                             reason)
        return cls._of(core, scene)

    def with_events(self, events: Any) -> "History":
        """The same history with other events, such as `np.delete(h.events, 5)`."""
        return History(self.scene, events, initial=self.initial, horizon=self.horizon,
                       producer=self.producer, ending=self.ending)

    def to_pandas(self) -> "pandas.DataFrame":
        """The events as a frame: t, kind, ids and coordinates in columns of their own."""
        return self._frame("xy")

    @property
    def scene(self) -> Scene:
        """The scene. Raises ValueError where the history was read without."""
        if self._scene is None:
            raise ValueError("the history was read without its scene: History.read(path, scene)")
        return self._scene

    @property
    def scene_sha256(self) -> str:
        return self._core.scene_sha256

    @property
    def initial(self) -> Optional[np.ndarray]:
        """The edges just after 0 as l, r, s, e, shape (m, 4), or None."""
        return self._core.initial

    # Answers from the recorded paths.

    @property
    def _motion(self) -> _core.RecordedMotion:
        if self._motion_made is None:
            self._motion_made = _core.RecordedMotion(self.scene._core, self._core)
        return self._motion_made

    def positions(self, t: Number) -> np.ndarray:
        """The centres of the disks at t, shape (n, 2), each rounded to nearest."""
        return self._motion.positions(t)

    def velocities(self, t: Number) -> np.ndarray:
        """The velocities just after t, shape (n, 2)."""
        return self._motion.velocities(t)

    def sample(self, times: Iterable[Number]) -> np.ndarray:
        """The centres at each time, shape (len(times), n, 2), each rounded to nearest."""
        return self._motion.sample(times)

    def times(self, count: int = 1001) -> np.ndarray:
        """`count` times, evenly spaced over what the history covers, shape (count,)."""
        end = self.ending.t
        if not self.ending.complete:
            end = np.nextafter(end, 0)
        elif Fraction(end) > self.horizon:  # rounded up
            end = np.nextafter(end, 0)
        return np.linspace(0, end, count)

    def gap_series(self, i: int, j: int, times: Optional[Iterable[Number]] = None) -> np.ndarray:
        """The gap of two generators at each time, by default `times()`, shape (len(times),).

        The gap is the distance between the boundaries; j = -1 is the container. Each is rounded to
        nearest, or next to that; it is negative where the recorded paths overlap.
        """
        return self._motion.gaps(i, j, self.times() if times is None else times)

    def least_gap(self, i: Optional[int] = None, j: Optional[int] = None, *, start: Number = 0,
                  end: Optional[Number] = None) -> Optional[LeastGap]:
        """The least gap of i and j from `start` to `end`, or without ids that of any two disks.

        It is exact: no sampling. None with fewer than two disks.
        """
        last = self._last if end is None else end
        if i is None and j is None:
            return least_gap_of(self._motion.least_gap_of_all(start, last))
        if i is None or j is None:
            raise ValueError("two ids or none")
        return least_gap_of(self._motion.least_gap(i, j, start, last))

    def neighbours_over(self, disk: int, *, start: Number = 0,
                        end: Optional[Number] = None) -> "list[Neighbourhood]":
        """When each generator's cell shares an edge with that of the disk, by generator and time."""
        spells = self._motion.neighbours(disk, start, self._last if end is None else end)
        return [Neighbourhood(*spell) for spell in spells]

    # When a probe of the given radius fits; instants at which it just fits and no longer are left out.
    # ValueError for negative radii and where `start` is not before `end`.

    def tunnel_openings(self, i: int, j: int, probe: Number, *, start: Number = 0,
                        end: Optional[Number] = None) -> "list[Opening]":
        """When some V-edge of i and j lets the probe pass from end to end."""
        last = self._last if end is None else end
        return [Opening(*spell) for spell in self._motion.tunnel_openings(i, j, probe, start, last)]

    def void_openings(self, vertex: Sequence[int], probe: Number, *, start: Number = 0,
                      end: Optional[Number] = None) -> "list[Opening]":
        """When the diagram has the V-vertex of three generators, counterclockwise, and the probe fits there."""
        last = self._last if end is None else end
        return [Opening(*spell) for spell in self._motion.void_openings(vertex, probe, start, last)]

    def void_lives(self, probe: Number, *, start: Number = 0, end: Optional[Number] = None) -> "list[VoidLife]":
        """The voids of the probe: when they come about, part, join and vanish, in the order of their beginnings."""
        last = self._last if end is None else end
        return [life_of(life) for life in self._motion.void_lives(probe, start, last)]

    @property
    def _last(self) -> Number:
        end = self.ending
        return self.horizon if end.complete else float(np.nextafter(end.t, 0))

    def diagram(self, t: Number, *, checked: bool = True) -> "Diagram":
        """The diagram at t: the initial one after the flips up to t.

        Raises InputError where an edge is illegal by more than tolerances explain, unless `checked`
        is False. That no such edge is found is no proof; `certify` the history first.
        """
        from .diagram import Diagram
        return Diagram(_core.diagram_of_history(self.scene._core, self._core, t, checked))

    # The pictures that are wanted first. They need matplotlib.

    def plot_events(self, ax: "Optional[Axes]" = None) -> "Axes":
        """Draws how many events of each kind have happened, over time."""
        from .plots import plot_events
        return plot_events(self, ax)

    def plot_gap(self, i: int, j: int, ax: "Optional[Axes]" = None) -> "Axes":
        """Draws the gap of two generators over time, with their collisions."""
        from .plots import plot_gap
        return plot_gap(self, i, j, ax)

    def plot_diagram(self, t: Number, ax: "Optional[Axes]" = None) -> "Axes":
        """Draws the disks and the cells at t."""
        return self.diagram(t).plot(ax)

    # The player.

    def movie_page(self, *, report: "Optional[Report]" = None, follow: Optional[int] = None) -> str:
        """A page of HTML that plays the history and needs no other file and no network.

        `report` is one of a certification of this history, or of the file that `write` makes of it: the time
        line shows what is proved, and the evidence of a refutation is drawn. A report of other bytes or by
        another version is an InputError. `follow` is the disk that is followed to begin with. The history
        may be right or wrong. Raises InputError, and ValueError for a disk that there is not.
        """
        return _core.movie_page(self.scene._core, self._core, None if report is None else report.json, follow)

    def write_movie(self, path: Path, *, report: "Optional[Report]" = None,
                    follow: Optional[int] = None) -> None:
        """Writes the page of `movie_page`, whole or not at all. Raises OSError besides."""
        write_whole(path, self.movie_page(report=report, follow=follow))

    def _repr_html_(self) -> str:
        from .notebook import history_html
        return history_html(self)


@overload
def simulate(scene: Scene, *, progress: Optional[Progress] = ..., threads: int = ...,
             max_bits: int = ..., max_events: int = ...) -> History: ...
@overload
def simulate(scene: "Billiard", *, progress: Optional[Progress] = ..., threads: int = ...,
             max_bits: int = ..., max_events: int = ...) -> "BilliardHistory": ...
def simulate(scene: Any, *, progress: Optional[Progress] = None, threads: int = 1,
             max_bits: int = 32768, max_events: int = 0) -> Any:
    """Computes the history of a scene or a billiard, every decision exact.

    Other threads of Python run meanwhile. `progress(t, events)` is called several times a second and
    once at the end; where it returns False the history ends there, and its `ending` says so. Ctrl-C
    raises KeyboardInterrupt. `max_bits` bounds the numbers from which decisions are taken, `max_events`
    the events (0: no bound): a history that would need more stops, and is right up to there.
    Every number of `threads` gives the same history; from a few hundred disks on more are faster, but for billiards.
    """
    core = _core.simulate(scene._core, progress, threads, max_bits, max_events)
    if isinstance(scene, Scene):
        return History._of(core, scene)
    from .billiard import BilliardHistory
    return BilliardHistory._of(core, scene)
