#!/usr/bin/env python3
"""Writes the cases of this folder anew: corpus/{certified,refuted,invalid,undecided} and cases.txt.

usage: corpus/make.py PROGRAM      (the program is build/voroproof)

A case is a history beside the scene it claims to be of. The refuted, invalid and undecided ones are
one edit away from a certified one: the edit is in the name. What `certify` must say of each is in
cases.txt, which corpus/run.sh holds against the files and against the program.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
HERE = Path(__file__).resolve().parent
cases = []


def run(*words):
    subprocess.run([str(PROGRAM), *map(str, words)], check=True, stdout=subprocess.DEVNULL)


def write(verdict, name, scene, text, truths=("exact", "recorded"), kind="-", options="",
          ending=".history.jsonl"):
    """One case for each truth; `kind` is the fault that the report must name."""
    path = HERE / verdict / (name + ending)
    path.parent.mkdir(exist_ok=True)
    path.write_text(text)
    for truth in truths:
        cases.append(f"{verdict}/{path.name}\t{scene}\t{truth}\t{kind}\t{options or '-'}")


def scene(name, *generate, edit=None):
    path = HERE / "scenes" / (name + ".scene.json")
    path.parent.mkdir(exist_ok=True)
    if generate:
        run("generate", *generate, "-o", path)
    if edit:
        path.write_text(edit(path.read_text() if path.exists() else ""))
    return path


def history(path):
    out = HERE / "scratch.history.jsonl"
    run("simulate", path, "-o", out, "--quiet")
    text = out.read_text()
    out.unlink()
    return text


def lines_of(text):
    return text.splitlines()


def joined(lines):
    return "\n".join(lines) + "\n"


def recounted(lines):
    """The same lines with an end line that counts them."""
    end = json.loads(lines[-1])
    for key, word in (("flips", "flip"), ("collisions", "collide"), ("maneuvers", "maneuver")):
        end["end"][key] = sum(1 for l in lines[1:-1] if f'"{word}":' in l)
    return lines[:-1] + [json.dumps(end, separators=(",", ":"))]


def index(lines, word, count=0):
    """The line of the count-th event of a kind."""
    return [k for k, l in enumerate(lines) if f'"{word}":' in l and k > 0][count]


def quad(line):
    return json.loads(line)["flip"]


def with_value(line, key, value):
    data = json.loads(line)
    data[key] = value
    return json.dumps(data, separators=(",", ":"))


def canonical(q):
    l, r, s, e = q
    return min([l, r, s, e], [r, l, e, s])


# ---- The scenes. ----
disks = scene("disks", "reference", "--n", 8, "--seed", 4, "--density", 0.25, "--horizon", 40)
swarm = scene("swarm", "swarm", "--n", 6, "--seed", 2, "--horizon", 20)
grid = scene("grid", "grid", "--n", 9, "--seed", 3, "--motion", "random", "--horizon", 6)
lossy = scene("lossy", "reference", "--n", 6, "--seed", 9, "--density", 0.2, "--horizon", 20,
              edit=lambda t: t.replace('"restitution": 1,',
                                       '"container_law": "whole",\n "restitution": 0.75,')
              .replace('"radius": ', '"restitution": 0.5, "radius": ', 1))
one = scene("one", "reference", "--n", 1, "--seed", 1, "--horizon", 40)
two = scene("two", "reference", "--n", 2, "--seed", 1, "--density", 0.3, "--horizon", 40)
none = scene("none", "reference", "--n", 0, "--horizon", 5)
slide = scene("slide", edit=lambda _: """{"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 10},
 "horizon": 6,
 "disks": [
  {"center": [0, 5], "radius": 1, "velocity": [0, 1]},
  {"center": [0, -5], "radius": 2, "velocity": [0, 0]}],
 "maneuvers": [{"t": 4, "disk": 0, "velocity": [1, 0]}]}
