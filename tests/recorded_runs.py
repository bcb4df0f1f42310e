# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks with a record, for use in tests."""

from host import ROOT

SMALL = (ROOT / "docs" / "decks" / "in.smallest").read_text()
MAIN = {"deck": "inputs/in.6208", "samples": 40, "passes": 1, "record": "all", "dumps": "yes"}


def small(folder, options="", more="", deck=SMALL):
    """Write `deck` to a file in `folder`, with a record in `folder / run` added, and return the
    path."""
    line = f"fix rec all bearing/record 100 {folder / 'run'} {options}\n{more}"
    text = deck.replace("compute total", line + "compute total")
    path = folder / "in.recorded"
    path.write_text(text)
    return path
