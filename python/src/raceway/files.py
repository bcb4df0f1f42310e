# SPDX-License-Identifier: GPL-2.0-or-later
"""Write files such that they appear either complete or not at all."""

import os
import stat
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from raceway.errors import RunError

FilePath = str | os.PathLike[str]


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
