#!/usr/bin/env python3
"""Runs the paths of the documents' readers where the packages are installed and no source tree is.

Each document is run whole, in a fresh folder: those of its blocks that are commands or take an installation (blocks.py).
Each path that is named below must have a block of its own in it.

usage: installed_test.py [FOLDER]      the documents' folder, by default that of the package voroproof-doc
"""
import os
import pathlib
import sys
import tempfile

from blocks import INSTALLED, blocks_of, run_blocks

# Who it is for: document, section, and the mark of the blocks that are the path.
PATHS = {
    "engine": ("docs/howto.md", "I have an engine of my own", "sh"),
    "Python": ("docs/howto.md", "I program in Python", "python installed"),
    "C++": ("docs/howto.md", "I program in C++", "cpp installed"),
    "hundred scenes": ("docs/howto.md", "I have a hundred scenes", "sh"),
    "teacher": ("docs/howto.md", "I teach", "sh"),
    "EDMD": ("docs/others.md", "Event-driven molecular dynamics", "sh"),
    "CCBS": ("docs/others.md", "Planners", "sh"),
}


def run_document(name, text):
    with tempfile.TemporaryDirectory() as folder:
        run_blocks(name, blocks_of(text), ("sh", *INSTALLED), pathlib.Path(folder), dict(os.environ, MPLBACKEND="agg"))


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "/usr/share/doc/voroproof")
    texts = {name: (root / name).read_text() for name in {document for document, _, _ in PATHS.values()}}
    for who, (document, section, mark) in PATHS.items():
        own = [block for block in blocks_of(texts[document]) if block.section == section and block.mark == mark]
        if not own:
            sys.exit(f"{document}: nothing marked '{mark}' below '{section}', the path of {who}")
        print(f"{who}: {document}, {section}, {sum(len(block.body.splitlines()) for block in own)} lines")
    for name, text in sorted(texts.items()):
        run_document(name, text)
    print(f"installed_test: {len(PATHS)} paths, by the packages alone")


main()
