"""Faults of files, said in one line, as the program says them."""

import contextlib
from typing import Iterator, NoReturn

from ..errors import InputError


class Refused(Exception):
    """A value that a table of paths cannot hold; the reader says where it stands."""

    def __init__(self, field: str, reason: str):
        super().__init__(field, reason)
        self.field = field
        self.reason = reason


def printable(given: str, limit: int = 80) -> str:
    """The text fit to stand in a message of one line."""
    cut = given if len(given) <= limit else given[:limit] + "..."
    return "".join(c if c.isprintable() else f"\\x{ord(c):02x}" for c in cut)


def fail(file: str, line: int, field: str, reason: str) -> NoReturn:
    """Raises InputError; the line is 0 where the file as a whole is meant."""
    parts = [printable(file, 4096) + (f":{line}" if line else ""), printable(field), reason]
    raise InputError(": ".join(part for part in parts if part), file, line, field, reason)


@contextlib.contextmanager
def refusing(file: str, what: str) -> Iterator[None]:
    """Whatever a library raises while it reads a damaged file is a fault of the file: raises InputError."""
    try:
        yield
    except InputError:
        raise
    except Exception as error:
        said = " ".join(str(error).split())
        fail(file, 0, "", f"{what}: {printable(said or type(error).__name__, 400)}")
