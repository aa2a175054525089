"""`clearance` and a judge by brute force, on histories of billiards.

    clearance.py PROGRAM [FIRST_SEED] [SCENES]

For each seed: a scene and its history by an engine in doubles, one mutant of each of some kinds, and a scene of small
fractions without events, in which gaps may be exactly 0. The least gap, where and when it is, all spells below some
distance, and the verdicts on distances near the least gap must be those of the judge. Counts by kind on standard
output; exit code 1 after a disagreement.
"""

import collections
import json
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction

from billiard import History, Malformed, Scene
from clearance_judge import ClearanceJudge
from engine import history_bytes, history_rows, make
from mutants import KINDS, mutate


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


def pair(x):
    return [Fraction(y) for y in x] if isinstance(x, list) else [Fraction(x)] * 2


class Told:
    """The answer of the program."""

    def __init__(self, program, paths, *options):
        answer = os.path.join(os.path.dirname(paths[0]), "answer.json")
        run = subprocess.run([program, "clearance", *paths, "-o", answer, *options], capture_output=True, text=True,
                             timeout=300, check=False)
        self.code, self.words = run.returncode, run.stdout + run.stderr
        self.verdict = run.stdout.rstrip().rsplit("\n", 1)[-1]
        self.data = {}
        if run.returncode in (0, 1, 3):
            with open(answer, encoding="utf-8") as file:
                self.data = json.load(file)
        elif run.returncode != 2:
            raise ValueError(f"exit {run.returncode}: {self.words}")


def key_of(approach):
    """The pair, the wall being the first, and the image."""
    ids = [int(d["disk"]) for d in approach["disks"]]
    if len(ids) == 1:
        return approach.get("wall", -1), ids[0], None
    return ids[0], ids[1], tuple(approach["image"]) if "image" in approach else None


def least_faults(judge, told, field, kind):
    """The faults of a least gap that is told."""
    least = told.data.get(field)
    if least is None:
        if judge.walls if field == "least_to_container" else judge.scene.periodic or len(judge.scene.disks) > 1:
            yield f"{field}: none"
        return
    low, high = pair(least["gap"])
    tiny = Fraction(1, 2 ** 40)
    if high - low > abs(low) / 2 ** 40 + judge.scene.extent / 2 ** 60:
        yield f"{field}: wide"
    for piece in filter(kind, judge.pieces(low)):
        if piece.is_below(min(low, low - judge.rounding) if piece.is_contact else low, True):
            yield f"{field}: {piece.i} {piece.j} {piece.image} from {float(piece.u)} come nearer than {float(low)}"
            break
    if not judge.verdicts(high + tiny, True, kind)[1]:
        yield f"{field}: no gap is as small as {float(high)}"
    i, j, image = key_of(least)
    t = pair(least["t"])[0]
    mine = [p for p in judge.pieces(high + 1) if (p.i, p.j) == (i, j) and p.u <= t <= p.v
            and (image is None or p.image is None or tuple(p.image) == image)]
    gaps = [p.gap_at((t - p.u) / (p.v - p.u) if p.v > p.u else Fraction(0)) for p in mine]
    if not any(abs(g - float(low)) <= 1e-9 * float(1 + judge.scene.extent) for g in gaps):
        yield f"{field}: another gap at that time: {gaps}, not {float(low)}"


def end_is_in(end, is_first, bounds):
    piece, root = end
    if root is None or piece.u == piece.v:
        t = piece.u if is_first else piece.v
        return bounds[0] <= t <= bounds[1]
    length = piece.v - piece.u
    return root.against((bounds[0] - piece.u) / length) >= 0 >= root.against((bounds[1] - piece.u) / length)


def spell_faults(judge, told, below):
    lists = {}
    for field in ("approaches", "approaches_to_container"):
        for spell in told.data.get(field, []):
            i, j, image = key_of(spell["least"])
            lists.setdefault((i, j, image), []).append((pair(spell["from"]), pair(spell["to"]), spell["least"]))
    true = {}
    for (i, j, image), spells in judge.spells(below).items():
        true[(i, j, image if judge.scene.periodic and i >= 0 else None)] = spells
    for key in true.keys() | lists.keys():
        own, others = true.get(key, []), sorted(lists.get(key, []), key=lambda s: s[0])
        if len(own) != len(others):
            yield f"below {below}: {len(others)} spells, not {len(own)}: {key}"
            continue
        for (first, last), (begin, end, least) in zip(own, others):
            if not end_is_in(first, True, begin) or not end_is_in(last, False, end):
                yield f"below {below}: other ends: {key}"
            if pair(least["gap"])[0] >= below or pair(least["t"])[1] < begin[0] or pair(least["t"])[0] > end[1]:
                yield f"below {below}: the least gap of a spell: {key}"


def verdict_faults(judge, told, required, may_touch):
    must, may = judge.verdicts(required, may_touch)
    missing = judge.is_missing()
    what = f"required {float(required)}{' may touch' if may_touch else ''}: {told.verdict}"
    if told.verdict == "s FREE" and (must or missing):
        yield f"{what}, and it {'must be refuted' if must else 'lacks something'}"
    elif told.verdict == "s REFUTED" and not may:
        yield f"{what}, and nothing is too near"
    elif told.verdict == "s UNDECIDED" and not (missing and told.data["missing"]) and "least" in told.data:
        near = judge.scene.extent / 2 ** 50
        if must and judge.verdicts(required - near, True)[0] or not judge.verdicts(required + near, False)[1]:
            yield f"{what}, and nothing is missing"
    elif told.verdict not in ("s FREE", "s REFUTED", "s UNDECIDED"):
        yield f"{what}: {told.words}"


