#!/usr/bin/env python3
"""Computes the trusted core and writes its size into docs/certificate.md, section 10.

usage: scripts/trusted-core.py [--check] [--objects BUILD]

The core is the closure of what a certificate rests on: the readers (history/claim.h) and the
certifier, under the recorded truth certify/recorded_certifier.h; what certify/certifier.h adds is of
the exact truth. A file belongs to it if a file of it includes it; and a .cpp belongs to the header
that it includes first. With --check nothing is written: it fails where the document has other counts.
With --objects the closure of linked symbols is computed as well, from the object files of a build:
each object that the certifier's need must be of a file of the core, for either truth.
"""
import argparse
import collections
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "certificate.md"
CERTIFIERS = ["certify/recorded_certifier", "certify/certifier"]
READERS = "history/claim"
ROOMS = ["certify", "exact", "filtered/numbers", "filtered/motion", "filtered/search", "filtered/computed",
         "exact/topology", "history"]
SUBJECTS = {
    "certify": "the checker and its proofs",
    "exact": "numbers and predicates",
    "filtered/numbers": "enclosures in doubles and double-doubles",
    "filtered/motion": "the motion",
    "filtered/search": "searches, roots",
    "filtered/computed": "collisions, ties",
    "exact/topology": "the diagram as incidences",
    "history": "the readers",
}
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def includes(file):
    return [name for name in INCLUDE.findall((ROOT / file).read_text()) if (ROOT / name).exists()]


def sources():
    """The .cpp files by the header that each includes first."""
    by_header = collections.defaultdict(list)
    for room in ROOMS:
        for path in sorted((ROOT / room).glob("*.cpp")):
            file = str(path.relative_to(ROOT))
            first = includes(file)[:1]
            if not first:
                sys.exit(f"{file}: includes no header of the project")
            by_header[first[0]].append(file)
    return by_header


def core(certifier):
    by_header = sources()
    found, waiting = set(), [f"{certifier}.h", f"{READERS}.h"]
    while waiting:
        file = waiting.pop()
        if file in found:
            continue
        found.add(file)
        waiting += includes(file) + by_header[file]
    return found


def room_of(file):
    room = file.rsplit("/", 1)[0]
    if room not in SUBJECTS:
        sys.exit(f"{file}: in the trusted core, but of no room that may be")
    return room


def table(cores):
    parts = [cores[0], cores[1] - cores[0]]
    lines = collections.Counter()
    for k, files in enumerate(parts):
        for file in files:
            for room in (room_of(file), "all"):
                lines[room, k] += (ROOT / file).read_bytes().count(b"\n")
    rows = ["| room | what | lines | exact |", "|---|---|---|---|"]
    rows += [f"| `{room}/` | {SUBJECTS[room]} | {lines[room, 0]:,} | {lines[room, 1]:,} |" for room in ROOMS]
    rows.append(f"| all | | {lines['all', 0]:,} | {lines['all', 1]:,} |")
    return "\n".join(rows)


def symbols(objects):
    """Per object file: the symbols it defines (strongly), and those it needs."""
    defined, needed = collections.defaultdict(set), collections.defaultdict(set)
    for path in objects:
        for line in subprocess.run(["nm", "-P", path], capture_output=True, text=True, check=True).stdout.splitlines():
            name, kind = line.split()[:2]
            if kind == "U":
                needed[path].add(name)
            elif kind in "TDBR":
                defined[path].add(name)
    return defined, needed


def linked(build, certifier):
    """The files whose objects a program gets that calls this certifier and the readers."""
    objects = {}
    for room in ROOMS:
        top, _, inner = room.partition("/")
        for path in (build / top).glob(f"CMakeFiles/*.dir/{inner + '/' if inner else ''}*.cpp.o"):
            objects[str(path)] = f"{room}/{path.name[:-2]}"
    defined, needed = symbols(objects)
    by_symbol = {name: path for path, names in defined.items() for name in names}
    waiting = [path for path, file in objects.items() if file in (f"{certifier}.cpp", f"{READERS}.cpp")]
    if len(waiting) != 2:
        sys.exit(f"{build}: no objects of the certifier")
    found = set()
    while waiting:
        path = waiting.pop()
        if path not in found:
            found.add(path)
            waiting += [by_symbol[name] for name in needed[path] if name in by_symbol]
    return {objects[path] for path in found}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--objects", type=Path)
    arguments = parser.parse_args()
    cores = [core(certifier) for certifier in CERTIFIERS]
    for certifier, files in zip(CERTIFIERS, cores):
        strangers = linked(arguments.objects, certifier) - files if arguments.objects else None
        if strangers:
            sys.exit(f"linked by {certifier}, and not in its core by its includes: " + " ".join(sorted(strangers)))
    old = DOCUMENT.read_text()
    new, changes = re.subn(r"^\| room \| what \|.*?^\| all \|[^\n]*$", lambda _: table(cores), old, flags=re.M | re.S)
    if changes != 1:
        sys.exit(f"{DOCUMENT.name}: no table of the trusted core")
    if not arguments.check:
        DOCUMENT.write_text(new)
    elif old != new:
        sys.exit(f"{DOCUMENT.name}: the trusted core has other line counts: scripts/trusted-core.py writes them anew")


if __name__ == "__main__":
    main()
