# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure A.4: free contact angle and endplay."""

from dataclasses import replace

import numpy as np
import pandas as pd
from matplotlib.figure import Figure

from raceway.paper import cases, panel
from raceway.paper.book import Book
from raceway.pictures.style import PALETTE
from raceway.theory import clearance
from raceway.theory.bearing import Bearing


def curved(bearing: Bearing, total_curvature: float) -> Bearing:
    """Return the bearing with the total curvature B (eq A.2) for both grooves."""
    radius = cases.groove(bearing, total_curvature)
    return replace(bearing, inner_groove=radius, outer_groove=radius)


def measured(book: Book) -> pd.DataFrame:
    """Return a DataFrame of free contact angle and endplay from the simulation and from eqs A.3
    and A.4, for each total curvature and clearance."""
    rows = []
    for given, angle, endplay in book.readings.endplays():
        bearing = curved(book.bearing, given["total_curvature"])
        gap = given["clearance_ratio"] * bearing.ball_diameter
        rows.append(
            (
                given["total_curvature"],
                gap,
                angle,
                np.degrees(clearance.free_contact_angle(bearing, gap)),
                endplay,
                clearance.free_endplay(bearing, gap),
            )
        )
    return pd.DataFrame(
        rows,
        columns="total_curvature clearance_m angle_deg angle_A3_deg endplay_m endplay_A4_m".split(),
    )


def play(book: Book) -> tuple[Figure, pd.DataFrame]:
    """Fig A.4: free contact angle and endplay against clearance."""
    figure, (left, right) = panel.page(
        "Free contact angle and free endplay",
        "6208 with other grooves, dry; B = 2 $r_c$/D − 1; "
        "the clearances were chosen here, because the paper's axis is missing",
        columns=2,
    )
    table, diameter = measured(book), book.bearing.ball_diameter
    line = np.linspace(0, 0.0055, 100)
    for (curvature, rows), colour, marker in zip(
        table.groupby("total_curvature"), PALETTE[:3] + PALETTE[5:], "osD^"
    ):
        bearing = curved(book.bearing, curvature)
        ratio = rows["clearance_m"] / diameter
        panel.marks(left, ratio * 1e3, rows["angle_deg"], colour, f"B = {curvature:.2f}", marker)
        panel.marks(
            right, ratio * 1e3, rows["endplay_m"] * 1e6, colour, f"B = {curvature:.2f}", marker
        )
        last = "eqs A.3, A.4" if curvature == table["total_curvature"].max() else None
        panel.theory(
            left,
            line * 1e3,
            np.degrees(clearance.free_contact_angle(bearing, line * diameter)),
            last,
            colour,
        )
        panel.theory(
            right, line * 1e3, clearance.free_endplay(bearing, line * diameter) * 1e6, last, colour
        )
    for axes, name in ((left, "free contact angle α⁰ (°)"), (right, "free endplay $P_e$ (µm)")):
        axes.set(xlabel="$P_d/D$ (10⁻³)", ylabel=name, xlim=(0, 5.5), ylim=(0, None))
    panel.legend(left, "upper left")
    return figure, table
