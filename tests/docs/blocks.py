"""The blocks of code of a document, and how they are run.

A block that is marked `sh` is commands, for bash. One that is marked `sh installed`, `python installed` or
`cpp installed` takes installed packages: it is run by installed_test.py. A program in C++ becomes the file main.cpp, which
the commands behind it compile. Where the next block is marked `text`, that is what it must print.
"""
import re
import subprocess
import sys
from typing import NamedTuple


# Commands and programs that take installed packages, and all marks of blocks.
INSTALLED = ("sh installed", "python installed", "cpp installed")
MARKS = ("", "indented", "sh", *INSTALLED, "text", "json", "jsonl")


class Block(NamedTuple):
    mark: str     # "" for a block in fences without one, "indented" for one without fences
    body: str
    section: str  # the heading above it


def blocks_of(text):
    found = []
    section = ""
    for match in re.finditer(r"^#+ ([^\n]*)$|^```([\w ]*)\n(.*?)^```$|(?:(?<=\n\n)|\A)((?:    [^\n]*\n|\n(?=    ))+)", text,
                             re.M | re.S):
        if match[1] is not None:
            section = match[1]
        elif match[4] is not None:
            found.append(Block("indented", re.sub(r"^    ", "", match[4], flags=re.M), section))
        else:
            found.append(Block(match[2], match[3], section))
    return found


def command_of(block, folder):
    """The command that runs the block; None for a program in C++, which is written for the commands behind it."""
    if block.mark.startswith("sh"):
        return ["bash", "-euc", block.body]
    if block.mark.startswith("python"):
        return ["python3", "-c", block.body]
    (folder / "main.cpp").write_text(block.body)
    return None


def run_blocks(name, blocks, marks, folder, environment, missing=()):
    """Runs the blocks that have one of the marks, in their order, in one folder, but for those with a text of `missing`.
    Returns how many were run, and how many passed over. Ends the program where one fails or prints anything else than the
    document says."""
    run = passed = 0
    for k, block in enumerate(blocks):
        if block.mark not in marks:
            continue
        if any(text in block.body for text in missing):
            passed += 1
            continue
        run += 1
        command = command_of(block, folder)
        if command is None:
            continue
        done = subprocess.run(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{name}: exit code {done.returncode}\n{block.body}\n{done.stderr}")
        if k + 1 < len(blocks) and blocks[k + 1].mark == "text" and done.stdout != blocks[k + 1].body:
            sys.exit(f"{name}: prints\n{done.stdout}\ninstead of\n{blocks[k + 1].body}\n{block.body}")
    return run, passed
