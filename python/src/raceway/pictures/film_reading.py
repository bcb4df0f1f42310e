# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot the film thickness that an instrument reads from the capacitance of a bearing."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from raceway.files import FilePath
from raceway.pictures.electric_page import LEFT, RIGHT, head, plain_ticks
from raceway.pictures.style import PALETTE, SOFT, drawing
from raceway.theory.film_reading import Reading


def reading(curve: Reading, names: Mapping[str, Any], path: FilePath) -> None:
    """Plot the film thickness that an instrument would read, and its error, against the thickness
    in the model, and write the plot to the PNG file `path`. Raises `RunError` if it cannot be
    written."""
    lines = (
        (curve.by_plates, "all capacitance as plates", PALETTE[5], "-"),
        (curve.less_constant, "after subtraction of a constant", PALETTE[0], (0, (4, 2))),
    )
    h = 1e9 * curve.h_c
    with drawing(path, figsize=(10, 8.2), dpi=110) as figure:
        (top, bottom) = figure.subplots(2, 1, sharex=True, height_ratios=(1.4, 1))
        figure.subplots_adjust(left=LEFT + 0.02, right=RIGHT, bottom=0.085, top=0.86, hspace=0.1)
        head(figure, names, "Film thickness read from the capacitance")
        top.loglog(h, h, color=SOFT, lw=1, label="the film itself")
        for values, text, colour, dashes in lines:
            top.loglog(h, 1e9 * values, color=colour, ls=dashes, lw=2.2, label=text)
            bottom.semilogx(h, 100 * (values / curve.h_c - 1), color=colour, ls=dashes, lw=2.2)
        bottom.axhline(0, color=SOFT, lw=1)
        top.set(ylabel="read (nm)", ylim=(0.5e9 * np.nanmin(curve.by_plates), 2 * h[-1]))
        top.legend(loc="upper left")
        bottom.set(
            xlabel="central film thickness at the largest load (nm)",
            ylabel="error (%)",
            ylim=(-100, 100),
            xlim=(h[0], h[-1]),
        )
        for axes in (top, bottom):
            axes.grid(True)
        plain_ticks(bottom, h)
