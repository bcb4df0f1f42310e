# SPDX-License-Identifier: GPL-2.0-or-later
"""The variables that decks take from the command line, as the C++ table has them."""

from typing import Any

from raceway import core

DATA = {"bearing data", "usual data", "oil data"}


def rows() -> list[dict[str, Any]]:
    """{"name", "default", "unit", "range", "of", "meaning"} of each; `of` names the commands that
    take it, joined by |, or the kind of data."""
    return core.table("variables")


def default(name: str) -> str:
    """Default as text; empty for that of the command, or of the data."""
    return next((row["default"] for row in rows() if row["name"] == name), "")


def data() -> list[str]:
    """Names of the data of bearings and oils."""
    return list(dict.fromkeys(row["name"] for row in rows() if DATA & set(row["of"].split("|"))))
