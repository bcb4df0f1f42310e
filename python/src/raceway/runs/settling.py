# SPDX-License-Identifier: GPL-2.0-or-later
"""Settling of a run: its latest changes, and those that remain after its last ball pass."""

import math

import numpy as np

from raceway.arrays import filled
from raceway.core import library
from raceway.errors import RunError
from raceway.runs.cage import ring_of_cage
from raceway.runs.columns import LOSSES
from raceway.runs.tables import RunTables
from raceway.runs.turning import changes

KEYS = {
    "torque": "settled_torque",
    "load": "settled_load",
    "cage_speed": "settled_cage_speed",
    "spin_axis": "settled_spin_axis_rad",
    "remaining_torque": "remaining_torque",
    "remaining_load": "remaining_load",
    "remaining_cage_speed": "remaining_cage_speed",
    "remaining_spin_axis": "remaining_spin_axis_rad",
}
ORBIT = "settled_cage_orbit"  # only for a run with a one-piece cage
MOST = 20  # ball passes that are compared, at most


def settling(tables: RunTables) -> dict[str, float | None]:
    """Return the changes between the last two ball passes of the window, or between its two halves
    if it has fewer than two passes (`settled_...`), and estimates of the changes that remain after
    the last ball pass (`remaining_...`).

    They are the relative changes of the mean friction torque, of the largest load on either raceway
    and of the cage speed, the angle (rad) by which the load-weighted mean spin axis of the balls
    turns, and, with a one-piece cage, `settled_cage_orbit`, the latest change of its mean distance
    from the axis as a fraction of half the play. A change is None if the run has not recorded the
    quantity, or if the speed of the rings changes. The formulas are in
    `src-package/core/figures/settling.h` and `settling_rest.h`.
    """
    result: dict[str, float | None] = dict.fromkeys(KEYS.values())
    first, last = max(tables.first, 1), tables.last
    turning = tables.turning
    speed = turning.shaft_speed(first, last) if last > first else np.zeros(0)
    if len(speed) < 2 or changes(speed):
        return result
    samples = _samples(tables, first, last)
    passes = min(MOST, (last - first) // samples)
    first = last - passes * samples
    here = slice(first - tables.first, last - tables.first)
    totals = {name: values[here] for name, values in tables.total_columns.items()}
    losses = [totals[name] for name in LOSSES.values() if name in totals]
    # The cage speed is recorded once per step.
    power = filled(sum(losses)) if losses else np.full(passes * samples, math.nan)
    balls, orbit = _balls(tables, first, last), _orbit(tables, first, last)
    found = library().call(
        "settling",
        passes=passes,
        samples=samples,
        balls=balls["load"].shape[1],
        torque=power,
        load=np.stack([totals["load_inner"], totals["load_outer"]], axis=-1),
        cage_speed=totals["cage_speed"],
        cage_orbit=orbit if orbit.size else np.zeros(passes * samples),
        ball_load=balls["load"],
        place=balls["place"],
        spin=balls["spin"],
    )
    for field, key in KEYS.items():
        value = getattr(found, field)
        result[key] = float(value) if math.isfinite(value) else None
    if not balls["load"].size:
        result["settled_spin_axis_rad"] = result["remaining_spin_axis_rad"] = None
    if orbit.size:
        result[ORBIT] = float(found.cage_orbit)
    return result


def _samples(tables, first, last):
    """Return the number of samples in a ball pass, at most half of the window."""
    most = (last - first) // 2
    passes = tables.turning.passes([first, last - 1])
    a_sample = abs(float(passes[1] - passes[0])) / (last - 1 - first)
    if not a_sample:
        return most
    return max(1, min(most, round(1 / a_sample)))


def _orbit(tables, first, last):
    """Return the distance of a one-piece cage from the axis for each sample, as a fraction of half
    the play; the array is empty if there is no such cage or if it has no play."""
    cage, play = ring_of_cage(tables.record) or (0, 0.0)
    if not play > 0:
        return np.zeros(0)
    place = tables.record.read(["ring_x", "ring_y"], first, last)
    return np.hypot(place["ring_x"][:, cage], place["ring_y"][:, cage]) / (play / 2)


def _balls(tables, first, last):
    """Return loads (N), positions relative to the bearing's centre (m) and spins (rad/s) for each
    sample and ball; the arrays are empty if the run has not recorded them."""
    record, samples = tables.record, last - first
    try:
        load = record.read(["load"], first, last)["load"].sum(axis=1)
        place, spin = (
            np.stack(list(record.read([f"ball_{way}{x}" for x in "xyz"], first, last).values()), -1)
            for way in ("", "omega")
        )
    except RunError:
        return {"load": np.zeros((samples, 0)), "place": np.zeros(0), "spin": np.zeros(0)}
    return {"load": np.nan_to_num(load), "place": place, "spin": spin}
