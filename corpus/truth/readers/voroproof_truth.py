#!/usr/bin/env python3
# SPDX-License-Identifier: CC0-1.0
"""Reads the truth set (../README.md), asks an engine its questions, counts the wrong answers.

    python3 voroproof_truth.py [--tolerance X] [--json] FILE...

FILE is text or .gz, - the standard input. Without a command:

    with open_truth("incircle.txt.gz") as lines:
        reader = Reader(lines)
        print(as_text(judge(reader, MyEngine())), end="")

An engine has a name and any of these methods, each of which returns None where it is undecided:

    incircle(g), exists(g)      a sign
    contact(g)                  ("none", None), ("graze", time) or ("hit", time)
    collapse(g, t0, t1)         (S0, [(time, sign after), ...])
    rootorder(question)         a sign
    static(frame, disks)        (pairs, hidden ids); the frame is None or a container

Nothing but the standard library is needed. A malformed file raises Malformed with its line.
"""

import gzip
import re
import sys
import zlib
from collections import namedtuple
from time import perf_counter_ns

SETS = ("incircle", "exists", "contact", "collapse", "rootorder", "static")
COLUMNS = ("queries", "wrong_sign", "wrong_none", "wrong_some", "wrong_time", "undecided")
MANY = 4096
MOST_ZEROS = 32
LONGEST_LINE = 1 << 24

# Letter d or c with centre and radius, or w with the unit vector (x, y) and the offset r. At rest
# the rates are 0.
Generator = namedtuple("Generator", "letter x y r vx vy vr")
# A time in [lo, hi], the order of the zero, the sign just after it.
Zero = namedtuple("Zero", "lo hi order sign")
# Root 0 is that of the generators ids[0] in windows[0], root 1 likewise.
Roots = namedtuple("Roots", "windows ids g")
# `question` has the arguments of the engine's method, `truth` is the answer: a sign; (KIND, LO,
# HI); (S0, [Zero...]); or (pairs, hidden ids) as sets.
Record = namedtuple("Record", "name bits proof question truth")


class Malformed(ValueError):
    pass


# Only as printf's %a writes it: float.fromhex would take 10 for 16, where others take it for 10.
_number = re.compile(r"-?0x[0-9a-f](\.[0-9a-f]{1,13})?p[+-]?[0-9]{1,4}").fullmatch
_integer = re.compile(r"-?[0-9]{1,9}").fullmatch
_name = re.compile(r"[A-Za-z0-9_.+-]{1,63}").fullmatch


def _overflows(text):
    try:
        return float.fromhex(text) is None
    except OverflowError:
        return True


class _Fields:
    """The fields of a line, from left to right."""

    def __init__(self, line):
        self.fields = line.split(" ")
        self.at = 0

    def next(self):
        self.at += 1
        return self.fields[self.at - 1] if self.at <= len(self.fields) else ""

    def fail(self, expected):
        raise Malformed(f"field {self.at}: expected {expected}")

    def word(self, *words):
        word = self.next()
        return word if word in words else self.fail(" ".join(words))

    def name(self):
        name = self.next()
        return name if _name(name) else self.fail("a name")

    def integer(self, low, high, expected):
        text = self.next()
        if not _integer(text) or not low <= int(text) <= high:
            self.fail(expected)
        return int(text)

    def numbers(self, count):
        texts = self.fields[self.at : self.at + count]
        self.at += count
        try:
            if len(texts) == count and all(map(_number, texts)):
                return list(map(float.fromhex, texts))
        except OverflowError:
            pass
        self.at -= count
        for text in texts + [""]:
            self.at += 1
            if not _number(text) or _overflows(text):
                self.fail("a hexadecimal float")

    def end(self):
        self.at += 1
        if self.at <= len(self.fields):
            self.fail("the end of the line")

    def times(self):
        lo, hi = self.numbers(2)
        return (lo, hi) if lo <= hi else self.fail("times in their order")

    def window(self):
        lo, hi = self.times()
        return (lo, hi) if lo < hi else self.fail("a window that is not empty")

    def generator(self, letter, moving):
        numbers = self.numbers(6) if moving else self.numbers(3) + [0.0, 0.0, 0.0]
        g = Generator(letter, *numbers)
        if letter == "d" and numbers[2] >= 0:
            return g
        if letter != "d" and not g.vx == g.vy == g.vr == 0:
            self.fail("rates of 0")
        self.at -= 3 if moving else 0
        if letter != "w" and not g.r >= 0:
            self.fail("a radius >= 0")
        if letter == "w" and (g.x * g.y != 0 or abs(g.x + g.y) != 1):
            self.fail("a wall along an axis")
        self.at += 3 if moving else 0
        return g

    def generators(self, n, moving, circle):
        """`circle`: the first three have a circle, so that one of them is a disk."""
        g = [self.generator(self.word("d", "c", "w"), moving) for _ in range(n)]
        letters = "".join(one.letter for one in g)
        containers = letters.count("c")
        if containers > 1 or (containers and "w" in letters):
            self.fail("one container and no walls")
        if circle and "d" not in letters[:3]:
            self.fail("a disk among the first three")
        return g


