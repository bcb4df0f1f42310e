# SPDX-License-Identifier: GPL-2.0-or-later
"""The text a run writes: dumps of LIGGGHTS and LAMMPS (`dump custom`, `dump local`) and tables with
a `#` header.

Read a block of frames at a time, so memory does not grow with the file. A file cut off in its last
frame loses that frame with a warning: a run may still be writing. Anything else out of place raises
`RunError` naming file and line.
"""

import warnings
from collections.abc import Iterator, Sequence
from itertools import chain, islice
from typing import BinaryIO, NamedTuple

import numpy as np
import pandas as pd

from raceway.arrays import Floats
from raceway.errors import RunError, RunWarning
from raceway.files import FilePath

BLOCK = 4 << 20  # bytes of text read into numbers at once: past 1 MB a larger one is no faster
START = b"ITEM: TIMESTEP\n"


class Frame(NamedTuple):
    """One snapshot of a dump."""

    step: int
    values: Floats  # (rows, columns)


class Block(NamedTuple):
    """Consecutive snapshots of a dump."""

    first: int  # number of the first frame in the file, from 0
    steps: list[int]  # of each frame
    counts: list[int]  # rows of each frame
    values: Floats  # (rows of all, columns)
    end: int  # bytes of the file up to here

    def table(self, columns: Sequence[str]) -> pd.DataFrame:
        """As a `DataFrame` with `columns` and `sample`, the frame's number; `attrs` as `read_dump`
        sets them."""
        table = pd.DataFrame(self.values, columns=list(columns))
        table["sample"] = np.repeat(
            np.arange(self.first, self.first + len(self.counts)), self.counts
        )
        table.attrs.update(first=self.first, samples=len(self.counts))
        return table


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
        if not text.isdigit() or len(text) > 18:
            self.fail(f"expected a whole number, found '{_show(text)}'")
        return int(text)

    def fail(self, what, number=None):
        raise RunError(f"{self.path}, line {number or self.number}: {what}")


class Index:
    """Where the frames of a dump begin: `offsets` in bytes and `lines` before each, arrays of one
    value a frame.

    Found in one pass over the bytes, without reading numbers. A frame that the file ends inside is
    not counted, with a warning.
    """

    def __init__(self, path: FilePath) -> None:
        offsets, lines = [], []
        tail, base, seen = b"\n", -1, -1  # as if a line had ended before the file
        with _open(path) as file:
            while chunk := file.read(BLOCK):
                text, here = tail + chunk, 0
                while (found := text.find(b"\n" + START, here)) >= 0:
                    seen += text.count(b"\n", here, found + 1)
                    here = found + 1
                    offsets.append(base + here)
                    lines.append(seen)
                # a byte too short to hold a start that was found already
                tail = text[-len(START) :]
                seen += text.count(b"\n", here, len(text) - len(tail))
                base += len(text) - len(tail)
        self.path, self.offsets, self.lines = (
            path,
            np.array(offsets, dtype=int),
            np.array(lines, dtype=int),
        )
        if offsets and self._cut():
            self.offsets, self.lines = self.offsets[:-1], self.lines[:-1]

    def __len__(self):
        return len(self.offsets)

    def _cut(self):
        with _open(self.path) as file:
            lines = self.seek(file, len(self) - 1)
            try:
                _frame(lines)
            except _Cut:
                _warn_cut(self.path, self.lines[-1] + 1)
                return True
        return False

    def seek(self, file: BinaryIO, frame: int) -> _Lines:
        """The `_Lines` of `file`, set to the start of a frame."""
        file.seek(self.offsets[frame])
        lines = _Lines(self.path, file)
        lines.number = int(self.lines[frame])
        return lines


def blocks(
    path: FilePath,
    columns: Sequence[str],
    start: int = 0,
    stop: int | None = None,
    index: Index | None = None,
) -> Iterator[Block]:
    """Yield the frames `start` to `stop` of the dump at `path` as `Block`s of about `BLOCK` bytes.

    The rows hold `columns` (names) in that order. An `Index` of the file is needed to begin
    anywhere but at frame 0; without one it is made. Raises `RunError` where there are no frames.
    """
    if start and start >= len(index := Index(path) if index is None else index):
        raise RunError(f"{path} holds {len(index)} complete frames, none from number {start} on")
    with _open(path) as file:
        lines = index.seek(file, start) if start else _Lines(path, file)
        number = start
        while stop is None or number < stop:
            block, cut = _gather(lines, columns, number, stop)
            if cut is not None:
                _warn_cut(path, cut)
            if block.counts:
                yield block
            number += len(block.counts)
            if cut is not None or not file.peek(1):
                break
    if number == start:
        raise RunError(f"{path} holds no complete frame")


