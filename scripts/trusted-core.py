#!/usr/bin/env python3
"""Computes the trusted core and writes its size into docs/certificate.md, section 10.

usage: scripts/trusted-core.py [--check] [--objects BUILD]

The core is the closure of what a certificate rests on: the certifier (certify/certifier.h) and the
readers (history/claim.h). A file belongs to it if a file of it includes it; and a .cpp belongs to the
header that it includes first. With --check nothing is written: it fails where the document has other
counts. With --objects the closure of linked symbols is computed as well, from the object files of a
build: each object that the certifier's need must be of a file of the core.
"""
import argparse
import collections
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "certificate.md"
ENTRIES = ["certify/certifier.h", "history/claim.h"]
ROOMS = ["certify", "exact", "filtered/numbers", "filtered/motion", "filtered/search", "exact/topology", "history"]
SUBJECTS = {
    "certify": "the checker and its proofs",
    "exact": "numbers and predicates",
    "filtered/numbers": "enclosures in doubles and double-doubles",
    "filtered/motion": "the motion",
    "filtered/search": "where doubles fail: searches, roots, ties proved by symmetry",
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


def core():
    by_header = sources()
    found, waiting = set(), list(ENTRIES)
    while waiting:
        file = waiting.pop()
        if file in found:
            continue
        found.add(file)
        waiting += includes(file) + by_header[file]
    return sorted(found)


def room_of(file):
    room = file.rsplit("/", 1)[0]
    if room not in SUBJECTS:
        sys.exit(f"{file}: in the trusted core, but of no room that may be")
    return room


def table(files):
    lines, count = collections.Counter(), collections.Counter()
    for file in files:
        lines[room_of(file)] += (ROOT / file).read_bytes().count(b"\n")
        count[room_of(file)] += 1
    rows = ["| room | what | files | lines |", "|---|---|---|---|"]
    rows += [f"| `{room}/` | {SUBJECTS[room]} | {count[room]} | {lines[room]:,} |" for room in ROOMS]
    rows.append(f"| all | | {len(files)} | {sum(lines.values()):,} |")
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


def linked(build):
    """The files whose objects a program gets that calls the entries."""
    objects = {}
    for room in ROOMS:
        top, _, inner = room.partition("/")
        for path in (build / top).glob(f"CMakeFiles/*.dir/{inner + '/' if inner else ''}*.cpp.o"):
            objects[str(path)] = f"{room}/{path.name[:-2]}"
    defined, needed = symbols(objects)
    by_symbol = {name: path for path, names in defined.items() for name in names}
    waiting = [path for path, file in objects.items() if file in ("certify/certifier.cpp", "history/claim.cpp")]
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
    files = core()
    if arguments.objects:
        strangers = linked(arguments.objects) - set(files)
        if strangers:
            sys.exit("linked by the certifier, and not in the core by its includes: " + " ".join(sorted(strangers)))
    old = DOCUMENT.read_text()
    new, changes = re.subn(r"^\| room \| what \|.*?^\| all \|[^\n]*$", lambda _: table(files), old, flags=re.M | re.S)
    if changes != 1:
        sys.exit(f"{DOCUMENT.name}: no table of the trusted core")
    if not arguments.check:
        DOCUMENT.write_text(new)
    elif old != new:
        sys.exit(f"{DOCUMENT.name}: the trusted core has other line counts: scripts/trusted-core.py writes them anew")


if __name__ == "__main__":
    main()
