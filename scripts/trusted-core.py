#!/usr/bin/env python3
"""Writes the line counts of the trusted core (docs/certificate.md, section 10) anew.

usage: scripts/trusted-core.py [--check]

With --check nothing is written: it fails where a count is another one, or a file is gone.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "certificate.md"


def main():
    total = 0

    def counted(row):
        nonlocal total
        lines = 0

        def count(file):
            nonlocal lines
            n = (ROOT / file[1]).read_bytes().count(b"\n")
            lines += n
            return f"`{file[1]}` {n}"

        files = re.sub(r"`([\w/.]+)` \d+", count, row[2])
        total += lines
        return f"{row[1]}{files}| {lines:,} |"

    old = DOCUMENT.read_text()
    new = re.sub(r"^(\| [^|`]+ \| )(`[\w/.]+` \d+, [^|]*)\| [\d,]+ \|$", counted, old, flags=re.M)
    new = re.sub(r"^\| all \| \| [\d,]+ \|$", f"| all | | {total:,} |", new, flags=re.M)
    if "--check" not in sys.argv[1:]:
        DOCUMENT.write_text(new)
    elif old != new:
        sys.exit(f"{DOCUMENT.name}: the trusted core has other line counts: "
                 "scripts/trusted-core.py writes them anew")


if __name__ == "__main__":
    main()
