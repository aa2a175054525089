#!/usr/bin/env python3
"""Attempts to make voroproof-proved accept what it must not: files made by hand.

usage: attempts.py PROVED DIRECTORY

Each attempt changes the files of one small scene, the example of docs/formats.md, in one way, and names the verdict that is
right. DIRECTORY takes the files. The exit code is 1 where a verdict is another.
"""

import copy
import fractions
import hashlib
import json
import pathlib
import subprocess
import sys

import swap

SCENE = {
    "format": "voroproof-scene", "version": 1, "name": "three disks", "comment": "", "seed": 1,
    "container": {"center": [0, 0], "radius": 20, "restitution": 1},
    "container_law": "normal", "restitution": 1, "horizon": 12,
    "disks": [
        {"center": [-6, "1/3"], "radius": 2, "velocity": [1, 0]},
        {"center": [4, "1/3"], "radius": 3, "velocity": [0, 0], "mass": 4},
        {"center": [5, -11], "radius": 1, "velocity": [0, 0], "x-label": "scout"}],
    "maneuvers": [{"t": 1.5, "disk": 2, "velocity": [1, 0]}]}
HISTORY = [
    {"format": "voroproof-history", "version": 1, "scene_sha256": "", "horizon": 12, "producer": "by hand",
     "initial": [[-1, 0, 2, 1], [-1, 1, 0, 2], [-1, 2, 1, 0], [0, 1, 2, -1], [0, 2, -1, 1], [1, 2, 0, -1]]},
    {"t": 1.5, "maneuver": 2, "v": [1, 0], "p": [5, -11]},
    {"t": 5, "collide": [0, 1], "v": [[0, 0], [1, 0]], "p": [[-1, 0.3333333333333333], [4, 0.3333333333333333]]},
    {"t": 8.886510686115848, "flip": [0, 2, -1, 1]},
    {"t": 11.991933384829668, "collide": [-1, 2], "v": [None, [-0.3296398891966759, 0.9441067436738302]],
     "p": [None, [15.491933384829668, -11]]},
    {"end": {"t": 12, "flips": 1, "collisions": 2, "maneuvers": 1}}]
HEADER, MANEUVER, HIT, FLIP, WALL, END = range(6)

ATTEMPTS = []


def attempt(right, name, *, scene=None, history=None, scene_text=None, history_text=None, options=()):
    """Edits of the objects, then of the texts. The history names the edited scene, unless an edit of its text changes that."""
    ATTEMPTS.append((right, name, scene, history, scene_text, history_text, list(options)))


def put(*path_and_value):
    """An edit that sets a value."""
    *path, key, value = path_and_value

    def edit(top):
        for step in path:
            top = top[step]
        top[key] = value
    return edit


def delete(*path):
    def edit(top):
        for step in path[:-1]:
            top = top[step]
        del top[path[-1]]
    return edit


def both(*edits):
    def edit(top):
        for one in edits:
            one(top)
    return edit


def insert(place, line):
    return lambda history: history.insert(place, line)


def text(old, new):
    def edit(source):
        assert old in source, old
        return source.replace(old, new, 1)
    return edit


def invalid(name, **edits):
    attempt("INVALID", name, **edits)


def undecided(name, **edits):
    attempt("UNDECIDED", name, **edits)


def certified(name, **edits):
    attempt("CERTIFIED", name, **edits)


# Right files are certified, so that the attempts below fail for their own reason only.
certified("the files as they are")
certified("an exact string for a number", history=put(HIT, "t", "5"))
certified("a hexadecimal float", history=put(HIT, "t", "0x1.4p2"))
certified("a fraction", history=put(MANEUVER, "t", "3/2"))
certified("extensions", scene=put("x-note", {"a": [1, None]}), history=both(put(HIT, "x-v", [9, 9]), put(HEADER, "x-initial", [])))
certified("an edge by its other name", history=put(HEADER, "initial", 0, [0, -1, 1, 2]))
certified("no line end after the last line", history_text=lambda s: s[:-1])
certified("a shorter horizon", history=both(put(HEADER, "horizon", 11), put(END, "end", {"t": 11, "flips": 1, "collisions": 1, "maneuvers": 1}),
                                            delete(WALL)))

