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
from raceway.theory.ball_pass import places
from raceway.theory.bearing import INNER, OUTER, Bearing
from raceway.theory.contact_law import FilmInGap
from raceway.theory.lubricant import Fluid
from raceway.theory.lubrication import Lubrication, lubricate, turning
from raceway.theory.models import DEFAULT
from raceway.theory.small_motion import Response, response
from raceway.theory.static import Equilibrium, equilibrium

PHASES = 8  # number of positions of the balls in a ball pass
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


def over_pass(at: Callable[[float], Response], balls: int, phases: int = PHASES) -> OverPass:
    """Evaluate `at`(phase in rad) at `phases` equidistant positions within one ball pass of a
    bearing with `balls` balls, and return the results as an `OverPass`.

    >>> from raceway.theory.bearing import Bearing
    >>> b = Bearing(9, 12.6e-3, 24.0e-3, 36.6e-3, 6.552e-3, 6.552e-3)
    >>> still = lambda phase: response(equilibrium(b, 3000.0, phase=phase).linear, 0.0)
    >>> found = over_pass(still, 9, 16)
    >>> print(*(f"{one.stiffness[1, 1]:.4g}" for one in found))
    1.222e+08 1.114e+08 1.354e+08
    """
    if phases < 1:
        raise ValueError(f"{phases} phases of a ball pass: give 1 or more")
    found = [at(phase) for phase in places(balls, phases).tolist()]
    both = [np.array(part) for part in zip(*found)]
    return OverPass(
        *(Response(*(how(one, axis=0) for one in both)) for how in (np.mean, np.min, np.max))
    )


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
    phases: int = PHASES,
    **options: Any,
) -> OverPass:
    """Return the `OverPass` under a radial load along x and an axial load (N), with the inner ring
    at `speed` rad/s.

    If no `oil` is given, there is no damping. The `models` "full" also need the `fluid`.
    `frequency` is the frequency of the motion in rad/s, 0 for slow motion. `options` (clearance,
    moment, held and others) are passed to `static.equilibrium`. Raises `NoEquilibrium` if no
    equilibrium is found.
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
            return response(state.linear, 0.0, frequency)
        films = lubricate(bearing, state, oil, speed, clearance, film and film.factor)
        beside = dampers(
            bearing, state, films, oil, models, clearance=clearance, frequency=frequency
        )
        return response(state.linear, beside.damping, frequency, stiffening=beside.stiffening)

    return over_pass(at, bearing.balls, phases)
