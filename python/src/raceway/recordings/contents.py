# SPDX-License-Identifier: GPL-2.0-or-later
"""Contents of a file of measured signals in SI units, with temperatures in degrees C."""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.files import FilePath

GRAVITY = 9.80665  # m/s^2
POUND = 4.4482216152605  # N, pound-force


class Channel(NamedTuple):
    """A channel of a file."""

    values: Floats  # (N,)
    rate: float  # Hz, sampling rate, or NaN if the file does not state it
    units: str
    meaning: str


class Contents(NamedTuple):
    """Contents of a file; values that the file does not state are NaN."""

    kind: str  # kind of file
    channels: dict[str, Channel]
    rpm: float = math.nan  # speed of the inner ring as stated in the file
    load: float = math.nan  # N, radial load
    measured: bool = False  # True if the speed was measured or is exact, i.e. is not only nominal


@contextmanager
def reading(path: FilePath, kind: str) -> Iterator[None]:
    """Convert what a reader raises for the file at `path`, which is not a readable file of this
    `kind`, to `RunError`. The libraries raise errors of many types for damaged files."""
    try:
        yield
    except Exception as error:
        raise RunError(f"cannot read {path}: it is damaged or not {kind} ({error})") from None


def channel(path: FilePath, name: str, values: ArrayLike, rate: float, **words: Any) -> Channel:
    """Return a `Channel` of `values`, which are a row or a column.

    `words` may contain the `scale` that converts the values to SI `units`, and the `meaning`.
    Raises `RunError` for values that are not finite real numbers and for other shapes.
    """
    try:
        if np.iscomplexobj(values):
            raise TypeError
        row = np.ravel(np.asarray(values, float)) * words.get("scale", 1.0)
    except (TypeError, ValueError):
        raise RunError(f"{path}: {name} is not a row of numbers") from None
    if row.size != max(np.shape(values), default=1):
        raise RunError(f"{path}: {name} has the shape {np.shape(values)}, must be one row")
    if len(wrong := np.flatnonzero(~np.isfinite(row))):
        raise RunError(
            f"{path}: {name} has values that are not finite, the first in row {wrong[0] + 1}"
        )
    return Channel(row, float(rate), words.get("units", ""), words.get("meaning", name))
