# SPDX-License-Identifier: GPL-2.0-or-later
"""The variables that decks take from the command line, as listed in the C++ table."""

from collections.abc import Mapping
from functools import cache
from typing import Any

from raceway import core

OIL = ("oil constant", "oil over temperature", "oil data")
DATA = {"bearing data", "usual data", "catalogue data", *OIL}


def rows() -> list[dict[str, Any]]:
    """Return a dict with "name", "default", "unit", "range", "of", "meaning", "models" and
    "without_default" for each variable.

    `of` contains the names of the commands that take the variable, joined by |, or the kinds of
    data. `models` contains the models that use a constant of an oil, or "" for all models.
    `without_default` contains the kinds of data to which the default does not apply.
    """
    return core.table("variables")


@cache
def row(name: str) -> dict[str, Any]:
    """Return the row of a variable. Raises `KeyError` if there is none."""
    return {row["name"]: row for row in rows()}[name]


@cache
def default(name: str) -> str:
    """Return the default of a variable as text, which is empty if the command or the data files
    define it, or if there is no such variable."""
    return next((row["default"] for row in rows() if row["name"] == name), "")


def limits(name: str) -> tuple[float, float]:
    """Return the smallest and the largest value of a variable, without the value beside its range
    that stands for the default. Raises `KeyError` if there is no such variable."""
    low, high = map(float, row(name)["range"].split()[:2])
    return low, high


def needed(kind: str) -> list[str]:
    """Return the names of the variables that data of a `kind` must include."""
    return [
        row["name"]
        for row in rows()
        if kind in row["of"].split("|")
        and (not row["default"] or kind in row["without_default"].split("|"))
    ]


def oil() -> dict[str, dict[str, Any]]:
    """Return {name: row} for oil data that have a default."""
    return {row["name"]: row for row in rows() if row["of"] in OIL and row["default"]}


def block(values: Mapping[str, float]) -> list[str]:
    """Return lines of text about `values`, the constants of an oil that its file lacks.

    They state the name, the default and the meaning of each constant.
    """
    table = oil()
    return ["", "Defaults of constants that the lubricant's file does not have"] + [
        f"  {name} {value:g} {table[name]['unit']}".rstrip() + f": {table[name]['meaning']}"
        for name, value in values.items()
    ]


def data() -> list[str]:
    """Return the names of the data of bearings and oils."""
    return list(dict.fromkeys(row["name"] for row in rows() if DATA & set(row["of"].split("|"))))


def numbers_of_data() -> list[str]:
    """Return the names of those data of bearings and oils that are numbers, not words."""
    return [name for name in data() if not row(name)["range"].startswith("one_of")]
