# SPDX-License-Identifier: GPL-2.0-or-later
"""Separation of balls and raceways during a run, with and without load, as the engine defines it
for the total capacitance."""

from typing import NamedTuple

import numpy as np
import xarray as xr

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.tables import RunTables
from raceway.theory import film, film_gap, hertz
from raceway.theory.bearing import INNER, Bearing


class GapFilm(NamedTuple):
    """A film in the gap between ball and raceway (keywords *gap* and *gap_film*)."""

    share: float  # fraction of the film that adds to the overlap
    all_regimes: bool  # its law defines a thickness at any load


def gap_film(tables: RunTables) -> GapFilm | None:
    """Return the film in the gap of a run, or None if the film does not affect the load."""
    share = tables.pair_keyword("gap")
    if share is None:
        return None
    return GapFilm(float(share), tables.pair_keyword("gap_film") == "moes")


def cut(within: GapFilm | None) -> float:
    """Return the load in N below which the thickness of the film is constant."""
    return film_gap.CUT if within and not within.all_regimes else 0.0


def of_raceway(
    bearing: Bearing,
    side: int,
    table: xr.Dataset,
    gap: Floats,
    quiet: float,
    within: GapFilm | None,
    clearance: float,
) -> tuple[Floats, Floats]:
    """Return the separation and the play from the onset of contact in m as arrays (time, ball).

    `table` contains the contacts with one raceway, and `gap` the distances (time, ball) between
    surfaces in m. The separation is h_c at the load max(Q, Q_u) with Q_u = `quiet` in N, or the gap
    if there is no load and the gap is larger. If the film in the gap has a law of all
    regimes, the separation is h_c at any load.
    """
    load, thick = table["load"].to_numpy(), table["h_c"].to_numpy()
    live = load > 0
    if within and within.all_regimes:
        onset, apart = film_gap.REACH * bearing.ball_radius, np.where(live, thick, 0.0)
        beyond = gap
    else:
        r_x, r_y = bearing.effective_radii(side, 0.0, clearance)
        power = film.load_exponent(hertz.exact(r_x, r_y).kappa)
        if not live.any():
            name = "inner" if side == INNER else "outer"
            raise RunError(f"no ball is loaded on the {name} raceway in any sample")
        # h_c Q^m at the largest load is the load-independent factor of the film thickness, also for
        # balls without load. A film in the gap has a constant thickness below its cut.
        least = cut(within)
        factor = np.where(live, thick * np.maximum(load, least) ** power, 0.0)
        top = np.take_along_axis(factor, load.argmax(1)[:, None], axis=1)
        top = np.where(top > 0, top, np.median(top[top > 0]))
        if within and within.share > 0:
            # a ball without load that rolls more slowly has a film that does not fill its gap
            top = np.minimum(top, np.maximum(gap, 0.0) * least**power / within.share)
        factor = np.where(live, factor, top)
        apart = factor * np.maximum(load, quiet) ** -power
        # contact begins at this gap, which counts as far as it exceeds the film thickness
        onset = within.share * factor * least**-power if within else np.zeros_like(factor)
        beyond = gap - np.maximum(onset - apart, 0.0)
    play = np.where(live, 0.0, np.maximum(gap - onset, 0.0))
    return np.where(live, apart, np.maximum(apart, beyond)), play
