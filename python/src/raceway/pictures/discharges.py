# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the position around the ring, the energy and the voltage of the discharges in a circuit."""

import numpy as np

from raceway.electric.circuit import Result
from raceway.files import FilePath
from raceway.pictures import style
from raceway.pictures.around_ring import polar
from raceway.pictures.page import LEFT, RIGHT, finish, head, key
from raceway.pictures.style import COLOUR, INK, NAME, PALETTE, SIDES, SOFT
from raceway.runs.run import Run
from raceway.units import axis

RACEWAYS = ("inner", "outer")


def picture(run: Run, result: Result, path: FilePath) -> None:
    """Plot the discharges in `result`, the circuit of `run`, and write the plot to the PNG file
    `path`.

    Each dot is a discharge, in the colour of the raceway at which the first film failed. In the
    left panel, its angle is the azimuth from the load line and its radius is the energy. The right
    panel shows the bearing voltage before each discharge, the voltage that remains after it, and
    the threshold voltage. Raises `RunError` if the picture cannot be written.
    """
    with style.drawing(path, figsize=(14, 7.4), dpi=110) as figure:
        head(figure, run.tables, _below(result), size=15)
        grid = figure.add_gridspec(
            1,
            2,
            left=LEFT,
            right=RIGHT,
            bottom=1.0 / 7.4,
            top=1 - 2.05 / 7.4,
            wspace=0.2,
            width_ratios=(1, 1.25),
        )
        _map(figure.add_subplot(grid[0], projection="polar"), result.events)
        _voltages(figure.add_subplot(grid[1]), result)


def _below(result):
    count = result.events["discharge"].nunique()
    length = float(result.data.time[-1])
    return f"{count} discharges in {length:.3g} s, {len(result.events)} films failed"


def _map(axes, events):
    first = events[events["order"] == 1]
    energy = events.groupby("discharge")["energy"].sum()
    largest = energy.max() if len(events) else 0.0
    factor, unit = axis(largest, "J")
    for side in SIDES:
        rows = first[first["raceway"] == RACEWAYS[side]]
        axes.plot(
            rows["from_load_line"].to_numpy(dtype=float),
            energy[rows["discharge"]].to_numpy(dtype=float) * factor,
            "o",
            ms=4.5,
            mfc="none",
            mec=COLOUR[side],
            mew=1.1,
            alpha=0.7,
        )
    handles = [
        key(f"{NAME[side]} first", color=COLOUR[side], marker="o", mfc="none", lw=0)
        for side in SIDES
    ]
    polar(axes, "Energy of discharges", unit, 1.08 * largest * factor or 1.0, handles)


def _voltages(axes, result):
    data, events = result
    factor, unit = axis(float(data.time[-1]), "s")
    time = data.time.to_numpy() * factor
    axes.plot(time, np.abs(data.bearing_voltage), color=SOFT, lw=0.7)
    threshold = data.threshold_voltage.where(np.isfinite(data.threshold_voltage))
    axes.plot(time, threshold, color=PALETTE[2], lw=1.6)
    first = events[events["order"] == 1]
    for side in SIDES:
        rows = first[first["raceway"] == RACEWAYS[side]]
        voltage = np.abs(rows["bearing_voltage"].to_numpy(dtype=float))
        axes.plot(
            rows["time"].to_numpy(dtype=float) * factor,
            voltage,
            "o",
            ms=3.5,
            color=COLOUR[side],
            mew=0,
            alpha=0.8,
        )
    axes.set(
        xlabel=f"time ({unit})", ylabel="magnitude of bearing voltage (V)", xlim=(time[0], time[-1])
    )
    tops = [float(np.abs(data.bearing_voltage).max()), *np.abs(first["bearing_voltage"])]
    tops.append(1.2 * float(threshold.min()) if threshold.notnull().any() else 0.0)
    finish(
        axes,
        "Bearing voltage",
        1.25 * max(tops),
        [
            key("after discharges", color=SOFT, lw=1.2),
            key("threshold", color=PALETTE[2], lw=1.6),
            key("before, as on the left", color=INK, marker="o", mew=0, lw=0, ms=5),
        ],
    )
