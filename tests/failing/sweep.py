#!/usr/bin/env python3
"""Calls to the system that fail, one in each run, in all verbs.

usage: tests/failing/sweep.py PROGRAM LIBRARY [--times N] [--seed S] [--verb VERB] [--kind KIND]

Each verb first runs undisturbed, under LIBRARY (failing.cpp), which counts its calls. Then single calls
fail: the first ones, the 2nd, 4th, 8th, ..., the last, and some of chance; --times multiplies the number
of the latter. Besides, files may not grow beyond some sizes (RLIMIT_FSIZE). What must hold of every run: it
ends with the exit code of the undisturbed run and its files, or with 2, 3 or 5 and one line on stderr;
`corpus run` may have judged its case otherwise, and says why; a file is whole or what it was before; none is
left for the time being. Exit code 1, with a line for each run that is otherwise.
"""
import argparse
import errno
import json
import os
import random
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OLD = b"what was there before\n"
ERRORS = {"memory": [errno.ENOMEM], "write": [errno.ENOSPC, errno.EIO], "short": [0], "open": [errno.EMFILE, errno.EACCES],
          "read": [errno.EIO], "rename": [errno.EIO, errno.ENOSPC], "fsync": [errno.EIO, errno.ENOSPC],
          "close": [errno.EIO], "thread": [errno.EAGAIN], "fork": [errno.EAGAIN]}
# libcairo 1.16 itself crashes where it gets no memory for a path that it strokes, and leaves a part of a PDF out without
# a word where it gets none for that. docs/trust.md says so.
PICTURES, CAIRO_CRASHES = (".svg", ".png", ".pdf"), (-signal.SIGABRT, -signal.SIGSEGV)
FILE_SIZES = (0, 100, 1000)
PLAN = """{"format": "voroproof-plan", "version": 1, "container": {"center": [0, 0], "radius": 50},
 "arrive": 10, "clearance": 1, "vehicles": [{"id": 0, "radius": 1, "start": [-10, 0], "goal": [10, 0]},
 {"id": 1, "radius": 1, "start": [0, -10], "goal": [0, 10]}]}
"""
DISKS = "x,y,radius\n0,0,1\n4,0,2\n4,0,1\n1,3,0.5\n"
TRACKS = "disk,t,x,y,radius\na,0,0,0,1\na,2,3,4,1\nb,0,9,9,1\nb,2,9,-9,1\n"

# Words of a command; those that begin with "=" are files that it writes.
COMMANDS = [
    "generate reference --n 5 --seed 2 -o =g.scene.json",
    "simulate a.scene.json -o =o.history.jsonl --stats =stats.json --quiet",
    "simulate a.scene.json -o =o.history.jsonl.gz --quiet",
    "simulate a.scene.json -o =o.history.jsonl --threads 2 --quiet",
    "snapshot a.scene.json a.history.jsonl --at 3 -o =o.diagram.json",
    "query nearest a.scene.json a.history.jsonl --at 3 --point 1 2 -o =o.json",
    "query voids-over a.scene.json a.history.jsonl --probe 1 -o =o.json",
    "render a.diagram.json -o =o.svg",
    "render a.diagram.json --size 64 -o =o.png",
    "diagram disks.csv -o =o.geojson",
    "diagram disks.csv --size 64 -o =o.pdf",
    "movie a.scene.json a.history.jsonl -o =o.html",
    "page -o =o.html",
    "validate a.history.jsonl",
    "certify a.scene.json a.history.jsonl --report =o.json --quiet",
    "certify a.scene.json a.history.jsonl --truth recorded --threads 2 --report =o.json",
    "certify a.scene.json wrong.history.jsonl --report =o.json",
    "certify a.scene.json a.history.jsonl --truth recorded --kernel --report =o.json",
    "clearance tracks.csv --required 0 -o =o.json",
    "explain a.report.json -o =o.svg",
    "convert a.history.jsonl --scene a.scene.json -o =o.evtsq",
    "plan plan.json -o =o.scene.json --report =o.json --picture =o.svg --quiet",
    "corpus list",
    "corpus run --case maneuver-to-the-same --json =o.json",
    "corpus run --case maneuver-to-the-same --against 'cp {scene} {history}' --json =o.json",
    "help --json",
]


def timeless(name, content):
    """A file without what the clock says: of statistics the names of the fields, of others no seconds."""
    def dropped(value):
        if isinstance(value, dict):
            return {key: dropped(one) for key, one in value.items() if key != "seconds"}
        return [dropped(one) for one in value] if isinstance(value, list) else value
    if content == OLD or not name.endswith(".json") or b'"seconds"' not in content:
        return content
    document = json.loads(content)
    return json.dumps(sorted(document) if name == "stats.json" else dropped(document)).encode()


