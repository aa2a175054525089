#!/usr/bin/env python3
"""Writes corpus/cases/ anew from the descriptions in corpus/degenerate/.

usage: corpus/degenerate.py [--check] [--only NAME] [-j N] PROGRAM [FAMILY...]

PROGRAM is build/voroproof. Every case is simulated, certified, drawn, and its wrong variants are
refuted, each for the fault that the description names; anything else is an error. With --check
the files are made in a scratch folder and compared with those here.
"""
import argparse
import filecmp
import shutil
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from degenerate import families
from degenerate.build import Failed, Program, build
from degenerate.case import cases_of

CASES = Path(__file__).resolve().parent / "cases"


def files_below(folder):
    return {p.relative_to(folder) for p in folder.rglob("*") if p.is_file()}


def differences(made, kept, names):
    """Files below the families `names` that only one of two folders has, or that differ."""
    found = []
    for name in names:
        a, b = files_below(made / name), files_below(kept / name)
        found += [f"{name}/{p}: only made" for p in sorted(a - b)]
        found += [f"{name}/{p}: only kept" for p in sorted(b - a)]
        found += [f"{name}/{p}: differs" for p in sorted(a & b)
                  if not filecmp.cmp(made / name / p, kept / name / p, shallow=False)]
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", metavar="PROGRAM")
    parser.add_argument("families", metavar="FAMILY", nargs="*")
    parser.add_argument("--check", action="store_true", help="compare, do not write")
    parser.add_argument("--only", metavar="NAME", help="one case")
    parser.add_argument("--times", action="store_true", help="say how long each case took")
    parser.add_argument("--patience", type=int, default=10, metavar="SECONDS",
                        help="for each step of a case that the program may not be able to make")
    parser.add_argument("-j", type=int, default=2, metavar="N", help="cases at a time")
    options = parser.parse_args()
    known = families.all_families()
    names = options.families or list(known)
    for name in set(names) - set(known):
        parser.error(f"{name}: no such family; there are {', '.join(known)}")
    if options.check and options.only:
        parser.error("--check compares whole families")
    patient, hurried = Program(options.program, 200), Program(options.program, options.patience)
    cases = [c for name in names for c in cases_of(name) if options.only in (None, c.name)]

    with tempfile.TemporaryDirectory() as scratch:
        root = Path(scratch) if options.check else CASES
        if not options.only:
            for name in names:
                shutil.rmtree(root / name, ignore_errors=True)

        def make(case):
            """Makes the case; says what was left out, and what failed."""
            start = time.monotonic()
            try:
                return build(case, hurried if case.awaits else patient, root), []
            except Failed as e:
                line = f"{case.family}/{case.name}: "
                if case.awaits:
                    shutil.rmtree(root / case.family / case.name)
                    return [line + case.awaits], []
                return [], [line + str(e)]
            finally:
                if options.times:
                    print(f"{time.monotonic() - start:.1f} s {case.family}/{case.name}")

        left_out, failures = [], []
        with ThreadPoolExecutor(options.j) as pool:
            for late, failed in pool.map(make, cases):
                left_out += late
                failures += failed
        if options.check:
            failures += differences(root, CASES, names)
            if not options.families:
                failures += [f"{p.name}: no such family" for p in CASES.iterdir()
                             if p.is_dir() and p.name not in known]
    for line in [f"not yet: {text}" for text in left_out] + failures:
        print(line)
    print(f"{len(cases)} cases, {len(failures)} failures, {len(left_out)} not yet")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
