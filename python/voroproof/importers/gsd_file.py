"""GSD files with the schema of HOOMD-blue, by Debian's python3-gsd."""

import contextlib
import os
import warnings
from fractions import Fraction
from typing import Any, List, Optional

from . import boxes, numbers
from .faults import Refused, fail, refusing
from .table import Table

NAME = "gsd"
# The module gsd makes arrays of so many, whether the file has them or not.
COUNTED = ("particles", "bonds", "angles", "dihedrals", "impropers", "constraints", "pairs")


def _open(path: str) -> Any:
    try:
        import gsd.hoomd
    except ImportError:
        fail(path, 0, "", "a GSD file is read by the module gsd, which is not there (Debian: python3-gsd)")
    with refusing(path, "no GSD file of HOOMD-blue"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # about names that newer versions of gsd have changed
        return gsd.hoomd.open(path, "rb")


class _Reader:
    def __init__(self, path: str, radius: Optional[Fraction], timestep: Optional[Fraction],
                 periodic: Optional[str], flatten: bool):
        self.path = path
        self.size = 0  # size of the file, in bytes
        self.radius = radius
        self.timestep = timestep
        self.treatment = periodic
        self.heights = boxes.Heights(flatten)
        self.count: Optional[int] = None
        self.images = boxes.Images()

    def read(self) -> Table:
        frames = _open(self.path)
        with contextlib.closing(frames), refusing(self.path, "no frame can be read"):
            self.size = os.path.getsize(self.path)
            if len(frames) == 0:
                fail(self.path, 0, "", "no frame")
            # A frame without them has those of the first frame, or else 1.
            self.has_sizes = any(frames.file.chunk_exists(frame=k, name="particles/diameter") for k in range(len(frames)))
            self.dimension = 2 if self.heights.flatten else 3
            table = Table(self.radius is not None or self.has_sizes, self.dimension)
            for k in range(len(frames)):
                self.frame(table, frames, k)
        table.remarks += self.remarks()
        self.images.tell(table)
        return table

    def require_plausible(self, frames: Any, k: int) -> None:
        """Refuses what the file has no bytes for."""
        for what in COUNTED:
            name = f"{what}/N"
            if not frames.file.chunk_exists(frame=k, name=name):
                continue
            count = frames.file.read_chunk(frame=k, name=name)
            if count.dtype.kind != "u" or count.size != 1:
                fail(self.path, 0, f"frame {k} {name}", "no whole number")
            if int(count.item()) > self.size:
                fail(self.path, 0, f"frame {k} {name}", f"{count.item()}, and the file has {self.size} bytes")

    def frame(self, table: Table, frames: Any, k: int) -> None:
        self.require_plausible(frames, k)
        snapshot = frames[k]
        particles, configuration = snapshot.particles, snapshot.configuration
        place = f"frame {k}"
        if self.count not in (None, particles.N):
            fail(self.path, 0, f"{place} particles/N", "another number of particles than before: they have no names, so "
                 "that nothing tells which are gone or new")
        self.count = particles.N
        lengths = self.box(configuration.box, place)
        t = int(configuration.step) * (self.timestep if self.timestep is not None else 1)
        has_images = frames.file.chunk_exists(frame=k, name="particles/image")
        for i in range(particles.N):
            self.particle(table, particles, i, k, t, lengths, has_images)

    def box(self, box: Any, place: str) -> List[Fraction]:
        """The lengths; that of z may be 0, where the box is in the plane."""
        field = f"{place} configuration/box"
        try:
            lengths = [numbers.binary(float(value)) for value in box[:3]]
            tilt = [numbers.binary(float(value)) for value in box[3:6]]
            for axis in "xy":
                boxes.side(axis, True, self.treatment)
        except ValueError as error:
            fail(self.path, 0, field, str(error))
        if any(tilt):
            fail(self.path, 0, field, "a tilted box; only boxes along the axes are read")
        if min(lengths[:2]) <= 0 or lengths[2] < 0:
            fail(self.path, 0, field, "no positive length")
        for axis, length in enumerate(lengths):
            self.images.take(axis, length != 0, length)
        return lengths

    def particle(self, table: Table, particles: Any, i: int, k: int, t: Fraction, lengths: List[Fraction],
                 has_images: bool) -> None:
        name = str(i)
        field = f"frame {k} particles/position[{i}]"
        try:
            at = [numbers.binary(float(value)) for value in particles.position[i]]
            if self.treatment == boxes.UNWRAP:
                at = [x + int(k) * length for x, k, length in zip(at, particles.image[i], lengths)]
            self.heights.take(at[2])
            at = at[:self.dimension]
            last = table.last(name)
            # Flags that never change are not written: where one is missing, the place must tell.
            if last is not None and not (self.treatment == boxes.UNWRAP and has_images):
                for axis, before, now, length in zip("xyz", last[1], at, lengths):
                    boxes.require_no_jump(axis, before, now, length)
            radius = self.radius
            if radius is None and self.has_sizes:
                radius = numbers.binary(float(particles.diameter[i])) / 2
            table.add(name, t, tuple(at), radius, k)
        except ValueError as error:
            fail(self.path, 0, field, str(error))
        except Refused as refused:
            fail(self.path, 0, f"frame {k} particle {i} {refused.field}", refused.reason)

    def remarks(self) -> List[str]:
        said = ["t is counted in steps: the file does not say how long one takes" if self.timestep is None
                else f"a step takes {numbers.text(self.timestep)}, as given: the file does not say so",
                "what happens between two frames is not in the file; forces and walls are not, either"]
        if self.radius is not None:
            said.append(f"the radius of every disk is {numbers.text(self.radius)}, as given")
        elif self.has_sizes:
            said.append("radii are half of the diameters of the file, which need not be those at which particles touch")
        else:
            said.append("the file does not give diameters: give --radius where the table is read")
        return said + [*self.heights.remarks(),
                       "no digit of the file is lost: positions are binary32 numbers, written exactly; HOOMD-blue may "
                       "have rounded them when it wrote them"]


def read(path: str, *, radius: Optional[Fraction] = None, timestep: Optional[Fraction] = None,
         periodic: Optional[str] = None, flatten: bool = False) -> Table:
    """The paths of a GSD file. Raises InputError."""
    return _Reader(path, radius, timestep, periodic, flatten).read()