def _incircle(f):
    sign = f.integer(-1, 1, "a sign")
    return (f.generators(4, False, True),), sign


def _exists(f):
    sign = f.integer(-1, 1, "a sign")
    return (f.generators(3, False, True),), sign


def _contact(f):
    kind = f.word("none", "graze", "hit")
    lo, hi = (f.word("-"), f.word("-")) if kind == "none" else f.times()
    return (f.generators(2, True, False),), (kind, lo, hi)


def _collapse(f):
    s0 = sign = f.integer(-1, 1, "a sign")
    zeros = []
    if s0 == 0:
        f.fail("1 or -1")
    for _ in range(f.integer(0, MOST_ZEROS, "a number of zeros")):
        lo, hi = f.times()
        order = f.integer(1, 99, "an order")
        sign = -sign if order % 2 else sign
        zeros.append(Zero(lo, hi, order, f.integer(sign, sign, "another sign, for this order")))
    t0, t1 = f.window()
    return (f.generators(4, True, True), t0, t1), (s0, zeros)


def _rootorder(f):
    sign = f.integer(-1, 1, "a sign")
    windows, ids = [], []
    for _ in range(2):
        windows.append(f.window())
        ids.append([f.integer(0, MANY - 1, "the number of a generator") for _ in range(4)])
    n = f.integer(max(ids[0] + ids[1]) + 1, MANY, "more generators")
    return (Roots(windows, ids, f.generators(n, True, False)),), sign


