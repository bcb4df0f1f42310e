# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the impedance of a bearing, computed from statics, as a function of frequency."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from raceway.arrays import Floats
from raceway.files import FilePath
from raceway.pictures.electric_page import LEFT, RIGHT, head
from raceway.pictures.style import PALETTE, drawing
from raceway.theory.electric_point import Point, of_pass


def frequencies(resistivity: float, count: int = 400) -> Floats:
    """Return frequencies (count,) in Hz from far below the corner frequency of the films, for an
    oil with `resistivity` (ohm m), to 100 MHz."""
    corner = 1 / (2 * np.pi * resistivity * 2e-11) if np.isfinite(resistivity) else 1.0
    return np.geomspace(10 ** np.floor(np.log10(max(corner / 100, 1e-3))), 1e8, count)


def impedance_axes(figure: Figure, left: float) -> tuple[Axes, Axes]:
    """Return axes for the magnitude and the phase of an impedance against frequency, from `left` (a
    fraction of the figure width)."""
    (top, bottom) = figure.subplots(2, 1, sharex=True, height_ratios=(1.5, 1))
    figure.subplots_adjust(left=left, right=RIGHT, bottom=0.09, top=0.85, hspace=0.1)
    top.set(xscale="log", yscale="log", ylabel="|Z| (Ω)")
    bottom.set(xlabel="frequency (Hz)", ylabel="phase (°)", ylim=(-95, 5))
    bottom.set_yticks([-90, -60, -30, 0])
    for axes in (top, bottom):
        axes.grid(True)
    return top, bottom


def bode(point: Point, names: Mapping[str, Any], resistivity: float, path: FilePath) -> None:
    """Plot magnitude and phase of the impedance against frequency, for the bearing and for its
    plates alone, in an oil with `resistivity` (ohm m). Write the plot to the PNG file `path`.
    Raises `RunError` if the file cannot be written."""
    every = point.every()
    bare = [
        type(one)(*(_plates(side, one.inner.load > 0) for side in (one.inner, one.outer)))
        for one in every
    ]
    frequency = frequencies(resistivity)
    with drawing(path, figsize=(10, 7.6), dpi=110) as figure:
        top, bottom = impedance_axes(figure, LEFT + 0.02)
        head(figure, names, "Impedance of the bearing")
        for found, text, colour, dashes in (
            (every, "all of the capacitance", PALETTE[0], "-"),
            (bare, "plates alone", PALETTE[1], (0, (4, 2))),
        ):
            z = of_pass(point, found, frequency, resistivity)
            for axes, values in ((top, np.abs(z)), (bottom, np.degrees(np.angle(z)))):
                axes.plot(frequency, values, color=colour, ls=dashes, lw=2.2, label=text)
        top.legend(loc="upper right")
        top.set_xlim(frequency[0], frequency[-1])


def _plates(side, loaded):
    """Return the contact ellipses of the `loaded` balls alone."""
    part = type(side)(*(values[loaded] for values in side))
    return part._replace(outside=0 * part.outside, paths=part.area / part.separation)
