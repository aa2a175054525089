"""Scenes and histories of hard-ball billiards, read exactly, and the exact paths a history records."""
import hashlib
import json
import math
from fractions import Fraction

SCENE_FORMAT = "voroproof-scene"
HISTORY_FORMAT = "voroproof-history"


class Malformed(Exception):
    """A scene (line 0) or a history that cannot be read."""

    def __init__(self, reason, line=0):
        super().__init__(reason)
        self.reason = reason
        self.line = line


def require(condition, reason):
    if not condition:
        raise Malformed(reason)


def number(value):
    """A JSON number is the nearest binary64, a string is exact."""
    require(isinstance(value, (int, float, str)) and not isinstance(value, bool), f"not a number: {value!r}")
    try:
        return Fraction(value) if isinstance(value, str) else Fraction(float(value))
    except (ValueError, OverflowError, ZeroDivisionError):
        raise Malformed(f"not a finite number: {value!r}") from None


def vector(value, dimension):
    require(isinstance(value, list) and len(value) == dimension, f"not a vector of {dimension}: {value!r}")
    return tuple(number(x) for x in value)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Disk:
    def __init__(self, data, dimension):
        self.center = vector(data.get("center"), dimension)
        self.radius = number(data.get("radius"))
        self.growth = number(data.get("growth", 0))
        self.fixed = data.get("fixed", False) is True
        if self.fixed and "velocity" not in data:
            self.velocity = (Fraction(0),) * dimension
        else:
            self.velocity = vector(data.get("velocity"), dimension)
        require(not self.fixed or not any(self.velocity), "a fixed disk has a velocity")
        self.mass = number(data["mass"]) if "mass" in data else self.radius ** 2
        require(self.fixed or self.mass > 0, "a disk without mass")


class Wall:
    def __init__(self, data, dimension):
        self.normal = vector(data.get("normal"), dimension)
        self.offset = number(data.get("offset"))
        self.speed = number(data.get("speed", 0))
        self.restitution = number(data.get("restitution", 1))
        require(dot(self.normal, self.normal) == 1, "a wall's normal is not of length 1")
        require(0 < self.restitution <= 1, "a wall's restitution is not in (0,1]")


class Circle:
    def __init__(self, data, dimension):
        self.center = vector(data.get("center"), dimension)
        self.radius = number(data.get("radius"))
        self.restitution = number(data.get("restitution", 1))
        require(0 < self.restitution <= 1, "the circle's restitution is not in (0,1]")


class Maneuver:
    def __init__(self, data, disks, dimension):
        self.t = number(data.get("t"))
        self.disk = data.get("disk")
        self.velocity = vector(data.get("velocity"), dimension)
        require(type(self.disk) is int and 0 <= self.disk < len(disks), "a maneuver of an unknown disk")
        require(not disks[self.disk].fixed, "a maneuver of a fixed disk")
        require(self.t >= 0, "a maneuver before time 0")


