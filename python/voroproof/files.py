"""Text files that appear whole or not at all."""

from __future__ import annotations

import fcntl
import itertools
import os
import stat
from contextlib import contextmanager
from typing import TYPE_CHECKING, Iterator, TextIO

if TYPE_CHECKING:
    from .scene import Path

_numbers = itertools.count()


@contextmanager
def whole_file(path: Path) -> Iterator[TextIO]:
    """A file to write to, which has its name when all is written and on the disk.

    Does what the program does (history/atomic_file.h): a file of another name, which no other has, is written and
    renamed; a file that is replaced hands on its permissions; of a symbolic link the file that it names is replaced. What
    is no regular file (a pipe, a device) is written to. Raises OSError; then there is no new file.
    """
    target = os.path.realpath(path)
    try:
        mode = os.stat(target).st_mode
    except FileNotFoundError:
        mode = None
    if mode is not None and not stat.S_ISREG(mode):
        with open(path, "w", encoding="utf-8", newline="\n") as there:
            yield there
        return
    descriptor, unfinished = _new_file_beside(target)
    try:
        with open(descriptor, "w", encoding="utf-8", newline="\n") as file:
            if mode is not None:
                os.fchmod(descriptor, stat.S_IMODE(mode) & 0o777)
            yield file
            file.flush()
            os.fsync(descriptor)
            os.replace(unfinished, target)
    except BaseException:
        try:
            os.unlink(unfinished)
        except FileNotFoundError:
            pass
        raise
    folder = os.open(os.path.dirname(target), os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(folder)
    finally:
        os.close(folder)


def _new_file_beside(target: str) -> tuple[int, str]:
    while True:
        name = f"{target}.{os.getpid()}.{next(_numbers)}.tmp"
        try:
            descriptor = os.open(name, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o666)
        except FileExistsError:
            continue
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)  # a living writer's is not removed by others
        except OSError:
            pass
        return descriptor, name


def write_whole(path: Path, text: str) -> None:
    """Writes the text as `whole_file` says."""
    with whole_file(path) as file:
        file.write(text)
