# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures 8a and 9: capacitance of one ball around the ring."""

import numpy as np
import pandas as pd
from matplotlib import colormaps
from matplotlib.figure import Figure

from raceway.paper import panel, theory
from raceway.paper.book import Book
from raceway.paper.reading import GRID, gridded
from raceway.pictures.style import INK, PALETTE


def by_load(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 8a: capacitance of one ball around the ring for radial loads of 1 to 7 kN."""
    runs = book.readings.all("loads")
    figure, (axes,) = panel.page(
        "Capacitance of one ball around the ring",
        "6208, mineral oil, $U_r$ = 0.41 m/s, no clearance; without the 30 pF the paper adds",
    )
    table, shades = (
        pd.DataFrame({"psi_deg": GRID}),
        colormaps["viridis_r"](np.linspace(0.08, 0.8, len(runs))),
    )
    for run, shade in zip(runs, shades):
        value = gridded(*run.ball_capacitance())
        table[f"{run.given['load']}_N_F"] = value
        axes.plot(GRID, value * 1e12, color=shade, lw=2.8, label=f"{run.given['load'] / 1000:g} kN")
        table[f"{run.given['load']}_N_static_F"] = _static(axes, book, run)
    _finish(axes, table, "radial load")
    return figure, table


def by_clearance(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 9: capacitance of one ball around the ring for different clearances."""
    runs = book.readings.all("clearances")
    figure, (axes,) = panel.page(
        "Capacitance of one ball around the ring",
        "6208, mineral oil, 5 kN, $U_r$ = 0.41 m/s; without the 30 pF the paper adds",
    )
    table = pd.DataFrame({"psi_deg": GRID})
    for run, colour in zip(runs, PALETTE):
        ratio, value = run.given["clearance_ratio"], gridded(*run.ball_capacitance())
        table[f"ratio_{ratio:+g}_F"] = value
        label = f"{ratio:+g}" if ratio else "0"
        axes.plot(
            GRID,
            value * 1e12,
            color=colour,
            lw=2.8,
            label=f"{label}, ε = {run.figures['load_parameter']:.2f}".replace("-", "−"),
        )
        table[f"ratio_{ratio:+g}_static_F"] = _static(axes, book, run)
    _finish(axes, table, "$P_d/D$, load parameter")
    return figure, table


def _static(axes, book, run):
    """Plot static theory for the oil, load and clearance of a run, and return the capacitance in F
    on `GRID`."""
    gap = run.given.get("clearance_ratio", 0) * book.bearing.ball_diameter
    psi, load, _ = theory.loads(book.bearing, float(run.given["load"]), gap)
    order = np.argsort(psi, axis=None)
    value = theory.ball(
        book.bearing,
        book.oils[run.given["lubricant"]],
        load.flat[order],
        run.given["entrainment"],
        gap,
    )
    axes.plot(psi.flat[order], value * 1e12, color=INK, lw=0.9, ls=(0, (4, 3)), zorder=3)
    return np.interp(GRID, psi.flat[order], value, period=360)


def _finish(axes, table, title):
    panel.ring_axis(axes)
    axes.set(
        ylabel="capacitance of one ball (pF)", ylim=(0, panel.scale(table.iloc[:, 1:]) * 1.15e12)
    )
    axes.plot([], [], color=INK, lw=0.9, ls=(0, (4, 3)), label="static theory")
    panel.legend(
        axes, "upper left", title=title, fontsize=9.5, title_fontsize=9.5, labelspacing=0.35
    )
