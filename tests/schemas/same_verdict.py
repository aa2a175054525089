#!/usr/bin/env python3
"""That the schemas and `voroproof validate` agree.

Takes one small file of each format that `validate` knows, changes it at each place in each of some
ways, and has both judge the result. A schema may accept what `validate` refuses for a reason that no
schema can say; these are listed, docs/formats.md lists them, too, and each must occur. A schema never
refuses what `validate` accepts.

usage: same_verdict.py PROGRAM
"""

import copy
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    from schemas import Files
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

FILES = {
    "scene.json": [{
        "format": "voroproof-scene", "version": 1, "name": "n", "comment": "c", "seed": 1,
        "container": {"center": [0, 0], "radius": 20, "restitution": 0.5},
        "container_law": "whole", "restitution": "1/2", "horizon": 10,
        "disks": [{"center": [1, "1/3"], "radius": 2, "velocity": [1, 0], "mass": 3},
                  {"center": [-9, 0], "radius": 1, "velocity": [0, "-0.5"]}],
        "maneuvers": [{"t": 1, "disk": 0, "velocity": [0, 1]},
                      {"t": "3/2", "disk": 1, "velocity": [1, 0]}]}],
    "history.jsonl": [
        {"format": "voroproof-history", "version": 1, "scene_sha256": "0a" * 32, "horizon": 10,
         "producer": "p 1", "initial": [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]},
        {"t": 1, "flip": [-1, 0, 1, 2]},
        {"t": "3/2", "collide": [0, 1], "v": [[1, 2], [3, 4]], "p": [[5, "1/3"], [7, 8]]},
        {"t": 2, "collide": [-1, 1], "v": [None, [1, 0]], "p": [None, [5, 6]]},
        {"t": 3, "maneuver": 1, "v": [1, 0], "p": [7, 8]},
        {"end": {"t": 10, "flips": 1, "collisions": 2, "maneuvers": 1}}],
    "stopped.jsonl": [
        {"format": "voroproof-history", "version": 1, "scene_sha256": "0A" * 32, "horizon": "1/3",
         "producer": ""},
        {"stopped": {"t": 0.25, "reason": "r", "events": [{"collide": [0, 1]}]}}],
    "diagram.json": [{
        "format": "voroproof-diagram", "version": 1, "t": "1/3", "scene_sha256": "0a" * 32,
        "container": {"center": [0, 0], "radius": 20},
        "disks": [{"center": [1, 0], "radius": 2, "velocity": [1, 0]},
                  {"center": [-9, 0], "radius": 1, "velocity": [0, 0]}],
        "vertices": [{"generators": [-1, 0, 1], "center": [3, 9], "radius": 9.5},
                     {"generators": [-1, 1, 0], "center": [3, -9], "radius": 9.5}],
        "edges": [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]}],
    "world.json": [{
        "format": "voroproof-scene", "version": 2, "name": "n", "horizon": 20, "contacts": "pass",
        "frame": {"center": [0, 0], "radius": 100, "growth": "-1/2"},
        "disks": [{"center": [1, "1/3"], "radius": 2, "velocity": [1, 0], "growth": "1/4"},
                  {"center": [1, 0], "radius": 1, "velocity": [0, 0], "enter": 1, "leave": 9}],
        "maneuvers": [{"t": 0, "disk": 0, "velocity": [0, 1]},
                      {"t": 3, "disk": 1, "center": [5, 5], "radius": 3},
                      {"t": 8, "disk": 0, "growth": 0}]}],
    "plane.json": [{
        "format": "voroproof-scene", "version": 2, "horizon": 5, "contacts": "pass", "frame": "none", "disks": []}],
    "held.json": [{
        "format": "voroproof-scene", "version": 2, "horizon": 5, "contacts": "pass",
        "container": {"center": [0, 0], "radius": 9}, "disks": []}],
    "world.jsonl": [
        {"format": "voroproof-history", "version": 2, "scene_sha256": "0a" * 32, "horizon": 20,
         "producer": "p 1", "initial": [[-1, 0, 1, 1], [-1, 1, 0, 0], [0, 1, -1, -1]]},
        {"t": 1, "flip": [-1, 0, 1, 2]},
        {"t": 1, "hide": [1, 0]},
        {"t": 2, "appear": [1, 0], "at": [0, 4, -1, 2]},
        {"t": 2, "swap": [0, 3]},
        {"t": 3, "maneuver": 1, "v": [1, 0], "p": [7, 8], "growth": 2},
        {"t": 4, "jump": 3, "out": [[1, 2, 3, 4], [5, 6], [5, 6, 6, 1, 2, 4], [5, 6, None]],
         "at": [4, 8, 1, -1], "in": [[3, 4, 5, 6]], "p": [1, 2], "v": [3, 4], "r": 5},
        {"t": 5, "jump": 4, "in": []},
        {"end": {"t": 20, "flips": 1, "hides": 1, "appears": 1, "swaps": 1, "jumps": 2,
                 "collisions": 0, "maneuvers": 1}}],
    "billiard.json": [{
        "format": "voroproof-scene", "version": 2, "name": "n", "comment": "c", "seed": "s", "horizon": 2,
        "contacts": "bounce", "dimension": 2, "frame": {"center": [0, 0], "radius": "99/2", "restitution": 0.5},
        "restitution": "1/2", "gravity": [0, "-1/3"],
        "disks": [{"center": [1, "1/3"], "radius": 2, "velocity": [1, 0], "growth": "-1/4", "mass": 3},
                  {"center": [9, 0], "radius": 1, "fixed": True},
                  {"center": [-9, 0], "radius": 1, "velocity": [0, "-0.0"], "growth": 1, "fixed": True},
                  {"center": [0, 9], "radius": 1, "velocity": [0, 1], "fixed": False}],
        "maneuvers": [{"t": 0, "disk": 0, "velocity": [0, 1]},
                      {"t": "3/2", "disk": 3, "velocity": [1, 0]}]}],
    "box.json": [{
        "format": "voroproof-scene", "version": 2, "horizon": 1, "contacts": "bounce", "dimension": 3,
        "frame": {"walls": [{"normal": [0, 0, "-1"], "offset": -40, "speed": "1/8", "restitution": 0.5},
                            {"normal": [0, 0, 1], "offset": "-81/2"}],
                  "periodic": [50, "101/2", None], "shear": "1/10"},
        "gravity": [0, 0, -10],
        "disks": [{"center": [0, 0, "1/3"], "radius": 3, "velocity": [1, -1, 0]}]}],
    "channel.json": [{
        "format": "voroproof-scene", "version": 2, "horizon": 1, "contacts": "bounce",
        "frame": {"periodic": [None, 9], "shear": "0/1"}, "disks": []}],
    "between.json": [{
        "format": "voroproof-scene", "version": 2, "horizon": 1, "contacts": "bounce",
        "frame": {"walls": [{"normal": ["3/5", "-4/5"], "offset": -40}]},
        "disks": []}],
    "free.json": [{
        "format": "voroproof-scene", "version": 2, "horizon": 1, "contacts": "bounce", "frame": "none", "disks": []}],
    "billiard.jsonl": [
        {"format": "voroproof-history", "version": 2, "scene_sha256": "0a" * 32, "horizon": 20, "producer": "p 1"},
        {"t": 0, "maneuver": 1, "v": [1, 0], "p": ["1/3", 8]},
        {"t": 1, "collide": [0, 1], "image": [-1, 0], "v": [[1, 2], [3, "1/4"]], "p": [[5, 6], [7, 8]]},
        {"t": "3/2", "collide": [-3, 1], "image": [0, 0], "v": [None, [1, 0]], "p": [None, [5, 6]]},
        {"t": 2, "collide": [1, 2], "v": [[1, 0], None], "p": [[5, 6], None]},
        {"end": {"t": 20, "collisions": 3, "maneuvers": 1, "flips": 0, "hides": 0, "appears": 0, "swaps": 0,
                 "jumps": 0}}],
    "space.jsonl": [
        {"format": "voroproof-history", "version": 2, "scene_sha256": "0A" * 32, "horizon": "1/3", "producer": ""},
        {"t": 0, "collide": [0, 1], "image": [0, 1, -1], "v": [[1, 2, 3], [4, 5, 6]], "p": [[0, 0, 0], [1, 2, 2]]},
        {"t": 0.25, "maneuver": 1, "v": [1, 0, "1/3"], "p": [0, 0, 0]},
        {"end": {"t": "1/3", "collisions": 1, "maneuvers": 1}}],
    "plan.json": [{
        "format": "voroproof-plan", "version": 1, "name": "n",
        "container": {"center": [0, 0], "radius": 50}, "arrive": 10, "clearance": "1/3",
        "vehicles": [{"id": 0, "radius": 1, "start": [-10, 0], "goal": [10, 0]},
                     {"id": 1, "radius": 1, "start": [0, -10], "goal": ["1/3", 10]}]}],
}

