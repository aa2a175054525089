#!/usr/bin/env python3
"""Counts the instructions of the hot predicates and compares with the record.

usage: bench/instructions.py BUILD [--record]

BUILD is a build directory made without the instructions of one machine alone (VOROPROOF_NATIVE=OFF)
by the compiler of the record, with voroproof_bench_instructions in it. Prints instructions an
operation; fails where one has grown by more than 10% of the record, bench/instructions.json.
--record writes that instead. Other compilers give other counts: with them nothing is compared.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

RECORD = pathlib.Path(__file__).with_name("instructions.json")
ALLOWED = 1.10


def cached(build, key):
    for line in (build / "CMakeCache.txt").read_text().splitlines():
        if line.startswith(key + ":"):
            return line.split("=", 1)[1]
    raise SystemExit(f"instructions: {build} says nothing of {key}")


def compiler(build):
    command = cached(build, "CMAKE_CXX_COMPILER")
    return subprocess.run([command, "--version"], check=True, capture_output=True,
                          text=True).stdout.splitlines()[0]


def count(program):
    """Instructions an operation, by task."""
    with tempfile.TemporaryDirectory() as scratch:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--instr-atstart=no",
             f"--callgrind-out-file={scratch}/out", str(program)],
            capture_output=True, text=True)
        if run.returncode != 0:
            raise SystemExit(f"instructions: {program} failed:\n{run.stderr}")
        operations = dict(line.split() for line in run.stdout.splitlines())
        counts = {}
        for part in pathlib.Path(scratch).glob("out.*"):
            text = part.read_text()
            task = re.search(r"^desc: Trigger: Client Request: (\S+)$", text, re.M)
            if task and task[1] in operations:
                total = int(re.search(r"^(?:totals|summary): (\d+)", text, re.M)[1])
                if total > 0:
                    counts[task[1]] = round(total / int(operations[task[1]]), 1)
    missing = operations.keys() - counts.keys()
    if missing or not counts:
        raise SystemExit(f"instructions: not counted: {', '.join(sorted(missing)) or 'anything'}")
    return {task: counts[task] for task in operations}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()

    if cached(options.build, "VOROPROOF_NATIVE") != "OFF":
        raise SystemExit(f"instructions: {options.build} was made for one machine alone; "
                         "configure with -DVOROPROOF_NATIVE=OFF")
    here = {"compiler": compiler(options.build), "build": cached(options.build, "CMAKE_BUILD_TYPE")}
    counts = count(options.build / "voroproof_bench_instructions")
    if options.record:
        RECORD.write_text(json.dumps({**here, "instructions": counts}, indent=2) + "\n")
        return 0

    record = json.loads(RECORD.read_text())
    comparable = all(record[key] == here[key] for key in here)
    grown = []
    print(f"{'task':28} {'instructions':>13} {'record':>11} {'ratio':>6}")
    for task, instructions in counts.items():
        before = record["instructions"].get(task)
        ratio = instructions / before if before else float("nan")
        print(f"{task:28} {instructions:13.1f} {before or float('nan'):11.1f} {ratio:6.2f}")
        # A task without a record cannot have been looked at.
        if not ratio <= ALLOWED:
            grown.append(task)
    if not comparable:
        print(f"not compared: the record is of {record['compiler']} ({record['build']}), "
              f"this is {here['compiler']} ({here['build']})")
        return 0
    if grown:
        print(f"instructions: more than {ALLOWED - 1:.0%} above the record: {', '.join(grown)}",
              file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
