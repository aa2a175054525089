#!/usr/bin/env python3
"""Runs the commands of a document, in one folder and in their order.

Every block that is marked `sh` is run by bash; where the next block is marked `text`, that is what
it must print. Commands may be refuted: their exit codes are printed by the document itself.

usage: commands_test.py PROGRAM DOCUMENT
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def main():
    program, document = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", document.read_text(), re.M | re.S)
    commands = [k for k, (kind, _) in enumerate(blocks) if kind == "sh"]
    if not commands:
        sys.exit(f"{document.name}: no commands")
    environment = dict(os.environ, PATH=f"{program.parent}{os.pathsep}{os.environ['PATH']}")
    with tempfile.TemporaryDirectory() as folder:
        for k in commands:
            done = subprocess.run(["bash", "-euc", blocks[k][1]], cwd=folder, env=environment,
                                  capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{document.name}: exit code {done.returncode}\n{blocks[k][1]}\n{done.stderr}")
            expected = blocks[k + 1] if k + 1 < len(blocks) else ("", "")
            if expected[0] == "text" and done.stdout != expected[1]:
                sys.exit(f"{document.name}: prints\n{done.stdout}\ninstead of\n{expected[1]}\n{blocks[k][1]}")
    print(f"{document.name}: {len(commands)} blocks")


main()
