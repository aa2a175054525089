#!/usr/bin/env python3
"""That the examples in documents are what they say.

Each block of code of README.md, docs/ and corpus/ that is marked `json` or `jsonl` is a whole file of one
of the formats: its schema accepts it, and `voroproof validate` does, where it knows the format. An
excerpt is marked `json excerpt`. The first examples of docs/formats.md are those that the program makes of
the scene there.

usage: documents.py PROGRAM
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    from schemas import Files
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[2]
VALIDATED = ["voroproof-scene", "voroproof-history", "voroproof-diagram", "voroproof-plan"]
BLOCK = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def documents():
    return [ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md")), *sorted(ROOT.glob("corpus/**/*.md"))]


def run(folder, *arguments):
    return subprocess.run(arguments, cwd=folder, capture_output=True, text=True)


def judge(program, folder, files, mark, text):
    """(the format that a block names, what is wrong with it or None)"""
    try:
        head = json.loads(text if mark == "json" else text.splitlines()[0])
        name = head["format"]
    except (ValueError, KeyError, TypeError) as error:
        return None, f"no file of a format: {error!r}"
    fault = files.fault(text)
    if fault is None and name in VALIDATED:
        path = folder / f"example.{mark}"
        path.write_text(text)
        done = run(folder, program, "validate", path)
        if done.returncode != 0:
            fault = done.stderr.strip()
    return name, fault


def made_by_program(program, folder, examples):
    """Which examples of docs/formats.md the program does not make of the scene there."""
    (folder / "a.scene.json").write_text(examples["voroproof-scene"])
    query = json.loads(examples["voroproof-answer"])
    for command in ("simulate a.scene.json -o voroproof-history",
                    f"snapshot a.scene.json voroproof-history --at {query['t']} -o voroproof-diagram",
                    f"query {query['query']} a.scene.json --at {query['t']} --probe {query['probe']} -o voroproof-answer"):
        done = run(folder, program, *command.split())
        assert done.returncode == 0, done.stderr
    for name in ("voroproof-history", "voroproof-diagram", "voroproof-answer"):
        if (folder / name).read_text() != examples[name]:
            yield f"docs/formats.md: the program makes another {name} of the scene"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    files = Files()
    faults, found = [], 0
    examples = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for document in documents():
            where = document.relative_to(ROOT)
            text = document.read_text()
            for mark, block in BLOCK.findall(text):
                if mark in ("json", "jsonl"):
                    found += 1
                    kind, fault = judge(program, folder, files, mark, block)
                    if fault is not None:
                        faults.append(f"{where}: {block[:40]!r}: {fault}")
                    if where.name == "formats.md":
                        examples.setdefault(kind, block)  # a later one of a kind is one of a world
            # An example without a mark would not be looked at. What commands write is (docs/commands_test.py).
            unmarked = BLOCK.sub(lambda m: "" if m[1].startswith(("json", "sh")) else m[2], text)
            for line in unmarked.splitlines():
                if re.search(r'^\s*\{"format": ?"voroproof-', line):
                    faults.append(f"{where}: not marked as json: {line[:60]}")
        if not faults:
            faults.extend(made_by_program(program, folder, examples))
    print("\n".join([*faults, f"{found} examples, {len(faults)} faults"]))
    return 1 if faults or not found else 0


if __name__ == "__main__":
    sys.exit(main())