def _gather(lines, columns, first, stop):
    """(the next `Block`, the line of the frame that the file ends inside, or None)."""
    steps, parts, begins, size, cut = [], [], [], 0, None
    while size < BLOCK and (stop is None or first + len(parts) < stop) and lines.file.peek(1):
        start = lines.number + 1
        try:
            step, rows = _frame(lines)
        except _Cut:
            cut = start
            break
        except (
            RunError
        ):  # the frame before may have had too few rows, and taken this one's head for its own
            if parts:
                _look_for_head(lines, parts[-1], begins[-1], len(parts[-1]))
            raise
        begins.append(lines.number - len(rows) + 1)
        steps.append(step)
        parts.append(rows)
        size += sum(map(len, rows)) + 100  # a head has about that, and an empty frame must count
    values = _numbers(list(chain.from_iterable(parts)), columns)
    if values is None:
        for begin, rows in zip(begins, parts):
            _blame(lines, rows, columns, begin)
    return Block(first, steps, list(map(len, parts)), values, lines.file.tell()), cut


def frames(path: FilePath, columns: Sequence[str]) -> Iterator[Frame]:
    """Yield the `Frame`s of the dump at `path`, whose rows hold `columns` (names) in that order."""
    for block in blocks(path, columns):
        yield from map(Frame, block.steps, np.split(block.values, np.cumsum(block.counts)[:-1]))


def first_steps(path: FilePath) -> list[int]:
    """The steps of the first two frames of the dump at `path`, as far as they are whole."""
    steps = []
    with _open(path) as file:
        lines = _Lines(path, file)
        while len(steps) < 2 and file.peek(1):
            try:
                steps.append(_frame(lines)[0])
            except _Cut:
                break
    return steps


def read_dump(
    path: FilePath,
    columns: Sequence[str],
    start: int = 0,
    stop: int | None = None,
    index: Index | None = None,
) -> pd.DataFrame:
    """The frames `start` to `stop` (default all) as one `DataFrame` with `columns` and `sample`,
    the frame's number from 0.

    Its `attrs["samples"]` is the number of frames, empty ones included, `attrs["first"]` the number
    of the first. Raises `RunError` where there are none.
    """
    parts = list(blocks(path, columns, start, stop, index))
    steps = sum((part.steps for part in parts), [])
    table = Block(
        parts[0].first,
        steps,
        sum((part.counts for part in parts), []),
        np.concatenate([part.values for part in parts]),
        parts[-1].end,
    ).table(columns)
    table.attrs["steps"] = steps
    return table


def read_table(path: FilePath) -> pd.DataFrame:
    """A whitespace table as a `DataFrame`; the names follow `#` on the first line."""
    with _open(path) as file:
        lines = _Lines(path, file)
        try:
            names = lines.take().decode(errors="replace")
        except _Cut:
            raise RunError(f"{path} holds no complete line") from None
        if not names.startswith("#"):
            lines.fail("expected '#' and the names of the columns")
        columns, parts, first = names[1:].split(), [], 2
        while rows := file.readlines(BLOCK):
            cut = not rows[-1].endswith(b"\n")
            if cut:
                warnings.warn(
                    f"{path}, line {first + len(rows) - 1}: the file ends inside this last line,"
                    " which is left out",
                    RunWarning,
                    stacklevel=2,
                )
                rows.pop()
            parts.append(_numbers(rows, columns))
            if parts[-1] is None:
                _blame(lines, rows, columns, first)
            first += len(rows)
            if cut:
                break
    if first == 2:
        raise RunError(f"{path} holds no complete row")
    return pd.DataFrame(np.concatenate(parts), columns=columns)


def _open(path):
    try:
        return open(path, "rb")
    except OSError as error:
        raise RunError(f"cannot read {path}: {error.strerror}") from None


def _warn_cut(path, line):
    warnings.warn(
        f"{path}, line {line}: the file ends inside this last frame, which is left out",
        RunWarning,
        stacklevel=3,
    )


def _frame(lines):
    """(step, rows as text) of the next frame."""
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
    rows = list(islice(lines.file, count))
    lines.number += len(rows)
    if len(rows) < count or (rows and not rows[-1].endswith(b"\n")):
        _look_for_head(lines, rows, lines.number - len(rows) + 1, count)
        raise _Cut
    return step, rows


def _numbers(rows, columns):
    """Rows as an array (rows, columns), or None where that is not what they are."""
    if not rows:
        return np.zeros((0, len(columns)))
    try:
        values = np.loadtxt(rows, ndmin=2, comments=None)
    except ValueError:
        return None
    return (
        values if values.shape == (len(rows), len(columns)) and not np.isnan(values).any() else None
    )


def _look_for_head(lines, rows, first, count):
    """Fail when the next frame begins among the rows of this one."""
    for offset, row in enumerate(rows):
        if row.startswith(b"ITEM:"):
            lines.fail(f"only {offset} of {count} rows before the next frame", first + offset)


def _blame(lines, rows, columns, first):
    """Fail with the row that is not a row of numbers, if one of these, from line `first` on, is
    not."""
    _look_for_head(lines, rows, first, len(rows))
    for number, row in enumerate(rows, first):
        words = row.split()
        if len(words) != len(columns):
            lines.fail(
                f"{len(words)} columns where {len(columns)} are named ({' '.join(columns)})", number
            )
        for word, name in zip(words, columns):
            try:  # Python takes 1_0 for a number
                bad = np.isnan(float(word)) or b"_" in word
            except ValueError:
                bad = True
            if bad:
                lines.fail(f"{name} is not a number: '{_show(word)}'", number)


def _show(text):
    return text[:60].decode(errors="replace")
