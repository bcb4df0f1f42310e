# SPDX-License-Identifier: GPL-2.0-or-later
"""Type hints for numbers and arrays, and the text that shows results. Shapes and units are in the
docstrings."""

from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Numbers = float | Floats  # one number or an array of them

SHOWN = 6  # longest array whose numbers are listed; others are shown by shape and range


def short(result: Any) -> str:
    """Text for the `__repr__` of a dataclass or named tuple: one line for each field; nested
    results are shown by the names of their fields."""
    lines = [f"  {name}: {_value(getattr(result, name))}" for name in _names(result)]
    return "\n".join([f"<{type(result).__name__}", *lines]) + ">"


def _names(result):
    """Names of the fields of a dataclass or named tuple; none for other objects."""
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
