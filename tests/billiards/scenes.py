"""Random scenes of every kind, as JSON data with a generous horizon."""
import math
import random

KINDS = ("none", "circle", "box", "slanted", "moving", "channel", "periodic-1", "periodic-2", "periodic-3", "small",
         "shear", "shear-small")
SLANTED = {2: (["3/5", "4/5"], ["-0.6", "0.8"], [1, 0], [0, -1], ["5/13", "-12/13"], ["-0.8", "-0.6"]),
           3: (["2/3", "1/3", "2/3"], ["-3/5", 0, "4/5"], [0, "0.8", "-0.6"], [-1, 0, 0], ["-2/7", "-3/7", "-6/7"])}


def as_float(x):
    if isinstance(x, str) and "/" in x:
        a, b = x.split("/")
        return int(a) / int(b)
    return float(x)


def some_number(rng, low, high):
    """Mostly a double, now and then an exact string."""
    choice = rng.random()
    if choice < 0.85:
        return rng.uniform(low, high)
    x = rng.uniform(low, high)
    return f"{x:.3f}" if choice < 0.95 else f"{round(x * 21)}/21"


def axis_walls(axes, half, dimension, rng, speed=0.0):
    walls = []
    for axis in axes:
        for sign in (1, -1):
            wall = {"normal": [sign if a == axis else 0 for a in range(dimension)], "offset": -half}
            if speed:
                wall["speed"] = rng.uniform(-speed, speed)
            if rng.random() < 0.4:
                wall["restitution"] = rng.uniform(0.6, 1)
            walls.append(wall)
    return walls


def slanted_walls(disks, dimension, rng):
    walls = []
    for normal in SLANTED[dimension]:
        n = [as_float(x) for x in normal]
        nearest = min(sum(a * as_float(c) for a, c in zip(n, d["center"])) - d["radius"] for d in disks)
        wall = {"normal": normal, "offset": nearest - rng.uniform(0.1, 0.6)}
        if rng.random() < 0.3:
            wall["restitution"] = rng.uniform(0.6, 1)
        walls.append(wall)
    return walls


def frame_of(kind, dimension, half, disks, rng):
    side = [2 * half * rng.uniform(1, 1.2) for _ in range(dimension)]
    if kind == "none":
        return "none"
    if kind == "circle":
        shift = [rng.uniform(-0.1, 0.1) for _ in range(dimension)]
        reach = max(math.dist([as_float(c) for c in d["center"]], shift) + d["radius"] for d in disks)
        return {"center": shift, "radius": reach + rng.uniform(0.05, 0.5), "restitution": rng.choice([1, 1, 0.8])}
    if kind in ("box", "moving"):
        return {"walls": axis_walls(range(dimension), half, dimension, rng, 0.1 if kind == "moving" else 0)}
    if kind == "slanted":
        return {"walls": slanted_walls(disks, dimension, rng)}
    if kind == "channel":
        walled = rng.randrange(dimension)
        return {"periodic": [None if a == walled else side[a] for a in range(dimension)],
                "walls": axis_walls([walled], half, dimension, rng, rng.choice([0, 0.05]))}
    count = {"periodic-1": 1, "periodic-2": 2, "periodic-3": 3}.get(kind, dimension)
    axes = list(range(dimension))
    rng.shuffle(axes)
    if "shear" in kind:
        axes, count = [0, 1, 2], rng.choice([2, dimension])
    frame = {"periodic": [side[a] if a in axes[:count] else None for a in range(dimension)]}
    if "shear" in kind:
        frame["shear"] = some_number(rng, 0.1, 0.5) if rng.random() < 0.5 else rng.uniform(-0.5, -0.1)
    open_axes = [a for a in range(dimension) if frame["periodic"][a] is None]
    if open_axes and rng.random() < 0.5:
        frame["walls"] = axis_walls(open_axes, half, dimension, rng)
    return frame