# Numbers.
for word in ("", "-", "+5", ".5", "5.", "5/", "/5", "5/-1", "10/0", "0x1_4p2", "0x", "1e+-5", "5e", "1_0", "nan", "inf", "0x1p5000", "1e500",
             "5 ", "0b101", "5\\u0030", "0x1.4p2p0", "1/2/3", "--5"):
    invalid(f"the time '{word}'", history_text=text('"t": 5', f'"t": "{word}"'))
for word in ("", "-", "+", ".", "-.", "/1", "e5", "0x0_0", "0x1p-5000"):
    invalid(f"'{word}' for zero", scene=put("disks", 1, "velocity", [word, 0]))
invalid("a number that is nearest to zero and is not zero", scene_text=text('"velocity": [0, 0]', '"velocity": [1e-400, 0]'))
# The second is less than the first by 2^-68, and the same to a binary64.
invalid("hexadecimal floats of more digits than a binary64 that decrease",
        history=both(put(MANEUVER, "t", "0x1.80000000000000001p0"), insert(HIT, {"t": 1.5, "maneuver": 2, "v": [1, 0]})))
for word in ("NaN", "Infinity", "1e999", "5.", "05", "+5", "0x5", "1e-400", "[5]", "null", "true", '{"x": 5}'):
    invalid(f"the time {word}", history_text=text('"t": 5', f'"t": {word}'))
invalid("an exact string that no binary64 but zero is near to", history=put(FLIP, "t", "1e-380"))
invalid("a radius beyond a scene's limits", scene=put("disks", 2, "radius", "1e-200"))
undecided("a time that is wrong in the last of many digits", history=put(HIT, "t", "5." + "0" * 40 + "1"), options=["--tolerance", "1e-50"])
undecided("a time beyond the tolerance", history=put(HIT, "t", "5.000001000001"))
undecided("a flip beyond the tolerance", history=put(FLIP, "t", 8.886512))

# The syntax of JSON.
invalid("a comment", history_text=text('"flip"', '/* "t": 3 */ "flip"'))
invalid("a comment to the end of the line", history_text=text('[0, 2, -1, 1]}\n{', '[0, 2, -1, 1]}// \n{'))
invalid("a name without quotes", history_text=text('"flip"', "flip"))
invalid("a tuple", history_text=text("[0, 2, -1, 1]}", "(0, 2, -1, 1)}"))
invalid("two objects in a line", history_text=text('{"t": 5', '{"t": 4}{"t": 5'))
invalid("a list for an object", history_text=text('{"t": 5', '[{"t": 5'))
invalid("a byte order mark", scene_text=lambda s: "\ufeff" + s)
invalid("a line end within a string", scene_text=text("three disks", "three\ndisks"))
invalid("a scene with something behind it", scene_text=lambda s: s + "{}")
invalid("an empty scene", scene_text=lambda _: "")

# Fields.
invalid("a field twice", history_text=text('"t": 5', '"t": 5, "t": 4'))
invalid("a field twice, once with an escape", history_text=text('"t": 5', '"t": 5, "\\u0074": 4'))
invalid("a field twice in the scene", scene_text=text('"radius": 2,', '"radius": 2, "radius": 9,'))
invalid("an extension twice", scene_text=text('"x-label": "scout"', '"x-label": 1, "x-label": 2'))
invalid("an unknown field of the scene", scene=put("gravity", 9.81))
invalid("an unknown field of a disk", scene=put("disks", 0, "omega", 1))
invalid("an unknown field of the container", scene=put("container", "x-kind", 1))
invalid("an unknown field of a flip", history=put(FLIP, "v", [0, 0]))
invalid("an unknown field of the last line", history=put(END, "end", "x-n", 0))
invalid("a flip that is a collision, too", history=put(FLIP, "collide", [0, 2]))
invalid("a last line that is an event, too", history=put(END, "flip", [0, 1, 2, -1]))
for name in ("center", "radius", "velocity"):
    invalid(f"a disk without {name}", scene=delete("disks", 1, name))
