"""The answers of `clearance` and of a judge by brute force, on random tables and on transformed ones.

    agreement.py PROGRAM [FIRST_SEED] [TABLES]

For each seed the least gap, where and when it is, all spells below some distance, and the verdicts on distances just
below the least gap, at it and just above it must be those of the judge, or a gap that is too near to be told. After an
exact transformation the same must be said. Counts by kind on standard output; exit code 1 after a disagreement.
"""

import collections
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from fractions import Fraction
from itertools import islice

import scenes
from judge import PairJudge, encloses, first_times, lacks_frames
from polynomials import value

ZERO, HALF = Fraction(0), Fraction(1, 2)
LIMIT = Fraction(10 ** 100)  # numbers have no greater magnitude


def written(x, rng):
    """A number in one of the exact spellings."""
    if x.denominator == 1 and rng.random() < 0.5:
        return rng.choice((f"{x.numerator}", f"{x.numerator}.0", f"{x.numerator}e0", f"{10 * x.numerator}e-1"))
    tens = 10 ** 12
    if (x * tens).denominator == 1 and abs(x) < 10 ** 6 and rng.random() < 0.5:
        return f"{int(x * tens)}e-12"
    return f"{x.numerator}/{x.denominator}"


def text_of(table, seed):
    rng = random.Random(seed)
    axes = "xyz"[:table.dimension]
    lines = []
    if any(table.sides):
        lines.append("# periodic: " + ",".join("none" if s is None else written(s, rng) for s in table.sides))
    columns = list(axes)
    if table.pieces:
        degrees = [max(len(row[2][k]) for _, _, rows in table.disks for row in rows) for k in range(table.dimension)]
        columns = [f"{a}^{k}" for a, n in zip(axes, degrees) for k in range(n)]
    lines.append(",".join(["disk", "t"] + ["duration"] * table.pieces + columns + ["radius"]))
    for name, radius, rows in table.disks:
        for row in rows:
            cells = [*row[:-1], *row[-1]]
            if table.pieces:
                cells = [*row[:-1]] + [c for p, n in zip(row[2], degrees) for c in p + [ZERO] * (n - len(p))]
            lines.append(",".join([name] + [written(Fraction(c), rng) for c in cells + [radius]]))
    return "\n".join(lines) + "\n"


class ToldClearance:
    """The answer of the program; numbers are fractions."""

    def __init__(self, program, folder, table, seed, below=None, required=None, may_touch=False):
        path, answer = os.path.join(folder, "table.csv"), os.path.join(folder, "answer.json")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text_of(table, seed))
        command = [program, "clearance", path, "-o", answer]
        for option, x in (("--below", below), ("--required", required), ("--height", table.height)):
            if x is not None:
                command += [option, f"{x.numerator}/{x.denominator}"]
        command += ["--frames-only"] * table.frames + ["--may-touch"] * may_touch
        command += [f"--{table.beyond}"] if table.beyond else []
        run = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
        self.words = run.stdout + run.stderr
        self.verdict = run.stdout.rstrip().rsplit("\n", 1)[-1] if required is not None else ""
        if run.returncode not in (0, 1, 3):
            raise ValueError(f"exit {run.returncode}: {run.stderr}")
        with open(answer, encoding="utf-8") as file:
            data = json.load(file)
        names = {name: k for k, (name, _, _) in enumerate(table.disks)}
        self.least = ToldApproach(data["least"], names) if "least" in data else None
        self.spells = [(pair(s["from"]), pair(s["to"]), ToldApproach(s["least"], names))
                       for s in data.get("approaches", [])]


def pair(x):
    return [Fraction(y) for y in x] if isinstance(x, list) else [Fraction(x)] * 2


class ToldApproach:
    def __init__(self, data, names):
        self.i, self.j = (names[d["disk"]] for d in data["disks"])
        self.is_exact = not isinstance(data["t"], list) and not isinstance(data["distance_squared"], list)
        self.t, self.square, self.gap = pair(data["t"]), pair(data["distance_squared"]), pair(data["gap"])
        self.image = tuple(data["image"]) if "image" in data else None

    def key(self, table):
        return self.i, self.j, self.image or (0,) * table.dimension


def spacing(x):
    """The distance of doubles about a number."""
    return Fraction(math.ulp(float(abs(x))))


