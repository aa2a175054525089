#!/usr/bin/env python3
"""Decides again what lines of the truth set say, and prints those that are wrong.

usage: oracle.py [--sample K --seed S] [--slice I/N] FILE...     (plain or .gz)

Each line, or K random ones of each file, is decided in integers from the definitions of
corpus/truth/README.md; nothing is rounded and nothing of the program is used. --slice takes the I-th of N equal
shares of a file's lines, I from 1. Prints `FILE:LINE: reason` for each wrong line, and for each file
`NAME: n lines, w wrong`. The exit code is 1 if a line is wrong, 2 if one is not of the format.
"""
import argparse
import gzip
import random
import sys
from itertools import chain

sys.dont_write_bytecode = True

import cells
import circle
import contact
import moments
from fields import Fields, Malformed, Wrong, admissible, integers, scaled
from flip import cotangency
from polynomial import before, dyadic

SIGNS = {"-1": -1, "0": 0, "1": 1}
PRECISIONS = {"0"} | {str(53 << k) for k in range(16)}


def expect(found, said, what):
    if found != said:
        raise Wrong(f"{what} is {found}, not {said}")


def checked(generators):
    admissible(generators)
    return scaled(generators)


def incircle(fields):
    said = SIGNS[fields.word(*SIGNS)]
    read = fields.generators(4)
    fields.end()
    generators = checked(read)
    circle.require_no_overlap(generators)
    found = circle.circle(generators[:3])
    if found is None:
        raise Wrong("the circle of the first three does not exist")
    expect(found.gap(generators[3]), said, "the sign")
    return said == 0


def exists(fields):
    said = SIGNS[fields.word(*SIGNS)]
    read = fields.generators(3)
    fields.end()
    three = checked(read)
    circle.require_no_overlap(three)
    expect(1 if circle.circle(three) else 0 if circle.is_line(three) else -1, said, "the sign")
    return said == 0


def times(fields):
    return fields.number(), fields.number()


def contact_line(fields):
    kind = fields.word("none", "graze", "hit")
    low, high = (fields.word("-"), fields.word("-")) if kind == "none" else times(fields)
    read = fields.generators(2, rates=True)
    fields.end()
    pair = checked(read)
    if "d" not in (pair[0][0], pair[1][0]):
        raise Wrong("no disk")
    if any(g[6] < 0 for g in pair):
        raise Wrong("a radius shrinks")
    found, time = contact.first_contact(*contact.room(*pair))
    expect(found, kind, "the kind")
    if time:
        sides = contact.compare(time, low), contact.compare(time, high)
        moments.require_neighbours(low, high)
        expect(sides, (0, 0) if low == high else (1, -1), "the place of the time between LO and HI")
    return kind == "graze"


def collapse(fields):
    first = SIGNS[fields.word("-1", "1")]
    said = [(*times(fields), fields.integer(1, 99), SIGNS[fields.word("-1", "1")])
            for _ in range(fields.integer(0, 99))]
    window = times(fields)
    read = fields.generators(4, rates=True)
    fields.end()
    generators = checked(read)
    if not window[0] < window[1]:
        raise Wrong("an empty window")
    sign, zeros = moments.zeros_of_gap(generators, dyadic(window[0]), dyadic(window[1]))
    expect(sign, first, "the first sign")
    expect(len(zeros), len(said), "the number of zeros")
    for number, ((root, *found), (low, high, *claimed)) in enumerate(zip(zeros, said), 1):
        moments.require_neighbours(low, high)
        if not moments.is_rounded(root, low, high):
            raise Wrong(f"time {number} is not between LO and HI")
        expect(found, claimed, f"the order of zero {number} and the sign after it")
    return any(order > 1 for _, order, _ in zeros)


def rootorder(fields):
    said = SIGNS[fields.word(*SIGNS)]
    windows, fours = [], []
    for _ in range(2):
        windows.append(times(fields))
        fours.append([fields.integer(0, 10**6) for _ in range(4)])
    count = fields.integer(1, 10**6)
    read = fields.generators(count, rates=True)
    fields.end()
    if any(i >= count for four in fours for i in four) or any(len(set(four)) < 4 for four in fours):
        raise Malformed("numbers of generators that are not four of those of the line")
    generators = checked(read)
    roots = []
    for (start, stop), four in zip(windows, fours):
        start, stop = dyadic(start), dyadic(stop)
        if not before(start, stop):
            raise Wrong("an empty window")
        roots.append(moments.single_root(cotangency([generators[i] for i in four]), start, stop))
    expect(moments.order_of(*roots), said, "the order")
    return said == 0