for name in ("format", "version", "scene_sha256", "horizon", "producer"):
    invalid(f"a header without {name}", history=delete(HEADER, name))
invalid("another format", history=put(HEADER, "format", "voroproof-scene"))
invalid("another version", history=put(HEADER, "version", 2))
invalid("a version that is no integer", history_text=text('"version": 1', '"version": 1.0'))
invalid("a producer that is no string", history=put(HEADER, "producer", 1))
invalid("an unknown law", scene=put("container_law", "soft"))
undecided("no initial diagram", history=delete(HEADER, "initial"))

# Lines.
invalid("an empty history", history_text=lambda _: "")
invalid("only a header", history=lambda h: h.__delitem__(slice(1, None)))
invalid("no last line", history=lambda h: h.pop())
invalid("cut within the last line", history_text=lambda s: s[:-10])
invalid("cut within an event", history_text=lambda s: s[:s.index('"flip"')])
invalid("two last lines", history=lambda h: h.append(h[-1]))
invalid("an event behind the last line", history=lambda h: h.append(h[FLIP]))
invalid("an empty line behind the last", history_text=lambda s: s + "\n")
invalid("an empty line between", history_text=text('\n{"t": 5', '\n\n{"t": 5'))
invalid("two headers", history=lambda h: h.insert(0, h[0]))
invalid("times that decrease", history=lambda h: h.insert(1, h.pop(2)))
invalid("times that decrease beyond the digits of a binary64",
        history=both(put(MANEUVER, "t", "1.5" + "0" * 30 + "1"), insert(HIT, {"t": 1.5, "maneuver": 2, "v": [1, 0]})))
invalid("a negative time", history=put(MANEUVER, "t", -1e-9))
for field in ("flips", "collisions", "maneuvers"):
    undecided(f"another number of {field}", history=put(END, "end", field, 3))
    invalid(f"a negative number of {field}", history=put(END, "end", field, -1))
invalid("a last line of another time", history=put(END, "end", "t", 11))
undecided("a history that stops", history=put(END, {"stopped": {"t": 12, "reason": "tired"}}))
invalid("a stop without a reason", history=put(END, {"stopped": {"t": 12}}))

# The horizon.
invalid("a negative horizon, no events", history=both(put(HEADER, "horizon", -5), lambda h: h.__delitem__(slice(1, 5)),
                                                      put(1, "end", {"t": -5, "flips": 0, "collisions": 0, "maneuvers": 0})))
invalid("an event after the horizon", history=both(put(HEADER, "horizon", 11), put(END, "end", "t", 11)))
undecided("a horizon with events that are not claimed", history=both(put(HEADER, "horizon", 300), put(END, "end", "t", 300)))
undecided("the events of half the time", history=both(delete(WALL), delete(FLIP), put(3, "end", "flips", 0), put(3, "end", "collisions", 1)))

# The scene.
invalid("the history of another scene", scene_text=lambda s: s + " ", history_text=lambda s: s)
invalid("a hash in capital letters", history_text=lambda s: s.replace(json.loads(s.split("\n", 1)[0])["scene_sha256"],
                                                                      json.loads(s.split("\n", 1)[0])["scene_sha256"].upper()))
