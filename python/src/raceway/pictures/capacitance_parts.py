# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the parts of a bearing's capacitance, computed from statics."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from raceway.arrays import Floats
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


def stack(axes: Axes, x: Floats, layers: Floats) -> None:
    """Plot the `layers` (parts, N) in F of `PARTS` against `x` (N,), on top of each other."""
    most = layers.sum(0).max()
    factor, unit = axis(most, "F")
    _, names, colours = zip(*PARTS)
    axes.grid(True)
    axes.stackplot(x, factor * layers, labels=names, colors=colours, lw=0)
    axes.set(ylabel=f"capacitance ({unit})", ylim=(0, 1.22 * factor * most))
    axes.legend(loc="upper left", ncols=3)


def parts(results: Sequence[Mapping[str, Any]], over: str, path: FilePath) -> None:
    """Plot the parts of the capacitance in `results` (from `electric_point.figures`) against the
    quantity `over`, which is a key of `OVER`, and write the plot to the PNG file `path`. Raises
    `RunError` if it cannot be written."""
    label, scale = OVER[over]
    results = sorted(results, key=lambda one: one[over])
    x = scale * np.array([one[over] for one in results])
    layers = np.array([[one[key] for one in results] for key, _, _ in PARTS])
    with drawing(path, figsize=(10, 6), dpi=110) as figure:
        axes = figure.subplots()
        figure.subplots_adjust(left=LEFT, right=RIGHT, bottom=0.11, top=0.83)
        head(figure, results[0], "Parts of the bearing capacitance", without=over)
        stack(axes, x, layers)
        axes.set(xlabel=label, xlim=(x[0], x[-1]))
        if x[0] > 0 and x[-1] > 8 * x[0]:
            axes.set_xscale("log")
            plain_ticks(axes, x)