class Scene:
    """Everything in exact fractions; `sides` has None on the axes that are not periodic."""

    def __init__(self, raw):
        self.sha256 = hashlib.sha256(raw).hexdigest()
        try:
            data = json.loads(raw)
        except ValueError:
            raise Malformed("the scene is not JSON") from None
        require(isinstance(data, dict) and data.get("format") == SCENE_FORMAT, "not a scene")
        require(data.get("version") == 2 and data.get("contacts") == "bounce", "not a bounce scene of version 2")
        self.dimension = data.get("dimension", 2)
        require(self.dimension in (2, 3), "dimension is neither 2 nor 3")
        self.horizon = number(data.get("horizon"))
        self.restitution = number(data.get("restitution", 1))
        self.gravity = vector(data.get("gravity", [0] * self.dimension), self.dimension)
        self.disks = [Disk(d, self.dimension) for d in data.get("disks", [])]
        self.maneuvers = [Maneuver(m, self.disks, self.dimension) for m in data.get("maneuvers", [])]
        self._read_frame(data.get("frame"))
        self._check()

    def _read_frame(self, frame):
        self.circle, self.walls = None, []
        self.sides, self.shear = [None] * self.dimension, Fraction(0)
        if frame == "none":
            return
        require(isinstance(frame, dict), "no frame")
        if "radius" in frame:
            self.circle = Circle(frame, self.dimension)
            return
        self.walls = [Wall(w, self.dimension) for w in frame.get("walls", [])]
        if "periodic" in frame:
            sides = frame["periodic"]
            require(isinstance(sides, list) and len(sides) == self.dimension, "periodic: one side per axis")
            self.sides = [None if side is None else number(side) for side in sides]
            self.shear = number(frame.get("shear", 0))

    @property
    def periodic(self):
        return any(side is not None for side in self.sides)

    @property
    def extent(self):
        """The length E that roundings of positions are measured with."""
        result = max((max(map(abs, d.center)) + d.radius for d in self.disks), default=Fraction(0))
        if self.circle:
            result += max(map(abs, self.circle.center)) + self.circle.radius
        result += max((abs(w.offset) for w in self.walls), default=0)
        return result + sum(side for side in self.sides if side is not None)

    def images(self, low, high, reach, drift=(0, 0)):
        """All images k that bring a vector, somewhere in the box from low to high, within reach on the periodic axes.

        drift holds the least and the greatest shift along axis 0 that one step of k along axis 1 adds."""
        found = [()]
        for axis in reversed(range(self.dimension)):
            side = self.sides[axis]
            longer = []
            for tail in found:
                lo, hi = low[axis], high[axis]
                if axis == 0 and self.shear:
                    shifts = [tail[0] * shift for shift in drift]
                    lo, hi = lo + min(shifts), hi + max(shifts)
                span = (0,)
                if side is not None:
                    span = range(math.ceil((-reach - hi) / side), math.floor((reach - lo) / side) + 1)
                longer += [(k,) + tail for k in span]
            found = longer
        return found

    def _check(self):
        require(self.horizon >= 0, "the horizon is negative")
        require(0 <= self.restitution <= 1, "restitution is not in [0,1]")
        largest = Fraction(0)
        for disk in self.disks:
            at_end = disk.radius + disk.growth * self.horizon
            require(disk.radius >= 0 and at_end >= 0, "a negative radius")
            largest = max(largest, disk.radius, at_end)
        for side in self.sides:
            require(side is None or side > 2 * largest, "a periodic side does not exceed twice a radius")
        require(not self.shear or None not in self.sides[:2], "shear needs axes 0 and 1 periodic")
        for wall in self.walls:
            require(all(side is None or n == 0 for n, side in zip(wall.normal, self.sides)),
                    "a wall across a periodic axis")
        require(not self.circle or self.circle.radius >= largest, "a disk larger than the circle")
        times = [m.t for m in self.maneuvers]
        require(times == sorted(times), "the maneuvers are not sorted")
        self._check_start()

    def _check_start(self):
        for j, b in enumerate(self.disks):
            for a in self.disks[:j]:
                reach = a.radius + b.radius
                d = [y - x for x, y in zip(a.center, b.center)]
                for k in self.images(d, d, reach):
                    shifted = [x + (n * side if side else 0) for x, n, side in zip(d, k, self.sides)]
                    require(dot(shifted, shifted) >= reach ** 2, "two disks overlap at the start")
            for wall in self.walls:
                require(dot(wall.normal, b.center) - wall.offset >= b.radius, "a disk outside a wall at the start")
            if self.circle:
                d = [x - o for x, o in zip(b.center, self.circle.center)]
                room = self.circle.radius - b.radius
                require(room >= 0 and dot(d, d) <= room ** 2, "a disk outside the circle at the start")


class Claim:
    """One event of a history: a collision (pair, image) or a maneuver, with what it says of the disks it names."""

    def __init__(self, line, t):
        self.line, self.t = line, t
        self.maneuver = self.pair = self.image = None
        self.velocities = {}   # after the event, of the disks that turn
        self.centres = {}      # as far as given
        self.before = {}       # disk -> number of the line it was on; filled in by record_paths


