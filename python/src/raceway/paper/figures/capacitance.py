# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures 8b, 10a, 10b, 11: capacitance against load, speed and film thickness."""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from raceway.paper import panel, theory
from raceway.paper.book import OILS, Book
from raceway.pictures.style import PALETTE, SOFT
from raceway.theory.bearing import INNER

WHOLE = "all of the capacitance"
BACKGROUND = 30e-12  # F, background that the paper adds (section 4.1)


def by_load(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 8b: capacitance of a ball on the load line against the radial load."""
    bearing, oil = book.bearing, book.oils["mineral"]
    figure, (axes,) = panel.page(
        "Capacitance on the load line against the load",
        "6208, mineral oil, $U_r$ = 0.41 m/s, no clearance, one ball at ψ = 0",
    )
    runs, printed = book.readings.all("loads"), book.readings.all("loads_printed")
    loads = np.array([run.given["load"] for run in runs], float)
    value = np.array([run.top_capacitance() for run in runs])
    whole = np.array([run.whole_top_capacitance() for run in runs])
    other = np.array([run.top_capacitance() for run in printed])
    line = np.linspace(1000, 7000, 25)
    # Without clearance, this fraction is the same for every load.
    share = theory.largest_load(bearing, 5000.0) / 5000.0
    rest, rest_printed = (
        theory.ball(bearing, oil, share * line, 0.41, printed=form) for form in (False, True)
    )
    panel.theory(axes, line * 1e-3, rest * 1e12, "static theory", PALETTE[0])
    panel.theory(axes, line * 1e-3, rest_printed * 1e12, colour=SOFT, ls="--")
    panel.marks(axes, loads * 1e-3, value * 1e12, PALETTE[0], "simulation")
    panel.marks(
        axes, loads * 1e-3, (value + BACKGROUND) * 1e12, PALETTE[5], "simulation + 30 pF", "^"
    )
    panel.whole(axes, loads * 1e-3, whole * 1e12, PALETTE[2], WHOLE)
    panel.marks(axes, loads * 1e-3, other * 1e12, SOFT, "formulas as printed", "s")
    axes.set(
        xlabel="radial load $F_r$ (kN)",
        ylabel="capacitance of one ball (pF)",
        xlim=(0, 7.4),
        ylim=(0, panel.scale(value + BACKGROUND) * 1.12e12),
    )
    panel.legend(axes, "upper left")
    return figure, pd.DataFrame(
        {
            "load_N": loads,
            "capacitance_F": value,
            "with_background_F": value + BACKGROUND,
            "whole_F": whole,
            "static_F": theory.ball(bearing, oil, share * loads, 0.41),
            "printed_F": other,
        }
    )


def mineral(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 10a: capacitance on the load line against entrainment speed, mineral oil."""
    return _by_speed(book, "mineral")


def pao(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 10b: capacitance on the load line against entrainment speed, PAO VG48."""
    return _by_speed(book, "pao48")


def _by_speed(book, oil):
    figure, (axes,) = panel.page(
        "Capacitance on the load line against speed",
        f"6208, {OILS[oil]}, no clearance, ψ = 0; without the 30 pF the paper adds",
    )
    # Both oils have the same scale, so that they can be compared.
    most = max(
        run.whole_top_capacitance()
        for name in OILS
        for run in book.readings.some("speeds", lubricant=name)
    )
    tables = []
    for load, colour, marker in ((5000, PALETTE[5], "s"), (1000, PALETTE[0], "o")):
        runs = book.readings.some("speeds", lubricant=oil, load=load)
        printed = book.readings.some("speeds_printed", lubricant=oil, load=load)
        speed = np.array([run.given["entrainment"] for run in runs])
        value, other = (
            np.array([run.top_capacitance() for run in some]) for some in (runs, printed)
        )
        line, q = np.geomspace(0.018, 1.25, 120), theory.largest_load(book.bearing, float(load))
        rest, rest_printed = (
            theory.ball(book.bearing, book.oils[oil], q, line, printed=form)
            for form in (False, True)
        )
        panel.marks(axes, speed, value * 1e12, colour, f"simulation, {load / 1000:g} kN", marker)
        whole = np.array([run.whole_top_capacitance() for run in runs])
        panel.whole(axes, speed, whole * 1e12, colour, None if tables else WHOLE)
        panel.theory(axes, line, rest * 1e12, f"static theory, {load / 1000:g} kN", colour)
        panel.theory(
            axes, line, rest_printed * 1e12, f"as printed, {load / 1000:g} kN", colour, ls="--"
        )
        tables.append(
            pd.DataFrame(
                {
                    "load_N": load,
                    "entrainment_m_s": speed,
                    "capacitance_F": value,
                    "whole_F": whole,
                    "static_F": theory.ball(book.bearing, book.oils[oil], q, speed),
                    "printed_F": other,
                }
            )
        )
    axes.set(
        xlabel="entrainment speed $U_r$ (m/s)",
        ylabel="capacitance of one ball (pF)",
        xlim=(0, 1.25),
        ylim=(0, panel.scale(most) * 1e12),
    )
    panel.legend(axes, "upper right")
    return figure, pd.concat(tables)


def by_film(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 11: capacitance of the bearing divided by permittivity, against film thickness."""
    figure, (axes,) = panel.page(
        "Capacitance over permittivity against film thickness",
        "6208, 5 kN, no clearance: mean of the bearing; film of the inner raceway at ψ = 0",
    )
    tables = []
    q = theory.largest_load(book.bearing, 5000.0)
    for (name, words), colour, marker, line in zip(OILS.items(), PALETTE, "os", ("-", "--")):
        oil, runs = book.oils[name], book.readings.some("speeds", lubricant=name, load=5000)
        film = np.array([run.top(INNER, "h_min") for run in runs])
        value = np.array([run.figures["capacitance_F"] for run in runs]) / oil.permittivity
        speed = np.geomspace(0.018, 1.25, 30)
        thick = theory.contact(book.bearing, oil, INNER, q, speed).h_min
        rest = (
            np.array([theory.bearing_capacitance(book.bearing, oil, 5000.0, one) for one in speed])
            / oil.permittivity
        )
        panel.marks(axes, film * 1e9, value * 1e12, colour, f"simulation, {words}", marker)
        panel.theory(axes, thick * 1e9, rest * 1e12, f"static theory, {words}", colour, ls=line)
        whole = np.array([run.whole_capacitance() for run in runs]) / oil.permittivity
        panel.whole(axes, film * 1e9, whole * 1e12, colour, f"{WHOLE}, {words}")
        tables.append(
            pd.DataFrame(
                {
                    "oil": name,
                    "h_min_m": film,
                    "capacitance_over_permittivity_F": value,
                    "whole_over_permittivity_F": whole,
                }
            )
        )
    axes.set(
        xlabel="smallest film thickness $h_{min}$, inner raceway (nm)",
        ylabel="$C_{bearing}/ε_r$ (pF)",
        xlim=(0, None),
        ylim=(0, panel.scale(max(table.iloc[:, 3].max() for table in tables)) * 1e12),
    )
    panel.legend(axes, "upper right")
    return figure, pd.concat(tables)
