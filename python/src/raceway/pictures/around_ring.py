# SPDX-License-Identifier: GPL-2.0-or-later
"""Polar panels that show the load and the film thickness of every ball against its azimuth, with
the load line pointing down."""

from collections.abc import Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from raceway.pictures.page import key
from raceway.pictures.part import LIGHT, largest_load, tracks
from raceway.pictures.style import COLOUR, FAINT, INK, NAME, REGIMES, SOFT
from raceway.runs.tables import RunTables
from raceway.theory.bearing import INNER, OUTER
from raceway.units import axis


def loads(axes: Axes, tables: RunTables) -> float:
    """Plot the contact loads of the run `tables` on polar `axes`, and return the factor that
    converts newtons to the unit of the plot. Raises `RunError` if no ball carries load."""
    largest = largest_load(tables)
    factor, unit = axis(largest, "N")
    # the outer curve is drawn first and wider, because the inner curve covers it at low centrifugal
    # load
    width = {OUTER: 5, INNER: 1.6}
    for side in (OUTER, INNER):
        for psi, load in tracks(tables, side, "load"):
            axes.plot(psi, load * factor, color=COLOUR[side], lw=width[side])
    handles = [key(NAME[side], color=COLOUR[side], lw=width[side]) for side in (INNER, OUTER)]
    polar(axes, "Contact load around the ring", unit, 1.08 * largest * factor, handles)
    axes.annotate(
        "",
        (0.5, -0.155),
        (0.5, -0.075),
        xycoords="axes fraction",
        arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 1.8},
    )
    axes.text(
        0.525, -0.115, "load on the inner ring", transform=axes.transAxes, ha="left", va="center"
    )
    return factor


def film(axes: Axes, tables: RunTables) -> float:
    """Plot the film thickness of the run `tables` and the lubrication regimes on polar `axes`, and
    return the factor that converts metres to the unit of the plot."""
    # only these contacts determine the scale
    loaded = tables.contacts[tables.contacts["load"] > 5 * LIGHT * tables.contacts["load"].max()]
    factor, unit = axis(loaded["h_c"].max(), "m")
    unity = tables.settings["roughness_m"] * factor  # film thickness at which lambda is one
    edge = thickest = 1.12 * loaded["h_c"].max() * factor
    for mark in (1, 3):  # show a limit only if it is close, so that the film curve remains legible
        if mark * unity < 3 * thickest:
            edge = max(edge, 1.12 * mark * unity)
    around = np.linspace(0, 2 * np.pi, 361)
    regimes = [
        (low, high, name, colour) for low, high, name, colour in REGIMES if low * unity < edge
    ]
    for low, high, _, colour in regimes:
        axes.fill_between(
            around, low * unity, min(high * unity, edge), color=colour, lw=0, zorder=0.1
        )
        if low:
            axes.plot(
                around, np.full_like(around, low * unity), color=SOFT, lw=1.2, ls=(0, (1, 1.6))
            )
            axes.text(
                np.radians(225),
                low * unity,
                f"Λ = {low}",
                ha="center",
                va="center",
                fontweight="bold",
                zorder=5,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 1, "alpha": 0.75},
            )
    # solid lines, because the dashes of many balls would fill each other's gaps
    width = {"h_c": 3.2, "h_min": 1.3}
    for column in width:
        for side in (OUTER, INNER):
            for psi, thickness in tracks(tables, side, column, above=LIGHT):
                axes.plot(psi, thickness * factor, color=COLOUR[side], lw=width[column])
    handles = [
        key(f"{side} ${column[0]}_{{{column[2:]}}}$", color=COLOUR[raceway], lw=width[column])
        for raceway, side in ((INNER, "inner"), (OUTER, "outer"))
        for column in width
    ]
    polar(axes, "Film thickness around the ring", unit, edge, handles)
    axes.add_artist(axes.get_legend())
    axes.legend(
        handles=[Patch(fc=colour, ec=FAINT, label=name) for *_, name, colour in regimes],
        loc="upper center",
        bbox_to_anchor=(0.5, -0.085),
        ncols=len(regimes),
        handlelength=1.2,
        columnspacing=1.5,
        borderaxespad=0,
    )
    axes.text(
        0.5,
        -0.165,
        f"contacts above {LIGHT:.0%} of the largest load",
        transform=axes.transAxes,
        ha="center",
        va="center",
        fontsize=9.5,
        color=SOFT,
    )
    return factor


def polar(axes: Axes, title: str, unit: str, edge: float, handles: Sequence[Artist]) -> None:
    """Set up polar `axes` that extend to `edge` in `unit`, with the load line pointing down, and
    with `title` and a legend of `handles` above them."""
    axes.set_title(title, pad=54, x=-0.06)
    axes.set_theta_zero_location("S")  # the load line points down, like a weight
    axes.set_thetagrids(
        range(0, 360, 45),
        [f"{angle}°".replace("-", "−") for angle in (0, 45, 90, 135, 180, -135, -90, -45)],
    )
    axes.tick_params(axis="x", pad=3, labelcolor=SOFT)
    axes.spines["polar"].set_color(FAINT)
    axes.set_ylim(0, edge)
    ticks = [tick for tick in MaxNLocator(4).tick_values(0, edge) if 0 < tick <= edge]
    axes.set_rgrids(ticks, [""] * len(ticks))
    for tick in ticks:  # labels are drawn on top of the curves
        if tick < 0.97 * edge:
            axes.text(
                np.radians(157.5),
                tick,
                f"{tick:g} {unit}",
                ha="center",
                va="center",
                fontsize=10,
                color=SOFT,
                zorder=5,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.8, "alpha": 0.75},
            )

    axes.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(-0.06, 1.075),
        ncols=len(handles),
        handlelength=1.5,
        handletextpad=0.5,
        columnspacing=1.3,
        borderaxespad=0,
        borderpad=0,
    )
