"""The bytes and the lines of a text file, plain or compressed by gzip or bzip2, in bounded memory."""

import bz2
import contextlib
import csv
import gzip
import io
import sys
import zlib
from fractions import Fraction
from typing import BinaryIO, Iterator, List, NoReturn

from . import numbers
from .faults import fail

LONGEST_LINE = 1 << 16


def binary_input(path: str, stack: contextlib.ExitStack) -> BinaryIO:
    """The expanded bytes of a file, which the stack closes; "-" is standard input.

    Raises OSError; reading raises OSError, EOFError or zlib.error.
    """
    raw = sys.stdin.buffer if path == "-" else stack.enter_context(open(path, "rb"))
    buffered = raw if hasattr(raw, "peek") else io.BufferedReader(raw)
    start = buffered.peek(3)[:3]
    if start[:2] == b"\x1f\x8b":
        return gzip.GzipFile(fileobj=buffered)
    return bz2.BZ2File(buffered) if start == b"BZh" else buffered


class Lines:
    """Iterates over the lines without their ends; `number` is that of the last, from 1.

    A line ends with "\\n", "\\r\\n" or "\\r". Bytes that are no UTF-8 stay as replacement characters.
    Raises InputError.
    """

    def __init__(self, path: str):
        self.path = path
        self.number = 0

    def __iter__(self) -> Iterator[str]:
        with contextlib.ExitStack() as stack:
            try:
                yield from self._lines(stack)
            except (OSError, EOFError, zlib.error) as error:
                fail(self.path, self.number, "", getattr(error, "strerror", None) or str(error))

    def _lines(self, stack: contextlib.ExitStack) -> Iterator[str]:
        text = io.TextIOWrapper(binary_input(self.path, stack), encoding="utf-8-sig", errors="replace", newline=None)
        if self.path == "-":
            stack.callback(text.detach)
        while True:
            line = text.readline(LONGEST_LINE + 1)
            if not line:
                return
            self.number += 1
            if len(line) > LONGEST_LINE:
                fail(self.path, self.number, "", f"a line of more than {LONGEST_LINE} characters")
            yield line.rstrip("\n")

    def rows(self) -> Iterator[List[str]]:
        """The lines as rows of comma-separated values, of which a line that ends within quotes goes on in the next one.

        Raises csv.Error, too.
        """
        return csv.reader((line + "\n" for line in self), strict=True)

    def fail(self, field: str, reason: str) -> NoReturn:
        """Raises InputError for the last line."""
        fail(self.path, self.number, field, reason)


class Frames:
    """The lines, the numbers and the errors of a reader of frames in text.

    All members raise InputError.
    """

    def __init__(self, path: str):
        self.lines = Lines(path)
        self.rest = iter(self.lines)

    def fail(self, field: str, reason: str) -> NoReturn:
        self.lines.fail(field, reason)

    def line(self, field: str) -> str:
        line = next(self.rest, None)
        if line is None:
            self.fail(field, "the file ends within a frame")
        return line

    def number(self, text: str, field: str) -> Fraction:
        try:
            return numbers.decimal(text)
        except ValueError as error:
            self.fail(field, str(error))

    def integer(self, text: str, field: str) -> int:
        try:
            return numbers.integer(text.strip())
        except ValueError as error:
            self.fail(field, str(error))
