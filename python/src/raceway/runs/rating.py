# SPDX-License-Identifier: GPL-2.0-or-later
"""Equivalent load and rating life of a run, computed from the ball loads (ISO/TS 16281)."""

import numpy as np

from raceway import catalogue, inputs
from raceway.rows import Row
from raceway.runs.measured import loading
from raceway.runs.tables import RunTables
from raceway.theory import life

ROWS = (
    Row("equivalent_load_N", "equivalent load", "N", "ISO/TS 16281, loads of the balls"),
    Row("dynamic_rating_N", "dynamic load rating C", "N"),
    Row("life_reference_Mrev", "reference life, 10^6 turns", "", "ISO/TS 16281"),
    Row("life_reference_h", "reference life, hours", "", "90 % survive"),
)


def rating(tables: RunTables) -> dict[str, float | None]:
    """Return the equivalent load, rating and life with the keys of `ROWS`.

    All are None unless the inner ring rotates relative to a steady load and the record has contact
    loads; the life is also None if the bearing has no rating. The equivalent load does not depend
    on the rating. Each groove of a ring counts as a row.
    """
    result: dict[str, float | None] = dict.fromkeys(row.key for row in ROWS)
    means = _means(tables)
    if means is None:
        return result
    angle, rated = _of_file(tables)
    per_ring = np.split(means, 2)
    unit = life.of_means(tables.geometry, 1.0, *per_ring, angle)  # for a rating of 1 N
    result["equivalent_load_N"] = unit ** (-1 / 3)
    if rated is not None:
        turns = rated**3 * unit
        result["dynamic_rating_N"], result["life_reference_Mrev"] = rated, turns
        if rpm := abs(tables.settings["rpm"]):
            result["life_reference_h"] = turns * 1e6 / (60 * rpm)
    return result


def _means(tables):
    """Return the means (2 T,) of powers of the loads, first on the grooves of the inner ring, then
    on the grooves of the outer ring."""
    record, turning, load = tables.record, tables.turning, loading(tables)
    if "load" not in record.contact_columns or load is None or load.turns:
        return None
    if turning.speed(1, tables.first, tables.last).any():  # the outer ring turns
        return None
    grooves = len(record.raceways) // 2
    powers = np.repeat(life.POWERS, grooves)[:, None]
    total, count = np.zeros(2 * grooves), 0
    for first, stop in record.blocks(tables.first, tables.last):
        loads = np.nan_to_num(record.read(["load"], first, stop)["load"])
        total += (loads**powers).sum(axis=(0, 2))
        count += loads.shape[0] * loads.shape[2]
    return total / count if total.all() else None


def _of_file(tables):
    """Return (nominal contact angle in rad, dynamic rating of all grooves in N or None)."""
    angle = np.radians(float(tables.settings.get("contact_angle_deg", 0) or 0))
    try:
        path = catalogue.find("bearings", str(tables.settings["bearing"]))
        rated = inputs.ratings(path)
        four_point = inputs.four_point_angle(path)
    except inputs.InputError:
        return angle, None
    if four_point is not None:
        angle = four_point
    # The ratings in a file do not apply to a bearing to which the deck adds grooves.
    same = (four_point is not None) == tables.record.two_grooves
    return angle, rated.dynamic if rated and same else None