# The messages of `validate` of each kind, which no schema can say.
UNSAYABLE = {
    "an order of values": ["earlier than", "later than", "the smaller first", "listed by id", "after the disk enters",
                           "has left"],
    "a bound that is another value": ["beyond the horizon", "not the horizon", "no such disk"],
    "generators that differ": ["names no edge", "its own host", "the first generator", "of the disk itself"],
    "an edge twice, under either name": ["names an edge twice"],
    "counts and the way in which parts belong together": [
        "wrong counts", " disks", "which is no vertex", "neither out nor in", "like another before it",
        "a vertex of the same name", "second maneuver", "is fixed"],
    "how many coordinates there are": ["coordinates, as", "coordinates, and", "the dimension of the scene"],
    "a radius that shrinks": ["becomes negative", "is not positive"],
    "geometry": ["overlap", "container", "contains", "no default", "for a point", "its own image", "does not fit", "lies across",
                 "length is not exactly 1"],
    "the size of an exact string": ["not in [0, 1", "not in (0, 1]", "beyond the limits of a scene"],
    "the size of a number where any value may stand": ["beyond the range of binary64"],
    "a number's form": ["not an integer"],
}

# Only the first line says of which kind a history is.
OF_ANOTHER_KIND = "what the lines of one history are"
LINES = {"scene": ("flip", "collision", "maneuver", "end", "stop"),
         "world": ("flip", "hide", "appear", "swap", "maneuver", "jump", "worldEnd", "stop"),
         "billiard": ("bounce", "turn", "billiardEnd", "stop")}

