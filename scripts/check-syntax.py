#!/usr/bin/env python3
"""Compiles sources without making code of them: for the warnings of another compiler, in half of the time.

usage: scripts/check-syntax.py BUILD JOBS FOLDER...

What a configured build (BUILD/compile_commands.json) compiles of the folders and has not compiled yet is compiled with the
build's own options, but for sources that the build makes itself. Exit code 1 where one of the files does not compile.
"""
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def commands(build, folders):
    """The command of each file, without its output."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        at = words.index("-o")
        made = Path(entry["directory"]) / words[at + 1]
        places = Path(entry["file"]).parents
        if not folders.isdisjoint(places) and build not in places and not made.exists():
            yield entry["file"], words[:at] + words[at + 2:] + ["-fsyntax-only"], entry["directory"]


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    build, jobs = Path(sys.argv[1]).resolve(), int(sys.argv[2])
    folders = {Path(name).resolve() for name in sys.argv[3:]}
    wanted = {file: (words, directory) for file, words, directory in commands(build, folders)}
    if not wanted:
        sys.exit(f"{build} compiles nothing of these folders that is not compiled")

    def compiles(file):
        words, directory = wanted[file]
        done = subprocess.run(words, cwd=directory, capture_output=True, text=True, check=False)
        if done.returncode != 0 or done.stderr:
            print(done.stderr, end="", flush=True)
        return done.returncode == 0

    with ThreadPoolExecutor(jobs) as pool:
        good = sum(pool.map(compiles, wanted))
    print(f"{good} of {len(wanted)} files compile")
    return good != len(wanted)


if __name__ == "__main__":
    sys.exit(main())
