# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures 12a and 12b: lambda ratio against speed and against the bearing's capacitance."""

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from raceway.paper import panel, theory
from raceway.paper.book import OILS, Book
from raceway.pictures.style import INK, PALETTE, SOFT
from raceway.theory import film
from raceway.theory.bearing import INNER

PASSAGE = 60e-12  # F, transition from boundary to mixed lubrication (section 4.2 of the paper)


def curves(book: Book, printed: bool = False) -> dict[str, pd.DataFrame]:
    """Return {oil: DataFrame} for the runs at 5 kN.

    The columns are entrainment_m_s, lambda (inner raceway, psi = 0) and capacitance_F (bearing).
    """
    result = {}
    for name in OILS:
        runs = book.readings.some(
            "speeds_printed" if printed else "speeds", lubricant=name, load=5000
        )
        result[name] = pd.DataFrame(
            {
                "entrainment_m_s": [run.given["entrainment"] for run in runs],
                "lambda": [run.top(INNER, "lambda") for run in runs],
                "capacitance_F": [run.figures["capacitance_F"] for run in runs],
            }
        )
    return result


def by_speed(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 12a: lambda ratio against entrainment speed."""
    speed = np.geomspace(0.005, 1.25, 120)
    figure, axes, _ = _page(
        book,
        "Lambda ratio against speed",
        speed,
        lambda rows: rows["entrainment_m_s"],
        lambda _: speed,
    )
    axes.set(xlabel="entrainment speed $U_r$ (m/s)", xlim=(0, 1.25))
    axes.legend(loc="upper left", handlelength=1.7)
    return figure, _table(book)


def by_capacitance(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig 12b: lambda ratio against the capacitance of the bearing."""
    speed = np.geomspace(0.018, 1.25, 30)

    def static(oil):
        values = [theory.bearing_capacitance(book.bearing, oil, 5000.0, one) for one in speed]
        return np.array(values) * 1e12

    figure, axes, top = _page(
        book,
        "Lambda ratio against the bearing's capacitance",
        speed,
        lambda rows: rows["capacitance_F"] * 1e12,
        static,
    )
    for (name, rows), marker in zip(curves(book, printed=True).items(), "os"):
        axes.plot(
            rows["capacitance_F"] * 1e12,
            rows["lambda"],
            marker + "--",
            ms=4,
            color=SOFT,
            lw=1,
            label=f"as printed, {OILS[name]}",
            zorder=2,
        )
    axes.axvline(PASSAGE * 1e12, color=INK, lw=1.2, ls=":")
    axes.text(PASSAGE * 1e12 + 12, 0.08 * top, "60 pF", fontsize=10)
    axes.set(xlabel="capacitance of the bearing (pF)", xlim=(0, 1500))
    axes.legend(loc="upper right", bbox_to_anchor=(0.83, 1.0), handlelength=1.7)
    return figure, _table(book)


def _page(book, title, speed, of_rows, of_oil):
    """Return (figure, axes, upper limit) with the lambda ratios of the runs at `of_rows(rows)` and
    those of theory at the given speeds, which are at `of_oil(oil)` on the x axis."""
    roughness, found = book.oils["mineral"].roughness * 1e6, curves(book)
    figure, (axes,) = panel.page(
        title,
        f"6208, 5 kN, no clearance; inner raceway, ψ = 0; roughness {roughness:g} µm is assumed",
    )
    top = 1.15 * max(rows["lambda"].max() for rows in found.values())
    panel.regimes(axes, top, 0.985)
    q = theory.largest_load(book.bearing, 5000.0)
    for (name, rows), colour, marker in zip(found.items(), PALETTE, "os"):
        oil, words = book.oils[name], OILS[name]
        thick = theory.contact(book.bearing, oil, INNER, q, speed).h_min
        panel.marks(axes, of_rows(rows), rows["lambda"], colour, f"simulation, {words}", marker)
        ratio = film.ratio(thick, oil.roughness)
        panel.theory(axes, of_oil(oil), ratio, f"static theory, {words}", colour)
    axes.set(ylabel="lambda ratio $Λ_f$", ylim=(0, top))
    return figure, axes, top


def _table(book):
    both = [
        rows.assign(oil=name, formulas=form)
        for form, printed in (("corrected", False), ("printed", True))
        for name, rows in curves(book, printed).items()
    ]
    return pd.concat(both)