invalid("a negative radius", scene=put("disks", 2, "radius", -1))
invalid("a container without extent", scene=put("container", "radius", 0))
invalid("a mass of zero", scene=put("disks", 1, "mass", 0))
invalid("a negative mass", scene=put("disks", 1, "mass", -3))
invalid("a point without a mass", scene=put("disks", 2, "radius", 0))
invalid("a restitution above one", scene=put("restitution", 1.5))
invalid("a negative restitution", scene=put("restitution", -1))
invalid("a wall that takes all", scene=put("container", "restitution", 0))
invalid("a negative horizon of the scene", scene=put("horizon", -12))
invalid("a disk outside", scene=put("disks", 2, "center", [40, 0]))
invalid("a disk that sticks out of the container", scene=put("disks", 2, "center", ["16", "-11"]))
invalid("a disk that touches the container and slides", scene=both(put("disks", 2, "center", [19, 0]), put("disks", 2, "velocity", [0, 1])))
invalid("two disks that overlap", scene=put("disks", 1, "center", ["-1.00000000000000000001", "1/3"]))
invalid("two points at one place", scene=put("disks", [{"center": [1, 1], "radius": 0, "velocity": [0, 0], "mass": 1}] * 2))
invalid("a maneuver of no disk", scene=put("maneuvers", 0, "disk", 3))
invalid("a maneuver of the container", scene=put("maneuvers", 0, "disk", -1))
invalid("a maneuver before the start", scene=put("maneuvers", 0, "t", -1))
invalid("maneuvers that are not sorted", scene=put("maneuvers", [{"t": 20, "disk": 1, "velocity": [1, 0]}, {"t": 1.5, "disk": 2, "velocity": [1, 0]}]))
invalid("two maneuvers of a disk at one instant", scene=put("maneuvers", [{"t": 1.5, "disk": 2, "velocity": [1, 0]}] * 2))
undecided("no disks", scene=both(put("disks", []), put("maneuvers", [])), history=both(put(HEADER, "initial", []), lambda h: h.__delitem__(slice(1, 5)),
          put(1, "end", {"t": 12, "flips": 0, "collisions": 0, "maneuvers": 0})))
undecided("one disk", scene=both(lambda s: s["disks"].__delitem__(slice(0, 2)), put("maneuvers", [])),
          history=both(put(HEADER, "initial", []), lambda h: h.__delitem__(slice(1, 5)),
                       put(1, "end", {"t": 12, "flips": 0, "collisions": 0, "maneuvers": 0})))

# Ids.
for word in ("-2", "3", "1.0", "1e0", '"1"', "4611686018427387903", "4611686018427387901", "9223372036854775808", "-4611686018427387904", "null"):
    invalid(f"the id {word} in a flip", history_text=text("[0, 2, -1, 1]}", f"[0, 2, -1, {word}]}}"))
    invalid(f"the id {word} in a collision", history_text=text('"collide": [0, 1]', f'"collide": [0, {word}]'))
    invalid(f"the id {word} in the initial diagram", history_text=text("[-1, 0, 2, 1]", f"[-1, 0, 2, {word}]"))
    invalid(f"the id {word} in a maneuver", history_text=text('"maneuver": 2', f'"maneuver": {word}'))
invalid("a maneuver of the container, claimed", history=put(MANEUVER, "maneuver", -1))
invalid("a flip of an edge between one and the same", history=put(FLIP, "flip", [0, 0, -1, 1]))
invalid("a flip of an edge that ends where it lies", history=put(FLIP, "flip", [0, 2, 0, 1]))
invalid("an initial edge of three generators", history=put(HEADER, "initial", 0, [-1, 0, 2]))
invalid("a collision of one", history=put(HIT, "collide", [0]))
invalid("a collision with itself", history=put(HIT, "collide", [1, 1]))

# Collisions. At the wall, in the other order of the ids, the law would be that of two disks, one of no mass.
invalid("the larger id first", history=both(put(HIT, "collide", [1, 0]), put(HIT, "v", [[1, 0], [0, 0]]), delete(HIT, "p")))
invalid("through the wall", history=both(put(WALL, "collide", [2, -1]), put(WALL, "v", [[1, 0], [1.3296398891966759, -0.9441067436738302]]), delete(WALL, "p")),
        options=["--tolerance", "0.01"])
