#!/usr/bin/env python3
"""Holds what a program computes against what was recorded: the bytes of histories and, of their
certificates under both truths, the verdict, the leniency and the statistics of lives.

usage: tests/kept/run.py PROGRAM [--record] [--only NAME]

Sixty scenes of all families are made by PROGRAM. kept.json beside this file has a hash for each. A
change that alters one on purpose records anew (--record) and says in the commit which, and why.
"""
import argparse
import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path

KEPT = Path(__file__).with_name("kept.json")
# The certificate's fields in a report, without names of files and of the program.
FIELDS = ["verdict", "truth", "disks", "horizon", "certified_prefix", "proved", "swaps", "leniency",
          "resolved_quadruplets", "remarks"]


def scenes():
    """Names, and the options of `generate` that make them."""
    def add(family, *options):
        words = [family, *map(str, options)]
        return " ".join(words), words

    for radii in ("uniform", "log", "equal"):
        for restitution in (1, 0.8):
            for density in (0.05, 0.3):
                for n, horizon in ((2, 40), (12, 30), (40, 20)):
                    yield add("reference", "--n", n, "--radii", radii, "--restitution", restitution,
                              "--density", density, "--horizon", horizon, "--seed", n + 1)
    for motion in ("rest", "common", "random", "shear"):
        for n in (1, 4, 9, 20):
            yield add("grid", "--n", n, "--motion", motion, "--horizon", 10, "--seed", 2)
    for n in (2, 7, 19, 24):
        yield add("swarm", "--n", n, "--horizon", 20, "--seed", 3)
    for preset in ("figure24", "h-to-y"):
        yield add("formation", "--preset", preset)
    yield add("reference", "--n", 200, "--horizon", 30, "--seed", 9)
    yield add("reference", "--n", 60, "--density", 0.45, "--horizon", 10, "--seed", 10)


def result(program, options, folder):
    """The hash of what the program makes of a scene; or what went wrong."""
    scene, history, report = (str(folder / name) for name in ("scene.json", "history.jsonl", "report.json"))

    def run(*words, allowed=(0,)):
        done = subprocess.run([program, *words], capture_output=True, text=True, check=False)
        if done.returncode not in allowed:
            raise RuntimeError(f"{' '.join(words)}: exit code {done.returncode}: {done.stderr.strip()}")

    digest = hashlib.sha256()
    run("generate", *options, "-o", scene)
    run("simulate", scene, "-o", history, "--quiet", allowed=(0, 3))
    digest.update(Path(scene).read_bytes() + Path(history).read_bytes())
    for truth in ("exact", "recorded"):
        run("certify", scene, history, "--truth", truth, "--report", report, "--quiet", allowed=(0, 3))
        said = json.loads(Path(report).read_text())
        digest.update(json.dumps([said.get(field) for field in FIELDS]).encode())
    return digest.hexdigest()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--only")
    arguments = parser.parse_args()
    kept = {} if arguments.record else json.loads(KEPT.read_text())
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, options in scenes():
            if arguments.only in (None, name):
                found[name] = result(arguments.program, options, Path(folder))
    if arguments.record:
        KEPT.write_text(json.dumps(found, indent=1) + "\n")
        print(f"{len(found)} scenes recorded")
        return
    others = [name for name in found if kept.get(name) != found[name]]
    for name in others:
        print(f"other than recorded: {name}")
    if arguments.only is None and set(kept) != set(found):
        sys.exit("the scenes are not those that were recorded")
    if others:
        sys.exit(1)
    print(f"{len(found)} scenes as recorded")


if __name__ == "__main__":
    main()
