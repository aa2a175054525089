"""Text files that appear whole or not at all."""

from __future__ import annotations

import os

from .scene import Path


def write_whole(path: Path, text: str) -> None:
    """Writes the text. Raises OSError; then there is no new file."""
    unfinished = f"{os.fspath(path)}.tmp"
    try:
        with open(unfinished, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(unfinished, path)
    except BaseException:
        if os.path.exists(unfinished):
            os.remove(unfinished)
        raise