VALUES = [None, "abc", "-1/3", "-0", "1/0", "0x1.8p-3", "1e200", "1e401", -1, 2.0, 0.5, 1e101, 1e-101, [], {}, 10**400]

# Faults that no change of one place makes, and a few that are none: the file, the line, the place there and
# its new value.
OTHERS = [
    ("history.jsonl", 0, ("initial",), [[-1, 0, 1, 1], [0, -1, 1, 1]]),
    ("history.jsonl", 5, ("end", "flips"), 2),
    ("diagram.json", 0, ("edges",), [[-1, 0, 1, 1], [-1, 0, 1, 1], [0, 1, -1, -1]]),
    ("scene.json", 0, ("disks",), [{"center": [0, 0], "radius": 0, "velocity": [0, 0]},
                                   {"center": [5, 0], "radius": 1, "velocity": [0, 0]}]),
    ("scene.json", 0, ("maneuvers",), [{"t": 1, "disk": 0, "velocity": [0, 1]}] * 2),
    ("world.json", 0, ("frame", "growth"), -10),
    ("world.json", 0, ("disks", 0, "growth"), -1),
    ("world.json", 0, ("disks", 1, "leave"), 3),
    ("world.json", 0, ("container",), {"center": [0, 0], "radius": 1}),
    ("world.jsonl", 3, ("at",), [4, 0, 2, -1]),
    ("world.jsonl", 3, ("at",), [0, 1, -1, 2]),
    ("world.jsonl", 6, ("out", 1), [5, 5]),
    ("world.json", 0, ("contacts",), "bounce"),
    ("billiard.json", 0, ("contacts",), "pass"),
    ("billiard.json", 0, ("gravity",), [0, 0, 0]),
    ("billiard.json", 0, ("frame", "walls"), []),
    ("billiard.json", 0, ("frame",), {"restitution": 1}),
    ("billiard.json", 0, ("frame",), {"shear": 0}),
    ("billiard.json", 0, ("container",), {"center": [0, 0], "radius": 20}),
    ("billiard.json", 0, ("disks", 0, "fixed"), True),
    ("billiard.json", 0, ("disks", 1, "velocity"), [0, "0x0p1"]),
    ("billiard.json", 0, ("disks", 1, "velocity"), [0, "1e-9"]),
    ("billiard.json", 0, ("disks", 1, "fixed"), False),
    ("billiard.json", 0, ("disks", 3, "radius"), 0),
    ("billiard.json", 0, ("maneuvers", 1, "disk"), 1),
    ("billiard.json", 0, ("maneuvers",), [{"t": 1, "disk": 0, "velocity": [0, 1]}] * 2),
    ("box.json", 0, ("dimension",), 2),
    ("box.json", 0, ("dimension",), 4),
    ("box.json", 0, ("disks", 0, "center"), [1, 2, 3, 4]),
    ("box.json", 0, ("frame", "walls", 1, "normal"), [0, 1, 1]),
    ("box.json", 0, ("frame", "walls", 1, "restitution"), "0/2"),
    ("box.json", 0, ("frame", "periodic"), [50, 6, None]),
    ("box.json", 0, ("frame", "periodic"), [50, None, 50]),
    ("channel.json", 0, ("frame", "shear"), "0/3"),
    ("channel.json", 0, ("frame", "shear"), "1/3"),
    ("channel.json", 0, ("frame", "periodic"), [None, None, None]),
    ("between.json", 0, ("frame", "shear"), -0.0),
    ("between.json", 0, ("frame", "shear"), 1),
    ("history.jsonl", 3, ("collide", 0), -2),
    ("history.jsonl", 3, ("image",), [0, 0]),
    ("billiard.jsonl", 0, ("initial",), []),
    ("billiard.jsonl", 0, ("version",), 1),
    ("billiard.jsonl", 1, ("image",), [0, 0]),
    ("billiard.jsonl", 1, ("growth",), 1),
    ("billiard.jsonl", 2, ("collide",), [1, 0]),
    ("billiard.jsonl", 2, ("collide",), [0, -1]),
    ("billiard.jsonl", 2, ("image", 0), 2**30),
    ("billiard.jsonl", 2, ("image", 0), -2**30 - 1),
    ("billiard.jsonl", 2, ("v",), [None, None]),
    ("billiard.jsonl", 2, ("v",), [1, 2]),
    ("billiard.jsonl", 3, ("image",), [1, 0]),
    ("billiard.jsonl", 3, ("v", 0), [1, 0]),
    ("billiard.jsonl", 4, ("flip",), [0, 1, 2, 3]),
    ("billiard.jsonl", 5, ("end", "collisions"), 4),
    ("billiard.jsonl", 5, ("end", "swaps"), 1),
    ("billiard.jsonl", 5, ("t",), 20),
    ("billiard.jsonl", 5, (), {"stopped": {"t": 3, "reason": "r"}}),
    ("space.jsonl", 2, ("v",), [[1, 2, 3], [4, 5, 6]]),
    ("space.jsonl", 2, (), {"t": 0, "flip": [0, 1, 2, 3]}),
]

