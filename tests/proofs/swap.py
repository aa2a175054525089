"""A bracket within which a fast disk flips eight edges, told as one flip of another edge.

What is right at both ends of the bracket is not right after it: the claimed diagram winds twice.
"""

import copy
import fractions

SWAP_SCENE = {
    "format": "voroproof-scene", "version": 1, "container": {"center": [0, 0], "radius": 16}, "horizon": 600000,
    "disks": [
        {"center": [0.1, -0.05], "radius": 13, "velocity": [0, 0], "mass": 1},
        {"center": [-14.5, 0.3], "radius": 0.25, "velocity": [0, 0], "mass": 1},
        {"center": [15.6, 0.05], "radius": 0.05, "velocity": [0, -1e-7], "mass": 1},
        {"center": [14.2, 1.6], "radius": 0.03125, "velocity": [0, 0.001], "mass": 1},
        {"center": [13.4, 0], "radius": 0.0625, "velocity": [0, 0], "mass": 1}],
    "maneuvers": [
        {"t": 2200, "disk": 3, "velocity": [0, 0]},
        {"t": "1367798109314227203062039166955/2417851639229258349412352", "disk": 3, "velocity": [0, -17179869184]},
        {"t": "1367798109314228417910802366485/2417851639229258349412352", "disk": 3, "velocity": [0, 0]}]}
SWAP_HISTORY = [
    {"format": "voroproof-history", "version": 1, "scene_sha256": "", "horizon": 600000, "producer": "by hand",
     "initial": [[-1, 0, 1, 3], [-1, 0, 4, 1], [-1, 1, 0, 0], [-1, 2, 3, 4], [-1, 3, 0, 2], [-1, 4, 2, 0],
                 [0, 1, -1, -1], [0, 3, 4, -1], [0, 4, -1, 3], [2, 3, -1, 4], [2, 4, 3, -1], [3, 4, 0, 2]]},
    {"t": 845.5909872579635, "flip": [3, 4, 0, 2]},
    {"t": 932.0093200612644, "flip": [2, 3, -1, 0]},
    {"t": 2200, "maneuver": 3, "v": [0, 0], "p": [14.2, 3.8000000000000003]},
    {"t": 342472.2898738402, "flip": [-1, 4, 2, 0]},
    {"t": "1367798109314227203062039166955/2417851639229258349412352", "maneuver": 3, "v": [0, -17179869184]},
    {"t": 565708.038955708, "flip": [0, 2, 4, -1]},
    {"t": "1367798109314228417910802366485/2417851639229258349412352", "maneuver": 3, "v": [0, 0]},
    {"end": {"t": 600000, "flips": 4, "collisions": 0, "maneuvers": 3}}]


def swap(*, time=1, length=1, mirrored=False, overlap=False, before=None):
    """Scene, history and tolerance: in other units of time and length, mirrored; with an overlap of disks 3 and 1 afterwards; up to a line."""
    def told(x):
        return str(x) if x.denominator > 1 else int(x)

    def place(p):
        return [told(fractions.Fraction(p[0]) * length), told(fractions.Fraction(p[1]) * (-length if mirrored else length))]

    def speed(v):
        return [told(fractions.Fraction(v[0]) * length / time), told(fractions.Fraction(v[1]) * (-length if mirrored else length) / time)]

    def edge(q):
        return [q[0], q[1], q[3], q[2]] if mirrored else q

    source, lines = copy.deepcopy(SWAP_SCENE), copy.deepcopy(SWAP_HISTORY)
    if overlap:
        source["disks"][1].update(center=[11.1, -9.3], radius=0.02)
        for t, v in ((570000, [-0.0005566922275945776, -0.0008023515938427722]), (575548, [0, 0])):
            source["maneuvers"].append({"t": t, "disk": 3, "velocity": v})
            lines.insert(-1, {"t": t, "maneuver": 3, "v": v})
        lines[-1]["end"]["maneuvers"] = 5
    if before is not None:
        cut = lines[before:-1]
        lines = lines[:before] + lines[-1:]
        end = lines[-1]["end"]
        end["flips"] -= sum("flip" in line for line in cut)
        end["maneuvers"] -= sum("maneuver" in line for line in cut)
        stop = fractions.Fraction(source["maneuvers"][1]["t"])
        source["maneuvers"] = [m for m in source["maneuvers"] if fractions.Fraction(m["t"]) < stop]
        source["horizon"] = lines[0]["horizon"] = end["t"] = 500000

    source["horizon"] = told(fractions.Fraction(source["horizon"]) * time)
    source["container"]["radius"] = told(fractions.Fraction(16) * length)
    for disk in source["disks"]:
        disk.update(center=place(disk["center"]), velocity=speed(disk["velocity"]), radius=told(fractions.Fraction(disk["radius"]) * length))
    for m in source["maneuvers"]:
        m.update(t=told(fractions.Fraction(m["t"]) * time), velocity=speed(m["velocity"]))
    head, end = lines[0], lines[-1]["end"]
    head["horizon"] = end["t"] = told(fractions.Fraction(end["t"]) * time)
    head["initial"] = [edge(q) for q in head["initial"]]
    for line in lines[1:-1]:
        line["t"] = told(fractions.Fraction(line["t"]) * time)
        line.pop("p", None)
        if "flip" in line:
            line["flip"] = edge(line["flip"])
        else:
            line["v"] = speed(line["v"])
    return source, lines, str(fractions.Fraction("1/1000000") * time)
