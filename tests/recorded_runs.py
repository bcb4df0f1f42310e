# SPDX-License-Identifier: GPL-2.0-or-later
"""Provide decks that write a record to the tests."""

from host import deck_file
from smallest import SMALLEST

MAIN = {"deck": "inputs/in.6208", "samples": 40, "passes": 1, "record": "all", "dumps": "yes"}


def small(folder, options="", more="", deck=SMALLEST):
    """Add a fix that records to `folder / run` to `deck`, write the result to a file in `folder`,
    and return the path of this file."""
    line = f"fix rec all bearing/record 100 {folder / 'run'} {options}\n{more}"
    return deck_file(folder, deck.replace("compute total", line + "compute total"))
