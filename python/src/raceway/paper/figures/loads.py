# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure A.2: load of a ball around the ring for three clearances."""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from raceway.arrays import Floats
from raceway.paper import panel
from raceway.paper.book import Book
from raceway.paper.reading import GRID, gridded
from raceway.pictures.style import PALETTE
from raceway.theory import clearance, distribution
from raceway.theory.bearing import INNER, Bearing


def stribeck(bearing: Bearing, radial_load: float, gap: float, psi: Floats) -> tuple[Floats, float]:
    """Return (loads in N at `psi` in degrees, load parameter) for a clearance `gap` in m.

    The results follow from the theory of Stribeck and Harris (eq A.1).
    """
    parameter = clearance.load_parameter(gap, distribution.shift(bearing, radial_load, gap))
    return (
        distribution.largest_load(bearing.balls, radial_load, parameter)
        * distribution.relative_load(np.radians(psi), parameter),
        parameter,
    )


def distribution_curves(book: Book) -> list[tuple[float, float, Floats, Floats, float]]:
    """Return a list of tuples with P_d/D, the load parameter of the run, the simulated load Q on
    `GRID` in N, Q from eq A.1 in N, and the load parameter from eq A.1."""
    result = []
    for run in book.readings.all("distribution"):
        ratio = run.given["clearance_ratio"]
        load, parameter = stribeck(book.bearing, 5000.0, ratio * book.bearing.ball_diameter, GRID)
        result.append(
            (
                ratio,
                run.figures["load_parameter"],
                gridded(*run.around(INNER, "load")),
                load,
                parameter,
            )
        )
    return result


def distribution_page(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig A.2: ratio of ball load to radial load around the ring."""
    figure, (axes,) = panel.page(
        "Load of a ball around the ring", "6208, dry, 5 kN, 1 rad/s, inner raceway"
    )
    table = pd.DataFrame({"psi_deg": GRID})
    for (ratio, seen, load, rest, _), colour, marker in zip(
        distribution_curves(book), PALETTE[:2] + PALETTE[5:], "osD"
    ):
        some = slice(0, None, 10)
        label = f"simulation, $P_d/D$ = {ratio:g}, ε = {seen:.2f}".replace("-", "−")
        panel.marks(axes, GRID[some], load[some] / 5000, colour, label, marker)
        panel.theory(
            axes, GRID, rest / 5000, "Stribeck-Harris (eq A.1)" if ratio > 0 else None, colour
        )
        table[f"ratio_{ratio:+g}"], table[f"ratio_{ratio:+g}_stribeck"] = load / 5000, rest / 5000
    panel.ring_axis(axes)
    axes.set(ylabel="$Q_ψ/F_r$", ylim=(0, 1.52 * float(table.iloc[:, 1:].max().max())))
    panel.legend(axes, "upper left", fontsize=9.5)
    return figure, table
