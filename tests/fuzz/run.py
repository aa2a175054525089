#!/usr/bin/env python3
"""The runs of the tests: each target with its kept cases, its seeds and a fixed number of changes.

usage: tests/fuzz/run.py FUZZ PROGRAM [--times N] [--seed S] [--only TARGET] [--out FOLDER]

FUZZ is the driver, PROGRAM voroproof, which makes the seeds. --times multiplies the runs of the tests.
Exit code 1 where there is a find, which is in FOLDER then.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fuzz")
    parser.add_argument("program")
    parser.add_argument("--times", type=float, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="")
    parser.add_argument("--out", default=".")
    a = parser.parse_args()
    listed = subprocess.run([a.fuzz, "--targets"], capture_output=True, text=True, check=True).stdout
    finds = 0
    with tempfile.TemporaryDirectory() as seeds:
        subprocess.run([sys.executable, "-B", HERE / "seeds.py", a.program, seeds], check=True)
        for line in listed.splitlines():
            name, runs = line.split()
            if a.only not in ("", name):
                continue
            places = [Path(seeds) / name, *(p for p in [HERE / "cases" / name] if p.is_dir())]
            done = subprocess.run([a.fuzz, name, *places, "--runs", str(int(int(runs) * a.times)), "--seed",
                                   str(a.seed), "--out", a.out], check=False)
            finds += done.returncode != 0
    return finds > 0


if __name__ == "__main__":
    sys.exit(main())
