"""Exact transformations of a scene and its history, after which the verdict and its line are the same.

A scene is the object of its file, a history the list of the objects of its lines.
"""

from fractions import Fraction


def number(x):
    """A number as the file has it, exactly; the inverse of `written`."""
    return Fraction(x)


def written(q):
    """As a JSON number where a double has it, else as a string."""
    return float(q) if Fraction(float(q)) == q else f"{q.numerator}/{q.denominator}"


def times(value, factor):
    """A number, or a list of any depth, times a factor; None stays."""
    if value is None:
        return None
    if isinstance(value, list):
        return [times(x, factor) for x in value]
    return written(number(value) * factor)


def scaled(length, time):
    """Lengths times 2^length, times times 2^time."""
    size, t = Fraction(2) ** length, Fraction(2) ** time
    of_disk = {"center": size, "radius": size, "velocity": size / t, "growth": size / t}
    of_wall = {"offset": size, "speed": size / t}
    of_frame = {"center": size, "radius": size, "periodic": size, "shear": 1 / t}

    def fields(data, factors):
        return {k: times(v, factors[k]) if k in factors else v for k, v in data.items()}

    def change(scene, rows):
        scene = fields(scene, {"horizon": t, "gravity": size / t / t})
        if isinstance(scene["frame"], dict):
            scene["frame"] = fields(scene["frame"], of_frame)
            if "walls" in scene["frame"]:
                scene["frame"]["walls"] = [fields(w, of_wall) for w in scene["frame"]["walls"]]
        disks = []
        for disk in scene["disks"]:
            # A mass that is not given is a square of a length.
            mass = {} if disk.get("fixed") else {"mass": written(number(disk["radius"]) ** 2)}
            disks.append(fields(mass | disk, of_disk))
        scene["disks"] = disks
        if "maneuvers" in scene:
            scene["maneuvers"] = [fields(m, {"t": t, "velocity": size / t}) for m in scene["maneuvers"]]
        told = [fields(row, {"t": t, "horizon": t, "v": size / t, "p": size}) for row in rows]
        told[-1] = {"end": fields(told[-1]["end"], {"t": t})}
        return scene, told, t
    return change


def mirrored(scene, rows):
    """The first axis turned round."""
    def turned(vector):
        if vector is None:
            return None
        if vector and isinstance(vector[0], list) or None in vector:
            return [turned(v) for v in vector]
        return [times(vector[0], -1), *vector[1:]]

    def fields(data, names):
        return {k: turned(v) if k in names else v for k, v in data.items()}

    scene = fields(scene, {"gravity"})
    frame = scene["frame"]
    if isinstance(frame, dict):
        frame = fields(frame, {"center"})
        if "shear" in frame:
            frame["shear"] = times(frame["shear"], -1)
        if "walls" in frame:
            frame["walls"] = [fields(w, {"normal"}) for w in frame["walls"]]
        scene["frame"] = frame
    scene["disks"] = [fields(d, {"center", "velocity"}) for d in scene["disks"]]
    if "maneuvers" in scene:
        scene["maneuvers"] = [fields(m, {"velocity"}) for m in scene["maneuvers"]]
    told = []
    for row in rows:
        row = fields(row, {"v", "p"})
        if "image" in row:
            row["image"] = [-row["image"][0], *row["image"][1:]]
        told.append(row)
    return scene, told, 1


def relabelled(scene, rows):
    """The disks in reverse order; the smaller id of a pair still comes first."""
    last = len(scene["disks"]) - 1

    def name(disk):
        return disk if disk < 0 else last - disk

    scene = dict(scene, disks=scene["disks"][::-1])
    if "maneuvers" in scene:
        scene["maneuvers"] = [dict(m, disk=name(m["disk"])) for m in scene["maneuvers"]]
    told = []
    for row in rows:
        row = dict(row)
        if "maneuver" in row:
            row["maneuver"] = name(row["maneuver"])
        if "collide" in row:
            a, b = map(name, row["collide"])
            row["collide"] = sorted((a, b))
            if a > b:
                for field in ("v", "p"):
                    if row.get(field):
                        row[field] = row[field][::-1]
                if "image" in row:
                    row["image"] = [-k for k in row["image"]]
        told.append(row)
    return scene, told, 1


TRANSFORMS = {"mirrored": mirrored, "relabelled": relabelled, "small and slow": scaled(-90, 40),
              "large and fast": scaled(120, -60)}
