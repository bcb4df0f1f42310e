# SPDX-License-Identifier: GPL-2.0-or-later
"""Provide decks that write a record to the tests, and compare records bit by bit."""

from host import deck_file
from scipy.io import netcdf_file
from smallest import SMALLEST

MAIN = {"deck": "inputs/in.6208", "samples": 40, "passes": 1, "record": "all", "dumps": "yes"}


def small(folder, options="", more="", deck=SMALLEST):
    """Add a fix that records to `folder / run` to `deck`, write the result to a file in `folder`,
    and return the path of this file."""
    line = f"fix rec all bearing/record 100 {folder / 'run'} {options}\n{more}"
    return deck_file(folder, deck.replace("compute total", line + "compute total"))


def bytes_of(folder):
    """Return a dict that maps the name of each variable in a record to its bytes."""
    with netcdf_file(folder / "record.nc", mmap=False) as file:
        return {name: one.data.tobytes() for name, one in file.variables.items()}


def differ(one, other):
    """Return the names of the variables that are not bitwise identical in both records."""
    one, other = bytes_of(one), bytes_of(other)
    assert one.keys() == other.keys()
    return [name for name in one if one[name] != other[name]]