def _static(f):
    frame = f.generator("c", False) if f.word("p", "c") == "c" else None
    disks = [f.generator("d", False) for _ in range(f.integer(0, MANY, "a number of disks"))]
    last = len(disks) - 1
    pairs = []
    for _ in range(f.integer(0, len(disks) * (len(disks) + 1) // 2, "a number of pairs")):
        a = f.integer(-1 if frame else 0, last, "an id")
        pairs.append((a, f.integer(a + 1, last, "a larger id")))
        if len(pairs) > 1 and pairs[-2] >= pairs[-1]:
            f.fail("pairs in their order")
    count = f.integer(0, len(disks), "a number of hidden disks")
    hidden = [f.integer(0, last, "an id") for _ in range(count)]
    return (frame, disks), (set(pairs), set(hidden))


_REST = dict(zip(SETS, (_incircle, _exists, _contact, _collapse, _rootorder, _static)))


class Reader:
    """Iterates over the records of a file that is given as lines of bytes."""

    def __init__(self, lines):
        self._lines = iter(lines)
        self.line = 0
        f = self._next()
        if f is None:
            raise Malformed("line 1: the file is empty")
        try:
            f.word("#")
            f.word("voroproof-truth")
            self.set = f.word(*SETS)
            self.version = f.name()
            f.end()
        except Malformed as error:
            raise Malformed(f"line 1, {error}") from None

    def _next(self):
        self.line += 1
        line = next(self._lines, None)
        if line is None:
            return None
        if len(line) > LONGEST_LINE:
            raise Malformed(f"line {self.line}: the line is too long")
        if b"\0" in line:
            raise Malformed(f"line {self.line}: a byte is zero")
        line = line[:-1] if line.endswith(b"\n") else line
        line = line[:-1] if line.endswith(b"\r") else line
        return _Fields(line.decode("latin-1"))

    def __iter__(self):
        rest = _REST[self.set]
        while (f := self._next()) is not None:
            if f.fields[0].startswith("#"):
                continue
            try:
                name = f.name()
                bits = f.integer(0, 99999999, "a number of bits")
                proof = f.word("interval", "exact")
                question, truth = rest(f)
                f.end()
            except Malformed as error:
                raise Malformed(f"line {self.line}, {error}") from None
            yield Record(name, bits, proof, question, truth)


def open_truth(name):
    if name == "-":
        return sys.stdin.buffer
    return gzip.open(name, "rb") if name.endswith(".gz") else open(name, "rb")


# ---- Scoring ----


def _more_or_less(has, had):
    return "wrong_none" if has < had else "wrong_some"


def _verdict(name, truth, answer, tolerance):
    """The column in which an answer counts: the first one that fits, of undecided, none or some
    (the answer has less or more of what there is), sign, time. None where it is right."""
    if answer is None:
        return "undecided"
    if name in ("incircle", "rootorder"):
        return None if answer == truth else "wrong_sign"
    if name == "exists":
        if (answer > 0) != (truth > 0):
            return _more_or_less(answer > 0, truth > 0)
        return None if answer == truth else "wrong_sign"
    if name == "static":
        pairs, hidden = set(answer[0]), set(answer[1])
        if truth[0] - pairs or truth[1] - hidden:
            return "wrong_none"
        return "wrong_some" if pairs - truth[0] or hidden - truth[1] else None
    if name == "contact":
        has, had = answer[0] != "none", truth[0] != "none"
        found = [(answer[1], None)] if has else []
        zeros = [Zero(truth[1], truth[2], None, None)] if had else []
    else:
        found, zeros = answer[1], truth[1]
    if len(found) != len(zeros):
        return _more_or_less(len(found), len(zeros))
    if answer[0] != truth[0] or any(a[1] != z.sign for a, z in zip(found, zeros)):
        return "wrong_sign"
    for (time, _), z in zip(found, zeros):
        reach = tolerance * (1 + abs(time))
        if not z.lo - reach <= time <= z.hi + reach:
            return "wrong_time"
    return None


Score = namedtuple("Score", "set version engine tolerance classes")


def judge(reader, engine, tolerance=1e-9):
    """The score of an engine; its classes are dictionaries of COLUMNS and "nanoseconds"."""
    classes = {}
    ask = getattr(engine, reader.set, None)
    for record in reader:
        if ask is None:
            raise Malformed("the engine has no answers to this set")
        begin = perf_counter_ns()
        answer = ask(*record.question)
        end = perf_counter_ns()
        of = classes.get(record.name)
        if of is None:
            of = classes[record.name] = dict.fromkeys(COLUMNS + ("nanoseconds",), 0)
        of["queries"] += 1
        of["nanoseconds"] += end - begin
        column = _verdict(reader.set, record.truth, answer, tolerance)
        if column:
            of[column] += 1
    return Score(reader.set, reader.version, engine.name, tolerance, classes)


def as_text(score):
    keys = COLUMNS + ("nanoseconds",)
    every = {key: sum(of[key] for of in score.classes.values()) for key in keys}
    width = max([5] + [len(name) for name in score.classes])
    text = "%s %s, engine %s, tolerance %g\n" % score[:4]
    text += "class".ljust(width)
    text += "".join(" %10s" % column for column in COLUMNS + ("ns/query",)) + "\n"
    for name, of in list(score.classes.items()) + [("all", every)]:
        text += name.ljust(width) + "".join(" %10d" % of[column] for column in COLUMNS)
        text += " %10.0f\n" % (of["nanoseconds"] / (of["queries"] or 1))
    return text


def as_json(score):
    classes = []
    for name, of in score.classes.items():
        numbers = ",".join('"%s":%d' % item for item in of.items())
        classes.append('{"class":"%s",%s}' % (name, numbers))
    head = '{"format":"voroproof-truth-score","version":1,"set":"%s","set_version":"%s",'
    head += '"engine":"%s","tolerance":%g,"classes":['
    return head % score[:4] + ",".join(classes) + "]}\n"


def main(arguments):
    usage = "usage: voroproof_truth.py [--tolerance X] [--json] FILE..."
    tolerance, show, bad = 1e-9, as_text, 0
    try:
        while arguments and arguments[0].startswith("--"):
            option = arguments.pop(0)
            if option == "--json":
                show = as_json
            elif option == "--tolerance" and arguments:
                tolerance = float(arguments.pop(0))
            else:
                arguments = []
    except ValueError:
        arguments = []
    if not arguments or not tolerance >= 0:
        print(usage, file=sys.stderr)
        return 2
    from judge_plain import Plain

    for name in arguments:
        try:
            with open_truth(name) as lines:
                sys.stdout.write(show(judge(Reader(lines), Plain(), tolerance)))
        except (Malformed, OSError, EOFError, zlib.error) as error:
            print(f"{name}: {error}", file=sys.stderr)
            bad = 1
    return bad


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
