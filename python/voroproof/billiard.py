"""Billiards: disks or balls that bounce off each other and off walls, also in periodic boxes, and their histories."""

from __future__ import annotations

import json
import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence

import numpy as np

from . import _core
from .events import Ending, Events, core_ending
from .scene import Number, Path, SceneFile, json_value

if TYPE_CHECKING:
    import pandas

#: The items of `BilliardHistory.events`: time `t`; `kind` (COLLISION, MANEUVER); `ids`, shape (2,), of the two that
#: collide, the smaller first, walls being -1, -2, ..., or the disk of a maneuver and -2**31; `image`, shape (3,), of
#: the second that the first touches, -2**31 throughout for the nearest; `velocity` just after and `center`, shape
#: (2, 3), of the first and the second, NaN for nothing. In the plane third coordinates are 0.
billiard_event_dtype: np.dtype = _core.billiard_event_dtype
_NONE = -2**31


def _one_each(name: str, values: Any, n: int) -> np.ndarray:
    array = np.asarray(values)
    if array.shape not in ((), (n,)):
        raise ValueError(f"{name}: the shape is not ({n},)")
    return np.broadcast_to(array, (n,))


class Billiard(SceneFile):
    """A scene of version 2 whose disks bounce, checked, which does not change.

    `Billiard(mapping)` takes the fields of a scene file (docs/formats.md, section 21); `format`, `version` and
    `contacts` may be left out. Each number is a float or an int, or exact: a Fraction, a Decimal or text such as "1/3".
    Raises InputError (a ValueError) that names the field and the reason, also where disks overlap or are
    outside of the frame.
    """

    def __init__(self, fields: Mapping[str, Any]):
        whole = {"format": "voroproof-scene", "version": 2, "contacts": "bounce", **fields}
        self._core = _core.make_billiard(json.dumps(json_value(whole)) + "\n")

    @classmethod
    def read(cls, path: Path) -> "Billiard":
        """Reads a scene file. Raises InputError with file, line and field."""
        return cls._of(_core.read_billiard(os.fspath(path)))

    @classmethod
    def parse(cls, text: str) -> "Billiard":
        """Reads the text of a scene file."""
        return cls._of(_core.parse_billiard(text))

    @classmethod
    def from_arrays(cls, centers: Any, radii: Any, *, horizon: Number, velocities: Any = None, masses: Any = None,
                    growths: Any = None, fixed: Any = None, periodic: "Optional[Sequence[Optional[Number]]]" = None,
                    shear: Optional[Number] = None, walls: "Optional[Sequence[Mapping[str, Any]]]" = None,
                    gravity: "Optional[Sequence[Number]]" = None, restitution: Number = 1,
                    maneuvers: "Sequence[Mapping[str, Any]]" = ()) -> "Billiard":
        """n disks in the plane or balls in space, in a frame of walls and periodic axes, or in none.

        `centers` and `velocities` (by default 0) have the shape (n, 2) or (n, 3); `radii`, `masses` (by default
        radius squared), `growths` and `fixed` the shape (n,), or are one value for all. `periodic` has the side of
        the box along each axis, None where it is not periodic; `shear`, `walls`, `gravity` and `maneuvers` are as in
        the file: a wall is {"normal": [0, 1], "offset": 0}. Arrays may be of Fractions.
        Raises ValueError for other shapes, and InputError as the constructor.
        """
        centers = np.asarray(centers)
        if centers.ndim != 2 or centers.shape[1] not in (2, 3):
            raise ValueError("centers: the shape is neither (n, 2) nor (n, 3)")
        n, dimension = centers.shape
        moving = np.zeros_like(centers) if velocities is None else np.asarray(velocities)
        if moving.shape != centers.shape:
            raise ValueError(f"velocities: the shape is not ({n}, {dimension})")
        columns = {"center": centers, "velocity": moving, "radius": _one_each("radii", radii, n)}
        for name, key, values in (("masses", "mass", masses), ("growths", "growth", growths), ("fixed", "fixed", fixed)):
            if values is not None:
                columns[key] = _one_each(name, values, n)
        frame = {"periodic": periodic, "shear": shear, "walls": walls}
        fields = {"dimension": dimension, "disks": [dict(zip(columns, values)) for values in zip(*columns.values())],
                  "frame": {key: value for key, value in frame.items() if value is not None} or "none",
                  "horizon": horizon, "restitution": restitution, "maneuvers": maneuvers}
        if gravity is not None:
            fields["gravity"] = gravity
        return cls(fields)

    @property
    def dimension(self) -> int:
        """2 for disks in the plane, 3 for balls in space."""
        return self._core.dimension

    def __reduce__(self):
        return Billiard.parse, (self.text,)

    def __repr__(self) -> str:
        bodies = "disks in the plane" if self.dimension == 2 else "balls in space"
        return f"<Billiard: {len(self)} {bodies}, horizon {float(self.horizon):g}>"


class BilliardHistory(Events):
    """A history of a billiard; it does not change.

    Made by `simulate`, by `BilliardHistory.read`, or of an array of `billiard_event_dtype` by the constructor.
    `events` is such an array, in the order of the events.
    """

    _kinds = ("collision", "maneuver")

    def __init__(self, billiard: Billiard, events: Any, *, horizon: Optional[Number] = None, producer: str = "",
                 ending: Optional[Ending] = None):
        """Takes `events` (copied) as a history of the billiard.

        The horizon is the billiard's unless given; `ending` says how it ends, by default complete at the
        horizon. Whether it is a history at all is checked where it is used; `certify` judges it.
        """
        end = billiard.horizon if horizon is None else horizon
        rows = np.ascontiguousarray(events, dtype=billiard_event_dtype)
        self.billiard = billiard
        self._core = _core.BilliardHistory(billiard._core, end, producer, rows, core_ending(ending, end))

    @classmethod
    def _of(cls, core: _core.BilliardHistory, billiard: Billiard) -> "BilliardHistory":
        history = cls.__new__(cls)
        history._core, history.billiard = core, billiard
        return history

    @classmethod
    def read(cls, path: Path, billiard: Billiard) -> "BilliardHistory":
        """Reads a history file of the billiard. Raises InputError, also where it is one of another scene."""
        return cls._of(_core.read_billiard_history(os.fspath(path), billiard._core), billiard)

    def to_pandas(self) -> "pandas.DataFrame":
        """The events as a frame: t, kind, ids, coordinates and the image in columns of their own, NA for nothing."""
        axes = "xyz"[:self.billiard.dimension]
        frame = self._frame(axes)
        for axis, letter in enumerate(axes):
            frame[f"image_{letter}"] = self.events["image"][:, axis]
        for name in ("id1", *(f"image_{letter}" for letter in axes)):
            frame[name] = frame[name].astype("Int64").mask(frame[name] == _NONE)
        return frame
