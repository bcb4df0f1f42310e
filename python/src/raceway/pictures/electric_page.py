# SPDX-License-Identifier: GPL-2.0-or-later
"""Title and tick labels of the pictures of a bearing as a capacitor."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from raceway.arrays import Floats
from raceway.pictures.page import fit
from raceway.pictures.style import SOFT
from raceway.units import prefixed

LEFT, RIGHT = 0.085, 0.965  # fractions of the figure width


def head(figure: Figure, names: Mapping[str, Any], title: str, without: str = "") -> None:
    """Write the title and, below it, the bearing and the operating point in `names` (from
    `electric_point.figures`), except for the quantity `without`."""
    height = figure.get_figheight()
    warm = names["temperature_C"]
    words = {
        "": f"{names['bearing']} ball bearing",
        "lubricant": f"{names['lubricant']} lubricant",
        "temperature_C": None if warm is None else f"{warm:g} °C",
        "load_N": f"{prefixed(names['load_N'], 'N')} radial",
        "axial_N": f"{prefixed(names['axial_N'], 'N')} axial" if names["axial_N"] else None,
        "rpm": f"{names['rpm']:g} rpm",
        "clearance_m": f"clearance {prefixed(names['clearance_m'], 'm', 3)}",
        "surroundings": names["surroundings"],
    }
    below = "  ·  ".join(word for key, word in words.items() if word and key != (without or None))
    for text, place, size, weight, colour in (
        (title, 0.42, 16, "bold", "black"),
        (below, 0.78, 11, "normal", SOFT),
    ):
        fit(
            figure.text(
                LEFT,
                1 - place / height,
                text,
                fontsize=size,
                fontweight=weight,
                color=colour,
                va="center",
            ),
            RIGHT - LEFT,
        )


def plain_ticks(axes: Axes, x: Floats) -> None:
    """Set tick labels such as 100, 200, 500 on a logarithmic axis for the values `x`."""
    low, high = np.floor(np.log10(x.min())), np.ceil(np.log10(x.max()))
    ticks = [m * 10.0**d for d in np.arange(low, high + 1) for m in (1, 2, 5)]
    ticks = [tick for tick in ticks if 0.999 * x.min() <= tick <= 1.001 * x.max()]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()


def around_ring(axes: Axes, edge: float) -> None:
    """Set up polar `axes` for a field up to `edge` in V/m, with the load line pointing down."""
    axes.set_theta_zero_location("S")
    angles = (0, 45, 90, 135, 180, -135, -90, -45)
    axes.set_thetagrids(range(0, 360, 45), [f"{angle}°" for angle in angles])
    axes.set_rlim(0, 1.12e-6 * edge)
    axes.set_rlabel_position(157)
    words = "azimuth from the load line; field in V/µm"
    axes.text(0.5, -0.09, words, transform=axes.transAxes, ha="center", color=SOFT)