def place_disks(count, dimension, half, radii, rng):
    """Random centres whose disks keep apart, also from each other's images in a torus of side 2 half."""
    disks = []
    for radius in radii[:count]:
        for _ in range(300):
            room = half - radius - 0.02
            center = [some_number(rng, -room, room) for _ in range(dimension)]
            c = [as_float(x) for x in center]
            if all(abs(x) < half - radius - 0.005 for x in c) and all(
                    math.dist(c, [as_float(x) for x in d["center"]]) > radius + d["radius"] + 0.02 for d in disks):
                disks.append({"center": center, "radius": radius})
                break
    return disks


def dress(disks, dimension, rng, options, horizon):
    """Velocities, masses, growth and fixed disks."""
    fixed = rng.randint(1, 2) if options["fixed"] else 0
    for n, disk in enumerate(disks):
        if n < fixed and n < len(disks) - 1:
            disk["fixed"] = True
        else:
            disk["velocity"] = [some_number(rng, -1, 1) for _ in range(dimension)]
            if options["mass"] and rng.random() < 0.7:
                disk["mass"] = some_number(rng, 0.2, 3)
        if options["growth"] and rng.random() < 0.7 and disk["radius"] > 0 and not (disk.get("fixed") and n):
            disk["growth"] = rng.uniform(-0.05, 0.1) / horizon
        if disk["radius"] == 0:
            disk["mass"] = 0.3
    rng.shuffle(disks)


def gather(disks, rng):
    """Sends the disks of an open plane towards its middle, or few of them would ever meet."""
    for disk in disks:
        if not disk.get("fixed"):
            haste = rng.uniform(0.3, 1)
            disk["velocity"] = [-haste * as_float(c) + rng.uniform(-0.1, 0.1) for c in disk["center"]]


def random_scene(seed, attempt):
    """Scene data and the wanted number of events; the kind of frame goes round with the seed."""
    rng = random.Random(f"scene {seed} {attempt}")
    kind = KINDS[seed % len(KINDS)]
    dimension = 3 if kind == "periodic-3" else 2 + seed // len(KINDS) % 2
    small = "small" in kind
    options = {name: rng.random() < chance for name, chance in
               (("gravity", 0.4), ("growth", 0.35), ("fixed", 0.4), ("mass", 0.5), ("lossy", 0.4), ("maneuver", 0.4))}
    if kind == "moving":
        options["fixed"] = False
    if kind == "none" and options["gravity"]:
        options["fixed"] = True
    half = rng.uniform(0.5, 0.8) if small else rng.uniform(0.9, 1.8 if dimension == 2 else 1.2)
    radii = [rng.uniform(0.12, 0.3) if not small else rng.uniform(0.15, 0.24) for _ in range(8)]
    horizon = rng.uniform(3, 8 if kind == "none" else 40)
    if rng.random() < 0.1:
        radii[rng.randrange(3)] = 0
    disks = place_disks(rng.randint(1, 3) if small else rng.randint(1, 8), dimension, half, radii, rng)
    if not disks:
        return None, 0
    dress(disks, dimension, rng, options, horizon)
    if kind == "none":
        gather(disks, rng)
    scene = {"format": "voroproof-scene", "version": 2, "horizon": horizon,
             "contacts": "bounce", "dimension": dimension, "frame": frame_of(kind, dimension, half, disks, rng)}
    if options["lossy"]:
        scene["restitution"] = some_number(rng, 0.5, 1)
    if options["gravity"]:
        scene["gravity"] = [rng.uniform(-0.5, 0.5) for _ in range(dimension)]
        if rng.random() < 0.3:
            scene["gravity"] = [0] * (dimension - 1) + ["-0.4"]
    scene["disks"] = disks
    movable = [n for n, d in enumerate(disks) if not d.get("fixed")]
    if options["maneuver"]:
        times = sorted(rng.uniform(0, rng.choice([1, 4])) for _ in range(rng.randint(1, 4)))
        scene["maneuvers"] = [{"t": t, "disk": rng.choice(movable),
                               "velocity": [rng.uniform(-1, 1) for _ in range(dimension)]} for t in times]
    return scene, rng.randint(0, 40)
