#!/usr/bin/env python3
"""Changed pairs of a scene and a history for the checkers that are no part of the program.

usage: tests/fuzz/checkers.py page FUZZ PROGRAM KERNEL [--runs N] [--seed S] [--out FOLDER]
       tests/fuzz/checkers.py proved FUZZ PROGRAM PROVED [--runs N] [--seed S] [--out FOLDER]

FUZZ is the driver, PROGRAM voroproof, which makes the seeds. `page` gives the pairs to the module
of the certifier's page, the file MODULE (page.mjs), `proved` to the proved checker: that must end with a verdict and its exit code,
within ten seconds of the processor and a gigabyte, and what it certifies `certify` must not refute nor refuse.
Exit code 1 where there is a find, whose files are in FOLDER then; 77 where node, MODULE or PROVED is missing.
"""
import argparse
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
VERDICTS = {"s CERTIFIED": 0, "s INVALID": 2, "s UNDECIDED": 3}
MISSING = 77


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (10, 10))
    resource.setrlimit(resource.RLIMIT_DATA, (1 << 30, 1 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def proved_says(proved, scene, history):
    """The verdict, or what is wrong with how the checker ended."""
    done = subprocess.run([proved, scene, history], capture_output=True, preexec_fn=limited, check=False)
    last = done.stdout.decode(errors="replace").splitlines()[-1:]
    verdict = last[0] if last else ""
    if VERDICTS.get(verdict, -1) == done.returncode and not done.stderr:
        return verdict[2:]
    return f"exit code {done.returncode}, the last line {verdict!r}, on stderr {done.stderr[:200]!r}"


def ask_proved(program, proved, folder, out):
    """The number of finds."""
    ended, finds = Counter(), 0
    for scene in sorted(Path(folder).glob("*.scene.json"), key=lambda path: int(path.name.split(".")[0])):
        history = scene.with_name(scene.name.replace(".scene.json", ".history.jsonl"))
        said = proved_says(proved, scene, history)
        if said == "CERTIFIED":
            code = subprocess.run([program, "certify", scene, history, "--truth", "recorded", "--quiet"], capture_output=True,
                                  check=False).returncode
            if code not in (0, 3):
                said = f"CERTIFIED, and certify ends with exit code {code}"
        ended[said] += 1
        if f"s {said}" not in VERDICTS:
            finds += 1
            print(f"find: {keep(scene, history, out, 'proved')}: {said}", flush=True)
    print(f"proved         {sum(ended.values())} runs", dict(ended), flush=True)
    return finds


def keep(scene, history, out, what):
    """Copies a find; its name there."""
    name = f"find-{what}-{scene.name.split('.')[0]}"
    shutil.copy(scene, Path(out) / f"{name}.scene.json")
    shutil.copy(history, Path(out) / f"{name}.history.jsonl")
    return name


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=["page", "proved"])
    parser.add_argument("fuzz")
    parser.add_argument("program")
    parser.add_argument("checker")
    parser.add_argument("--runs", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", default=".")
    a = parser.parse_args()
    needed = "node" if a.kind == "page" else a.checker
    if shutil.which(needed) is None or (a.kind == "page" and not os.environ.get("MODULE")):
        print(f"{needed}, or the page's module, is not there")
        return MISSING
    with tempfile.TemporaryDirectory() as folder:
        seeds, changed = Path(folder) / "seeds", Path(folder) / "changed"
        changed.mkdir()
        subprocess.run([sys.executable, "-B", HERE / "seeds.py", a.program, seeds], check=True)
        subprocess.run([a.fuzz, "--changed", changed, seeds / "certify", "--runs", str(a.runs), "--seed", str(a.seed)],
                       check=True)
        if a.kind == "proved":
            return ask_proved(a.program, a.checker, changed, a.out) > 0
        done = subprocess.run(["node", HERE / "page.mjs", a.checker, changed], stdout=subprocess.PIPE, text=True, check=False)
        print(done.stdout, end="")
        for line in done.stdout.splitlines():
            if line.startswith("find: "):
                scene = changed / f"{line.split()[1].rstrip(',')}.scene.json"
                keep(scene, scene.with_name(scene.name.replace(".scene.json", ".history.jsonl")), a.out, "page")
        return done.returncode != 0


if __name__ == "__main__":
    sys.exit(main())
