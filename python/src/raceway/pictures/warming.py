# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot temperatures, losses and clearance of a run against thermal time."""

import numpy as np

from raceway.files import FilePath
from raceway.pictures.style import INK, PALETTE, drawing
from raceway.runs.measured import title
from raceway.runs.tables import RunTables
from raceway.runs.warming import PARTS, transient
from raceway.units import axis

NAMES = {"inner": "inner ring", "outer": "outer ring", "oil": "oil in the contacts"}
LONG = 600.0  # s, thermal time above which the axis is in minutes


def warming(tables: RunTables, path: FilePath) -> None:
    """Plot the run `tables` and write the plot to the PNG file `path`. Raises `RunError` if the run
    has no table of time jumps."""
    found = transient(tables.folder)
    time = found["thermal_time"].to_numpy()
    minutes = time[-1] > LONG
    with drawing(path, figsize=(10, 8), dpi=120, layout="constrained") as figure:
        (warm, lost, clear) = figure.subplots(3, 1, sharex=True, height_ratios=(2, 1, 1))
        along = time / 60 if minutes else time
        figure.suptitle(title(tables))
        for k, part in enumerate(PARTS):
            values = found[f"temperature_{part}"].to_numpy()
            if part == "housing" and np.array_equal(values, found["temperature_outer"]):
                continue
            line = dict(color=INK, ls="--") if part == "oil" else dict(color=PALETTE[k])
            warm.plot(along, values, marker=".", label=NAMES.get(part, part), **line)
        warm.set(ylabel="temperature (°C)")
        warm.legend()
        lost.plot(along, found["power"], color=INK, marker=".")
        lost.set(ylabel="losses (W)")
        values = found["clearance"].to_numpy()
        factor, unit = axis(abs(values).max(), "m")
        clear.plot(along, factor * values, color=INK, marker=".")
        clear.set(
            ylabel=f"clearance ({unit})",
            xlabel=f"thermal time ({'min' if minutes else 's'}); a dot is a jump",
        )
        for one in (warm, lost, clear):
            one.grid(True)
