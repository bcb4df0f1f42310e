# SPDX-License-Identifier: GPL-2.0-or-later
"""The text a run writes: LAMMPS dumps (`dump custom`, `dump local`) and tables with a `#` header.

Read a frame at a time. A file cut off in its last frame loses that frame with a warning: a run may still be
writing. Anything else out of place raises `RunError` naming the file and the line.
"""

import warnings
from itertools import islice
from typing import NamedTuple

import numpy as np
import pandas as pd

from raceway.errors import RunError, RunWarning


class Frame(NamedTuple):
    """One snapshot of a dump."""

    step: int
    values: np.ndarray  # (rows, columns)


class _Cut(Exception):
    """The file ends inside a frame."""


class _Lines:
    """A file's lines and how many have been read."""

    def __init__(self, path, file):
        self.path, self.file, self.number = path, file, 0

    def take(self):
        line = self.file.readline()
        self.number += 1
        if not line.endswith(b"\n"):
            raise _Cut
        return line.strip()

    def whole(self):
        text = self.take()
        try:
            return int(text)
        except ValueError:
            self.fail(f"expected a whole number, found '{_show(text)}'")

    def fail(self, what, number=None):
        raise RunError(f"{self.path}, line {number or self.number}: {what}")


def frames(path, columns):
    """Yield the `Frame`s of the dump at `path`, whose rows hold `columns` (names) in that order."""
    with _open(path) as file:
        lines = _Lines(path, file)
        while True:
            start = lines.number + 1
            if not file.peek(1):
                return
            try:
                yield _frame(lines, columns)
            except _Cut:
                warnings.warn(f"{path}, line {start}: the file ends inside this last frame, which is left out",
                              RunWarning, stacklevel=2)
                return


def read_dump(path, columns):
    """All frames of the dump as one `DataFrame` with `columns` and `sample`, the frame's number from 0.

    Its attribute `attrs["samples"]` is the number of frames, empty ones included. Raises `RunError` for none.
    """
    blocks = [frame.values for frame in frames(path, columns)]
    if not blocks:
        raise RunError(f"{path} holds no complete frame")
    table = pd.DataFrame(np.concatenate(blocks), columns=list(columns))
    table["sample"] = np.repeat(np.arange(len(blocks)), [len(block) for block in blocks])
    table.attrs["samples"] = len(blocks)
    return table


def read_table(path):
    """A whitespace table as a `DataFrame`; the names follow `#` on the first line."""
    with _open(path) as file:
        lines = _Lines(path, file)
        try:
            names = lines.take().decode(errors="replace")
        except _Cut:
            raise RunError(f"{path} holds no complete line") from None
        if not names.startswith("#"):
            lines.fail("expected '#' and the names of the columns")
        rows = file.readlines()
    if rows and not rows[-1].endswith(b"\n"):
        warnings.warn(f"{path}, line {len(rows) + 1}: the file ends inside this last line, which is left out",
                      RunWarning, stacklevel=2)
        rows.pop()
    columns = names[1:].split()
    if not rows:
        raise RunError(f"{path} holds no complete row")
    return pd.DataFrame(_numbers(lines, rows, columns, first=2), columns=columns)


def _open(path):
    try:
        return open(path, "rb")
    except OSError as error:
        raise RunError(f"cannot read {path}: {error.strerror}") from None


def _frame(lines, columns):
    step = count = None
    while True:
        item = lines.take()
        if item == b"ITEM: TIMESTEP":
            step = lines.whole()
        elif item.startswith(b"ITEM: NUMBER OF"):
            count = lines.whole()
        elif item.startswith(b"ITEM: BOX BOUNDS"):
            for _ in range(3):
                lines.take()
        elif item in (b"ITEM: UNITS", b"ITEM: TIME"):
            lines.take()
        elif item.startswith((b"ITEM: ENTRIES", b"ITEM: ATOMS")):
            break
        else:
            lines.fail(f"expected the head of a frame, found '{_show(item)}'")
    if step is None or count is None:
        lines.fail("rows without TIMESTEP and NUMBER OF before them")
    first, rows = lines.number + 1, list(islice(lines.file, count))
    lines.number += len(rows)
    for offset, row in enumerate(rows):
        if row.startswith(b"ITEM:"):
            lines.fail(f"only {offset} of {count} rows before the next frame", first + offset)
    if len(rows) < count or (rows and not rows[-1].endswith(b"\n")):
        raise _Cut
    return Frame(step, _numbers(lines, rows, columns, first))


def _numbers(lines, rows, columns, first):
    """Rows as an array (rows, columns); the line at fault is looked for only when there is one."""
    if not rows:
        return np.zeros((0, len(columns)))
    try:
        values = np.loadtxt(rows, ndmin=2, comments=None)
        if values.shape == (len(rows), len(columns)) and not np.isnan(values).any():
            return values
    except ValueError:
        pass
    for number, row in enumerate(rows, first):
        words = row.split()
        if len(words) != len(columns):
            lines.fail(f"{len(words)} columns where {len(columns)} are named ({' '.join(columns)})", number)
        for word, name in zip(words, columns):
            try:
                bad = np.isnan(float(word))
            except ValueError:
                bad = True
            if bad:
                lines.fail(f"{name} is not a number: '{_show(word)}'", number)
    lines.fail("rows that do not form a table", first)


def _show(text):
    return text[:60].decode(errors="replace")
