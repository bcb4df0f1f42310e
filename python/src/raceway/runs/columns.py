# SPDX-License-Identifier: GPL-2.0-or-later
"""Columns in the files of a run, with their meaning, unit, and value for a ball without contact.

They are defined in C++, next to the code that computes them (`core.table`).
"""

from typing import NamedTuple

from raceway import core


class Column(NamedTuple):
    """Meaning and unit of a column.

    `unit` is the SI unit, or "" for a dimensionless number. `absent` is the value when there is no
    contact: 0 for a quantity that vanishes with the contact, NaN for a quantity that is undefined.
    """

    meaning: str
    unit: str
    absent: float = float("nan")


def _table(rows: list[dict]) -> dict[str, Column]:
    nan = float("nan")
    return {
        row["name"]: Column(
            row["meaning"], row["unit"], nan if row["absent"] is None else float(row["absent"])
        )
        for row in rows
    }


_TABLES = core.table("columns")

CONTACT = _table(_TABLES["contact"])
ATOM = _table(_TABLES["atom"])
_RING = _table(_TABLES["ring"])
RING = {
    "step": Column("host step", ""),
    "time": Column("time since the start of the measured window", "s"),
    **{
        name: column._replace(meaning=column.meaning.replace("the ring", "the inner ring"))
        for name, column in _RING.items()
    },
    # not contained in a file, but computed in Python
    "shift": Column("displacement of the inner ring along the load", "m"),
}
# motion of a cage that is a ring
CAGE = {
    name: _RING[name]._replace(meaning=_RING[name].meaning.replace("the ring", "the cage"))
    for name in "x y z vx vy vz spin angle tilt_1 tilt_2".split()
}
HEAT = _table(_TABLES["fix_heat"])  # columns of fix bearing/heat and its file
BEARING = {
    **_table(_TABLES["total"]),
    **_table(_TABLES["bearing"]),
    **{name: column for name, column in HEAT.items() if name.startswith("temperature_")},
}
# {key of `losses_W`: column of the dissipated power in W}, for contacts, rings and bearings
LOSSES = {row["loss"]: row["name"] for row in _TABLES["bearing"] if "loss" in row}