# A message of `validate`: the file, and the reason behind line and field.
MESSAGE = re.compile(r"^voroproof: (.*?\.jsonl?)(?::\d+)?: (?:[^ :]*: )?(.*)$")
# As many files are given to one `validate`.
BATCH = 500


def places(value, path=()):
    """Every place in a JSON document, as the keys that lead to it."""
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from places(inner, path + (key,))


def at(document, path):
    for key in path:
        document = document[key]
    return document


def changes(document):
    """(what was changed, changed document), for one JSON document."""
    for path in places(document):
        here = at(document, path)
        if path:
            for value in VALUES:
                changed = copy.deepcopy(document)
                at(changed, path[:-1])[path[-1]] = value
                yield f"{path} = {str(value)[:20]}", changed
            changed = copy.deepcopy(document)
            del at(changed, path[:-1])[path[-1]]
            yield f"{path} left out", changed
        if isinstance(here, dict):
            for name in ("foo", "x-foo"):
                changed = copy.deepcopy(document)
                at(changed, path)[name] = {"a": [1]}
                yield f"{path} with {name}", changed
        if isinstance(here, list) and here:
            changed = copy.deepcopy(document)
            at(changed, path).append(here[-1])
            yield f"{path} with its last element twice", changed


def texts(name, documents):
    """(what was changed, text of the file), of each document with one change."""
    lines = [json.dumps(document) for document in documents]
    yield "as it is", "\n".join(lines) + "\n"
    for index, document in enumerate(documents):
        for what, changed in changes(document):
            rest = lines[:index] + [json.dumps(changed)] + lines[index + 1:]
            yield f"line {index + 1}: {what}", "\n".join(rest) + "\n"
    for _, index, path, value in (other for other in OTHERS if other[0] == name):
        changed = copy.deepcopy(documents)
        place = (index, *path)
        at(changed, place[:-1])[place[-1]] = value
        yield f"{path} = {value}", "".join(json.dumps(line) + "\n" for line in changed)


