#!/usr/bin/env python3
"""Makes the seeds of all targets: small files of every format, of the corpus and by the program.

usage: tests/fuzz/seeds.py PROGRAM FOLDER

FOLDER/TARGET gets the files of one target, numbered; what was there before goes. The same each time,
but for what PROGRAM writes differently.
"""
import gzip
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CORPUS = ROOT / "corpus"
MOST_BYTES = 6000
MOST_FILES = 60
SHARDS = ROOT / "tests" / "fuzz" / "shards.scene.json"
SEPARATOR = b"\n====\n"
SEVERAL = ("certify", "merge", "begun-history")  # targets that take several files in one text

PLAN = b"""{"format": "voroproof-plan", "version": 1, "name": "two vehicles",
 "container": {"center": [0, 0], "radius": 50}, "arrive": 10, "clearance": "1/3",
 "vehicles": [{"id": 0, "radius": 1, "start": [-10, 0], "goal": [10, 0]},
              {"id": 1, "radius": 1, "start": [0, -10], "goal": ["1/3", 10]}]}
"""
SCENE = b"""{"format": "voroproof-scene", "version": 1, "name": "all fields", "comment": "\\u00e9", "seed": 12,
 "x-own": {"a": [1, "b", null, true]}, "horizon": "7/3", "restitution": 0.5, "container_restitution": 0.75,
 "container_law": "whole", "container": {"center": [0, "1/3"], "radius": 1e2},
 "disks": [{"center": [-5, 0], "radius": 1, "velocity": [1, 0], "mass": "3/2"},
           {"center": [5, 0], "radius": 0, "velocity": ["-0x1p-1", 0], "mass": 1, "x-b": 2}],
 "maneuvers": [{"t": 1, "disk": 0, "velocity": [0, 1]}, {"t": "4/3", "disk": 1, "velocity": [0, 0]}]}
"""
WAYPOINTS = [b"t,disk,x,y,radius\n0,a,0,0,1\n1.5,a,3,4,1\n0,b,9,9,0.5\n1.5,b,9,-9,0.5\n",
             b"# a comment\ndisk,t,x,y\n7,0,0,0\n7,1,1e1,-2.5\n\n8,0,5,5\n8,1,5,5\n"]
CCBS = b"""<?xml version="1.0" ?>
<root><log>
 <agent number="0"><path duration="2.8">
  <section number="0" start_i="0" start_j="0" goal_i="1" goal_j="1" duration="1.4"/>
  <section number="1" start_i="1" start_j="1" goal_i="2" goal_j="2" duration="1.4"/></path></agent>
 <agent number="1"><path duration="2"><section number="0" start_i="4" start_j="2" goal_i="4" goal_j="0" duration="2"/>
 </path></agent>
</log></root>
"""