undecided("the wall reflects nothing", history=put(WALL, "v", [None, [1, 0]]), options=["--tolerance", "0.01"])
invalid("null for the velocity of a disk", history=put(HIT, "v", [None, [1, 0]]))
invalid("null for the centre of a disk", history=put(HIT, "p", [None, [4, 0.3333333333333333]]))
invalid("null for both velocities", history=put(HIT, "v", None))
invalid("null for a disk at the wall", history=put(WALL, "v", [None, None]))
invalid("a velocity of the container", history=put(WALL, "v", [[0, 0], [-0.3296398891966759, 0.9441067436738302]]))
invalid("a centre of the container", history=put(WALL, "p", [[0, 0], [15.491933384829668, -11]]))
invalid("a velocity of three coordinates", history=put(HIT, "v", [[0, 0, 0], [1, 0]]))
undecided("no velocities", history=both(delete(HIT, "v"), delete(HIT, "p")))
undecided("velocities exchanged", history=put(HIT, "v", [[1, 0], [0, 0]]))
undecided("a velocity beyond the tolerance", history=put(HIT, "v", [[2e-9, 0], [1, 0]]))
undecided("a centre beyond the tolerance", history=put(HIT, "p", 0, [-1.00001, 0.3333333333333333]))
undecided("another mass", scene=put("disks", 1, "mass", 4.0001))
undecided("another restitution", scene=put("restitution", 0.999))
undecided("another law of the wall", scene=both(put("container_law", "whole"), put("container", "restitution", 0.5)))
undecided("a collision left out", history=both(delete(HIT), put(HIT, "t", 8.886510686115848), put(4, "end", "collisions", 1)))
undecided("a collision twice", history=both(insert(HIT, HISTORY[HIT]), put(6, "end", "collisions", 3)))
undecided("a collision of two that are far apart", history=both(insert(HIT, {"t": 3, "collide": [0, 2], "v": [[1, 0], [1, 0]]}),
                                                                 put(6, "end", "collisions", 3)))
undecided("the collision at the wall left out", history=both(delete(WALL), put(4, "end", "collisions", 1)))

# Two pass through each other, as the tolerance lets them; the claim is of the time when they have. The law then turns them
# back, and they pass through each other once more, within the tolerance after the claim.
undecided("twice through each other with one claim",
          scene=lambda s: s.update(horizon=17, maneuvers=[], disks=[{"center": [-5, 0], "radius": 1, "velocity": [1, 0]},
                                                                     {"center": [5, 0.5], "radius": 1, "velocity": [0, 0]}]),
          history=lambda h: h.__setitem__(slice(0, None), [
              {**h[HEADER], "horizon": 17, "initial": [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]},
              {"t": 12.25, "collide": [0, 1], "v": [["4/85", "18/85"], ["81/85", "-18/85"]]},
              {"end": {"t": 17, "flips": 0, "collisions": 1, "maneuvers": 0}}]),
          options=["--tolerance", "4.5"])

# Maneuvers.
undecided("a maneuver left out", history=both(delete(MANEUVER), put(4, "end", "maneuvers", 0)))
undecided("a maneuver twice", history=both(insert(MANEUVER, HISTORY[MANEUVER]), put(6, "end", "maneuvers", 2)))
undecided("a maneuver of another disk", history=put(MANEUVER, {"t": 1.5, "maneuver": 1, "v": [1, 0]}))
undecided("a maneuver to another velocity", history=put(MANEUVER, "v", [1, 1e-8]))
undecided("a maneuver without its velocity", history=both(delete(MANEUVER, "v"), delete(MANEUVER, "p")))
undecided("a maneuver at another time", history=put(MANEUVER, "t", 1.6))
undecided("a maneuver elsewhere", history=put(MANEUVER, "p", [5.1, -11]))
undecided("a maneuver that the scene has not", scene=delete("maneuvers"))
undecided("a second maneuver that is not claimed", scene=lambda s: s["maneuvers"].append({"t": 12, "disk": 0, "velocity": [0, 0]}))

