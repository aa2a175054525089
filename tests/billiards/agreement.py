"""The certifier of billiards, the kernel (recorded truth) and the brute-force judge, on the histories of an engine in doubles and on wrong ones.

    agreement.py PROGRAM [FIRST_SEED] [SCENES] [recorded|exact]

For each seed: a scene and its history, and one mutant of each kind. Where the judge of that truth refutes, so must the
program; where it certifies, so must the program. Under the recorded truth both must certify the history; under the
exact one its roundings may have grown too large. The history that the program simulates must be certified by both, and
begin as that of the engine in doubles. The verdict and its line are the same without filters, and after exact
transformations. Counts by kind on standard output; exit code 1 after a disagreement.
"""

import collections
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

from billiard import History, Malformed, Scene
from engine import history_bytes, make
from judge import judge
from mutants import KINDS, mutate
from transforms import TRANSFORMS
from truth import Tie, TrueJudge, TrueMotion

WORDS = {0: "CERTIFIED", 1: "REFUTED", 2: "INVALID", 3: "UNDECIDED"}


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


def told(program, truth, scene, history, tolerance="1e-6", filters="on"):
    """The program's word, and the line that it names."""
    kernel = ["--kernel"] if truth == "recorded" else []  # undecided where the kernel does not decide
    run = subprocess.run([program, "certify", scene, history, "--truth", truth, "--quiet",
                          "--tolerance", tolerance, *kernel], env=dict(os.environ, VOROPROOF_FILTERS=filters),
                         capture_output=True, text=True, timeout=300, check=False)
    words = run.stderr.split("line ", 1)
    line = int(words[1].split(":", 1)[0]) if len(words) > 1 and words[1][:1].isdigit() else None
    return WORDS.get(run.returncode, f"exit {run.returncode}"), line, run.stderr.strip()


def recorded_judge(scene):
    return lambda history: judge(scene, history)


def exact_judge(scene):
    return TrueJudge(scene, TrueMotion(scene)).verdict


JUDGES = {"recorded": recorded_judge, "exact": exact_judge}


def judged(verdict, scene, rows):
    try:
        return verdict(History(history_bytes(rows), scene))
    except Malformed as fault:
        return fault.line, fault.reason


def stays(program, truth, folder, scene, rows, said):
    """The first transformation after which something else is said; None where nothing changes."""
    for name, transform in TRANSFORMS.items():
        data, other, time = transform(scene, rows)
        raw = json.dumps(data).encode()
        paths = [os.path.join(folder, file) for file in ("other.scene.json", "other.history.jsonl")]
        other[0] = dict(other[0], scene_sha256=hashlib.sha256(raw).hexdigest())
        write(paths[0], raw)
        write(paths[1], history_bytes(other))
        tolerance = Fraction(1, 10 ** 6) * time
        if told(program, truth, *paths, f"{tolerance.numerator}/{tolerance.denominator}")[:2] != said[:2]:
            return name
    return None


def compare(program, truth, verdict, folder, scene, scene_path, name, rows, counts):
    """Whether the two agree; a disagreement is told."""
    history_path = os.path.join(folder, "history.jsonl")
    write(history_path, history_bytes(rows))
    said = word, line, words = told(program, truth, scene_path, history_path)
    if told(program, truth, scene_path, history_path, filters="off")[:2] != said[:2]:
        print(f"{name}: without filters another verdict than {said}")
        return False
    with open(scene_path, encoding="utf-8") as file:
        changed = stays(program, truth, folder, json.load(file), rows, said)
    if changed:
        print(f"{name}: {changed}, another verdict than {said}")
        return False
    fault = judged(verdict, scene, rows)
    counts[name, word] += 1
    if word == "REFUTED" and fault and line != fault[0]:
        counts[name, "at another line"] += 1
    if word == ("REFUTED" if fault else "CERTIFIED"):
        return True
    print(f"{name}: the program says {word} ({words}), the judge {fault or 'CERTIFIED'}")
    return False


def simulated(program, folder, scene_path):
    """The rows of the program's own history; None where it says that it does not simulate such a scene."""
    path = os.path.join(folder, "simulated.jsonl")
    run = subprocess.run([program, "simulate", scene_path, "-o", path, "--quiet", "--replace"],
                         capture_output=True, text=True, timeout=300, check=False)
    if run.returncode == 3 and "is not simulated" in run.stderr:
        return None
    if run.returncode != 0:
        raise SystemExit(f"simulate: {run.returncode}: {run.stderr}")
    with open(path, encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def begin_alike(own, rows):
    """Whether two histories tell the same, until the roundings of doubles have grown."""
    for a, b in zip(own[1:-1], rows[1:-1]):
        if abs(a["t"] - b["t"]) > 1e-9:
            return True
        if any(a.get(field) != b.get(field) for field in ("collide", "image", "maneuver")):
            return False
    return True


def main():
    program = sys.argv[1]
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    scenes = int(sys.argv[3]) if len(sys.argv) > 3 else 100
    truth = sys.argv[4] if len(sys.argv) > 4 else "recorded"
    counts, disagreements = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        scene_path = os.path.join(folder, "scene.json")
        for seed in range(first, first + scenes):
            raw, rows = make(seed)
            write(scene_path, raw)
            scene = Scene(raw)
            try:
                verdict = JUDGES[truth](scene)
            except Tie:
                counts["all", "not told"] += 1
                continue
            own = simulated(program, folder, scene_path)
            if own and not begin_alike(own, rows):
                print(f"simulate tells otherwise than the engine in doubles\n  seed {seed}")
                disagreements += 1
            histories = [("right", rows), ("simulated", own)]
            histories += [(kind, mutate(scene, rows, seed, kind)) for kind in KINDS]
            for name, altered in histories:
                if altered and not compare(program, truth, verdict, folder, scene, scene_path, name, altered, counts):
                    print(f"  seed {seed}")
                    disagreements += 1
    for (name, word), count in sorted(counts.items()):
        print(f"{name:20} {word:16} {count}")
    if counts["right", "CERTIFIED"] == 0 or counts["simulated", "CERTIFIED"] == 0 or disagreements:
        sys.exit(1)


if __name__ == "__main__":
    main()