class Runs:
    def __init__(self, program, library):
        self.program, self.library = str(Path(program).resolve()), str(Path(library).resolve())
        self.inputs = tempfile.TemporaryDirectory()
        folder = Path(self.inputs.name)
        (folder / "plan.json").write_text(PLAN)
        (folder / "tracks.csv").write_text(TRACKS)
        (folder / "disks.csv").write_text(DISKS)
        for command in ("generate reference --n 5 --density 0.2 --seed 3 --horizon 8 -o a.scene.json",
                        "simulate a.scene.json -o a.history.jsonl --quiet",
                        "snapshot a.scene.json a.history.jsonl --at 2 -o a.diagram.json"):
            subprocess.run([self.program, *command.split()], cwd=folder, check=True, capture_output=True)
        lines = (folder / "a.history.jsonl").read_text().splitlines(keepends=True)
        (folder / "wrong.history.jsonl").write_text("".join(lines[:2] + lines[3:]))
        subprocess.run([self.program, "certify", "a.scene.json", "wrong.history.jsonl", "--report", "a.report.json"],
                       cwd=folder, capture_output=True, check=False)

    def run(self, command, failing="", most_bytes=resource.RLIM_INFINITY):
        """The exit code, stderr, the files that are there afterwards but for the inputs, and the calls."""
        def limited():
            resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(self.inputs.name, folder, dirs_exist_ok=True)
            before = {p.name for p in Path(folder).iterdir()}
            words = [self.program]
            for word in shlex.split(command):
                if word.startswith("="):
                    word = word[1:]
                    (Path(folder) / word).write_bytes(OLD)
                words.append(word)
            counts = Path(folder) / "counts"
            environment = dict(os.environ, LD_PRELOAD=self.library, FAILING=failing, TMPDIR=folder)
            if not failing:
                environment["FAILING_COUNTS"] = str(counts)
            done = subprocess.run(words, cwd=folder, env=environment, capture_output=True, timeout=300, check=False,
                                  preexec_fn=limited)
            calls = {}
            if counts.exists():
                calls = {k: int(n) for k, n in (line.split() for line in counts.read_text().splitlines())}
                counts.unlink()
            files = {p.name: p.read_bytes() if p.is_file() else b"" for p in Path(folder).iterdir() if p.name not in before}
            return done.returncode, done.stderr.decode(errors="replace"), files, done.stdout, calls

    def fault(self, command, kind, undisturbed, outcome):
        """The fault of a run's outcome; empty where there is none."""
        code, err, files, out, _ = outcome
        if kind == "memory" and code in CAIRO_CRASHES and any(p in command for p in PICTURES):
            return ""
        if kind == "memory" and code == 0 and ".pdf" in command and set(files) == set(undisturbed[2]):
            return ""
        good_code, good_err, good_files, good_out, _ = undisturbed
        beyond = {name for name in files if name not in good_files and not name.endswith(".partial")}
        if beyond:
            return f"leaves {', '.join(sorted(beyond))}"
        for found in (files, good_files):
            found.update({name: timeless(name, content) for name, content in found.items()})
        if code == good_code and files == good_files and out == good_out:
            return ""
        judged_otherwise = command.startswith("corpus run") and code == 1 and b"\n0 of 1 case" in out
        if judged_otherwise and all(name in files for name in good_files):
            return ""
        if code not in (2, 3, 5):
            return f"exit code {code}"
        lines = [line for line in err.splitlines() if line not in good_err.splitlines()]
        if not lines or not all(line.startswith("voroproof: ") for line in lines) or len(lines) > 2:
            return f"exit code {code}, and on stderr {err!r}"
        for name, content in good_files.items():
            begun = command.startswith("simulate") and files.get(name, b"")[-200:].find(b'"stopped"') >= 0
            undecided = code == 3 and name.endswith(".json")
            if files.get(name) not in (OLD, content) and not begun and not undecided:
                return f"exit code {code}, and {name} is neither what it was nor whole"
        return ""


def numbers(count, kind, chance, times):
    """Which calls fail, of so many."""
    found = {1, 2, 3, count, count - 1} if kind != "memory" else {1, count}
    power = 1
    while power < count:
        found.add(power)
        power *= 2
    if kind == "short":
        found = {1, count}
    found |= {chance.randint(1, count) for _ in range(int((6 if kind == "memory" else 2) * times))}
    return sorted(k for k in found if 1 <= k <= count)


def disturbances(calls, chance, times):
    """Kind, name and arguments of run() of each, for a command that makes so many calls."""
    for kind, count in calls.items():
        if count == 0:
            continue
        for place, k in enumerate(numbers(count, kind, chance, times)):
            error = ERRORS[kind][place % len(ERRORS[kind])]
            on = ":on" if kind == "memory" and place % 2 == 1 else ""
            failing = f"{kind}:{k}:{error}{on}"
            yield kind, failing, {"failing": failing}
    if calls.get("write", 0) > 0:
        for most in FILE_SIZES:
            yield "size", f"size:{most}", {"most_bytes": most}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("library")
    parser.add_argument("--times", type=float, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--verb", default="")
    parser.add_argument("--kind", default="")
    a = parser.parse_args()
    runs, chance = Runs(a.program, a.library), random.Random(a.seed)
    tried, codes, faults = Counter(), Counter(), 0
    for command in COMMANDS:
        if a.verb not in ("", command.split()[0]):
            continue
        undisturbed = runs.run(command)
        for kind, disturbance, given in disturbances(undisturbed[4], chance, a.times):
            if a.kind not in ("", kind):
                continue
            outcome = runs.run(command, **given)
            tried[kind] += 1
            codes[outcome[0]] += 1
            fault = runs.fault(command, kind, undisturbed, outcome)
            if fault:
                faults += 1
                print(f"{disturbance}: {command}: {fault}", flush=True)
    print("tried:", ", ".join(f"{kind} {n}" for kind, n in sorted(tried.items())), "in all", sum(tried.values()))
    print("exit codes:", ", ".join(f"{code}: {n}" for code, n in sorted(codes.items())))
    return faults > 0 or not tried


if __name__ == "__main__":
    sys.exit(main())
