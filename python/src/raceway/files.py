# SPDX-License-Identifier: GPL-2.0-or-later
"""Files appear whole or not at all."""

import os
from collections.abc import Callable
from pathlib import Path

from raceway.errors import RunError

FilePath = str | os.PathLike[str]


def whole(path: FilePath, write: Callable[[Path], object]) -> Path:
    """Let `write(part)` make a file in the folder of `path`, then rename it to `path`; return the
    `Path`.

    Raises `RunError` when it cannot be written; what was there before stays.
    """
    path = Path(path)
    part = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        write(part)
        part.replace(path)
    except OSError as error:
        raise RunError(f"cannot write {path}: {error.strerror or error}") from None
    finally:
        part.unlink(missing_ok=True)
    return path


def folder(path: FilePath) -> Path:
    """Make the folder `path` and those above it; return it as a `Path`. Raises `RunError` when that
    cannot be done."""
    try:
        Path(path).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RunError(f"cannot make the folder {path}: {error.strerror or error}") from None
    return Path(path)