def faults(program, folder, raw, rows, rng, counts):
    paths = [os.path.join(folder, name) for name in ("a.scene.json", "a.history.jsonl")]
    scene, text = Scene(raw), history_bytes(rows)
    write(paths[0], raw)
    write(paths[1], text)
    if scene.shear:
        told = Told(program, paths, "--required", "0")
        counts["shear"] += 1
        if told.code != 2 or "frame.shear" not in told.words or "s INVALID" not in told.words:
            yield f"shear: {told.words}"
        return
    judge = ClearanceJudge(scene, History(text, scene), scene.horizon)
    below = Fraction(rng.choice((1, 2, 5)), rng.choice((10, 4)))
    told = Told(program, paths, "--below", str(below), "--required", "0")
    if told.code == 2:
        yield f"refused: {told.words}"
        return
    yield from least_faults(judge, told, "least", lambda piece: piece.i >= 0)
    yield from least_faults(judge, told, "least_to_container", lambda piece: piece.i < 0)
    yield from spell_faults(judge, told, below)
    yield from verdict_faults(judge, told, Fraction(0), False)
    counts["spells"] += len(told.data["approaches"]) + len(told.data.get("approaches_to_container", []))
    gaps = [pair(told.data[field]["gap"]) for field in ("least", "least_to_container") if field in told.data]
    asked = [(Fraction(0), True), (Fraction(-1, 10 ** 9), False)]
    asked += [(g + by, rng.random() < 0.5) for low, high in gaps
              for g, by in ((low, 0), (high, Fraction(1, 10 ** 12)), (low, -Fraction(1, 10 ** 12)))]
    for required, may_touch in rng.sample(asked, min(4, len(asked))):
        said = Told(program, paths, f"--required={required}", *["--may-touch"] * may_touch)
        counts[said.verdict] += 1
        yield from verdict_faults(judge, said, required, may_touch)


def bare(seed):
    """A scene of small fractions and its history without events."""
    rng = random.Random(f"bare {seed}")
    while True:
        dimension = rng.choice((2, 2, 3))

        def few(*values):
            return rng.choice(values)
        disks = []
        for _ in range(rng.randint(1, 3)):
            disk = {"center": [few(*range(-3, 4)) for _ in range(dimension)], "radius": few("1/2", 1, "1/3")}
            if rng.random() < 0.2:
                disk["fixed"] = True
            else:
                disk["velocity"] = [few(0, 0, 1, -1, "1/2") for _ in range(dimension)]
            if rng.random() < 0.6:
                disk["growth"] = few("1/4", "1/2", "-1/8", 1, "1/10")
            disks.append(disk)
        frame = few("none", {"center": [0] * dimension, "radius": few(5, 6, 8)},
                    {"walls": [{"normal": [1] + [0] * (dimension - 1), "offset": few(-4, -5), "speed": few(0, "1/4")},
                               {"normal": ["-3/5", "4/5"] + [0] * (dimension - 2), "offset": -6}]},
                    {"periodic": [few(7, 8)] + [few(None, 8) for _ in range(dimension - 1)]})
        data = {"format": "voroproof-scene", "version": 2, "contacts": "bounce", "dimension": dimension,
                "horizon": few(1, 2, "3/2"), "frame": frame, "disks": disks}
        if rng.random() < (0.8 if "walls" in frame else 0.4):
            data["gravity"] = [few(1, 1, 2, "1/2"), *(few(0, 1, -1, "1/2") for _ in range(dimension - 1))]
        raw = json.dumps(data).encode()
        try:
            return raw, history_rows(Scene(raw), [])
        except Malformed:
            continue


def cases(seed):
    """(kind, scene, rows) of a seed."""
    raw, rows = make(seed)
    yield "engine", raw, rows
    rng = random.Random(f"kinds {seed}")
    for kind in rng.sample(sorted(KINDS), 3):
        other = mutate(Scene(raw), rows, seed, kind)
        if other is not None:
            yield kind, raw, other
    for part in range(3):
        yield "bare", *bare(f"{seed} {part}")


def main():
    program = sys.argv[1]
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    scenes = int(sys.argv[3]) if len(sys.argv) > 3 else 24
    counts, disagreements = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + scenes):
            for kind, raw, rows in cases(seed):
                counts[kind] += 1
                try:
                    History(history_bytes(rows), Scene(raw))
                except Malformed:
                    counts["not read"] += 1
                    continue
                for fault in faults(program, folder, raw, rows, random.Random(f"{seed} {kind}"), counts):
                    print(f"seed {seed}, {kind}: {fault}", flush=True)
                    disagreements += 1
    for name, count in sorted(counts.items()):
        print(f"{name:20} {count}")
    if disagreements or not all(counts[x] for x in ("shear", "s FREE", "s REFUTED", "s UNDECIDED")):
        sys.exit(1)


if __name__ == "__main__":
    main()
