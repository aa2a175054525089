#!/usr/bin/env python3
"""Finds names of types that are defined twice, and comments that open like riddles.

usage: scripts/check-names.py

Two definitions of one qualified name in one program break C++'s rule of one definition: the compiler keeps one
of them, and one copy of each function of a template over it, whatever the sizes are. No linker sees
that where the template is the standard library's. A name is not that of a class and of an alias (`using`), nor of two
aliases for different types. All sources are looked at, but for names in unnamed namespaces.

A comment names its subject first: none opens with the words of RIDDLE. Comments of C++ (but for tests/ and bench/),
Python and JavaScript are looked at.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CPP, SCRIPTS = (".h", ".cpp"), (".py", ".js", ".mjs")
OPENS = re.compile(r"^(?:inline )?namespace ?([\w:]*) ?\{$")
CLOSES = re.compile(r"^\}  // namespace ?([\w:]*)$")
DEFINES = re.compile(r"^(?:class|struct|enum class|enum|union) (?:\[\[\w+\]\] )?(?:alignas\(\w+\) )?([\w:]+)(?: final)?(?: : [^;]*)? ?\{")
ALIAS = re.compile(r"^using (\w+) = ([^;]*);$")

RIDDLE = re.compile(r'(?:^|(?<=[\s;{}),]))(//|#|""")[/!<]* *(?:Of|So many|So much|What)\b', re.IGNORECASE)


def riddles(path):
    """The lines on which a comment opens so; a line that goes on with the comment above opens none."""
    above = ""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if opened := RIDDLE.search(line):
            column = opened.start(1)
            if line[:column].strip() or not above.startswith(opened[1], column):
                yield f"{path.relative_to(ROOT)}:{number}"
        above = line


def definitions(path):
    """The qualified names that a source defines outside of unnamed namespaces, as (name, meaning, line)."""
    spaces, opened_at = [], 0
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if opened := OPENS.match(line):
            spaces.append(opened[1])
            opened_at = number
        # A namespace of one line is closed without a comment.
        elif CLOSES.match(line) or (line == "}" and number == opened_at + 2):
            spaces.pop()
        elif "" not in spaces and (defined := DEFINES.match(line) or ALIAS.match(line)):
            place = f"{path.relative_to(ROOT)}:{number}"
            # A definition means itself, an alias its type.
            yield "::".join([*spaces, defined[1]]), defined[2] if defined.re is ALIAS else place, place


def sources(folder, suffixes):
    """All of the project: what begins with "build" is made."""
    for path in sorted(folder.iterdir()):
        if path.is_dir() and not path.name.startswith(("build", ".")):
            yield from sources(path, suffixes)
        elif path.suffix in suffixes:
            yield path


def main():
    places = {}
    for path in sources(ROOT, CPP):
        for defined, meaning, place in definitions(path):
            places.setdefault(defined, {}).setdefault(meaning, place)
    twice = {name: where.values() for name, where in places.items() if len(where) > 1}
    for name, where in sorted(twice.items()):
        print(f"{name} is defined {len(where)} times: {', '.join(where)}")
    print(f"{len(places)} names of types, {len(twice)} of them defined more than once")
    rooms = [path for path in sources(ROOT, CPP + SCRIPTS)
             if path.suffix in SCRIPTS or path.relative_to(ROOT).parts[0] not in ("tests", "bench")]
    unclear = [place for path in rooms for place in riddles(path)]
    for place in unclear:
        print(f'{place}: a comment opens with "Of", "So many", "So much" or "What"')
    return 1 if twice or unclear else 0


if __name__ == "__main__":
    sys.exit(main())
