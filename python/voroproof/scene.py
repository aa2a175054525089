"""Scenes: disks in a circular container, and what is to happen to them."""

from __future__ import annotations

import json
import os
from decimal import Decimal
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence, TypeVar, Union

import numpy as np

from . import _core

if TYPE_CHECKING:
    from .diagram import Diagram
    from .queries import Instant

Number = Union[int, float, Fraction, Decimal, str]
Path = Union[str, "os.PathLike[str]"]
Kind = TypeVar("Kind", bound="SceneFile")


class Disk(NamedTuple):
    """A disk at t = 0: centre, radius, velocity, all exact. `mass` is None for radius squared."""

    x: Fraction
    y: Fraction
    radius: Fraction
    vx: Fraction
    vy: Fraction
    mass: Optional[Fraction]


class Maneuver(NamedTuple):
    """At time t the velocity of the disk becomes (vx, vy)."""

    t: Fraction
    disk: int
    vx: Fraction
    vy: Fraction


def json_value(value: Any) -> Any:
    """The value as scene files have it: floats as numbers, exact ones as text."""
    if isinstance(value, Mapping):
        return {str(key): json_value(inner) for key, inner in value.items()}
    if isinstance(value, np.generic):
        # float32 and so on: the number that it is.
        return json_value(value.item())
    if isinstance(value, (Fraction, Decimal)):
        numerator, denominator = value.as_integer_ratio()
        return f"{numerator}/{denominator}"
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, (Sequence, np.ndarray)):
        return [json_value(inner) for inner in value]
    raise TypeError(f"{type(value).__name__} is nothing that a scene holds")


class SceneFile:
    """A scene, whatever its disks do: it is made of a file, and makes one."""

    _core: Any

    def __init__(self, fields: Mapping[str, Any]):
        raise NotImplementedError

    @classmethod
    def _of(cls: "type[Kind]", core: Any) -> "Kind":
        scene = cls.__new__(cls)
        scene._core = core
        return scene

    def write(self, path: Path) -> None:
        """Writes a scene file, whole or not at all. Raises OutputError."""
        self._core.write(os.fspath(path))

    @property
    def text(self) -> str:
        """The text of the scene's file."""
        return self._core.text()

    def to_dict(self) -> dict:
        """The fields of the scene's file; numbers that no binary64 equals are text."""
        return json.loads(self.text)

    def replace(self: "Kind", **fields: Any) -> "Kind":
        """The scene with other fields, such as `horizon=5`."""
        return type(self)({**self.to_dict(), **fields})

    @property
    def sha256(self) -> str:
        """The hash by which histories name the scene: 64 hexadecimal digits."""
        return self._core.sha256()

    @property
    def horizon(self) -> Fraction:
        """Histories cover [0, horizon]."""
        return self._core.horizon

    def __len__(self) -> int:
        return self._core.size()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)


class Scene(SceneFile):
    """A scene, checked, which does not change.

    `Scene(mapping)` takes the fields of a scene file (docs/formats.md, section 4); `format` and
    `version` may be left out. Each number is a float or an int, or exact: a Fraction, a Decimal or
    text such as "1/3".

        Scene({"container": {"center": [0, 0], "radius": 10}, "horizon": 8,
               "disks": [{"center": ["1/3", 0], "radius": 1, "velocity": [1, 0]}]})

    Raises InputError (a ValueError) that names the field and the reason.
    """

    def __init__(self, fields: Mapping[str, Any]):
        whole = {"format": "voroproof-scene", "version": 1, **fields}
        # NaN is no JSON, and refused by the reader with the name of its field.
        self._core = _core.make_scene(json.dumps(json_value(whole)), None)

    @classmethod
    def read(cls, path: Path) -> "Scene":
        """Reads a scene file. Raises InputError with file, line and field."""
        return cls._of(_core.read_scene(os.fspath(path)))

    @classmethod
    def parse(cls, text: str) -> "Scene":
        """Reads the text of a scene file."""
        return cls._of(_core.parse_scene(text))

    @classmethod
    def reference(cls, n: int = 1000, *, seed: int = 1, radii: str = "uniform", rmin: float = 1,
                  rmax: float = 10, density: float = 0.05, speed: float = 1,
                  restitution: float = 1, horizon: float = 1000) -> "Scene":
        """n disjoint disks at random places with random directions and one speed.

        `radii` is "uniform" or "log" between rmin and rmax, or "equal" (all rmax); `density` is the
        area of the disks over that of the container. The same options give the same scene
        everywhere. Raises ValueError, and Error where a disk finds no free place.
        """
        return cls._of(_core.reference_scene(n, seed, radii, rmin, rmax, density, speed, restitution,
                                             horizon))

    @classmethod
    def grid(cls, n: int = 100, *, seed: int = 1, motion: str = "random", spacing: float = 4,
             radius: float = 1, speed: float = 1, horizon: float = 100) -> "Scene":
        """n equal disks on a square lattice; `motion` is "rest", "common", "random" or "shear"."""
        return cls._of(_core.grid_scene(n, seed, motion, spacing, radius, speed, horizon))

    @classmethod
    def swarm(cls, n: int = 20, *, seed: int = 1, spacing: float = 4, radius: float = 1,
              horizon: float = 100) -> "Scene":
        """n equal disks fly from a lattice to a circle and stop there at half the horizon."""
        return cls._of(_core.swarm_scene(n, seed, spacing, radius, horizon))

    @property
    def disks(self) -> "list[Disk]":
        return [Disk(*fields) for fields in self._core.disks()]

    @property
    def maneuvers(self) -> "list[Maneuver]":
        """In the order of their times."""
        return [Maneuver(*fields) for fields in self._core.maneuvers()]

    @property
    def radii(self) -> np.ndarray:
        """The disks' radii, rounded; shape (n,)."""
        return np.array(self._core.radii(), dtype=float)

    @property
    def container(self) -> "tuple[Fraction, Fraction, Fraction]":
        """x and y of its centre, and its radius."""
        return self._core.container

    @property
    def container_law(self) -> str:
        """ "normal" or "whole": what the container's restitution scales."""
        return self._core.container_law

    @property
    def container_restitution(self) -> Fraction:
        return self._core.container_restitution

    @property
    def restitution(self) -> Fraction:
        """Between two disks, in [0, 1]."""
        return self._core.restitution

    @property
    def name(self) -> str:
        return self._core.name

    @property
    def comment(self) -> str:
        return self._core.comment

    def diagram(self, t: Number, *, max_bits: int = 32768) -> "Diagram":
        """The diagram just after all events at t >= 0, by the engine; t may be beyond the horizon.

        Raises Undecided where the engine stops before t.
        """
        from .diagram import Diagram
        return Diagram(_core.diagram_of_scene(self._core, t, max_bits))

    def at(self, t: Number, *, max_bits: int = 32768) -> "Instant":
        """The true motion just after all events at t >= 0, to be asked often."""
        from .queries import Instant
        return Instant(_core.Instant(self._core, t, max_bits))

    def __reduce__(self):
        return _restored, (self.text, self._core.source())

    def _repr_html_(self) -> str:
        from .notebook import scene_html
        return scene_html(self)

    def __repr__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        return f"<Scene{name}: {len(self)} disks, horizon {float(self.horizon):g}>"


def _restored(text: str, source: "Optional[tuple[str, str]]") -> Scene:
    """A scene that was pickled: it keeps the identity of the file that it was read from."""
    return Scene._of(_core.make_scene(text, source))
