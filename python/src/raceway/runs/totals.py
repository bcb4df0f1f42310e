# SPDX-License-Identifier: GPL-2.0-or-later
"""From the contacts of a sample to the bearing: pairs of contacts in series, sums and extremes."""

import numpy as np
import pandas as pd

from raceway.theory import capacitance
from raceway.theory.bearing import INNER, OUTER

_OF_GROOVES = {"load": "max", "capacitance": "sum"}
SUMS = ("friction_power", "damping_power")


def pairs(contacts: pd.DataFrame) -> pd.DataFrame:
    """A row per sample and ball loaded on both raceways, from a table of contacts: `load_inner`,
    `load_outer` and, if the contacts have them, `capacitance_inner`, `capacitance_outer` and
    `capacitance`, both in series. Of a ring with two grooves: the larger load, and the sum of the
    capacitances.
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


def totals(contacts: pd.DataFrame) -> pd.DataFrame:
    """A row per sample (the index), from a table of contacts with `attrs` as `dump.read_dump` sets
    them.

    Columns as `columns.BEARING` has them, as far as the contacts have what they need: largest
    loads, pressure and sums are 0 in a sample without contacts, the thinnest film is NaN.
    """
    first, samples = contacts.attrs["first"], contacts.attrs["samples"]
    table = pd.DataFrame(index=pd.RangeIndex(first, first + samples, name="sample"))
    both = pairs(contacts).groupby("sample")
    each = contacts.groupby("sample")
    table["contacts"] = each.size()
    table["loaded_balls"] = both.size()
    for name, side in (("load_inner", INNER), ("load_outer", OUTER)):
        table[name] = contacts.loc[contacts["raceway"] == side].groupby("sample")["load"].max()
    table["pressure"] = each["pressure"].max()
    for name in SUMS:
        if name in contacts:
            table[name] = each[name].sum()
    if "capacitance" in contacts:
        table["capacitance"] = both["capacitance"].sum()
    table = table.fillna(0.0).astype({"contacts": int, "loaded_balls": int})
    for name in ("h_min", "lambda"):
        if name in contacts:
            table[name] = each[name].min()
    return table.astype(
        {name: np.float64 for name in table if name not in ("contacts", "loaded_balls")}
    )
