#!/usr/bin/env python3
"""Seeds faults into the program, one at a time, and says which test finds each.

usage: tests/faults/run.py [--only NAME] [--jobs N] [--out DIR] [--resume] [--record]
       tests/faults/run.py --check

The faults are those of faults.json beside this file (CONTRIBUTING.md, "Seeded faults"). They are made in
a copy of the tree, DIR, never in the tree itself; DIR is build-faults where it is not given. For each
fault: what depends on it is built, and the room's test programs run, the quick ones first, until one
fails. DIR/build/faults.json keeps what was found, DIR/build/faults.md tells it as a table. The exit
code is 0 if every fault is found but those that say why none can be ("survives").

--only NAME  only this fault; may be given more than once
--resume     leaves alone what has a result already, and believes how long the tests took
--record     writes into faults.json which test found each fault that was tried ("found_by")
--check      only checks that each fault can be made in the tree as it is, also those that the proved
             checker is tried with (tests/proofs/faults.py), and that docs/seeded-faults.md has the score
             and the survivors of faults.json
"""

import argparse
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

TREE = pathlib.Path(__file__).resolve().parents[2]
FAULTS = pathlib.Path(__file__).with_name("faults.json")
OF_PROOFS = TREE / "tests" / "proofs" / "faults.json"  # some have a text of their own
DOCUMENT = TREE / "docs" / "seeded-faults.md"

# The test programs of each room: name, target to build, command in the build directory.
CERTIFY = ("certify_test", "certify_test", ["tests/certify_test"])
CORPUS = ("corpus", "voroproof", ["../corpus/run.sh", "./voroproof"])
CASES = ("corpus_cases", "voroproof", ["./voroproof", "corpus", "run", "--corpus",
                                       "../corpus/cases", "--memory", "0", "--timeout", "600"])


def program(name):
    return (name, name, ["tests/" + name])


ORDER = {
    "certify/world": [program("world_certifier_test")],
    "certify/billiards": [program("billiard_test")],
    "filtered/billiards": [program("billiard_test")],
    "certify": [CERTIFY, CORPUS, program("evidence_test"), CASES, program("adversary_test")],
    "filtered": [program("filtered_test"), program("carry_test"), program("symmetry_test"), CERTIFY,
                 CORPUS, program("engine_oracle_test"), CASES],
    "library/planning": [program("planning_test"),
                         ("clearance_agreement", "voroproof",
                          ["python3", "-B", "../tests/planning/agreement/agreement.py", "./voroproof", "0", "60"]),
                         ("billiards_clearance", "voroproof",
                          ["python3", "-B", "../tests/billiards/clearance.py", "./voroproof", "0", "24"])],
    "certify/kernel": [program("kernel_test"), program("kernel_corpus_test"), program("adversary_test")],
}


def room(fault):
    """The innermost room of ORDER that the file is in, or else its folder."""
    return max((name for name in ORDER if fault["file"].startswith(name + "/")), key=len, default=fault["file"].split("/")[0])


def load():
    faults = json.loads(FAULTS.read_text())
    names = [f["name"] for f in faults]
    for name in names:
        if names.count(name) > 1:
            raise SystemExit(f"faults: two have the name {name}")
    return faults


def faulty(fault, tree):
    """The text of the file with the fault in it."""
    path = tree / fault["file"]
    text = path.read_text() if path.exists() else ""
    count = text.count(fault["text"])
    if count != 1 or fault["text"] == fault["replacement"]:
        raise ValueError(f"{fault['name']}: its text occurs {count} times in {fault['file']}, not once")
    return text.replace(fault["text"], fault["replacement"])


