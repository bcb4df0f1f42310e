# SPDX-License-Identifier: GPL-2.0-or-later
"""Plot load and film around the ring, with curves for the simulation and dots for quasi-static
theory."""

import numpy as np

from raceway.arrays import Floats
from raceway.errors import NoEquilibrium
from raceway.files import FilePath
from raceway.inputs import Oil
from raceway.pictures import around_ring, style
from raceway.pictures.page import LEFT, RIGHT, head
from raceway.pictures.part import LIGHT, filmed, shown
from raceway.pictures.style import COLOUR, SIDES
from raceway.runs.settings import LUBRICANT
from raceway.runs.statics import NoStatics, need_steady_point
from raceway.runs.tables import RunTables
from raceway.theory.lubrication import lubricate, turning

PHASES = 4  # number of ball positions in a ball pass for which theory is evaluated
STRAIGHT = 0.01  # rad; contacts at larger angles also carry loads other than the radial load


def polar(tables: RunTables, path: FilePath) -> None:
    """Plot the contact load and, if there is a lubricant, the film thickness of the run `tables`
    against azimuth, and write the plot to the PNG file `path`.

    Dots are the results of `theory`. Raises `RunError` if the run's files are invalid or the
    picture cannot be written.
    """
    tables = shown(tables)
    film = filmed(tables)
    with style.drawing(path, figsize=(12, 7.4) if film else (7, 7.4), dpi=110) as figure:
        dots = theory(tables)
        head(
            figure,
            tables,
            "curves: simulation, all balls and samples"
            + ("    dots: quasi-static theory, as in raceway static" if dots else ""),
            size=15,
        )
        grid = figure.add_gridspec(
            1,
            2 if film else 1,
            left=LEFT,
            right=RIGHT,
            bottom=1.0 / 7.4,
            top=1 - 2.05 / 7.4,
            wspace=0.16,
        )
        axes = figure.add_subplot(grid[0], projection="polar")
        factor = around_ring.loads(axes, tables)
        _dots(axes, dots, "load", factor)
        if film:
            axes = figure.add_subplot(grid[1], projection="polar")
            factor = around_ring.film(axes, tables)
            for name in ("h_c", "h_min"):
                _dots(axes, dots, name, factor)


def theory(tables: RunTables) -> dict[int, dict[str, Floats]]:
    """Return {side: {"psi": rad, "load": N, "h_min": m, "h_c": m}} for the loaded contacts at
    `PHASES` positions of the balls; a dry bearing has no films. The dict is empty if the theory
    does not apply, i.e. if contacts are at an angle, if there is no equilibrium, or in the cases of
    `need_steady_point`.
    """
    try:
        need_steady_point(tables)
    except NoStatics:
        return {}
    if "angle" in tables.contacts and np.abs(tables.contacts["angle"]).max() > STRAIGHT:
        return {}
    settings, bearing = tables.settings, tables.geometry
    spin = abs(settings["rpm"]) * np.pi / 30
    oil = Oil(*(settings[name] for name in LUBRICANT)) if filmed(tables) else None
    found = {side: {"psi": [], "load": [], "h_min": [], "h_c": []} for side in SIDES}
    for k in range(PHASES):
        try:
            rest, _ = turning(
                bearing,
                spin,
                settings["load_N"],
                clearance=settings["clearance_m"],
                phase=2 * np.pi * (k + 0.5) / PHASES / bearing.balls,
            )
        except NoEquilibrium:
            return {}
        films = lubricate(bearing, rest, oil, spin, settings["clearance_m"]) if oil else None
        for side, contact in zip(SIDES, (rest.inner, rest.outer)):
            loaded = contact.load > LIGHT * max(rest.inner.load.max(), rest.outer.load.max())
            found[side]["psi"].append(rest.azimuth[loaded])
            found[side]["load"].append(contact.load[loaded])
            for name in ("h_min", "h_c") if films else ():
                found[side][name].append(getattr(films[side], name)[loaded])
    return {
        side: {name: np.concatenate(parts) for name, parts in columns.items() if parts}
        for side, columns in found.items()
    }


def _dots(axes, dots, name, factor):
    for side, columns in dots.items():
        axes.plot(
            columns["psi"],
            columns[name] * factor,
            "o",
            ms=5.5,
            mfc="white",
            mec=COLOUR[side],
            mew=1.3,
            zorder=4,
        )