def static(fields):
    frame = fields.numbers(3) if fields.word("p", "c") == "c" else None
    disks = [fields.numbers(3) for _ in range(fields.integer(0, 10**6))]
    pairs = [(fields.integer(-1, len(disks) - 1), fields.integer(0, len(disks) - 1))
             for _ in range(fields.integer(0, 10**6))]
    gone = [fields.integer(0, len(disks) - 1) for _ in range(fields.integer(0, len(disks)))]
    fields.end()
    admissible([("d", disk) for disk in disks] + ([("c", frame)] if frame else []))
    flat = integers(list(chain(*disks, frame or [])))
    whole = [flat[i:i + 3] for i in range(0, len(flat), 3)]
    container = whole.pop() if frame else None
    hidden = cells.hidden(container, whole)
    expect(sorted(hidden), gone, "the list of hidden disks")
    edges = cells.edges(container, whole, hidden)
    for pair in edges:
        if pair not in pairs:
            raise Wrong(f"the edge {pair[0]} {pair[1]} is missing")
    for pair in pairs:
        if pair not in edges:
            raise Wrong(f"there is no edge {pair[0]} {pair[1]}")
    if edges != pairs:
        raise Wrong("the edges are not sorted, or one is there twice")
    return False


KINDS = {"incircle": incircle, "exists": exists, "contact": contact_line, "collapse": collapse,
         "rootorder": rootorder, "static": static}


def check(name, line):
    """Raises Wrong or Malformed, unless the line is right.

    Each kind says whether its answer is an exact zero, a graze or a multiple root: intervals decide none of these.
    """
    fields = Fields(line)
    fields.word()
    bits = fields.word(*PRECISIONS)
    proof = fields.word("interval", "exact")
    zero = KINDS[name](fields)
    if zero and (bits != "0" or proof != "exact"):
        raise Wrong("an exact zero that intervals are said to decide")
    if proof == "interval" and bits == "0":
        raise Wrong("intervals decide, but at no precision")


def lines_of(file):
    """The name of the set in the first line, and (number, line) of all lines that are no comments."""
    head = file.readline().rstrip("\n").split(" ")
    if head[:2] != ["#", "voroproof-truth"] or len(head) != 4 or head[2] not in KINDS:
        raise Malformed("the first line is not `# voroproof-truth NAME VERSION`")
    rest = ((number, line.rstrip("\n")) for number, line in enumerate(file, 2) if not line.startswith("#"))
    return head[2], rest


def chosen(lines, options, path):
    """The share and the sample that the options ask for."""
    share, shares = options.slice
    lines = (line for index, line in enumerate(lines) if index % shares == share - 1)
    if options.sample is None:
        return lines
    # Each file has its own seed: a sample does not depend on the files before it.
    source, kept = random.Random(f"{options.seed} {path.rsplit('/', 1)[-1]}"), []
    for index, line in enumerate(lines):
        if index < options.sample:
            kept.append(line)
        else:
            place = source.randrange(index + 1)
            if place < options.sample:
                kept[place] = line
    return sorted(kept)


def run_file(path, options):
    """The exit code for one file."""
    code = count = wrong = 0
    with (gzip.open if path.endswith(".gz") else open)(path, "rt", encoding="ascii", newline="\n") as file:
        name, lines = lines_of(file)
        for number, line in chosen(lines, options, path):
            count += 1
            try:
                check(name, line)
            except Wrong as reason:
                wrong, code = wrong + 1, max(code, 1)
                print(f"{path}:{number}: {reason}")
            except Malformed as reason:
                wrong, code = wrong + 1, 2
                print(f"{path}:{number}: malformed: {reason}")
    print(f"{name}: {count} lines, {wrong} wrong", flush=True)
    return code


def share_of(text):
    share, shares = (int(part) for part in text.split("/"))
    if not 1 <= share <= shares:
        raise ValueError
    return share, shares


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", metavar="FILE", nargs="+")
    parser.add_argument("--sample", type=int, metavar="K", help="K random lines of each file")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of the sample")
    parser.add_argument("--slice", type=share_of, default=(1, 1), metavar="I/N", help="the I-th of N shares")
    options = parser.parse_args()
    code = 0
    for path in options.files:
        try:
            code = max(code, run_file(path, options))
        except (Malformed, OSError, EOFError, UnicodeDecodeError) as error:
            print(f"{path}: {error}")
            code = 2
    sys.exit(code)


if __name__ == "__main__":
    main()