def check(faults):
    """Messages about faults that cannot be made, and about what the document says otherwise than faults.json."""
    wrong = []
    document = DOCUMENT.read_text() if DOCUMENT.exists() else ""
    for name, rows in (("score", score(faults, recorded)), ("survivors", survivors(faults))):
        if "\n".join(["", *rows, ""]) + "\n" not in document:
            wrong.append(f"{DOCUMENT.name}: the table of {name} is not that of {FAULTS.name}:\n" + "\n".join(rows))
    for fault in faults:
        try:
            if room(fault) not in ORDER:
                raise ValueError(f"{fault['name']}: no tests are known for {fault['file']}")
            faulty(fault, TREE)
            if "found_by" in fault and "survives" in fault:
                raise ValueError(f"{fault['name']}: it is found, and says why it survives")
        except ValueError as e:
            wrong.append(str(e))
    for fault in json.loads(OF_PROOFS.read_text()):
        try:
            if "file" in fault:
                faulty(fault, TREE)
        except ValueError as e:
            wrong.append(str(e))
    return wrong


def copy_tree(source):
    """Brings the copy up to date: only what differs is written, so that little is built anew."""
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            cwd=TREE, check=True, capture_output=True, text=True).stdout
    names = {n for n in listed.split("\0") if n and (TREE / n).is_file()}
    for name in names:
        to, data = source / name, (TREE / name).read_bytes()
        if not to.exists() or to.read_bytes() != data:
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_bytes(data)
            shutil.copymode(TREE / name, to)
    for path in source.rglob("*"):
        name = path.relative_to(source).as_posix()
        if path.is_file() and name not in names and not name.startswith("build/"):
            path.unlink()


class Build:
    def __init__(self, out, jobs):
        self.source, self.build, self.jobs = out, out / "build", jobs
        self.log = self.build / "faults.log"
        copy_tree(self.source)
        with self.log.open("w") as log:
            subprocess.run(["cmake", "--preset", "release"], cwd=self.source,
                           check=True, stdout=log, stderr=log)

    def make(self, target):
        with self.log.open("w") as log:
            return subprocess.run(["cmake", "--build", self.build, "-j", str(self.jobs), "--target",
                                   target], stdout=log, stderr=log).returncode == 0

    def test(self, command, limit):
        """Nothing where the test passes; else what failed."""
        def confine():
            resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        # The same cases each time; what follows the first failure tells no more.
        environment = dict(os.environ, RC_PARAMS="seed=1", GTEST_FAIL_FAST="1", GTEST_BRIEF="1")
        try:
            run = subprocess.run(command, cwd=self.build, env=environment, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=limit,
                                 text=True, errors="replace", preexec_fn=confine)
        except subprocess.TimeoutExpired:
            return "takes too long"
        if run.returncode == 0:
            return None
        self.log.write_text(run.stdout)
        failed = re.search(r"\[  FAILED  \] ([\w./]+)", run.stdout)
        return failed[1] if failed else "fails" if run.returncode > 0 else "crashes"


def try_fault(fault, build, limits):
    path = build.source / fault["file"]
    right = path.read_text()
    path.write_text(faulty(fault, build.source))
    try:
        for name, target, command in ORDER[room(fault)]:
            if not build.make(target):
                return {"result": "does not compile"}
            failed = build.test(command, limits.get(name))
            if failed:
                return {"result": "found", "by": name if failed == "fails" else f"{name}: {failed}"}
        return {"result": "survived"}
    finally:
        path.write_text(right)


def measure(build, rooms, limits):
    """How long each test may take; all of them have to pass without a fault."""
    for name, target, command in [step for r in sorted(rooms) for step in ORDER[r]]:
        if name in limits:
            continue
        if not build.make(target):
            raise SystemExit(f"faults: {target} does not build without a fault: {build.log}")
        start = time.monotonic()
        failed = build.test(command, None)
        if failed:
            raise SystemExit(f"faults: {name} fails without a fault: {failed}")
        limits[name] = 60 + 5 * (time.monotonic() - start)


def recorded(fault):
    """Reads from faults.json whether the fault was found, or survived."""
    return "found" if "found_by" in fault else "survived"