def small(*patterns, folder=CORPUS, most=MOST_BYTES):
    """The contents of the files that match, evenly chosen where they are too many."""
    found = [path for pattern in patterns for path in sorted(folder.glob(pattern))
             if path.stat().st_size <= most]
    step = max(1, -(-len(found) // MOST_FILES))
    return [path.read_bytes() for path in found[::step]]


def in_folder(case):
    """The case as one of the folder that the target takes it for."""
    fields = json.loads(case) | {"family": "family", "name": "case"}
    return json.dumps(fields, indent=1).encode()


def wrong_and_right():
    """Scenes, and histories of all verdicts."""
    cases = ROOT / "tests" / "adversary" / "cases"
    found = [(s, s.with_name(s.name.replace(".scene.json", ".history.jsonl")))
             for s in sorted(cases.glob("*.scene.json"))]
    found.append((CORPUS / "scenes" / "slide.scene.json",
                  CORPUS / "undecided" / "slide-along-the-container.history.jsonl"))
    return found


def pairs():
    """The pairs that certify takes, in one text each."""
    found = wrong_and_right()
    for history in sorted((CORPUS / "cases").glob("*/*/exact.history.jsonl")):
        found.append((history.with_name("scene.scene.json"), history))
        found += [(history.with_name("scene.scene.json"), wrong)
                  for wrong in sorted(history.parent.glob("wrong/*"))[:1]]
    for name in ("none", "one", "two", "swarm", "grid", "lossy"):
        found.append((CORPUS / "scenes" / f"{name}.scene.json", CORPUS / "certified" / f"{name}.history.jsonl"))
    texts = [scene.read_bytes() + SEPARATOR + history.read_bytes()
             for scene, history in found if scene.stat().st_size + history.stat().st_size < 4000]
    return texts[::max(1, len(texts) // 100)]


class Made:
    """The program's output, in a folder of its own: no file names another's place."""

    def __init__(self, program, folder):
        self.program, self.folder = Path(program).resolve(), Path(folder)
        self.run("generate", "reference", "--n", "6", "--horizon", "12", "--seed", "5", "-o", "a.scene.json")
        self.run("simulate", "a.scene.json", "-o", "a.history.jsonl", "--quiet")

    def run(self, *words, allowed=(0,)):
        done = subprocess.run([self.program, *words], capture_output=True, text=True, check=False, cwd=self.folder)
        if done.returncode not in allowed:
            raise RuntimeError(f"{' '.join(map(str, words))}: {done.returncode}: {done.stderr}")

    def file(self, name, *words, allowed=(0,)):
        """The bytes that a verb writes to a file of that name."""
        self.run(*words, name, allowed=allowed)
        return (self.folder / name).read_bytes()

    def given(self, name, text):
        (self.folder / name).write_bytes(text)
        return name

    def sequences(self):
        for name, options in (("a", []), ("b", ["--numbers", "decimal"]), ("c", ["--evtsq-version", "1.0"])):
            yield self.file(f"{name}.evtsq", "convert", "a.history.jsonl", "--scene", "a.scene.json", *options, "-o")

    def reports(self):
        for k, (scene, history) in enumerate(wrong_and_right()):
            self.given("r.scene.json", scene.read_bytes())
            self.given("r.history.jsonl", history.read_bytes())
            # A case that takes many bits takes minutes, for a report that is not worth more.
            yield self.file(f"{k}.json", "certify", "r.scene.json", "r.history.jsonl", "--max-bits", "2048", "--quiet",
                            "--report", allowed=(0, 1, 3))

    def compressed(self):
        scene = self.given("one.scene.json", (CORPUS / "scenes" / "one.scene.json").read_bytes())
        for ending in ("gz", "zst"):
            yield self.file(f"b.jsonl.{ending}", "simulate", scene, "--quiet", "-o")
        yield gzip.compress(b"0" * 4000, mtime=0)
        yield gzip.compress(b"one", mtime=0) + gzip.compress(b"two", mtime=0)

    def shards(self):
        """The certificates of the shards of a history that is right, and of a wrong one."""
        self.run("simulate", SHARDS, "-o", "s.history.jsonl", "--quiet")
        lines = (self.folder / "s.history.jsonl").read_bytes().splitlines(keepends=True)
        self.given("wrong.history.jsonl", b"".join(lines[:-3] + lines[-2:]))
        for history, allowed in (("s.history.jsonl", (0,)), ("wrong.history.jsonl", (0, 1))):
            yield [self.file("shard.json", "certify", SHARDS, history, "--truth", "recorded", "--quiet", "--part", f"{k}/3",
                             "--report", allowed=allowed) for k in (1, 2, 3)]

    def indexes(self):
        """An index of the history of shards(), and one without an entry."""
        yield self.file("s.index", "index", SHARDS, "s.history.jsonl", "--quiet", "-o")
        yield self.file("a.index", "index", "a.scene.json", "a.history.jsonl", "--quiet", "-o")

    def begun_reports(self):
        """The report so far that a run leaves when a limit ends it."""
        self.run("certify", SHARDS, "s.history.jsonl", "--truth", "recorded", "--checkpoint", "0", "--quiet", "--max-events",
                 "550", "--report", "b.json", allowed=(3,))
        yield (self.folder / "b.json.partial").read_bytes()

    def begun_histories(self):
        """Histories that stopped, and one that was cut off within a line."""
        text = SHARDS.read_bytes() + SEPARATOR
        for most in (5, 30):
            whole = self.file("b.history.jsonl", "simulate", SHARDS, "--quiet", "--replace", "--max-events", str(most), "-o",
                              allowed=(3,))
            yield text + whole
            yield text + whole[:-len(whole.splitlines()[-1]) - 20]

    def plan_reports(self):
        plan = self.given("plan.json", PLAN)
        yield self.file("plan-report.json", "plan", plan, "--quiet", "-o", "p.scene.json", "--report")


def seeds(made):
    """The texts of each target."""
    found = {
        "scene": small("scenes/*", "cases/*/*/scene.scene.json", most=2500) + [SCENE],
        "disks": [made.file("a.disks.txt", "convert", "a.scene.json", "-o")],
        "history": small("certified/*.jsonl", "invalid/*.jsonl", "cases/*/*/exact.history.jsonl", most=3000)
        + [(made.folder / "a.history.jsonl").read_bytes()],
        "sequence": small("*/*.evtsq") + list(made.sequences()),
        "diagram": small("cases/*/*/*.diagram.json", most=3000),
        "plan": [PLAN],
        "plan-report": list(made.plan_reports()),
        "waypoints": WAYPOINTS,
        "ccbs": [CCBS],
        "case": [in_folder(text) for text in small("cases/*/*/case.json", most=3000)],
        "report": list(made.reports()),
        "compressed": list(made.compressed()),
        "certify": pairs(),
    }
    shards = list(made.shards())
    found["shard"] = [shard for of_one in shards for shard in of_one]
    found["merge"] = [SEPARATOR.join(of_one) for of_one in shards]
    found["index"] = list(made.indexes())
    found["begun-report"], found["begun-history"] = list(made.begun_reports()), list(made.begun_histories())
    found["picture"] = found["diagram"]
    found["kernel-scene"], found["kernel-history"] = found["scene"], found["history"]
    found["any"] = [text for name in sorted(found) if name not in SEVERAL for text in found[name][:6]]
    return found


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, out = sys.argv[1], Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for target, texts in seeds(Made(program, folder)).items():
            shutil.rmtree(out / target, ignore_errors=True)
            (out / target).mkdir(parents=True)
            for k, text in enumerate(texts):
                (out / target / f"{k:03}").write_bytes(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