# The diagram.
undecided("an initial edge left out", history=lambda h: h[HEADER]["initial"].pop())
undecided("an initial edge twice", history=lambda h: h[HEADER]["initial"].append(h[HEADER]["initial"][0]))
undecided("an initial edge in place of another", history=lambda h: put(HEADER, "initial", 5, h[HEADER]["initial"][0])(h))
undecided("an initial edge the other way round", history=put(HEADER, "initial", 3, [0, 1, -1, 2]))
undecided("an empty initial diagram", history=put(HEADER, "initial", []))
undecided("all vertices clockwise", history=lambda h: put(HEADER, "initial", [[l, r, e, s] for l, r, s, e in h[HEADER]["initial"]])(h))
undecided("the diagram after the flip", history=put(HEADER, "initial", [[-1, 0, 1, 2], [-1, 1, 0, 2], [-1, 2, 1, 0], [0, 1, 2, -1], [-1, 1, 2, 0], [1, 2, 0, -1]]))
undecided("a flip left out", history=both(delete(FLIP), put(4, "end", "flips", 0)))
undecided("a flip twice", history=both(insert(FLIP, HISTORY[FLIP]), put(6, "end", "flips", 2)))
undecided("a flip and back", history=both(insert(FLIP + 1, {"t": 8.886510686115848, "flip": [-1, 1, 2, 0]}), put(6, "end", "flips", 2)))
undecided("a flip of another edge", history=put(FLIP, "flip", [0, 1, 2, -1]))
undecided("a flip the other way round", history=put(FLIP, "flip", [0, 2, 1, -1]))
undecided("a flip of an edge that is not there", history=put(FLIP, "flip", [-1, 1, 2, 0]))
undecided("a flip too early", history=lambda h: put(FLIP, "t", 8.8)(h))

# Other flips within the bracket of a claimed one (swap.py).
def swapped(right, name, **how):
    source, lines, tolerance = swap.swap(**how)
    attempt(right, name, scene=lambda s: (s.clear(), s.update(source)), history=lambda h: h.__setitem__(slice(None), lines),
            options=["--tolerance", tolerance])


swapped("CERTIFIED", "the scene of a swap without it", before=5)
swapped("UNDECIDED", "a swap within a bracket")
swapped("UNDECIDED", "a swap within a bracket, and an overlap", overlap=True)
for power in (-20, -3, 3, 20):
    swapped("UNDECIDED", f"a swap with times by 2^{power}", time=fractions.Fraction(2) ** power)
    swapped("UNDECIDED", f"a swap with lengths by 2^{power}", length=fractions.Fraction(2) ** power)
    swapped("UNDECIDED", f"a mirrored swap and an overlap, times by 2^{power}", time=fractions.Fraction(2) ** power, mirrored=True, overlap=True)

# A motion that ends where the model has none.
SLIDES = {"disks": [{"center": [0, -9], "radius": 1, "velocity": [0, 0]}, {"center": [0, 5], "radius": 0.5, "velocity": [0, 0]}],
          "container": {"center": [0, 0], "radius": 10}, "horizon": 1}
for moves, right in ((1, "UNDECIDED"), (0, "CERTIFIED")):
    attempt(right, f"a disk at the container gets the velocity {moves} along it at the horizon",
            scene=lambda s, v=moves: s.update(SLIDES, maneuvers=[{"t": 1, "disk": 0, "velocity": [v, 0]}]),
            history=lambda h, v=moves: h.__setitem__(slice(None), [
                {**h[HEADER], "horizon": 1, "initial": [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]},
                {"t": 1, "maneuver": 0, "v": [v, 0]}, {"end": {"t": 1, "flips": 0, "collisions": 0, "maneuvers": 1}}]))