def least_faults(judge, told):
    """The faults of the least gap that is told."""
    least = told.least
    if least is None:
        if not judge.keeps(Fraction(10) ** 101, True):
            yield "no gap is told, and there is one"
        return
    table = judge.table
    reach = judge.radii[least.i] + judge.radii[least.j]
    if not judge.keeps(least.gap[0], True):
        yield "a gap is less than the least one that is told"
    size = abs(least.gap[0]) + reach
    # Where heights count, gaps may only come as near to it as one likes.
    if judge.keeps(least.gap[1] + (size / 2 ** 60 if table.height else 0), False):
        yield "no gap is as small as the least one that is told"
    if least.gap[1] - least.gap[0] > sum(2 * spacing(x) for x in least.gap) + size / 2 ** 60:
        yield "wide: the least gap"
    if least.t[1] - least.t[0] > 2 * spacing(least.t[0]) + 2 * spacing(least.t[1]):
        yield "wide: the time of the least gap"
    if judge.is_straight and not least.is_exact:
        yield "of straight ways, and not exact"
    i, j, image = least.key(table)
    ways = [w for w in judge.common if (w.i, w.j) == (i, j) and w.u <= least.t[1] and w.v >= least.t[0]]
    squares = []
    for way in ways:
        square, _ = judge.square(way, image)
        here = least.t[0] if least.is_exact else (max(least.t[0], way.u) + min(least.t[1], way.v)) / 2
        squares.append((way, square, value(square, (here - way.u) / (way.v - way.u)) if way.u < way.v else None))
    if not squares:
        yield "no such pair at that time"
    if not least.is_exact:
        return
    if not any(at == least.square[0] or at is None for _, _, at in squares):
        yield "another distance at that time"
    square, above = least.square[0], Fraction(math.isqrt(int(least.square[0] * 4 ** 400)) + 1, 2 ** 400)
    for way in judge.common:
        if way.reach == reach:
            for rival in judge.nearer(way, square, above, True):
                yield f"nearer: {way.i} {way.j} at {rival[1]}"
            for _, _, excess, heights in judge.nearer(way, square, above, False):
                if heights is None and first_times(way, excess, least.t[0]):
                    yield f"earlier: {way.i} {way.j}"


def spell_faults(judge, told, below):
    """The faults of the spells that are told."""
    table = judge.table
    lists = {}
    for begin, end, least in told.spells:
        lists.setdefault(least.key(table), []).append((begin, end, least))
    true = judge.spells(below)
    for key in sorted(set(true) | set(lists)):
        own, others = true.get(key, []), sorted(lists.get(key, []), key=lambda s: (s[0], s[1]))
        if table.frames:
            # Two that both stay are near for a while.
            instants, told_times = [s[0][0].u for s in own], [(o[0][0], o[1][1]) for o in others]
            if key[0] < key[1] and not (all(any(a <= t <= b for a, b in told_times) for t in instants) and
                                        all(any(a <= t <= b for t in instants) for a, b in told_times)):
                yield f"frames: {key}"
            continue
        if len(own) != len(others):
            yield f"{len(others)} spells, not {len(own)}: {key}"
            continue
        for (first, last), (begin, end, least) in zip(own, others):
            if not encloses(first, True, *begin) or not encloses(last, False, *end):
                yield f"a spell has other ends: {key}"
            if least.gap[0] >= below or least.t[1] < begin[0] or least.t[0] > end[1]:
                yield f"the least gap of a spell: {key}"
            if any(e[1] - e[0] > 4 * spacing(e[0]) + abs(last[0].v) / 2 ** 70 for e in (begin, end)):
                yield f"wide: the ends of a spell: {key}"


def verdict_faults(judge, told, required, may_touch):
    strict = required != 0 or may_touch
    is_free = judge.keeps(required, strict)
    if judge.table.frames and lacks_frames(judge.table):
        if told.verdict != ("s UNDECIDED" if is_free else "s REFUTED"):
            yield f"{told.verdict}, and a disk lacks a frame"
        return
    if told.verdict == "s FREE" and (not is_free or told.least is None):
        yield f"FREE, and a gap is not {float(required)}"
    if told.verdict == "s REFUTED" and is_free:
        yield f"REFUTED, and all gaps are {float(required)}"
    if told.verdict == "s UNDECIDED" and told.least is not None:
        size = max(judge.radii) * 2 + abs(required) + abs(told.least.gap[0])
        if judge.is_straight:
            yield f"UNDECIDED of straight ways: {float(required)}"
        elif not judge.keeps(required - size / 2 ** 50, True) or judge.keeps(required + size / 2 ** 50, True):
            yield f"UNDECIDED far from the least gap: {float(required)}"


