# SPDX-License-Identifier: GPL-2.0-or-later
"""Films and capacitance of a bearing in static equilibrium whose balls roll without slip, computed
from statics, kinematics and film thickness.

The entrainment speed of a contact is that of pure rolling at its own contact angle. For a ball on
several grooves, it follows instead from the motion of the ball (`ball_motion`). The film thickness
is computed with the formula by Masjedi and Khonsari for the elastic load of the contact (eqs 6, 7,
9), and the capacitance with eqs 8 and 10-12.
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

ROUNDS = 200  # largest number of equilibria on the way to that of `turning`


class Film(NamedTuple):
    """Films on one raceway, in arrays with the same shape as in `static.Contacts`. Values are zero
    if there is no contact."""

    entrainment: Floats  # m/s, entrainment speed
    h_min: Floats  # m
    h_c: Floats  # m
    ratio: Floats  # Lambda
    capacitance: Floats  # F
    rolling: Floats  # m/s, rolling speed as returned by `ball_motion.speeds`

    __repr__ = short


class Lubrication(NamedTuple):
    """Films on both raceways, and the capacitance that a bridge would measure."""

    inner: Film
    outer: Film
    # (Z,), F, inner and outer films in series (eq 12), grooves of one ring in parallel
    ball: Floats
    total: float  # F, all balls in parallel (eq 12), without background

    __repr__ = short


def lubricate(
    bearing: Bearing,
    state: Equilibrium,
    oil: Oil,
    speed: float,
    clearance: float = 0.0,
    factor: Callable[[Floats], Floats] | None = None,
    speeds: tuple[Floats, Floats] | None = None,
) -> Lubrication:
    """Compute the `Lubrication` of an `Equilibrium` with the oil `inputs.Oil`, for an inner ring
    that turns at `speed` rad/s. `clearance` in m must be the one used for the equilibrium. `factor`
    computes a factor on the film thickness from the entrainment speed in m/s; by default the factor
    is 1. `speeds` are (entrainment, rolling) speeds (C, Z) in m/s if they are known, otherwise
    those of `ball_motion.speeds`.

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
    speeds = np.array(ball_motion.speeds(bearing, speed, state) if speeds is None else speeds)
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
    of = bearing.effective_modulus, r_x, hertz.exact(r_x, r_y).kappa, entrained, contact.load[live]
    group = film.group(oil.viscosity, oil.pressure_viscosity, *of)
    thinned = 1.0 if factor is None else factor(entrained)
    h_min, h_c = thinned * film.h_min(r_x, group), thinned * film.h_c(r_x, group)
    electric = capacitance.contact(
        oil.permittivity, contact.pressure[live], contact.a[live], contact.b[live], h_c
    )
    values[:, live] = entrained, h_min, h_c, film.ratio(h_min, oil.roughness), electric, rolling
    return Film(*values)


def orbit(bearing: Bearing, state: Equilibrium, speed: float) -> float | Floats:
    """Return the orbital speed of the balls in rad/s for an inner ring that turns at `speed` rad/s.
    The balls roll at the mean contact angle, weighted by the loads on both raceways, because all
    balls of a row share one cage (Harris, ch. 10). If there are several rows, the result has one
    speed for each ball (Z,). Raises `NoEquilibrium` if no ball carries load."""
    load = np.vstack([state.inner.load, state.outer.load])
    if not load.any():
        raise NoEquilibrium("no ball carries load: the ring is held where it touches no ball")
    cosine = np.cos(np.vstack([state.inner.angle, state.outer.angle]))
    if len(bearing.layout.rows) == 1:
        mean = np.average(cosine, weights=load)
    else:  # a row without load is assigned the mean contact angle of all rows
        rows = [bearing.row == row for row in range(len(bearing.layout.rows))]
        loads = [load * row if (load * row).any() else load for row in rows]
        mean = np.array([np.average(cosine, weights=one) for one in loads])[bearing.row]
    return speed * kinematics.frequencies(bearing, np.arccos(mean)).cage


def turning(
    bearing: Bearing, speed: float, *loads: float, **options: Any
) -> tuple[Equilibrium, float | Floats]:
    """Return the `Equilibrium` and the `orbit` in rad/s, including the centrifugal load of balls
    that roll on an inner ring at `speed` rad/s. Loads and options are as in `static.equilibrium`.
    The orbital speed depends on the contact angles and vice versa, so both are determined by
    iteration. With several grooves, the film in the gap is part of the iteration: it follows from
    the motion of the balls, and the loads follow from it. The film first belongs to balls that roll
    at all contacts, so the result does not depend on a nearby equilibrium.

    A film that is thinner where a ball slides more can change the loads such that it slides less,
    and the speeds would oscillate. The change of a ball's speeds is therefore halved whenever it
    reverses. Raises `NoEquilibrium` if they do not settle.
    """
    near, film = options.get("near"), options.get("film")
    orbital = orbit(bearing, near, speed) if near else speed * kinematics.frequencies(bearing).cage
    several = film is not None and len(bearing.raceways) > 2
    drawn = last = None
    part = np.ones(len(bearing.row))
    for _ in range(ROUNDS):
        state = equilibrium(bearing, *loads, orbital_speed=orbital, **options)
        options["near"] = state
        before, orbital = orbital, orbit(bearing, state, speed)
        same = np.all(np.abs(orbital - before) <= 1e-9 * abs(speed))
        if several and (same or drawn is not None):
            found, _ = ball_motion.speeds(bearing, speed, state)
            if drawn is None:
                drawn, last, same = found, np.zeros(found.shape), False
            else:
                change = found - drawn
                same = same and np.all(np.abs(change) <= 1e-6 * np.abs(drawn))
                part[(change * last).sum(0) < 0] /= 2
                drawn, last = drawn + part * change, change
            options["film"] = replace(film, entrainment=drawn)
        if same:
            return state, before
    raise NoEquilibrium("the speeds of the balls, their films and their loads do not settle")
