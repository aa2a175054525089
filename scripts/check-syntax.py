#!/usr/bin/env python3
"""Compiles sources without making code of them: for the warnings of another compiler, in half of the time.

usage: scripts/check-syntax.py BUILD FOLDER [JOBS]

What a configured build (BUILD/compile_commands.json) compiles of FOLDER and has not compiled yet is compiled with the
build's own options, but for sources that the build makes itself. Exit code 1 where one of the files does not compile.
"""
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def commands(build, folder):
    """The command of each file, without its output."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        at = words.index("-o")
        made = Path(entry["directory"]) / words[at + 1]
        places = Path(entry["file"]).parents
        if folder in places and build not in places and not made.exists():
            yield entry["file"], words[:at] + words[at + 2:] + ["-fsyntax-only"], entry["directory"]


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    build, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    jobs = int(sys.argv[3]) if len(sys.argv) == 4 else os.cpu_count()
    wanted = {file: (words, directory) for file, words, directory in commands(build, folder)}
    if not wanted:
        sys.exit(f"{build} compiles nothing of {folder} that is not compiled")

    def compiles(file):
        words, directory = wanted[file]
        done = subprocess.run(words, cwd=directory, capture_output=True, text=True, check=False)
        if done.returncode != 0 or done.stderr:
            print(done.stderr, end="", flush=True)
        return done.returncode == 0

    with ThreadPoolExecutor(jobs) as pool:
        good = sum(pool.map(compiles, wanted))
    print(f"{good} of {len(wanted)} files of {folder.name}/ compile")
    return good != len(wanted)


if __name__ == "__main__":
    sys.exit(main())
