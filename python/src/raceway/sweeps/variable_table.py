# SPDX-License-Identifier: GPL-2.0-or-later
"""The variables that decks take from the command line, from the C++ table
(`runs/variables.json`, written by `make columns`)."""

import json
from functools import cache
from importlib.resources import files
from typing import Any

DATA = {"bearing data", "usual data", "oil data"}


@cache
def rows() -> list[dict[str, Any]]:
    """{"name", "default", "unit", "range", "of", "meaning"} of each; `of` names the commands that
    take it, joined by |, or the kind of data."""
    return json.loads(files("raceway").joinpath("runs/variables.json").read_text())


def default(name: str) -> str:
    """Default as text; empty for that of the command, or of the data."""
    return next((row["default"] for row in rows() if row["name"] == name), "")


def data() -> list[str]:
    """Names of the data of bearings and oils."""
    return list(dict.fromkeys(row["name"] for row in rows() if DATA & set(row["of"].split("|"))))
