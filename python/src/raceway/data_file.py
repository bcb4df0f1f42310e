# SPDX-License-Identifier: GPL-2.0-or-later
"""A data file, `variable NAME index VALUE # comment`, with numbers checked against the ranges of
the decks (`sweeps.variable_table`)."""

import math
import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from raceway import core, data_table
from raceway.errors import InputError
from raceway.files import FilePath
from raceway.sweeps import variable_table

LINE = re.compile(r"\s*variable\s+(\w+)\s+index\s+(\S+)")
REMARK = re.compile(r"\s*variable\s+(\w+)\s+index\s+\S+\s*#\s*(.*\S)")


class Range(NamedTuple):
    """Allowed numbers of a variable."""

    low: float
    high: float
    whole: bool
    beside: float  # allowed value outside the range; NaN if there is none
    unit: str

    def allows(self, value: float) -> bool:
        """True for an allowed `value`; False for NaN."""
        inside = self.low <= value <= self.high and not (self.whole and value % 1)
        return inside or value == self.beside

    def __str__(self) -> str:
        text = f"{'a whole number ' if self.whole else ''}from {self.low:g} to {self.high:g}"
        text += f" {self.unit}" if self.unit else ""
        return text if math.isnan(self.beside) else f"{text}, or {self.beside:g}"


def text(path: FilePath) -> str:
    """Text of a data file, or text that represents a row of a table in its folder (`data_table`).
    Raises `InputError` if there is neither a file nor a row, or if it cannot be read."""
    path = Path(path)
    if not path.is_file() and (row := data_table.text(path)):
        return row
    try:
        return path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            f"cannot read {path}: {getattr(error, 'strerror', None) or error}"
        ) from None


def values(path: FilePath) -> dict[str, str]:
    """The index variables of a data file as {name: text}. Raises `InputError` if it cannot be read
    or, as decks do, for a mistyped name, that is, a name that is not a variable but resembles a
    variable that the file lacks. Other names are the user's own."""
    found = _matches(path, LINE)
    if wrong := core.mistyped(found):
        raise InputError(f"{path}: {wrong}")
    return found


def comments(path: FilePath) -> dict[str, str]:
    """Comments on the index variables of a data file, as {name: comment}. Raises `InputError` if
    it cannot be read."""
    return _matches(path, REMARK)


def _matches(path, pattern):
    # the last of equal keys counts in a dict, but the first of equal variables counts in a deck
    lines = reversed(text(path).splitlines())
    found = dict(m.groups() for m in map(pattern.match, lines) if m)
    return dict(reversed(found.items()))


def numbers(path: FilePath, *names: str) -> dict[str, float]:
    """Numbers of a data file by name. Raises `InputError` for a value that is missing, not a number
    or out of its range."""
    data = values(path)
    if missing := [name for name in names if name not in data]:
        raise InputError(f"{path} has no variable {', '.join(missing)}")
    found = {}
    for name in names:
        try:
            found[name] = float(data[name])
        except ValueError:
            raise InputError(f"{path}: {name} = {data[name]} is not a number") from None
    check(path, found)
    return found


def check(path: FilePath, numbers: Mapping[str, float]) -> None:
    """Raise `InputError` for a number out of its range."""
    for name, value in numbers.items():
        allowed = ranges().get(name)
        if allowed and not allowed.allows(value):
            raise InputError(f"{path}: {name} = {value:g} must be {allowed}")


@cache
def ranges() -> dict[str, Range]:
    """The `Range` of each variable that has one."""
    found: dict[str, Range] = {}
    for row in variable_table.rows():
        words = row["range"].split()
        if not words or words[0] == "one_of":
            continue
        beside = float(words[words.index("or") + 1]) if "or" in words else math.nan
        low, high = map(float, words[:2])
        found.setdefault(row["name"], Range(low, high, "whole" in words, beside, row["unit"]))
    return found