def is_of_another_kind(files, text):
    """Whether a line of a history is none of its kind."""
    header, *lines = [json.loads(line) for line in text.splitlines()]
    if header["format"] != "voroproof-history":
        return False
    kind = "scene" if header["version"] == 1 else "world" if "initial" in header else "billiard"
    return any(all(files.schema("history", name).fault(line) for name in LINES[kind]) for line in lines)


def batches(all_texts):
    """Lists of at most BATCH of them."""
    while batch := list(itertools.islice(all_texts, BATCH)):
        yield batch


def refusals(program, folder, name, batch):
    """By text of a batch, the reason for which `validate` refuses it; None where it is valid."""
    paths = [folder / f"{index}.{name}" for index in range(len(batch))]
    for path, (_, text) in zip(paths, batch):
        path.write_text(text)
    run = subprocess.run([program, "validate", *paths], capture_output=True, text=True)
    reasons = dict(MESSAGE.match(line).groups() for line in run.stderr.splitlines())
    valid = {line.split(": ")[0] for line in run.stdout.splitlines()}
    if run.returncode != (2 if reasons else 0) or valid ^ {*reasons} != {str(path) for path in paths}:
        sys.exit(f"{name}: validate: {run.returncode}, {len(valid)} and {len(reasons)} of {len(batch)} files")
    return [reasons.get(str(path)) for path in paths]


def main():
    program = sys.argv[1]
    files = Files()
    failed, judged = 0, 0
    seen = set()
    with tempfile.TemporaryDirectory() as folder:
        for name, documents in FILES.items():
            for batch in batches(texts(name, documents)):
                for (what, text), said in zip(batch, refusals(program, pathlib.Path(folder), name, batch)):
                    fault = files.fault(text)
                    judged += 1
                    if fault is not None and (said is None or what == "as it is"):
                        print(f"{name}: {what}: validate: {said}; schema: {fault}")
                        failed += 1
                    if fault is not None or said is None:
                        continue
                    kinds = [kind for kind, phrases in UNSAYABLE.items() if any(p in said for p in phrases)]
                    if not kinds and is_of_another_kind(files, text):
                        kinds = [OF_ANOTHER_KIND]
                    seen.update(kinds)
                    if not kinds:
                        print(f"{name}: {what}: only validate refuses it: {said}")
                        failed += 1
    for kind in {*UNSAYABLE, OF_ANOTHER_KIND} - seen:
        print(f"no schema fails to say: {kind}")
        failed += 1
    print(f"{judged} files judged, {failed} otherwise by the schemas")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
