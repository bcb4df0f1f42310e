# SPDX-License-Identifier: GPL-2.0-or-later
"""Table of the two contacts of each loaded ball, whose capacitances are in series."""

import pandas as pd

from raceway.theory import capacitance
from raceway.theory.bearing import INNER, OUTER

_OF_GROOVES = {"load": "max", "capacitance": "sum"}


def pairs(contacts: pd.DataFrame) -> pd.DataFrame:
    """Return a table with one row for each sample and ball that is loaded on both raceways.

    `contacts` is a table of contacts. The columns are `load_inner`, `load_outer` and, if the
    contacts have capacitances, `capacitance_inner`, `capacitance_outer` and their value in series,
    `capacitance`. For a ring with two grooves, the larger of the two loads and the sum of the
    capacitances are used.
    """
    names = ["sample", "ball"] + [name for name in ("load", "capacitance") if name in contacts]
    live = contacts.loc[contacts["load"] > 0, [*names, "raceway"]]
    sides = [live.loc[live["raceway"] == side, names] for side in (INNER, OUTER)]
    if "groove" in contacts:
        of = {name: how for name, how in _OF_GROOVES.items() if name in names}
        sides = [one.groupby(["sample", "ball"], as_index=False).agg(of) for one in sides]
    table = sides[0].merge(sides[1], on=["sample", "ball"], suffixes=("_inner", "_outer"))
    if "capacitance_inner" in table:
        table["capacitance"] = capacitance.ball(
            table["capacitance_inner"], table["capacitance_outer"]
        )
    return table
