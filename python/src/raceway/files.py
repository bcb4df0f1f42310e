# SPDX-License-Identifier: GPL-2.0-or-later
"""Write files such that they appear either complete or not at all, and notice that they change."""

import csv
import os
import stat
import time
from collections.abc import Callable, Hashable
from contextlib import suppress
from pathlib import Path

from raceway.errors import RacewayError, RunError, unreadable

FilePath = str | os.PathLike[str]
RECENT = 10**9  # ns; file systems store the time of a change with a resolution of up to this


def version(path: FilePath) -> Hashable:
    """Return an object that is equal to an earlier one only if the file or folder `path` has not
    changed since then. It is None if there is no such file."""
    try:
        found = os.stat(path)
    except OSError:
        return None
    if time.time_ns() - found.st_mtime_ns < RECENT:  # it may change again at the same time
        return time.monotonic_ns()
    return found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns


def csv_rows(path: FilePath, wrong: type[RacewayError]) -> list[tuple[int, list[str]]]:
    """Return (line number, cells) for each row of a CSV file that is neither empty nor a comment,
    and skip the byte order mark that spreadsheets write. Raises `wrong` if the file cannot be
    read."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            reader = csv.reader(file)
            return [
                (reader.line_num, cells)
                for cells in reader
                if any(cells) and not cells[0].lstrip().startswith("#")
            ]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise wrong(unreadable(path, error)) from None


def whole(path: FilePath, write: Callable[[Path], object]) -> Path:
    """Call `write(part)` to create a file in the folder of `path`, rename it to `path`, and return
    the `Path`. If `path` is a link, the link is kept and its target is replaced.

    Raises `RunError` if the file cannot be written, or if `path` is a device, a pipe or a folder.
    In these cases existing content remains unchanged.
    """
    path, part = Path(path), None
    try:
        if path.exists() and not stat.S_ISREG(path.stat().st_mode):
            raise OSError("not a regular file")
        target = Path(os.path.realpath(path))
        if target.is_symlink():
            raise OSError("a link to itself")
        part = target.with_name(f".{target.name}.{os.getpid()}")
        write(part)
        part.replace(target)
    except OSError as error:
        raise RunError(f"cannot write {path}: {error.strerror or error}") from None
    finally:
        with suppress(OSError):
            if part:
                part.unlink()
    return path


def text(path: FilePath, content: str) -> Path:
    """Write `content` to the file `path` in the same way as `whole`."""
    return whole(path, lambda part: part.write_text(content, encoding="utf-8"))


def folder(path: FilePath) -> Path:
    """Create the folder `path` and its parents, and return it as a `Path`. Raises `RunError` if it
    cannot be created."""
    try:
        Path(path).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RunError(f"cannot make the folder {path}: {error.strerror or error}") from None
    return Path(path)
