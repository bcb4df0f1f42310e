# SPDX-License-Identifier: GPL-2.0-or-later
"""Read data files, whose lines are `variable NAME index VALUE # comment`, and check their numbers
against the ranges allowed in decks (`sweeps.variable_table`)."""

import math
from collections.abc import Mapping
from functools import cache, lru_cache
from pathlib import Path
from typing import NamedTuple

from raceway import core, data_table, files
from raceway.errors import InputError
from raceway.files import FilePath
from raceway.sweeps import variable_table


class Range(NamedTuple):
    """Range of the permitted values of a variable."""

    low: float
    high: float
    whole: bool
    beside: float  # an additional allowed value outside the range; NaN if there is none
    unit: str

    def allows(self, value: float) -> bool:
        """Return True if `value` is allowed; NaN never is."""
        inside = self.low <= value <= self.high and not (self.whole and value % 1)
        return inside or value == self.beside

    def __str__(self) -> str:
        text = f"{'a whole number ' if self.whole else ''}from {self.low:g} to {self.high:g}"
        text += f" {self.unit}" if self.unit else ""
        return text if math.isnan(self.beside) else f"{text}, or {self.beside:g}"


def text(path: FilePath) -> str:
    """Return the text of a data file. If there is no such file, return instead the text that
    represents the row of that name in a table in its folder (`data_table`). Raises `InputError` if
    neither exists, or if the file cannot be read or starts with a byte order mark, which decks
    reject as well."""
    path = Path(path)
    if not path.is_file() and (row := data_table.text(path)):
        return row
    try:
        found = path.read_text()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(
            f"cannot read {path}: {getattr(error, 'strerror', None) or error}"
        ) from None
    if found.startswith("\ufeff"):
        raise InputError(f"{path} starts with a byte order mark: save it as UTF-8 without one")
    return found


def values(path: FilePath) -> dict[str, str]:
    """Return the index variables of a data file as {name: text}. If a name is set twice, the first
    value counts, as in decks. Raises `InputError` if the file cannot be read or contains a line in
    another form or a mistyped name. As in decks, a name counts as mistyped if it is not the name of
    a variable but resembles one that the file does not set. All other names are left to the
    user."""
    found = {name: line.value for name, line in _lines(path).items()}
    if wrong := core.mistyped(found):
        raise InputError(f"{path}: {wrong}")
    return found


def comments(path: FilePath) -> dict[str, str]:
    """Return the comments on the index variables of a data file as {name: comment}. Raises
    `InputError` as in `values`, except for mistyped names."""
    return {name: line.comment for name, line in _lines(path).items() if line.comment}


def _lines(path):
    """Return the first line of each name in a data file as {name: `data_table.Line`}."""
    path = Path(path)
    return _lines_of(path, files.version(path) or data_table.version(path.parent))


@lru_cache(maxsize=256)  # a summary needs the data of the same oil dozens of times
def _lines_of(path, version):
    found: dict[str, data_table.Line] = {}
    for number, row in enumerate(text(path).splitlines(), start=1):
        if line := data_table.line(row, f"{path}, line {number}"):
            found.setdefault(line.name, line)
    return found


def numbers(path: FilePath, *names: str) -> dict[str, float]:
    """Return the numbers `names` in a data file as {name: value}. Raises `InputError` if a value is
    missing, is not a number or is outside its range."""
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
    """Raise `InputError` if one of the `numbers` is outside its range."""
    for name, value in numbers.items():
        allowed = ranges().get(name)
        if allowed and not allowed.allows(value):
            raise InputError(f"{path}: {name} = {value:g} must be {allowed}")


@cache
def ranges() -> dict[str, Range]:
    """Return the `Range` of each variable that has one, keyed by name."""
    found: dict[str, Range] = {}
    for row in variable_table.rows():
        words = row["range"].split()
        if not words or words[0] == "one_of":
            continue
        beside = float(words[words.index("or") + 1]) if "or" in words else math.nan
        low, high = map(float, words[:2])
        found.setdefault(row["name"], Range(low, high, "whole" in words, beside, row["unit"]))
    return found