""")
all_scenes = {"disks": disks, "swarm": swarm, "grid": grid, "lossy": lossy, "one": one, "two": two,
              "none": none}

# ---- Right histories, and other ways to write them. ----
right = {name: history(path) for name, path in all_scenes.items()}
for name, text in right.items():
    write("certified", name, name, text)
base = lines_of(right["disks"])
head = json.loads(base[0])

write("certified", "disks-without-initial", "disks",
      joined([json.dumps({k: v for k, v in head.items() if k != "initial"})] + base[1:]))
write("certified", "disks-initial-backwards", "disks",
      joined([json.dumps(head | {"initial": [[q[1], q[0], q[3], q[2]] for q in head["initial"]][::-1]})]
             + base[1:]))


def without(key):
    out = []
    for line in base:
        data = json.loads(line)
        if "collide" in data:
            data.pop(key)
        out.append(json.dumps(data, separators=(",", ":")))
    return joined(out)


write("certified", "disks-without-velocities", "disks", without("v"))
write("certified", "disks-without-centres", "disks", without("p"))
write("certified", "disks-keys-reordered", "disks",
      joined([json.dumps(dict(reversed(json.loads(l).items()))) for l in base]))
write("certified", "disks-quadruplets-backwards", "disks",
      joined([with_value(l, "flip", [quad(l)[1], quad(l)[0], quad(l)[3], quad(l)[2]])
              if '"flip"' in l else l for l in base]))
write("certified", "disks-quadruplets-not-oriented", "disks",
      joined([with_value(l, "flip", [quad(l)[0], quad(l)[1], quad(l)[3], quad(l)[2]])
              if '"flip"' in l else l for l in base]))
k = index(base, "flip", 3)
write("certified", "disks-time-within-tolerance", "disks",
      joined(base[:k] + [with_value(base[k], "t", json.loads(base[k])["t"] + 9e-7)] + base[k + 1:]))
sequence = HERE / "scratch.evtsq"
for numbers in ("hexadecimal", "decimal"):
    run("convert", HERE / "certified" / "disks.history.jsonl", "--scene", disks, "-o", sequence,
        "--numbers", numbers)
    write("certified", f"disks-{numbers}", "disks", sequence.read_text(), ending=".evtsq")
events = sequence.read_text()
sequence.unlink()

# ---- One fault each. ----
flip0, hit0 = index(base, "flip", 2), index(base, "collide", 1)


def refuted(name, lines, kind, scene_name="disks", truths=("exact", "recorded"), options=""):
    write("refuted", name, scene_name, joined(lines), truths, kind, options)


def replaced(k, *with_lines, of=base):
    return recounted(of[:k] + list(with_lines) + of[k + 1:])


refuted("dropped-flip", replaced(flip0), "missing event")
refuted("dropped-collision", replaced(hit0), "missing event", truths=("exact",))
refuted("dropped-collision-overlaps", replaced(hit0), "overlap", truths=("recorded",))
refuted("flip-too-late", replaced(flip0, with_value(base[flip0], "t",
                                                    json.loads(base[flip0])["t"] + 1.1e-6)),
        "wrong time")
refuted("flip-too-early", replaced(flip0, with_value(base[flip0], "t",
                                                     json.loads(base[flip0])["t"] - 1.1e-6)),
        "wrong time")
refuted("collision-too-late", replaced(hit0, with_value(base[hit0], "t",
                                                        json.loads(base[hit0])["t"] + 2e-6)),
        "wrong time")
refuted("flip-twice", replaced(flip0, base[flip0], base[flip0]), "edge not present")
q = quad(base[flip0])
refuted("flip-and-back", replaced(flip0, base[flip0],
                                  with_value(base[flip0], "flip",
                                             canonical([q[2], q[3], q[1], q[0]]))),
        "spurious event")
refuted("mirrored-quadruplet", replaced(flip0, with_value(base[flip0], "flip",
                                                          canonical([q[0], q[1], q[3], q[2]]))),
        "wrong quadruple")
refuted("rotated-quadruplet", replaced(flip0, with_value(base[flip0], "flip",
                                                         canonical([q[2], q[3], q[1], q[0]]))),
        "edge not present")
spurious = json.loads(base[0])["initial"][1]
early = json.loads(base[1])["t"] / 2
refuted("inserted-flip", recounted(base[:1] + [json.dumps({"t": early, "flip": spurious})] + base[1:]),
        "spurious event")
hit = json.loads(base[hit0])
off = [[x * (1 + 1e-6) for x in v] if v else None for v in hit["v"]]
refuted("velocity-off-by-a-millionth", replaced(hit0, with_value(base[hit0], "v", off)),
        "wrong response")
refuted("velocity-turned", replaced(hit0, with_value(
    base[hit0], "v", [[-v[1], v[0]] if v else None for v in hit["v"]])), "wrong response")
refuted("centre-off", replaced(hit0, with_value(
    base[hit0], "p", [[p[0] + 1e-3, p[1]] if p else None for p in hit["p"]])), "wrong response")
wrong_pair = [next(g for g in range(hit["collide"][1]) if g not in hit["collide"]),
              hit["collide"][1]]
refuted("wrong-pair", replaced(hit0, with_value(base[hit0], "collide", wrong_pair)), "*")
initial = head["initial"][:-1]
refuted("initial-edge-missing", [json.dumps(head | {"initial": initial})] + base[1:],
        "wrong initial diagram")
refuted("counts-off", base[:-1] + [base[-1].replace('"flips":', '"flips":1')], "bad count")
refuted("dropped-tail", recounted(base[:len(base) // 2] + [base[-1]]), "*")
k = next(k for k in range(1, len(base) - 2)
         if json.loads(base[k + 1])["t"] - json.loads(base[k])["t"] > 1e-3 and '"flip"' in base[k]
         and '"flip"' in base[k + 1])
t0, t1 = json.loads(base[k])["t"], json.loads(base[k + 1])["t"]
refuted("swapped-neighbours", base[:k] + [with_value(base[k + 1], "t", t0),
                                          with_value(base[k], "t", t1)] + base[k + 2:], "*")
moves = lines_of(right["swarm"])
turn = index(moves, "maneuver", 1)
refuted("dropped-maneuver", replaced(turn, of=moves), "missing event", "swarm")
refuted("changed-maneuver", replaced(turn, with_value(moves[turn], "v", [1e-3, 0]), of=moves),
        "wrong response", "swarm")
soft = lines_of(right["lossy"])
wall = next(k for k, l in enumerate(soft) if '"collide":[-1' in l)
v = json.loads(soft[wall])["v"]
refuted("container-law-elastic", replaced(wall, with_value(
    soft[wall], "v", [None, [2 * x for x in v[1]]]), of=soft), "wrong response", "lossy")
shadow = events.splitlines()
e = next(k for k, l in enumerate(shadow) if l.startswith("E"))
write("refuted", "real-flip-as-shadow", "disks",
      joined(shadow[:e] + ["S" + shadow[e][1:]] + shadow[e + 1:]), kind="missing event",
      ending=".evtsq")
write("refuted", "too-many-lines", "disks",
      re.sub(r"(?m)^(\d+)$", lambda m: str(int(m[1]) - 1), events, count=1), kind="bad count",
      ending=".evtsq")

# ---- Not of the format, or of another scene. ----


def invalid(name, text, scene_name="disks", ending=".history.jsonl"):
    write("invalid", name, scene_name, text, ("exact",), ending=ending)


invalid("truncated", joined(base[:-1]))
invalid("cut-in-a-line", joined(base[:-1]) + base[-1][:10])
invalid("other-scene", right["swarm"])
invalid("wrong-hash", right["disks"].replace(head["scene_sha256"], "0" * 64))
invalid("time-decreases", joined(base[:flip0] + [with_value(base[flip0], "t", 0)] + base[flip0 + 1:]))
invalid("id-too-large", joined(replaced(flip0, with_value(base[flip0], "flip", [0, 1, 2, 8]))))
invalid("key-twice", joined(replaced(flip0, base[flip0].replace('{"t":', '{"t":0,"t":'))))
invalid("unknown-key", joined(replaced(flip0, base[flip0].replace('{"t":', '{"T":0,"t":'))))
invalid("not-a-number", joined(replaced(flip0, re.sub(r'"t":[^,]*', '"t":NaN', base[flip0]))))
invalid("after-the-end", right["disks"] + base[1] + "\n")
invalid("empty", "")
invalid("sequence-truncated", joined(shadow[:-1]), ending=".evtsq")
invalid("sequence-with-hops", events.replace("\nE\t", "\nT\t", 1), ending=".evtsq")

# ---- What cannot be decided, and says so. ----
t = (json.loads(base[19])["t"] + json.loads(base[20])["t"]) / 2
stop = json.dumps({"stopped": {"t": t, "reason": "interrupted", "events": []}})
write("undecided", "stopped", "disks", joined(base[:20] + [stop]))
# A maneuver at the wall, along it: the model has no motion for that, and so no truth.
scratch = HERE / "scratch.jsonl"
subprocess.run([str(PROGRAM), "simulate", str(slide), "-o", str(scratch)], capture_output=True)
write("undecided", "slide-along-the-container", "slide",
      joined(lines_of(scratch.read_text())[:1]
             + ['{"t":4,"collide":[-1,0],"v":[null,[0,-1]],"p":[null,[0,9]]}',
                '{"t":4,"maneuver":0,"v":[1,0],"p":[0,9]}',
                '{"end":{"t":6,"flips":0,"collisions":1,"maneuvers":1}}']))
scratch.unlink()

(HERE / "cases.txt").write_text(
    "# What certify must say: file, scene, truth, fault named by the report (* any), options.\n"
    "# Written by make.py, checked by run.sh.\n" + "".join(c + "\n" for c in cases))
print(len(cases), "cases")