def score(faults, result):
    """The lines of a table: for each room how many faults there are and how many are found."""
    rows = ["| room | faults | found | survive, explained | survive |", "|---|---|---|---|---|"]
    for name in [*ORDER, "all"]:
        mine = [f for f in faults if name in (room(f), "all")]
        if not mine:
            continue
        found = sum(result(f) == "found" for f in mine)
        survived = [f for f in mine if result(f) == "survived"]
        explained = sum("survives" in f for f in survived)
        rows.append(f"| {name} | {len(mine)} | {found} | {explained} | {len(survived) - explained} |")
    return rows


def survivors(faults):
    """The lines of a table: the faults that no test finds, and why."""
    rows = ["| fault | file | why no test finds it |", "|---|---|---|"]
    return rows + [f"| {f['name']} | `{f['file']}` | {f.get('survives', 'open')} |"
                   for f in faults if recorded(f) == "survived"]


def record_results(faults, results):
    """Writes into faults.json what was found."""
    for fault in faults:
        got = results.get(fault["name"], {})
        if got.get("result") == "found":
            fault["found_by"] = got["by"]
        elif got.get("result") == "survived":
            fault.pop("found_by", None)
    FAULTS.write_text(json.dumps(faults, indent=1, ensure_ascii=False) + "\n")


def table(faults, results):
    rows = ["| fault | file | what it means | found by |", "|---|---|---|---|"]
    for fault in faults:
        got = results.get(fault["name"])
        by = ("not run" if not got else got["by"] if got["result"] == "found" else
              "survives: " + fault["survives"] if got["result"] == "survived" and "survives" in fault
              else got["result"])
        rows.append(f"| {fault['name']} | `{fault['file']}` | {fault['means']} | {by} |")
    rows += ["", *score(faults, lambda f: results.get(f["name"], {}).get("result"))]
    return "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description="Seeds faults, one at a time, and tests.")
    parser.add_argument("--only", action="append", metavar="NAME")
    parser.add_argument("--jobs", type=int, default=1, metavar="N")
    parser.add_argument("--out", type=pathlib.Path, default=TREE / "build-faults", metavar="DIR")
    parser.add_argument("--resume", action="store_true")
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--check", action="store_true")
    asked = parser.parse_args()
    faults = load()
    if asked.check:
        wrong = check(faults)
        print("\n".join(wrong) or f"{len(faults)} faults can be made")
        return 1 if wrong else 0

    unknown = set(asked.only or []) - {f["name"] for f in faults}
    if unknown:
        raise SystemExit(f"faults: there is no {', '.join(sorted(unknown))}")
    out = asked.out.resolve()
    (out / "build").mkdir(parents=True, exist_ok=True)
    record = out / "build" / "faults.json"
    known = json.loads(record.read_text()) if record.exists() else {"limits": {}, "results": {}}
    if not asked.resume:
        known["limits"] = {}
        if not asked.only:
            known["results"] = {}
    results = known["results"]
    todo = [f for f in faults if (not asked.only or f["name"] in asked.only)
            and not (asked.resume and f["name"] in results)]
    for fault in todo:
        faulty(fault, TREE)
    if todo:
        build = Build(out, asked.jobs)
        measure(build, {room(f) for f in todo}, known["limits"])
    for fault in todo:
        start = time.monotonic()
        got = results[fault["name"]] = try_fault(fault, build, known["limits"])
        record.write_text(json.dumps(known, indent=1) + "\n")
        print(f"{fault['name']}: {got['result']} {got.get('by', '')} ({time.monotonic() - start:.0f} s)",
              flush=True)
    (out / "build" / "faults.md").write_text(table(faults, results))
    if asked.record:
        record_results(faults, results)
    bad = [f["name"] for f in faults if f["name"] in results
           and results[f["name"]]["result"] != "found"
           and not (results[f["name"]]["result"] == "survived" and "survives" in f)]
    no_survivors = [f["name"] for f in faults
                    if "survives" in f and results.get(f["name"], {}).get("result") == "found"]
    if bad:
        print("not found: " + ", ".join(bad))
    if no_survivors:
        print("found, though it says that it survives: " + ", ".join(no_survivors))
    return 1 if bad or no_survivors else 0


if __name__ == "__main__":
    sys.exit(main())
