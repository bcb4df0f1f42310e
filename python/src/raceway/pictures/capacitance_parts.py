# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the parts of a bearing's capacitance, computed from statics."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from raceway.files import FilePath
from raceway.pictures.electric_page import LEFT, RIGHT, head, plain_ticks
from raceway.pictures.style import PALETTE, drawing
from raceway.units import axis

# {quantity against which the capacitance can be plotted: (label, factor)}
OVER = {
    "rpm": ("inner ring speed (rpm)", 1.0),
    "load_N": ("radial load (N)", 1.0),
    "axial_N": ("axial load (N)", 1.0),
    "temperature_C": ("temperature of the lubricant (°C)", 1.0),
    "clearance_m": ("diametral clearance (µm)", 1e6),
}
PARTS = (
    ("capacitance_F", "plates: the contact ellipses", PALETTE[0]),
    ("capacitance_surroundings_F", "around the ellipses", PALETTE[4]),
    ("capacitance_unloaded_F", "balls without load", PALETTE[1]),
)


def parts(results: Sequence[Mapping[str, Any]], over: str, path: FilePath) -> None:
    """Plot the parts of the capacitance in `results` (from `electric_point.figures`) against the
    quantity `over`, which is a key of `OVER`, and write the plot to the PNG file `path`. Raises
    `RunError` if it cannot be written."""
    label, scale = OVER[over]
    results = sorted(results, key=lambda one: one[over])
    x = scale * np.array([one[over] for one in results])
    layers = np.array([[one[key] for one in results] for key, _, _ in PARTS])
    factor, unit = axis(layers.sum(0).max(), "F")
    with drawing(path, figsize=(10, 6), dpi=110) as figure:
        axes = figure.subplots()
        figure.subplots_adjust(left=LEFT, right=RIGHT, bottom=0.11, top=0.83)
        head(figure, results[0], "Parts of the bearing capacitance", without=over)
        axes.grid(True)
        axes.stackplot(
            x,
            factor * layers,
            labels=[name for _, name, _ in PARTS],
            colors=[colour for _, _, colour in PARTS],
            lw=0,
        )
        axes.set(xlabel=label, ylabel=f"capacitance ({unit})", xlim=(x[0], x[-1]))
        axes.set_ylim(0, 1.22 * factor * layers.sum(0).max())
        if x[0] > 0 and x[-1] > 8 * x[0]:
            axes.set_xscale("log")
            plain_ticks(axes, x)
        handles, names = axes.get_legend_handles_labels()
        axes.legend(handles, names, loc="upper left", ncols=3)
