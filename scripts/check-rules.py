#!/usr/bin/env python3
"""Checks what docs/certificate.md says of the code: the rules, and the tests that fail without them.

usage: scripts/check-rules.py

The document has tables with a column "test", most of them with a column "function". In these columns
`certify/flips.cpp` is a file; `Flips::flip` is a function in the file named before it; `Suite.Name` is a
test; "a fault" is a seeded fault of tests/faults/faults.json that a test finds; and "no test" stands
alone. Each of them must exist. Each Rule of the text must have a row, and each row of rules its Rule.
"""
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "certificate.md"
FAULTS = ROOT / "tests" / "faults" / "faults.json"
TEST = re.compile(r"^\s*(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+),\s*(\w+)", re.M)
RULE = re.compile(r"\*\*Rule (\d+\.\d+)")


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def tables(text):
    """The rows of the tables with a column "test": (line number, {column: cell})."""
    head = None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.startswith("|"):
            head = None
        elif head is None:
            head = cells(line)
        elif "test" in head and not line.startswith("|---"):
            yield number, dict(zip(head, cells(line)))


def tests():
    found = set()
    for path in (ROOT / "tests").rglob("*.cpp"):
        found |= {f"{suite}.{name}" for suite, name in TEST.findall(path.read_text())}
    return found


def faults():
    return {fault["name"] for fault in json.loads(FAULTS.read_text()) if "found_by" in fault}


def function_errors(cell):
    text, named = None, False
    for name in re.findall(r"`([^`]+)`", cell):
        if "/" in name:
            path = ROOT / name
            text = path.read_text() if path.is_file() else None
            if text is None:
                yield f"no file {name}"
        elif text is not None:
            named = True
            if not re.search(rf"\b{re.escape(name.split('::')[-1])}\b", text):
                yield f"no {name} there"
    if not named:
        yield "no function"


def test_errors(cell, known_tests, known_faults):
    named = re.findall(r"`([^`]+)`", cell)
    seeded = re.findall(r'"([^"]+)"', cell)
    yield from (f"no test {name}" for name in named if "/" not in name and name not in known_tests)
    yield from (f"no file {name}" for name in named if "/" in name and not (ROOT / name).exists())
    yield from (f'no seeded fault "{name}" that is found' for name in seeded if name not in known_faults)
    if not named and not seeded and cell != "no test":
        yield "neither a test nor \"no test\""


def main():
    text = DOCUMENT.read_text()
    known_tests, known_faults = tests(), faults()
    errors, rows = [], {}
    for number, row in tables(text):
        found = list(test_errors(row.get("test", ""), known_tests, known_faults))
        if "function" in row:
            found += function_errors(row["function"])
        if "rule" in row:
            rows[row["rule"].split()[0]] = number
        errors += [f"{DOCUMENT.name}:{number}: {error}" for error in found]
    rules = set(RULE.findall(text))
    errors += [f"{DOCUMENT.name}: Rule {rule} has no row" for rule in sorted(rules - rows.keys())]
    errors += [f"{DOCUMENT.name}:{rows[rule]}: no Rule {rule}" for rule in sorted(rows.keys() - rules)]
    if not rows:
        errors.append(f"{DOCUMENT.name}: no table of rules")
    for error in errors:
        print(error)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