class History:
    def __init__(self, raw, scene):
        self.scene = scene
        self.claims = []
        rows = raw.decode("utf-8", "replace").rstrip("\n").split("\n")
        line = 0
        try:
            for line, row in enumerate(rows, 1):
                try:
                    data = json.loads(row)
                except ValueError:
                    raise Malformed("not JSON") from None
                require(isinstance(data, dict), "not an object")
                if line == 1:
                    self._read_header(data)
                elif line == len(rows):
                    self._read_end(data, line)
                else:
                    self._read_claim(data, line)
            require(len(rows) > 1, "no end line")
        except Malformed as fault:
            raise Malformed(fault.reason, line) from None

    def _read_header(self, data):
        require(data.get("format") == HISTORY_FORMAT and data.get("version") == 2, "not a history of version 2")
        require(data.get("scene_sha256") == self.scene.sha256, "a history of another scene")
        require(number(data.get("horizon")) == self.scene.horizon, "another horizon than the scene's")

    def _read_end(self, data, line):
        end = data.get("end")
        require(isinstance(end, dict), "no end line")
        require(number(end.get("t")) == self.scene.horizon, "the end is not at the horizon")
        self.end_line = line
        self.counts = (end.get("collisions"), end.get("maneuvers"))

    def _read_claim(self, data, line):
        require("end" not in data, "events after the end")
        claim = Claim(line, number(data.get("t")))
        require(0 <= claim.t <= self.scene.horizon, "an event outside the time span")
        require(not self.claims or self.claims[-1].t <= claim.t, "time runs backwards")
        if "maneuver" in data:
            disk = data["maneuver"]
            require(type(disk) is int and 0 <= disk < len(self.scene.disks), "no such disk")
            # The k-th maneuver told of a disk is the k-th that is scheduled for it.
            scheduled = [n for n, m in enumerate(self.scene.maneuvers) if m.disk == disk]
            told = sum(c.maneuver is not None and disk in c.velocities for c in self.claims)
            require(told < len(scheduled), "no maneuver of the disk is left")
            claim.maneuver = scheduled[told]
            claim.velocities[disk] = vector(data.get("v"), self.scene.dimension)
            if data.get("p") is not None:
                claim.centres[disk] = vector(data["p"], self.scene.dimension)
        else:
            self._read_collision(claim, data)
        self.claims.append(claim)

    def _read_collision(self, claim, data):
        scene, dimension = self.scene, self.scene.dimension
        pair = data.get("collide")
        require(isinstance(pair, list) and len(pair) == 2 and all(type(x) is int for x in pair), "no pair of ids")
        i, j = claim.pair = tuple(pair)
        walls = 1 if scene.circle else len(scene.walls)
        require(-walls <= i < j and 0 <= j < len(scene.disks), "no such pair")
        image = data.get("image", [0] * dimension)
        require(isinstance(image, list) and len(image) == dimension and all(type(k) is int for k in image), "no image")
        require(all(k == 0 or (side is not None and i >= 0) for k, side in zip(image, scene.sides)), "no such image")
        claim.image = tuple(image)
        v, p = data.get("v"), data.get("p") or [None, None]
        require(isinstance(v, list) and len(v) == 2 and isinstance(p, list) and len(p) == 2, "not two velocities")
        for disk, velocity, centre in zip(claim.pair, v, p):
            if disk < 0:
                require(velocity is None and centre is None, "a wall with a velocity or centre")
                continue
            if centre is not None:
                claim.centres[disk] = vector(centre, dimension)
            if not scene.disks[disk].fixed:
                claim.velocities[disk] = vector(velocity, dimension)
            else:
                require(velocity is None or not any(vector(velocity, dimension)), "a fixed disk is to move")


class Path:
    """The lines of one disk: per axis the coefficients of 1, t, t^2 of the centre, in the time of the scene."""

    def __init__(self, disk, gravity):
        self.acceleration = (Fraction(0),) * len(gravity) if disk.fixed else gravity
        self.starts, self.lines, self.turned_by = [], [], []
        self._append(Fraction(0), disk.center, disk.velocity, None)

    def _append(self, t, centre, velocity, claim):
        self.starts.append(t)
        self.turned_by.append(claim)
        self.lines.append([(x - v * t + a * t * t / 2, v - a * t, a / 2)
                           for x, v, a in zip(centre, velocity, self.acceleration)])

    def centre(self, n, t):
        """Where line n is at time t."""
        return [c0 + t * (c1 + t * c2) for c0, c1, c2 in self.lines[n]]

    def velocity(self, n, t):
        return [c1 + 2 * t * c2 for _, c1, c2 in self.lines[n]]

    def turn(self, claim, velocity):
        self._append(claim.t, self.centre(-1, claim.t), velocity, claim)


def record_paths(scene, history):
    """The continuous paths that turn where the history says; notes in each claim the lines it ended."""
    paths = [Path(disk, scene.gravity) for disk in scene.disks]
    for claim in history.claims:
        disks = claim.pair if claim.pair else claim.velocities
        claim.before = {disk: len(paths[disk].lines) - 1 for disk in disks if disk >= 0}
        for disk, velocity in claim.velocities.items():
            paths[disk].turn(claim, velocity)
    return paths


def read_scene(path):
    with open(path, "rb") as file:
        return Scene(file.read())


def read_history(path, scene):
    with open(path, "rb") as file:
        return History(file.read(), scene)
