# SPDX-License-Identifier: GPL-2.0-or-later
"""Theory of a radially loaded bearing with oil: static loads, the film at rolling speed, and the
capacitance that follows from both.

No run is needed: `raceway.static` provides the loads, and `film` and `capacitance` provide films
and capacitances. With `printed`, eqs 2 and 9 are used as printed in the paper (docs/errata.rst).
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from raceway.arrays import Floats, Numbers
from raceway.inputs import Oil
from raceway.theory import capacitance, film, hertz, static
from raceway.theory.bearing import INNER, OUTER, Bearing

# number of positions of the first ball within a ball spacing; the mean over a ball pass is accurate
# to better than 1e-3
PHASES = 20


class Contact(NamedTuple):
    """Loaded contacts of one raceway, as arrays with the shape of the loads, in SI units."""

    pressure: Numbers
    area: Numbers
    h_min: Numbers
    h_c: Numbers
    permittivity: Numbers
    capacitance: Numbers  # zero where there is no load


def contact(
    bearing: Bearing,
    oil: Oil,
    raceway: int,
    load: Numbers,
    speed: float,
    clearance: float = 0.0,
    printed: bool = False,
) -> Contact:
    """Return the `Contact` for loads in N at an entrainment speed in m/s.

    Unloaded contacts have no film (nan) and no capacitance.
    """
    r_x, r_y = bearing.effective_radii(raceway, clearance=clearance)
    ellipse = hertz.hamrock_brewe(r_x, r_y, printed=True) if printed else hertz.exact(r_x, r_y)
    load = np.asarray(load, float)
    live = np.where(load > 0, load, np.nan)
    a, b = hertz.semi_axes(ellipse, bearing.effective_modulus, live)
    pressure = 1.5 * live / (np.pi * a * b)
    modulus, kappa = bearing.effective_modulus, ellipse.kappa
    group = film.group(oil.viscosity, oil.pressure_viscosity, modulus, r_x, kappa, speed, live)
    h_c = film.h_c(r_x, group, printed=printed)
    value = capacitance.contact(oil.permittivity, pressure, a, b, h_c)
    return Contact(
        pressure,
        np.pi * a * b,
        film.h_min(r_x, group),
        h_c,
        capacitance.permittivity(oil.permittivity, pressure),
        np.where(load > 0, value, 0.0)[()],
    )


def ball(
    bearing: Bearing,
    oil: Oil,
    load: Numbers,
    speed: float,
    clearance: float = 0.0,
    printed: bool = False,
) -> Numbers:
    """Return the capacitance in F of balls with the same load in N on both raceways (eq 12)."""
    sides = (
        contact(bearing, oil, side, load, speed, clearance, printed).capacitance
        for side in (INNER, OUTER)
    )
    return capacitance.ball(*sides)


@lru_cache(maxsize=64)
def loads(
    bearing: Bearing, radial_load: float, clearance: float = 0.0
) -> tuple[Floats, Floats, float]:
    """Return (psi in degrees, load in N, mean shift in m along the load).

    psi and load are those of all balls at `PHASES` positions within a ball pass. The load acts on
    both raceways and excludes the centrifugal load.
    """
    turns = [
        static.equilibrium(
            bearing, radial_load, clearance=clearance, phase=phase, finite_shift=True
        )
        for phase in 2 * np.pi / bearing.balls * np.arange(PHASES) / PHASES
    ]
    psi = np.degrees(np.mod(np.array([turn.azimuth for turn in turns]) + np.pi, 2 * np.pi) - np.pi)
    return (
        psi,
        np.array([turn.inner.load for turn in turns]),
        float(np.mean([turn.shift[0] for turn in turns])),
    )


def largest_load(bearing: Bearing, radial_load: float, clearance: float = 0.0) -> float:
    """Return the load in N of a ball on the load line."""
    psi, load, _ = loads(bearing, radial_load, clearance)
    return float(load.flat[np.argmin(np.abs(psi))])


def bearing_capacitance(
    bearing: Bearing,
    oil: Oil,
    radial_load: float,
    speed: float,
    clearance: float = 0.0,
    printed: bool = False,
) -> float:
    """Return the capacitance of the bearing in F, averaged over a ball pass (eq 12).

    `printed` does not change the loads, because without clearance the load distribution remains the
    same if all stiffnesses change by the same factor.
    """
    _, load, _ = loads(bearing, radial_load, clearance)
    return float(ball(bearing, oil, load, speed, clearance, printed).sum(axis=1).mean())
