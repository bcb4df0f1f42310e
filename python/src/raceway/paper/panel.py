# SPDX-License-Identifier: GPL-2.0-or-later
"""Functions shared by the figures of the paper."""

from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.legend import Legend
from numpy.typing import ArrayLike, NDArray

from raceway.pictures.style import FAINT, INK, REGIMES, SOFT

SIZE, DPI = (6.6, 4.6), 110
AZIMUTH = "azimuth ψ from the load line (°)"


def page(title: str, note: str, columns: int = 1) -> tuple[Figure, NDArray[Any]]:
    """Return (figure, axes) with a title and a line of text that describes the run."""
    figure, axes = plt.subplots(
        1,
        columns,
        figsize=(SIZE[0] * (1.55 if columns > 1 else 1), SIZE[1]),
        dpi=DPI,
        squeeze=False,
    )
    figure.subplots_adjust(
        left=0.13 if columns == 1 else 0.085, right=0.965, top=0.83, bottom=0.13, wspace=0.24
    )
    left = figure.subplotpars.left
    figure.text(left, 0.945, title, fontsize=13, fontweight="bold", va="center")
    figure.text(left, 0.88, note, fontsize=9.5, color=SOFT, va="center")
    for one in axes[0]:
        one.grid(True)
    return figure, axes[0]


def ring_axis(axes: Axes) -> None:
    """Set up the x axis as an azimuth from -180 to 180 degrees."""
    axes.set(xlabel=AZIMUTH, xlim=(-180, 180), xticks=range(-180, 181, 45))


def legend(axes: Axes, where: str, **options: Any) -> Legend:
    """Add a legend with a white background, so that the grid does not cross it."""
    return axes.legend(
        loc=where,
        frameon=True,
        facecolor="white",
        edgecolor="none",
        framealpha=1,
        borderaxespad=0.3,
        handlelength=1.7,
        **options,
    )


def regimes(axes: Axes, top: float, at: float) -> None:
    """Draw bands for the lubrication regimes along the y axis, which is the lambda ratio.

    The names of the regimes are at the fraction `at` of the width.
    """
    for low, high, name, colour in REGIMES:
        if low < top:
            axes.axhspan(low, min(high, top), color=colour, lw=0, zorder=0.1)
            axes.text(
                at,
                min(high, top) - 0.03 * top,
                name,
                transform=axes.get_yaxis_transform(),
                ha="right",
                va="top",
                fontsize=10,
                color=SOFT,
            )
            if low:
                axes.axhline(low, color=FAINT, lw=1, zorder=0.2)


def marks(
    axes: Axes, x: ArrayLike, y: ArrayLike, colour: str, label: str, marker: str = "o"
) -> None:
    """Plot results of the simulation as open symbols."""
    axes.plot(x, y, marker, ms=6.5, mfc="white", mec=colour, mew=1.7, label=label, zorder=4)


def whole(axes: Axes, x: ArrayLike, y: ArrayLike, colour: str, label: str | None = None) -> None:
    """Plot results of the simulation with the total capacitance as crosses."""
    axes.plot(x, y, "+", ms=9, mew=1.7, color=colour, label=label, zorder=5)


def theory(
    axes: Axes,
    x: ArrayLike,
    y: ArrayLike,
    label: str | None = None,
    colour: str = INK,
    **options: Any,
) -> None:
    """Plot results of theory as a thin line."""
    axes.plot(x, y, color=colour, lw=1.3, label=label, zorder=3, **options)


def scale(values: ArrayLike) -> float:
    """Return the upper limit for an axis that starts at zero."""
    return 1.08 * float(np.nanmax(values))
