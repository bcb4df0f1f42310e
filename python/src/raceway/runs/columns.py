# SPDX-License-Identifier: GPL-2.0-or-later
"""What the columns of a run's files are: meaning, unit, and what a ball has that touches no
raceway.

They stand in C++, with what computes them; `make columns` writes `columns.json` from there.
"""

import json
from importlib.resources import files
from typing import NamedTuple


class Column(NamedTuple):
    """`unit` in SI, "" for a plain number. `absent`: the value of a contact that is not: 0 for what
    vanishes with the contact, NaN for what it does not have."""

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


_TABLES = json.loads(files(__package__).joinpath("columns.json").read_text())

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
    # not of a file: worked out here
    "shift": Column("displacement of the inner ring along the load", "m"),
}
BEARING = {**_table(_TABLES["total"]), **_table(_TABLES["bearing"])}
# key of `losses_W`: column of the power lost, in W; of contacts, rings and bearings alike
LOSSES = {row["loss"]: row["name"] for row in _TABLES["bearing"] if "loss" in row}
