# SPDX-License-Identifier: GPL-2.0-or-later
"""The two contacts of a ball in series."""

import pandas as pd

from raceway.theory import capacitance
from raceway.theory.bearing import INNER, OUTER

_OF_GROOVES = {"load": "max", "capacitance": "sum"}


def pairs(contacts: pd.DataFrame) -> pd.DataFrame:
    """One row for each sample and ball loaded on both raceways, from a table of contacts:
    `load_inner`, `load_outer` and, if the contacts have capacitances, `capacitance_inner`,
    `capacitance_outer` and their value in series, `capacitance`. For a ring with two grooves, the
    larger load and the sum of the capacitances.
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
