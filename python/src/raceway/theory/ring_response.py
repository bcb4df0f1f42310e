# SPDX-License-Identifier: GPL-2.0-or-later
"""Stiffness and damping of a bearing ring from statics and films, either at one position of the
balls or as mean and range over a ball pass.

Damping includes only the films and the steel of the contacts. Seats, housing, grease and friction
are neglected.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.inputs import Oil
from raceway.theory import damping, film_damping, hertz
from raceway.theory.ball_pass import places, refined
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication, lubricate, turning
from raceway.theory.models import DEFAULT
from raceway.theory.small_motion import Response, response
from raceway.theory.static import Equilibrium, equilibrium

# sign of each degree of freedom in a mirror image on the other side of the plane of x and z
MIRRORED = np.array([1, -1, 1, -1, 1])
# laws of the contact dampers for each of the models
LAWS = {"paper": "steel and squeeze film, eqs 4 and 5", "full": "steel, eq 4, and film branch"}
LAWS["eyring"] = LAWS["full"]


class Dampers(NamedTuple):
    """Dampers in parallel with the springs of the contacts (C, Z), in the same order as in
    `seat`."""

    damping: Floats  # N s/m
    stiffening: Floats  # N/m


class OverPass(NamedTuple):
    """The `Response` over a ball pass. The smallest and largest values are determined separately
    for each entry."""

    mean: Response
    least: Response
    most: Response


def dampers(
    bearing: Bearing,
    state: Equilibrium,
    films: Lubrication,
    oil: Oil,
    models: str = DEFAULT,
    *,
    clearance: float = 0.0,
    frequency: float = 0.0,
) -> Dampers:
    """Return the `Dampers` of the contacts at the equilibrium `state` with its films, which are the
    same as in a simulation with these `models` (a key of `LAWS`). `clearance` in m must be the one
    used for `state`.

    The film branch depends on the `frequency` of the motion in rad/s. Raises `ValueError` for
    unknown models.
    """
    if models not in LAWS:
        raise ValueError(f"models '{models}' is not one of {', '.join(LAWS)}")
    sides = []
    for side, contact, film in (
        (INNER, state.inner, films.inner),
        (OUTER, state.outer, films.outer),
    ):
        live = contact.load > 0
        load, result = contact.load[live], np.zeros((2, *live.shape))
        sides.append(result.reshape(2, -1, live.shape[-1]))
        result[0, live] = damping.hysteretic(load)
        if models == "paper":
            floor = np.maximum(film.h_min[live], oil.roughness)
            result[0, live] += damping.film(
                oil.viscosity, contact.a[live], bearing.ball_radius, floor
            )
            continue
        live &= film.h_c > 0  # balls at rest on a raceway have no film there
        load = contact.load[live]
        ellipse = hertz.exact(*bearing.effective_radii(side, contact.angle[live], clearance))
        elastic = (load / hertz.stiffness(ellipse, bearing.effective_modulus)) ** (2 / 3)
        one = film_damping.branch(
            1.5 * load / elastic, film.h_c[live], elastic, contact.b[live], film.entrainment[live]
        )
        turn = (frequency * one.time) ** 2
        result[0, live] += one.stiffness * one.time / (1 + turn)
        result[1, live] = one.stiffness * turn / (1 + turn)
    return Dampers(*np.concatenate(sides, axis=1))


def over_pass(
    at: Callable[[float], tuple[Response, Floats]],
    balls: int,
    phases: int | None = None,
    *,
    symmetric: bool = False,
) -> OverPass:
    """Return the `OverPass` of a bearing with `balls` balls. `at`(azimuth of the first ball in rad)
    returns the `Response` and the loads of the inner contacts.

    By default, `ball_pass.refined` selects the positions of the balls for the diagonals of both
    matrices. `phases` selects that number of evenly spaced positions instead. `symmetric` is as in
    `ball_pass.over`, for the plane of x and z.

    >>> from raceway.theory.bearing import Bearing
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> def still(phase):
    ...     rest = equilibrium(b, 3000.0, phase=phase)
    ...     return response(rest.linear, 0.0), rest.inner.load
    >>> for found in (over_pass(still, 9, symmetric=True), over_pass(still, 9, 64)):
    ...     print(*(f"{one.stiffness[1, 1]:.4g}" for one in found))
    1.22e+08 1.103e+08 1.354e+08
    1.22e+08 1.106e+08 1.354e+08
    """
    if phases is not None and phases < 1:
        raise ValueError(f"{phases} phases of a ball pass: give 1 or more")
    if phases is None:
        found = refined(at, balls, _loads, _diagonals, symmetric=symmetric)
    else:
        found = [(1 / phases, at(phase)) for phase in places(balls, phases).tolist()]
    shares = [share for share, _ in found]
    both = [np.array(part) for part in zip(*(one for _, (one, _) in found))]
    if phases is None and symmetric:
        sign = np.outer(MIRRORED, MIRRORED)
        shares, both = [*shares, *shares], [np.concatenate([one, sign * one]) for one in both]
    return OverPass(
        Response(*(np.average(one, axis=0, weights=shares) for one in both)),
        Response(*(one.min(0) for one in both)),
        Response(*(one.max(0) for one in both)),
    )


def _loads(found):
    return found[1]


def _diagonals(found):
    return np.concatenate([np.diag(matrix) for matrix in found[0]])


def turning_ring(
    bearing: Bearing,
    load: float,
    axial: float = 0.0,
    *,
    speed: float = 0.0,
    oil: Oil | None = None,
    fluid: Fluid | None = None,
    models: str = DEFAULT,
    frequency: float = 0.0,
    phases: int | None = None,
    **options: Any,
) -> OverPass:
    """Return the `OverPass` under a radial load along x and an axial load (N), with the inner ring
    at `speed` rad/s.

    If no `oil` is given, there is no damping. The `models` "full" also need the `fluid`.
    `frequency` is the frequency of the motion in rad/s, 0 for slow motion. `phases` is as in
    `over_pass`. `options` (clearance, moment, held and others) are passed to `static.equilibrium`.
    Raises `NoEquilibrium` if no equilibrium is found.
    """
    film = None
    if oil is not None and speed and models == "full":
        if fluid is None:
            raise ValueError("models full need the fluid")
        film = FilmInGap(fluid, speed)
    clearance = options.get("clearance", 0.0)
    # the film is omitted because it hardly affects the contact angles but slows the solution down
    _, orbit = turning(bearing, speed, load, axial, **options)

    def at(phase):
        # with several grooves, the entrainment speed depends on the motion of the balls
        if film is not None and len(bearing.raceways) > 2:
            state, _ = turning(bearing, speed, load, axial, phase=phase, film=film, **options)
        else:
            state = equilibrium(
                bearing, load, axial, phase=phase, orbital_speed=orbit, film=film, **options
            )
        if oil is None or not speed:
            return response(state.linear, 0.0, frequency), state.inner.load
        films = lubricate(bearing, state, oil, speed, clearance, film and film.factor)
        beside = dampers(
            bearing, state, films, oil, models, clearance=clearance, frequency=frequency
        )
        found = response(state.linear, beside.damping, frequency, stiffening=beside.stiffening)
        return found, state.inner.load

    held, moment = options.get("held") or {}, options.get("moment")
    across = [options.get("load_azimuth"), held.get("y"), held.get("rx"), *(moment or ())[:1]]
    return over_pass(at, bearing.balls, phases, symmetric=not any(across))
