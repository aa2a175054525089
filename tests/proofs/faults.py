#!/usr/bin/env python3
"""Certifiers with a fault on purpose, and the proved checker beside them.

usage: tests/proofs/faults.py PROVED
       tests/proofs/faults.py PROVED --build [--out DIR] [--only NAME]

Each fault of faults.json beside this file makes the certifier accept something wrong: the folder wrong/ has a
history of its name (with - for blanks) that the faulty certifier certifies under the recorded truth. A fault
without a file is one of tests/faults/faults.json. PROVED (build/proofs/voroproof-proved) must accept none of these
histories, nor any other of that folder.

--build  makes each fault in a copy of the tree, DIR (build-faults-proved where it is not given), builds the
         program, and sees that it certifies the history. Takes some minutes.
--only   only this fault; may be given more than once
"""

import argparse
import json
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "faults"))
import run as seeded  # noqa: E402  (tests/faults/run.py)


def faults():
    known = {f["name"]: f for f in seeded.load()}
    mine = json.loads((HERE / "faults.json").read_text())
    return [f if "file" in f else known[f["name"]] for f in mine]


def files(stem):
    return [str(HERE / "wrong" / f"{stem}{end}") for end in (".scene.json", ".history.jsonl")]


def stem_of(fault):
    return fault["name"].replace(" ", "-").replace(",", "")


def verdict(command):
    done = subprocess.run(command, capture_output=True, text=True)
    lines = done.stdout.splitlines()
    return (lines or ["no verdict"])[-1], lines[-2] if len(lines) > 1 else done.stderr.strip()


def main():
    parser = argparse.ArgumentParser(description="Faulty certifiers and the proved checker.")
    parser.add_argument("proved", type=pathlib.Path)
    parser.add_argument("--build", action="store_true")
    parser.add_argument("--out", type=pathlib.Path, default=seeded.TREE / "build-faults-proved", metavar="DIR")
    parser.add_argument("--only", action="append", metavar="NAME")
    asked = parser.parse_args()
    all_faults = faults()
    bad = []
    stems = sorted(p.name[:-len(".scene.json")] for p in (HERE / "wrong").glob("*.scene.json"))
    for stem in stems:
        said, why = verdict([str(asked.proved.resolve()), *files(stem)])
        if said != "s UNDECIDED":
            bad.append(f"{stem}: {said} by the proved checker: {why}")
    for fault in all_faults:
        if stem_of(fault) not in stems:
            bad.append(f"{fault['name']}: there is no history in tests/proofs/wrong")
        seeded.faulty(fault, seeded.TREE)  # it can still be made
    if asked.build:
        out = asked.out.resolve()
        (out / "build").mkdir(parents=True, exist_ok=True)
        build = seeded.Build(out, 2)
        for fault in all_faults:
            if asked.only and fault["name"] not in asked.only:
                continue
            path = build.source / fault["file"]
            right = path.read_text()
            path.write_text(seeded.faulty(fault, build.source))
            try:
                built = build.make("voroproof")
            finally:
                path.write_text(right)
            said, why = ("does not build", "") if not built else verdict(
                [str(build.build / "voroproof"), "certify", *files(stem_of(fault)), "--truth", "recorded"])
            print(f"{fault['name']}: {said}", flush=True)
            if said != "s CERTIFIED":
                bad.append(f"{fault['name']}: the faulty certifier says {said}: {why}")
    print("\n".join(bad) or f"{len(all_faults)} faults of the certifier, none of {len(stems)} wrong histories accepted")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