def required_gaps(judge, least, rng):
    """Just below the least gap, at it, just above it, and 0."""
    if least is None:
        return []
    reach = judge.radii[least.i] + judge.radii[least.j]
    root = Fraction(math.isqrt(int(least.square[0] * 4 ** 500)), 2 ** 500)
    near = reach / 2 ** 120 + abs(least.gap[0]) / 2 ** 100
    gaps = [ZERO, root - reach, root - reach + rng.choice((-near, near)), rng.choice(least.gap)]
    return [g for g in gaps if g == 0 or 1 / LIMIT <= abs(g) <= LIMIT]


def changes(table, rng):
    """Transformed tables: what the transformation is called, the table, and the factors of length and time."""
    length, time = Fraction(1, 2 ** 40), Fraction(2 ** 20)
    yield "scaled", scenes.scaled(table, length, time), length, time
    by = [Fraction(rng.randint(-9, 9), 4) * (side or 1) for side in table.sides]
    yield "moved", scenes.moved(table, by), 1, 1
    yield "mirrored", scenes.mirrored(table), 1, 1
    yield "exchanged", scenes.exchanged(table), 1, 1
    yield "relabelled", scenes.relabelled(table), 1, 1
    if any(table.sides):
        yield "folded", scenes.folded(table, rng, 50), 1, 1
    if not table.frames:
        yield "split", scenes.split_all(table), 1, 1
        if not table.pieces and all(len(rows) > 1 for _, _, rows in table.disks):
            yield "as pieces", scenes.as_pieces(table), 1, 1


def meet(a, b, factor=1):
    return a[0] * factor <= b[1] and b[0] <= a[1] * factor


def same(told, other, length, time):
    """The difference in the answer for a transformed table, or None."""
    if (told.least is None) != (other.least is None):
        return "another least gap"
    if told.least:
        a, b = told.least, other.least
        if not meet(a.gap, b.gap, length):
            return "another least gap"
        if a.is_exact and b.is_exact and a.square[0] * length ** 2 != b.square[0] and {a.i, a.j} == {b.i, b.j}:
            return "another square"
        if not meet(a.t, b.t, time) and a.is_exact and b.is_exact:
            return "another time"
    if len(told.spells) != len(other.spells):
        return "other spells"
    for begin, end, _ in told.spells:
        if not any(meet(begin, o[0], time) and meet(end, o[1], time) for o in other.spells):
            return "a spell of other ends"
    return None


def table_faults(program, folder, seed, counts):
    kind, table = scenes.make(seed)
    counts[kind] += 1
    rng = random.Random(-seed - 1)
    judge = PairJudge(table)
    reach = max((way.reach for way in judge.common), default=ZERO) or Fraction(1)
    below = reach * rng.choice((HALF, 1, 2, 2, Fraction(1, 2 ** 70), Fraction(1, 2 ** 180)))
    if below < LIMIT ** -1:
        below = reach
    if any(table.sides):
        below = min(below, 2 * min(s for s in table.sides if s is not None))
    told = ToldClearance(program, folder, table, seed, below, ZERO)
    counts["exact" if told.least and told.least.is_exact else "enclosed" if told.least else "without a gap"] += 1
    counts["spells"] += len(told.spells)
    yield from ((kind, f) for f in least_faults(judge, told))
    yield from ((kind, f"below {below}: {f}") for f in spell_faults(judge, told, below))
    yield from ((kind, f) for f in verdict_faults(judge, told, ZERO, False))
    gaps = required_gaps(judge, told.least, rng)
    for required in rng.sample(gaps, min(2, len(gaps))):
        may_touch = rng.random() < 0.5
        said = ToldClearance(program, folder, table, seed, None, required, may_touch)
        counts[said.verdict] += 1
        yield from ((kind, f) for f in verdict_faults(judge, said, required, may_touch))
    others = list(changes(table, rng))
    for name, other, length, time in rng.sample(others, 2):
        if not scenes.in_limits(other):
            continue
        fault = same(told, ToldClearance(program, folder, other, seed, below * length), length, time)
        counts[name] += 1
        if fault:
            yield kind, f"{name}: {fault}"


def main():
    program = sys.argv[1]
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 0
    tables = int(sys.argv[3]) if len(sys.argv) > 3 else 100
    counts, disagreements = collections.Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + tables):
            for kind, fault in islice(table_faults(program, folder, seed, counts), 8):
                print(f"seed {seed}, {kind}: {fault}", flush=True)
                disagreements += 1
    for name, count in sorted(counts.items()):
        print(f"{name:20} {count}")
    if disagreements or not all(counts[x] for x in ("exact", "enclosed", "s REFUTED", "s FREE")):
        sys.exit(1)


if __name__ == "__main__":
    main()
