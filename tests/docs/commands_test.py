#!/usr/bin/env python3
"""Runs the commands of documents: of each in a fresh folder, in their order.

Every block that is marked `sh` is run (blocks.py), as `voroproof` and as `build/voroproof`. The files in a document's own folder of pictures
(start/ of start.md) must have the bytes that it draws.

A block that is not marked and has a line with a command is one that is not run. It must be named in
NOT_RUN, with the reason; a name there without a block is an error as well.

Blocks with the Python module's commands take --python, its interpreter and the folder of the module; without that they are
passed over, and counted. Documents that take a program with the page, which is made where Emscripten is, come behind
--page; without that they are named, and passed over.

usage: commands_test.py [--python PYTHON FOLDER] PROGRAM DOCUMENT... [--page | --no-page DOCUMENT...]
"""
import os
import pathlib
import re
import sys
import tempfile

from blocks import MARKS, blocks_of, run_blocks

ROOT = pathlib.Path(__file__).resolve().parents[2]

# How the line of a command begins, in a block that is not marked.
COMMAND = re.compile(r"^(\$ )?(((sudo|apt|apt-get|make|cmake|cpack|git|tar|c\+\+|pip|python3|man|cat|sed) "
                     r"|(scripts|tests|bench)/|PYTHONPATH=)|(build/)?(proofs/)?voroproof(-kernel|-proved)? )", re.M)

# Document: the first line of a block that is not run, and why.
NOT_RUN = {
    "README.md": {
        "make demo": "installs packages and builds",
    },
    "docs/start.md": {
        "voroproof movie a.scene.json a.history.jsonl -o a.html": "the page is for looking at; make site makes one",
    },
    "docs/howto.md": {
        "scripts/install-deps.sh python": "installs packages",
        "cmake --install build --prefix PREFIX": "installs; the test of the library's consumer does so",
        "build/voroproof corpus run --against 'mysim {scene} {history}' --html corpus.html":
            "takes an engine of the reader's",
        "build/voroproof minimize gas.scene.json --against 'mysim {scene} {history}' -o small.scene.json":
            "takes an engine of the reader's",
        "make packages": "installs packages and needs root",
    },
    "docs/install.md": {
        "scripts/install-deps.sh python packages": "installs packages and builds; scripts/check-packages.sh makes a wheel",
        "scripts/install-deps.sh browser": "installs packages and builds; the test certifier_npm asks the package",
        "make packages": "installs packages and needs root",
        "apt install ./packages/*.deb": "installs packages",
        "tar -xf voroproof-0.1.0-linux-x86_64.tar.gz": "takes an archive, which scripts/check-packages.sh makes and tries",
        "cmake -B build -G Ninja && cmake --build build && cmake --install build --prefix PREFIX": "builds and installs",
    },
    "docs/library.md": {
        "cmake --install build --prefix PREFIX": "installs; the test of the library's consumer does so",
        "find_package(voroproof 0.1 REQUIRED)": "needs an installed library; as above",
    },
    "docs/others.md": {
        "python3 -m voroproof.importers jupedsim trajectories.sqlite --radius 0.2 -o a.csv && "
        "voroproof clearance a.csv --vanish --required 0":
            "takes files of other repositories",
    },
    "docs/cluster.md": {
        "sbatch --wait --array=1-16 packaging/cluster/certify_array.sh a.scene.json a.history.jsonl a.shards":
            "takes a Slurm; tests/cluster/slurm.py has one",
    },
    "docs/python.md": {
        "scripts/install-deps.sh python": "installs packages and builds",
    },
}


# The marks of blocks that take the Python module.
PYTHON = ("python3 -m voroproof", "import voroproof")


def check_named(name, blocks):
    """That each block of commands that is not run is named, and the other way round; and that marks are known."""
    for block in blocks:
        if block.mark not in MARKS:
            sys.exit(f"{name}: the mark '{block.mark}' of a block says nothing: {block.body.splitlines()[0]}")
    unmarked = {block.body.split("\n", 1)[0] for block in blocks
                if block.mark in ("", "indented") and COMMAND.search(block.body)}
    reasons = NOT_RUN.get(name, {})
    for line in sorted(unmarked - set(reasons)):
        sys.exit(f"{name}: this block is neither run nor named in NOT_RUN: {line}")
    for line in sorted(set(reasons) - unmarked):
        sys.exit(f"{name}: NOT_RUN names a block that is not there: {line}")


def check_pictures(name, document, folder):
    """That the document's pictures are what it draws."""
    for kept in sorted(document.with_suffix("").glob("*")):
        drawn = folder / kept.name
        if not drawn.exists() or drawn.read_bytes() != kept.read_bytes():
            sys.exit(f"{name}: {kept.relative_to(ROOT)} is not what its commands draw")


def make_python(folder, python):
    """A folder with a python3 that is the module's interpreter, and finds the module."""
    interpreter, module = python
    folder.mkdir()
    wrapper = folder / "python3"
    wrapper.write_text(f"#!/bin/sh\nPYTHONPATH='{module}' exec '{interpreter}' -B \"$@\"\n")
    wrapper.chmod(0o755)
    return folder


def check(program, document, python):
    name = str(document.relative_to(ROOT))
    blocks = blocks_of(document.read_text())
    check_named(name, blocks)
    environment = dict(os.environ, PATH=f"{program.parent}{os.pathsep}{os.environ['PATH']}")
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        (folder / "build").symlink_to(program.parent)
        if python is not None:
            environment["PATH"] = f"{make_python(folder / '.python', python)}{os.pathsep}{environment['PATH']}"
        run, passed = run_blocks(name, blocks, ("sh",), folder, environment, PYTHON if python is None else ())
        check_pictures(name, document, folder)
    print(f"{name}: {run} blocks" + (f", {passed} passed over: no Python module" if passed else ""))


def main():
    arguments, python = sys.argv[1:], None
    if arguments[0] == "--python":
        python, arguments = arguments[1:3], arguments[3:]
    has_page = "--page" in arguments
    place = arguments.index("--page" if has_page else "--no-page")
    program, *documents = (pathlib.Path(p).resolve() for p in arguments[:place])
    with_page = [pathlib.Path(p).resolve() for p in arguments[place + 1:]]
    for document in documents + (with_page if has_page else []):
        check(program, document, python)
    if not has_page:
        print("passed over, without the page: " + ", ".join(document.name for document in with_page))
    documents += with_page
    names = {str(d.relative_to(ROOT)) for d in documents}
    marked = {str(d.relative_to(ROOT)) for d in [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
              if re.search(r"^```sh$", d.read_text(), re.M)}
    for name in sorted((marked | set(NOT_RUN)) - names):
        sys.exit(f"{name} has commands, and is not looked at")


main()
