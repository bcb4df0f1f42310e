# SPDX-License-Identifier: GPL-2.0-or-later
"""Type hints for numbers and arrays, and helpers for the `__repr__` and the JSON of results. Shapes
and units are stated in docstrings."""

import math
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Numbers = float | Floats  # one number or an array of them

SHOWN = 6  # arrays up to this length are printed in full; longer ones as shape and range


def mean(values: Floats) -> float:
    """Return the mean of the known `values`, which are not NaN, or NaN if there are none."""
    known = ~np.isnan(values)
    count = np.count_nonzero(known)
    return float(np.where(known, values, 0.0).sum() / count) if count else np.nan


def filled(values: Floats) -> Floats:
    """Return `values` (N,) in which each NaN is replaced by the last number before it, or by the
    first number if there is none.

    >>> filled(np.array([np.nan, 1.0, np.nan, 3.0]))
    array([1., 1., 1., 3.])
    """
    known = ~np.isnan(values)
    if not known.any():
        return values
    last = np.maximum.accumulate(np.where(known, np.arange(len(values)), known.argmax()))
    return values[last]


def short(result: Any) -> str:
    """Return the text for the `__repr__` of a dataclass or named tuple, with one line per field. A
    nested result is represented by its type and the names of its fields."""
    lines = [f"  {name}: {_value(getattr(result, name))}" for name in _names(result)]
    return "\n".join([f"<{type(result).__name__}", *lines]) + ">"


def _names(result):
    """Return the field names of a dataclass or named tuple."""
    return [one.name for one in fields(result)] if is_dataclass(result) else result._fields


def _value(value):
    if isinstance(value, np.ndarray):
        if value.ndim < 2 and value.size <= SHOWN:
            return "[" + ", ".join(f"{one:.6g}" for one in np.atleast_1d(value)) + "]"
        known = value[np.isfinite(value)]
        ends = f", {known.min():.6g} to {known.max():.6g}" if known.size else ""
        return f"{' x '.join(map(str, value.shape))}{ends}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if hasattr(value, "_fields") or is_dataclass(value):
        return f"{type(value).__name__} of {', '.join(_names(value))}"
    if isinstance(value, list):
        return f"{len(value)}, each {_value(value[0])}" if value else "none"
    return repr(value)


def plain(value: Any) -> Any:
    """Convert a result, or a dict or list of results, for JSON. Numbers that are not finite, e.g.
    the capacitance of contacts without a film, become None."""
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, list):
        return [plain(one) for one in value]
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and not math.isfinite(value) else value
