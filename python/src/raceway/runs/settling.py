# SPDX-License-Identifier: GPL-2.0-or-later
"""Settling of a run, measured by the change of its means from one ball pass to the next."""

import math

import numpy as np

from raceway.core import library
from raceway.errors import RunError
from raceway.runs.columns import LOSSES
from raceway.runs.tables import RunTables
from raceway.runs.turning import changes

KEYS = {
    "torque": "settled_torque",
    "load": "settled_load",
    "cage_speed": "settled_cage_speed",
    "spin_axis": "settled_spin_axis_rad",
}


def settling(tables: RunTables) -> dict[str, float | None]:
    """Return the changes between the last two ball passes of the window, or between its two halves
    if the window has fewer than two passes.

    They are the relative changes of the mean friction torque, of the largest load on either raceway
    and of the cage speed, and `settled_spin_axis_rad`, the angle between the load-weighted mean
    spin axes of the balls. A change is None if the run has not recorded the quantity, or if the
    speed of the rings changes. The formulas are in `src-package/core/figures/settling.h`.
    """
    result: dict[str, float | None] = dict.fromkeys(KEYS.values())
    first, last = max(tables.first, 1), tables.last
    turning = tables.turning
    speed = turning.shaft_speed(first, last) if last > first else np.zeros(0)
    if len(speed) < 2 or changes(speed):
        return result
    half = _half(tables, first, last)
    first = last - 2 * half
    totals = tables.totals.loc[first : last - 1]
    losses = [totals[name] for name in LOSSES.values() if name in totals]
    # The cage speed is recorded once per step.
    power = sum(losses).ffill().bfill() if losses else None
    balls = _balls(tables, first, last)
    found = library().call(
        "settling",
        samples=2 * half,
        balls=balls["load"].shape[1],
        half=half,
        torque=power.to_numpy() if losses else np.full(2 * half, math.nan),
        load=totals[["load_inner", "load_outer"]].to_numpy(),
        cage_speed=totals["cage_speed"].to_numpy(),
        ball_load=balls["load"],
        place=balls["place"],
        spin=balls["spin"],
    )
    for field, key in KEYS.items():
        value = getattr(found, field)
        result[key] = float(value) if math.isfinite(value) else None
    if not balls["load"].size:
        result["settled_spin_axis_rad"] = None
    return result


def _half(tables, first, last):
    """Return the number of samples in a ball pass, at most half of the window."""
    most = (last - first) // 2
    passes = tables.turning.passes([first, last - 1])
    a_sample = abs(float(passes[1] - passes[0])) / (last - 1 - first)
    if not a_sample:
        return most
    return max(1, min(most, round(1 / a_sample)))


def _balls(tables, first, last):
    """Return loads (N), positions relative to the bearing's centre (m) and spins (rad/s) for each
    sample and ball; the arrays are empty if the run has not recorded them."""
    record, samples = tables.record, last - first
    try:
        load = record.read(["load"], first, last)["load"].sum(axis=1)
        names = [f"ball_{name}" for name in ("x", "y", "z", "omegax", "omegay", "omegaz")]
        read = np.stack(list(record.read(names, first, last).values()), axis=-1)
    except RunError:
        return {"load": np.zeros((samples, 0)), "place": np.zeros(0), "spin": np.zeros(0)}
    return {"load": np.nan_to_num(load), "place": read[..., :3], "spin": read[..., 3:]}
