# SPDX-License-Identifier: GPL-2.0-or-later
"""Film and capacitance of a bearing in static equilibrium, rolling without slip: statics,
kinematics and film combined.

Each contact has the entrainment speed of pure rolling at its own contact angle or, for a ball on
several grooves, the speed that follows from the ball's motion (`ball_motion`). The film is that of
Masjedi and Khonsari for the contact's elastic load (eqs 6, 7, 9), the capacitance that of eqs 8 and
10-12.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from raceway.arrays import Floats, short
from raceway.errors import NoEquilibrium
from raceway.inputs import Oil
from raceway.theory import ball_motion, capacitance, film, hertz, kinematics
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.static import Equilibrium, equilibrium


class Film(NamedTuple):
    """Films of one raceway, arrays with the shape of those in `static.Contacts`; zero without
    contact."""

    entrainment: Floats  # m/s
    h_min: Floats  # m
    h_c: Floats  # m
    ratio: Floats  # Lambda
    capacitance: Floats  # F
    rolling: Floats  # m/s, as from `ball_motion.speeds`

    __repr__ = short


class Lubrication(NamedTuple):
    """Films of both raceways and the capacitance in a bridge measurement."""

    inner: Film
    outer: Film
    ball: Floats  # (Z,), F: inner and outer in series (eq 12), grooves of a ring in parallel
    total: float  # F: all balls in parallel (eq 12), no background

    __repr__ = short


def lubricate(
    bearing: Bearing,
    state: Equilibrium,
    oil: Oil,
    speed: float,
    clearance: float = 0.0,
    factor: Callable[[Floats], Floats] | None = None,
) -> Lubrication:
    """`Lubrication` of an `Equilibrium` with an `inputs.Oil`, the inner ring at `speed` rad/s;
    `clearance` of the equilibrium in m; `factor` maps an entrainment speed in m/s to a factor on
    the thickness, by default 1.

    >>> from raceway.theory.bearing import Bearing
    >>> from raceway.inputs import Oil
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> oil = Oil(viscosity=0.04, pressure_viscosity=22e-9, permittivity=2.25, roughness=1e-7)
    >>> films = lubricate(b, equilibrium(b, 5000.0), oil, 50.0)
    >>> (1e9 * films.inner.h_min).round(1).tolist()[:3]  # nm
    [140.7, 144.4, 166.7]
    >>> round(1e12 * float(films.total), 1)  # pF
    303.5
    """
    speeds = np.array(ball_motion.speeds(bearing, speed, state))
    inner = bearing.raceways.count(INNER)
    sides = [
        _film(bearing, side, contact, own.reshape(2, *contact.load.shape), oil, clearance, factor)
        for side, contact, own in (
            (INNER, state.inner, speeds[:, :inner]),
            (OUTER, state.outer, speeds[:, inner:]),
        )
    ]
    ball = capacitance.ball(*(np.atleast_2d(side.capacitance).sum(0) for side in sides))
    return Lubrication(*sides, ball, float(np.sum(ball)))


def _film(bearing, side, contact, speeds, oil, clearance, factor):
    live = contact.load > 0
    values = np.zeros((6, *live.shape))
    angle, (entrained, rolling) = contact.angle[live], speeds[:, live]
    r_x, r_y = bearing.effective_radii(side, angle, clearance)
    group = film.group(
        oil.viscosity,
        oil.pressure_viscosity,
        bearing.effective_modulus,
        r_x,
        hertz.exact(r_x, r_y).kappa,
        entrained,
        contact.load[live],
    )
    thinned = 1.0 if factor is None else factor(entrained)
    h_min, h_c = thinned * film.h_min(r_x, group), thinned * film.h_c(r_x, group)
    electric = capacitance.contact(
        oil.permittivity, contact.pressure[live], contact.a[live], contact.b[live], h_c
    )
    values[:, live] = entrained, h_min, h_c, film.ratio(h_min, oil.roughness), electric, rolling
    return Film(*values)


def orbit(bearing: Bearing, state: Equilibrium, speed: float) -> float | Floats:
    """Orbital speed of the balls in rad/s for an inner ring at `speed` rad/s: rolling at the mean
    contact angle, weighted by the loads on both raceways, since one cage carries all balls of a row
    (Harris, ch. 10). For several rows, one speed for each ball (Z,). Raises `NoEquilibrium` if no
    ball carries load."""
    load = np.vstack([state.inner.load, state.outer.load])
    if not load.any():
        raise NoEquilibrium("no ball carries load: the ring is held where it touches no ball")
    cosine = np.cos(np.vstack([state.inner.angle, state.outer.angle]))
    if len(bearing.layout.rows) == 1:
        mean = np.average(cosine, weights=load)
    else:  # a row without load has the mean contact angle of all rows
        rows = [bearing.row == row for row in range(len(bearing.layout.rows))]
        loads = [load * row if (load * row).any() else load for row in rows]
        mean = np.array([np.average(cosine, weights=one) for one in loads])[bearing.row]
    return speed * kinematics.frequencies(bearing, np.arccos(mean)).cage


def turning(
    bearing: Bearing, speed: float, *loads: float, **options: Any
) -> tuple[Equilibrium, float | Floats]:
    """(`Equilibrium`, `orbit` in rad/s) with the centrifugal load of balls that roll at `speed`
    rad/s of the inner ring; loads and options as in `static.equilibrium`. The contact angles
    determine the orbital speed and the orbital speed determines the angles, so both are iterated.
    With several grooves, the film in the gap is part of the iteration.
    """
    near, film = options.get("near"), options.get("film")
    orbital = orbit(bearing, near, speed) if near else speed * kinematics.frequencies(bearing).cage
    for _ in range(30):
        state = equilibrium(bearing, *loads, orbital_speed=orbital, **options)
        options["near"] = state
        before, orbital = orbital, orbit(bearing, state, speed)
        same = np.all(np.abs(orbital - before) <= 1e-9 * abs(speed))
        if film is not None and len(bearing.raceways) > 2:
            drawn, _ = ball_motion.speeds(bearing, speed, state)
            known = options["film"].entrainment
            same = same and known is not None and np.allclose(drawn, known, rtol=1e-6, atol=0)
            options["film"] = replace(film, entrainment=drawn)
        if same:
            break
    return state, before
