#!/usr/bin/env python3
"""Finds classes and enumerations of one name that are defined twice.

usage: scripts/check-names.py

Two definitions of one qualified name in one program break C++'s rule of one definition: the compiler keeps one
of them, and one copy of each function of a template over it, whatever the sizes are. No linker sees
that where the template is the standard library's. All sources are looked at, but for names in unnamed namespaces.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OPENS = re.compile(r"^(?:inline )?namespace ?([\w:]*) ?\{$")
CLOSES = re.compile(r"^\}  // namespace ?([\w:]*)$")
DEFINES = re.compile(r"^(?:class|struct|enum class|enum|union) (?:\[\[\w+\]\] )?(?:alignas\(\w+\) )?([\w:]+)(?: final)?(?: : [^;]*)? ?\{")


def definitions(path):
    """The qualified names that a source defines outside of unnamed namespaces, with their lines."""
    spaces, opened_at = [], 0
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if opened := OPENS.match(line):
            spaces.append(opened[1])
            opened_at = number
        # A namespace of one line is closed without a comment.
        elif CLOSES.match(line) or (line == "}" and number == opened_at + 2):
            spaces.pop()
        elif defined := DEFINES.match(line):
            if "" not in spaces:
                yield "::".join([*spaces, defined[1]]), f"{path.relative_to(ROOT)}:{number}"


def sources(folder):
    """All of the project: what begins with "build" is made."""
    for path in sorted(folder.iterdir()):
        if path.is_dir() and not path.name.startswith(("build", ".")):
            yield from sources(path)
        elif path.suffix in (".h", ".cpp"):
            yield path


def main():
    places = {}
    for path in sources(ROOT):
        for defined, place in definitions(path):
            places.setdefault(defined, []).append(place)
    twice = {name: where for name, where in places.items() if len(where) > 1}
    for name, where in sorted(twice.items()):
        print(f"{name} is defined {len(where)} times: {', '.join(where)}")
    print(f"{len(places)} classes and enumerations, {len(twice)} of them defined more than once")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main())
