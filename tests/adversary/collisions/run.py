#!/usr/bin/env python3
"""Wrong worlds against `certify --events collisions`.

usage: tests/adversary/collisions/run.py PROGRAM [--count N] [--seed S] [--family NAME] [--fault NAME]
       [--tolerance T] [--jobs J] [--out FOLDER]

Worlds of few disks err once and go on consistently (worlds.py, families.py). The program and two judges by
brute force (judge_exact.py, judge_recorded.py), which share no code with it, judge each history under both
truths. A find is a history that the program certifies and the judge refutes, or the other way round, or one that
the program cannot read: the exit code is 1, and --out keeps its files. The seeds decide everything.
"""
import argparse
import collections
import hashlib
import json
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import judge_exact
import judge_recorded
from families import FAMILIES, FAULTS, a_fault, rewrite
from worlds import Scene, World

LAW = Fraction(1, 10**9)
JUDGES = {"exact": judge_exact.judge, "recorded": judge_recorded.judge}
FINDS = {("CERTIFIED", "wrong"), ("REFUTED", "right")}
BATCH = 200  # histories that the program is given at once


@dataclass
class Case:
    """A history to be judged: the claims of a world of the scene, up to the horizon that they tell."""
    seed: int
    family: str
    kind: str
    scene: Scene
    claims: list
    horizon: float

    @property
    def name(self):
        return f"{self.seed}-{self.family}-{self.kind}".replace(" ", "-")

    def judged_scene(self):
        return replace(self.scene, horizon=self.horizon)

    def history(self, scene_text):
        rng = random.Random(self.seed)
        lines = [{"format": "voroproof-history", "version": 1, "scene_sha256": hashlib.sha256(scene_text).hexdigest(),
                  "horizon": self.horizon, "producer": "a world"}]
        flips = 0
        for c in self.claims:
            line = c.text()
            if len(self.scene.disks) > 2 and rng.random() < 0.1:  # for flips, which the verdict passes over
                lines.append({"t": line["t"], "flip": [-1, 0, 1, 2]})
                flips += 1
            lines.append(line)
        turns = sum(c.i == c.j for c in self.claims)
        lines.append({"end": {"t": self.horizon, "flips": flips, "collisions": len(self.claims) - turns, "maneuvers": turns}})
        return "".join(json.dumps(line) + "\n" for line in lines).encode()

    def write(self, path):
        scene = json.dumps(self.scene.text()).encode()
        Path(f"{path}.scene.json").write_bytes(scene)
        Path(f"{path}.history.jsonl").write_bytes(self.history(scene))


def make(seed, family, kind, tau):
    """A case, or None where its fault found no place."""
    rng = random.Random(f"{seed} {family} {kind}")
    scene = FAMILIES[family](rng)
    fault = a_fault(rng, kind, float(tau))
    if not scene.disks:
        return None
    given = scene.horizon
    world = World(scene, fault, rng, most_events=rng.choice([6, 12, 25])).run()
    claims = [c for c in world.claims if c.t <= scene.horizon]
    told = rewrite(rng, fault, scene, claims)
    if told is None or (not world.erred and told == claims and kind not in ("none", "other horizon")):
        return None
    horizon = scene.horizon
    if kind == "other horizon":
        horizon = max([given] + [float(c.t) for c in told])
        scene.horizon = 2 * max(scene.horizon, given)
    return Case(seed, family, kind, scene, told, horizon) if horizon >= tau else None


def verdicts(args, folder, count, truth):
    """The program's verdicts and reasons."""
    def verdict(k):
        done = subprocess.run([args.program, "certify", f"{folder / str(k)}.scene.json", f"{folder / str(k)}.history.jsonl",
                               "--truth", truth, "--events", "collisions", "--tolerance", str(float(args.tolerance)), "--quiet"],
                              capture_output=True, text=True, check=False)
        return done.stdout.split("\n")[-2].removeprefix("s "), done.stderr.strip()
    with ThreadPoolExecutor(args.jobs) as jobs:
        return list(jobs.map(verdict, range(count)))


class Campaign:
    """Makes worlds, has them judged, and counts. `finds`: those on which program and judge contradict each other."""

    def __init__(self, args):
        self.args = args
        self.cases = 0
        self.verdicts = {truth: collections.Counter() for truth in JUDGES}
        self.finds = 0

    def run(self):
        args = self.args
        families = [args.family] if args.family else list(FAMILIES)
        kinds = [args.fault] if args.fault else FAULTS
        batch, end = [], args.seed + args.count
        with tempfile.TemporaryDirectory() as folder:
            for seed in range(args.seed, end):
                family, kind = families[seed % len(families)], kinds[seed // len(families) % len(kinds)]
                case = make(seed, family, kind, args.tolerance)
                if case is not None:
                    batch.append(case)
                if len(batch) == BATCH or seed == end - 1:
                    self.judge(Path(folder), batch)
                    batch = []
        return self.report()

    def judge(self, folder, batch):
        self.cases += len(batch)
        for k, case in enumerate(batch):
            case.write(folder / str(k))
        for truth, judge in JUDGES.items():
            for k, (case, (said, why)) in enumerate(zip(batch, verdicts(self.args, folder, len(batch), truth), strict=True)):
                judged, because = judge(case.judged_scene(), case.claims, self.args.tolerance, LAW)
                self.verdicts[truth][said, judged] += 1
                if (said, judged) in FINDS or said not in ("CERTIFIED", "REFUTED", "UNDECIDED"):
                    self.finds += 1
                    print(f"find: {truth}, {case.name}: {said}, {judged} ({why}; {because})", flush=True)
                    if self.args.out:
                        self.args.out.mkdir(parents=True, exist_ok=True)
                        case.write(self.args.out / f"{truth}-{case.name}")

    def report(self):
        print(f"{self.cases} histories; finds {self.finds}")
        for truth, table in self.verdicts.items():
            print(truth + ":", ", ".join(f"{said}/{judged} {count}" for (said, judged), count in sorted(table.items())))
        return 1 if self.finds else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--family", choices=FAMILIES)
    parser.add_argument("--fault", choices=FAULTS)
    parser.add_argument("--tolerance", type=Fraction, default=Fraction(1, 10**6))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", type=Path)
    return Campaign(parser.parse_args()).run()


if __name__ == "__main__":
    sys.exit(main())
