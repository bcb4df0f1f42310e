# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures 6a and 6b: contact pressure and its effect on the permittivity of the oil."""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from raceway.paper import panel, theory
from raceway.paper.book import Book
from raceway.paper.reading import GRID, gridded
from raceway.pictures.style import COLOUR, NAME
from raceway.theory import capacitance
from raceway.theory.bearing import INNER, OUTER

SIDE = {INNER: "inner", OUTER: "outer"}


def permittivity(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 6a: relative permittivity against Hertz pressure."""
    run, oil = book.readings.one("pressure"), book.oils["pao48"]
    figure, (axes,) = panel.page(
        "Permittivity against Hertz pressure",
        "6208, PAO VG48, 5 kN, 477.5 rpm: contacts of one ball pass",
    )
    tables, most = [], 0
    for side, marker in ((OUTER, "s"), (INNER, "o")):
        pressure, value = run.around(side, "pressure")[1], run.permittivity(side)[1]
        order = np.argsort(pressure)
        some = order[
            np.unique(
                np.searchsorted(pressure[order], np.linspace(0, pressure.max(), 16)).clip(
                    0, len(order) - 1
                )
            )
        ]
        most = max(most, pressure.max())
        panel.marks(
            axes,
            pressure[some] * 1e-9,
            value[some],
            COLOUR[side],
            f"simulation, {NAME[side]}",
            marker,
        )
        tables.append(
            pd.DataFrame(
                {"raceway": SIDE[side], "pressure_Pa": pressure[some], "permittivity": value[some]}
            )
        )
    line = np.linspace(0, 1.1 * most, 200)
    panel.theory(
        axes,
        line * 1e-9,
        capacitance.permittivity(oil.permittivity, line),
        "Clausius-Mossotti, Dowson-Higginson",
    )
    axes.set(
        xlabel="Hertz pressure (GPa)",
        ylabel="relative permittivity $ε_r$",
        xlim=(0, 1.1 * most * 1e-9),
    )
    panel.legend(axes, "lower right")
    return figure, pd.concat(tables)


def around(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 6b: Hertz pressure around the ring."""
    run, bearing = book.readings.one("pressure"), book.bearing
    figure, (axes,) = panel.page(
        "Hertz pressure around the ring",
        "6208, PAO VG48, 5 kN, 477.5 rpm, no clearance; beyond 90° centrifugal load only",
    )
    table = pd.DataFrame({"psi_deg": GRID})
    psi, load, _ = theory.loads(bearing, 5000.0)
    order = np.argsort(psi, axis=None)
    most = 0
    for side in (INNER, OUTER):
        value = gridded(*run.around(side, "pressure"))
        rest = np.nan_to_num(theory.contact(bearing, book.oils["pao48"], side, load, 1.0).pressure)
        table[f"{SIDE[side]}_Pa"] = value
        table[f"{SIDE[side]}_static_Pa"] = np.interp(
            GRID, psi.flat[order], rest.flat[order], period=360
        )
        axes.plot(GRID, value * 1e-9, color=COLOUR[side], lw=4.5, label=NAME[side])
        panel.theory(
            axes,
            psi.flat[order],
            rest.flat[order] * 1e-9,
            "static theory" if side == OUTER else None,
        )
        most = max(most, value.max())
    panel.ring_axis(axes)
    axes.set(ylabel="Hertz pressure (GPa)", ylim=(0, 1.3 * most * 1e-9))
    panel.legend(axes, "upper left", ncols=3, columnspacing=1.0, fontsize=9.5)
    return figure, table
