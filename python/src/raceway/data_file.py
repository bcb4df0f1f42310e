# SPDX-License-Identifier: GPL-2.0-or-later
"""Read data files, whose lines are `variable NAME index VALUE # comment`, and check their numbers
against the ranges allowed in decks (`core.wrong_value`)."""

from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path

from raceway import core, data_table, files
from raceway.errors import InputError, unreadable
from raceway.files import FilePath


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
        raise InputError(unreadable(path, error)) from None
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
        if wrong := core.wrong_value(name, repr(value)):
            raise InputError(f"{path}: {wrong}")