# At one instant turns come before flips.
STOPPED = {"disks": [{"center": c, "radius": 0.25, "velocity": [v, v]} for c, v in (([-1, 1], 0), ([-1, -1], 0), ([1, -1], 0), ([1.5, 1.5], -0.25))],
           "container": {"center": [0, 0], "radius": 10}, "horizon": 4, "maneuvers": [{"t": 2, "disk": 3, "velocity": [0, 0]}]}
TURN, TIE = {"t": 2, "maneuver": 3, "v": [0, 0]}, {"t": 2, "flip": [0, 2, 1, 3]}
for right, lines in (("CERTIFIED", [TURN, TIE]), ("UNDECIDED", [TIE, TURN])):
    attempt(right, "a flip and a turn of its disk at one instant", scene=lambda s: s.update(STOPPED),
            history=lambda h, lines=lines: h.__setitem__(slice(None), [
                {**h[HEADER], "horizon": 4, "initial": [[-1, 0, 1, 3], [-1, 1, 2, 0], [-1, 2, 3, 1], [-1, 3, 0, 2], [0, 1, -1, 2], [0, 2, 1, 3],
                                                        [0, 3, 2, -1], [1, 2, -1, 0], [2, 3, -1, 0]]},
                *lines, {"end": {"t": 4, "flips": 1, "collisions": 0, "maneuvers": 1}}]))

# Options.
invalid("a negative tolerance", options=["--tolerance", "-1"])
invalid("a tolerance beyond the horizon", options=["--tolerance", "13"])
invalid("a tolerance that is no number", options=["--tolerance", ""])
invalid("a tolerance of velocities beyond one", options=["--law-tolerance", "1.5"])
undecided("a tolerance of zero", options=["--tolerance", "0"])


def main():
    proved, directory = sys.argv[1], pathlib.Path(sys.argv[2])
    directory.mkdir(parents=True, exist_ok=True)
    failed = 0
    for number, (right, name, edit_scene, edit_history, edit_scene_text, edit_history_text, options) in enumerate(ATTEMPTS):
        scene, history = copy.deepcopy(SCENE), copy.deepcopy(HISTORY)
        if edit_scene:
            edit_scene(scene)
        if edit_history:
            edit_history(history)
        scene_text = json.dumps(scene)
        named = hashlib.sha256(scene_text.encode()).hexdigest()
        if edit_scene_text:
            scene_text = edit_scene_text(scene_text)
            if not edit_history_text:
                named = hashlib.sha256(scene_text.encode()).hexdigest()
        if history and "scene_sha256" in history[0]:
            history[0]["scene_sha256"] = named
        history_text = "".join(json.dumps(line) + "\n" for line in history)
        if edit_history_text:
            history_text = edit_history_text(history_text)
        files = [directory / f"{number}.scene.json", directory / f"{number}.history.jsonl"]
        for file, content in zip(files, (scene_text, history_text)):
            file.write_text(content, encoding="utf-8")
        ran = subprocess.run([proved, *files, *options], capture_output=True, text=True, check=False)
        said = ran.stdout.splitlines()[-1:] or [f"exit code {ran.returncode}"]
        # An option that cannot be read is an error of usage: a message and the exit code, no verdict.
        if said != ["s " + right] and not (right == "INVALID" and options and ran.returncode == 2 and ran.stderr):
            print(f"{name} ({files[1]}): {' '.join(ran.stdout.splitlines()[-2:])} {ran.stderr.strip()}, and not {right}")
            failed += 1
    if not failed:
        print(f"{len(ATTEMPTS)} attempts by hand, none wrongly accepted")
    return min(failed, 1)


if __name__ == "__main__":
    sys.exit(main())
